# Every command shown in the README and in docs/ is run as shown.
file(GLOB documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/docs/*.md)
foreach(document IN LISTS documents)
  file(STRINGS ${document} commands REGEX "^```sh$")
  if(commands)
    cmake_path(GET document STEM name)
    add_test(NAME documented_commands.${name}
      COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/documented_commands.sh $<TARGET_FILE:scenelore> ${document})
    set_tests_properties(documented_commands.${name} PROPERTIES LABELS "cli;docs" TIMEOUT 600)
  endif()
endforeach()
