# Two INTERFACE targets that every target of ours links: how it is compiled, and what it is warned about.
add_library(scenelore_flags INTERFACE)
target_compile_features(scenelore_flags INTERFACE cxx_std_20)
# The same bytes out on every machine: no contraction of a*b+c that one processor has and another has not.
target_compile_options(scenelore_flags INTERFACE -ffp-contract=off)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(scenelore_warnings INTERFACE)
# Designated initialisers that leave fields to their defaults are the house style, so g++ 12 need not warn of them.
target_compile_options(scenelore_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-sign-conversion -Wno-missing-field-initializers)
if(SCENELORE_WARNINGS_AS_ERRORS)
  target_compile_options(scenelore_warnings INTERFACE -Werror)
endif()

set(SCENELORE_SANITIZE "" CACHE STRING "sanitizers, for instance address,undefined")
if(SCENELORE_SANITIZE)
  target_compile_options(scenelore_flags INTERFACE -fsanitize=${SCENELORE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(scenelore_flags INTERFACE -fsanitize=${SCENELORE_SANITIZE})
endif()
