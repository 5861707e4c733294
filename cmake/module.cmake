# scenelore_module(NAME SOURCES … [DEPENDS …] [PRIVATE …])
# A static library scenelore_NAME with the alias scenelore::NAME. Public headers are what lies in include/; the sources
# see src/ too, so that the include path itself forbids a wrong dependency. DEPENDS are part of the interface.
function(scenelore_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(scenelore_${name} STATIC ${arg_SOURCES})
  add_library(scenelore::${name} ALIAS scenelore_${name})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/include/*.hpp)
  target_sources(scenelore_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  set_target_properties(scenelore_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
  target_include_directories(scenelore_${name} PRIVATE src)
  target_link_libraries(scenelore_${name} PUBLIC scenelore_flags ${arg_DEPENDS} PRIVATE scenelore_warnings ${arg_PRIVATE})
endfunction()

# scenelore_test(NAME SOURCES … LINKS … [LABELS …])
# A GoogleTest program; each of its cases is a test of ctest's. SCENELORE_SHARED_DATA names the folder of real scans,
# which need not exist: tests that want it skip themselves and say so.
function(scenelore_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE scenelore_flags scenelore_warnings ${arg_LINKS} GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_compile_definitions(${name} PRIVATE
    SCENELORE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" SCENELORE_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data/real")
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}." PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 600)
endfunction()
