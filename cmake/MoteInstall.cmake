# The package that other projects find with find_package(Mote): libraries, headers, Python.

include(CMakePackageConfigHelpers)
# The linker follows shared libraries to those behind them, and CMake with it: whoever uses Mote
# must find the VTK modules that Mote uses inside, too.
set(MOTE_PACKAGE_VTK_COMPONENTS)
foreach (_module IN LISTS MOTE_MODULES)
  get_target_property(_libraries ${_module} LINK_LIBRARIES)
  foreach (_library IN LISTS _libraries)
    if (_library MATCHES "^VTK::([A-Za-z0-9]+)$")
      list(APPEND MOTE_PACKAGE_VTK_COMPONENTS "${CMAKE_MATCH_1}")
    endif ()
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES MOTE_PACKAGE_VTK_COMPONENTS)
list(SORT MOTE_PACKAGE_VTK_COMPONENTS)
list(JOIN MOTE_PACKAGE_VTK_COMPONENTS " " MOTE_PACKAGE_VTK_COMPONENTS)
set(_mote_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/mote")
configure_package_config_file(
  "${CMAKE_SOURCE_DIR}/cmake/mote-config.cmake.in" "${CMAKE_BINARY_DIR}/mote-config.cmake"
  INSTALL_DESTINATION "${_mote_cmake_destination}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/mote-config-version.cmake"
  VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/mote-config.cmake"
  "${CMAKE_BINARY_DIR}/mote-config-version.cmake"
  DESTINATION "${_mote_cmake_destination}" COMPONENT development)
install(EXPORT MoteKernels NAMESPACE Mote:: FILE Mote-kernels-targets.cmake
  DESTINATION "${_mote_cmake_destination}" COMPONENT development)
install(EXPORT MoteModules NAMESPACE Mote:: FILE Mote-targets.cmake
  DESTINATION "${_mote_cmake_destination}" COMPONENT development)
