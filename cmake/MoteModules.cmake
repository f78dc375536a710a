# The VTK-facing classes are VTK modules: declared dependencies, object factories, Python wrapping.

vtk_module_find_modules(_mote_module_files "${CMAKE_SOURCE_DIR}/filters")
vtk_module_find_modules(_mote_rendering_files "${CMAKE_SOURCE_DIR}/rendering")
list(APPEND _mote_module_files ${_mote_rendering_files})
vtk_module_scan(
  MODULE_FILES ${_mote_module_files}
  REQUEST_MODULES Mote::FiltersHexahedra Mote::FiltersIO Mote::FiltersImaging
    Mote::FiltersParticles Mote::RenderingData Mote::RenderingVTK
  PROVIDES_MODULES MOTE_MODULES
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${MOTE_MODULES}
  PACKAGE Mote
  INSTALL_EXPORT MoteModules
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/mote"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/mote"
  LIBRARY_NAME_SUFFIX ""
  VERSION "${PROJECT_VERSION}"
  USE_EXTERNAL ON
  ENABLE_WRAPPING "${MOTE_BUILD_PYTHON}"
  TEST_DIRECTORY_NAME "NONE")
if (MOTE_PRECOMPILE_HEADERS)
  # The modules depend on each other: what they share is nobody's own.
  file(WRITE "${CMAKE_BINARY_DIR}/ModuleHeaders.cpp" "")
  add_library(MoteModuleHeaders OBJECT "${CMAKE_BINARY_DIR}/ModuleHeaders.cpp")
  target_link_libraries(MoteModuleHeaders
    PRIVATE VTK::CommonExecutionModel VTK::CommonDataModel TBB::tbb)
  mote_precompile(MoteModuleHeaders VTK)
  mote_share_precompiled(MoteModuleHeaders FiltersHexahedra FiltersIO FiltersImaging FiltersParticles
    RenderingData RenderingVTK)
  foreach (_module FiltersHexahedra FiltersIO FiltersImaging FiltersParticles RenderingData RenderingVTK)
    mote_unite(${_module})
  endforeach ()
endif ()

if (MOTE_BUILD_PYTHON)
  vtk_module_python_default_destination(MOTE_PYTHON_DESTINATION)
  # Extension modules lie deeper than programs do, and find the libraries from there.
  set(_install_rpath "${CMAKE_INSTALL_RPATH}")
  file(RELATIVE_PATH _to_libraries
    "/${MOTE_PYTHON_DESTINATION}/mote" "/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_INSTALL_RPATH "$ORIGIN/${_to_libraries}")
  vtk_module_wrap_python(
    MODULES ${MOTE_MODULES}
    INSTALL_EXPORT MotePython
    INSTALL_HEADERS OFF
    PYTHON_PACKAGE "mote"
    MODULE_DESTINATION "${MOTE_PYTHON_DESTINATION}"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/mote"
    WRAPPED_MODULES MOTE_WRAPPED_MODULES
    TARGET Mote::Python
    BUILD_STATIC OFF)
  set(CMAKE_INSTALL_RPATH "${_install_rpath}")
endif ()
