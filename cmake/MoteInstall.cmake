# The package that other projects find with find_package(Mote): libraries, headers, Python.

include(CMakePackageConfigHelpers)
set(_mote_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/mote")
configure_package_config_file(
  "${CMAKE_SOURCE_DIR}/cmake/mote-config.cmake.in" "${CMAKE_BINARY_DIR}/mote-config.cmake"
  INSTALL_DESTINATION "${_mote_cmake_destination}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/mote-config-version.cmake"
  VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/mote-config.cmake"
  "${CMAKE_BINARY_DIR}/mote-config-version.cmake"
  DESTINATION "${_mote_cmake_destination}")
install(EXPORT MoteKernels NAMESPACE Mote:: FILE Mote-kernels-targets.cmake
  DESTINATION "${_mote_cmake_destination}")
install(EXPORT MoteModules NAMESPACE Mote:: FILE Mote-targets.cmake
  DESTINATION "${_mote_cmake_destination}")
