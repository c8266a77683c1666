# Descriptors and techniques as text: no OpenGL, so that they build, are tested and fuzzed alone.
croquis_library(framework_text
  SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/value.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grammar_source.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grammar.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grammar_properties.cpp
    ${CMAKE_CURRENT_LIST_DIR}/grammar_values.cpp
    ${CMAKE_CURRENT_LIST_DIR}/descriptor.cpp
    ${CMAKE_CURRENT_LIST_DIR}/technique_definition.cpp
  USES croquis_base)
