# scenelore_embed(TARGET FUNCTION FILES…): compiles text files (SQL, Lua) into TARGET. The generated source defines
#   std::span<const scenelore::EmbeddedFile> FUNCTION();      // FUNCTION is a qualified name, e.g. scenelore::kb::schema_files
# in the order given, with names relative to the project; cmake/embedded_file.hpp declares the type. Editing a file rebuilds.
function(scenelore_embed target function)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_${target}.cpp)
  string(REGEX REPLACE "::[^:]*$" "" namespace ${function})
  string(REGEX REPLACE "^.*::" "" name ${function})
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUT=${source} -DNAMESPACE=${namespace} -DNAME=${name} -DROOT=${PROJECT_SOURCE_DIR}
            "-DFILES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake VERBATIM)
  target_sources(${target} PRIVATE ${source})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/include)
endfunction()
