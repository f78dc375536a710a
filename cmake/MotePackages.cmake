# Debian packages, one for each component of the installation: `cpack` in the build folder, or
# scripts/package, which makes that of the plugin of ParaView too.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mote)
set(CPACK_PACKAGE_CONTACT "The developers of Mote")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_COMPONENTS_ALL runtime program development python)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# What libraries of Debian are needed its own tools find.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "libmote${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Ray casting for VTK: libraries\n The libraries of Mote, which casts rays at particles, meshes and hexahedral volumes.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME mote)
set(CPACK_COMPONENT_PROGRAM_DEPENDS runtime)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, python3-mote, paraview-mote")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "Viewer of simulation data\n Particles as exact spheres, triangle meshes and hexahedral volumes, ray cast on the CPU: in a\n window, or as pictures and films without a display.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmote-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libvtk9-dev, libglm-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Ray casting for VTK: headers\n Headers and CMake files of Mote, for programs that call find_package(Mote).")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-mote)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-vtk9, python3-numpy, fonts-dejavu-core")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "Ray casting for VTK: Python package\n Pictures, windows and films of NumPy arrays and of data of VTK, and the classes of Mote.")

include(CPack)
