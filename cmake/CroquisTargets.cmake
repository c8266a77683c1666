# One static library a folder of src/, all with the same warnings. The arrows between folders are those of
# docs/design.md: a folder links only what it may include.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(spdlog REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)

add_library(croquis_flags INTERFACE)
target_include_directories(croquis_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR}/include)
target_compile_options(croquis_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CROQUIS_SANITIZE)
  target_compile_options(croquis_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
  target_link_options(croquis_flags INTERFACE -fsanitize=address,undefined)
endif()
# Error bounds of the lines' predicates hold for plain IEEE operations; and drawings are to be the same on all machines.
target_compile_options(croquis_flags INTERFACE -ffp-contract=off)
if(CROQUIS_FUZZ)
  # Which branches an input reached, for the fuzzers alone; tests of the same libraries pass it by.
  target_compile_options(croquis_flags INTERFACE -fsanitize-coverage=inline-8bit-counters,pc-table)
endif()

# What most files include is compiled once for all libraries, and once with GoogleTest for all tests:
# croquis_precompile(NAME header...) compiles it with further headers, croquis_reuse_headers(TARGET NAME) takes it.
set(croquis_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string>
                           <vector> <fmt/format.h> <glm/geometric.hpp> <tbb/parallel_for.h>)
file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "// Headers alone.\n")
function(croquis_precompile target)
  if(NOT CROQUIS_PRECOMPILE)
    return()
  endif()
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${target} PRIVATE croquis_flags spdlog::spdlog fmt::fmt TBB::tbb glm::glm)
  target_precompile_headers(${target} PRIVATE ${croquis_common_headers} ${ARGN})
endfunction()

function(croquis_reuse_headers target from)
  if(CROQUIS_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()

# croquis_library(NAME SOURCES file... USES library...): src/NAME as the static library croquis_NAME.
function(croquis_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_library(croquis_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(croquis_${name} PUBLIC $<BUILD_INTERFACE:croquis_flags> ${ARG_USES})
  croquis_reuse_headers(croquis_${name} croquis_precompiled)
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
  # gcc 12 takes moves of std::string for overruns there.
  target_compile_options(test_${name} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
  croquis_reuse_headers(test_${name} croquis_precompiled_tests)
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
