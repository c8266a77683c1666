# What `cmake --install` puts in place: the program, the library as one shared file with its headers and CMake package,
# the shipped data, licence and manual.
include(CMakePackageConfigHelpers)

# The library: the API whole, and of the folders below it what that uses. Nothing of theirs is linked publicly, so that
# consumers need none of their packages.
set(croquis_exports ${CMAKE_SOURCE_DIR}/cmake/croquis.map)
add_library(croquis SHARED ${CMAKE_SOURCE_DIR}/include/croquis/croquis.h)
add_library(croquis::croquis ALIAS croquis)
target_link_libraries(croquis PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,croquis_api>)
target_link_options(croquis PRIVATE "LINKER:--version-script=${croquis_exports}" "LINKER:--as-needed")
target_compile_features(croquis INTERFACE cxx_std_20)
target_include_directories(croquis INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/include>
                                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Before 1.0 a new minor version may change the interface.
set_target_properties(croquis PROPERTIES
  LINKER_LANGUAGE CXX LINK_DEPENDS ${croquis_exports}
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/croquis)
install(TARGETS croquis EXPORT croquisTargets)
install(EXPORT croquisTargets NAMESPACE croquis:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/croquisConfig.cmake.in ${CMAKE_BINARY_DIR}/croquisConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/croquisConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/croquisConfig.cmake ${CMAKE_BINARY_DIR}/croquisConfigVersion.cmake
  DESTINATION ${package_folder})

install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/croquis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/croquis)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
