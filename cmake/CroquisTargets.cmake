# One static library a folder of src/, all with the same warnings. The arrows between folders are those of
# docs/design.md: a folder links only what it may include.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

add_library(croquis_flags INTERFACE)
target_include_directories(croquis_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR}/include)
target_compile_options(croquis_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CROQUIS_SANITIZE)
  target_compile_options(croquis_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
  target_link_options(croquis_flags INTERFACE -fsanitize=address,undefined)
endif()
if(CROQUIS_FUZZ)
  target_compile_options(croquis_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                                                 -fno-sanitize-recover=all)
  target_link_options(croquis_flags INTERFACE -fsanitize=address,undefined)
endif()

# What most files include. Tests add GoogleTest.
function(croquis_precompile target)
  if(CROQUIS_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <functional> <memory> <optional> <span>
                              <string> <vector> <fmt/format.h> <glm/geometric.hpp> <tbb/parallel_for.h> ${ARGN})
  endif()
endfunction()

# croquis_library(NAME SOURCES file... USES library...): src/NAME as the static library croquis_NAME.
function(croquis_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_library(croquis_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(croquis_${name} PUBLIC $<BUILD_INTERFACE:croquis_flags> ${ARG_USES})
  croquis_precompile(croquis_${name})
endfunction()

# croquis_package(TARGET module...): a Debian library found by pkg-config, its headers taken as system headers.
function(croquis_package target)
  pkg_check_modules(${target} REQUIRED IMPORTED_TARGET ${ARGN})
endfunction()

# Builds the programs of all croquis_test and nothing else.
add_custom_target(unit_tests)

# croquis_test(NAME SOURCES file... USES library... [GL]): a GoogleTest program, labelled "unit". With GL it runs twice, on
# OpenGL 3.3 and on OpenGL ES 3.0.
function(croquis_test name)
  cmake_parse_arguments(ARG "GL" "" "SOURCES;USES" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE croquis_flags ${ARG_USES} GTest::gtest_main)
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # compiling costs more than running
  list(LENGTH ARG_SOURCES files)
  if(files GREATER 3)
    croquis_precompile(test_${name} <gtest/gtest.h>)
  endif()
  add_dependencies(unit_tests test_${name})
  set(environment "CROQUIS_DATA=${CMAKE_SOURCE_DIR}/data" "LP_NUM_THREADS=1"
                  "ASAN_OPTIONS=intercept_tls_get_addr=0"
                  "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/lsan_suppressions.txt:print_suppressions=0")
  if(ARG_GL)
    foreach(gl gl gles)
      add_test(NAME ${name}_${gl} COMMAND test_${name})
      set_tests_properties(${name}_${gl} PROPERTIES ENVIRONMENT "${environment};CROQUIS_GL=${gl}" TIMEOUT 300 LABELS unit)
    endforeach()
  else()
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${environment}" TIMEOUT 300 LABELS unit)
  endif()
endfunction()
