# Every external library, found in one place. scripts/packages.txt names the Debian packages.

set(MOTE_VTK_COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  CommonColor FiltersCore FiltersExtraction FiltersFlowPaths FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersVerdict
  ImagingCore ImagingHybrid
  InteractionStyle InteractionWidgets
  IOCGNSReader IOChemistry IOCore IOEnSight IOGeometry IOImage IOLegacy IOOggTheora
  IOParallel IOParallelXML IOPLY IOXML IOXMLParser ParallelCore
  RenderingAnnotation RenderingContextOpenGL2 RenderingCore RenderingFreeType
  RenderingOpenGL2 RenderingUI RenderingVolume cgns hdf5 opengl glew)
if (MOTE_BUILD_BENCHMARKS)
  list(APPEND MOTE_VTK_COMPONENTS RenderingVolumeOpenGL2) # peers
endif ()
if (MOTE_BUILD_PYTHON)
  # VTK must be found before Python: otherwise another interpreter on PATH is taken, which lacks
  # the modules that Debian's VTK was built for.
  if (NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The interpreter VTK was built for")
  endif ()
  list(APPEND MOTE_VTK_COMPONENTS WrappingTools WrappingPythonCore Python PythonInterpreter)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${MOTE_VTK_COMPONENTS})
if (MOTE_BUILD_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif ()

find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(glm REQUIRED)
find_package(ZLIB REQUIRED)
find_package(muparser REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenImageIO 2.4 REQUIRED)
# Debian's exported target names include folders that need not exist, which CMake refuses.
get_target_property(_oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(_oiio_existing)
foreach (_dir IN LISTS _oiio_includes)
  if (EXISTS "${_dir}")
    list(APPEND _oiio_existing "${_dir}")
  endif ()
endforeach ()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${_oiio_existing}")

find_package(nlohmann_json REQUIRED)
if (MOTE_BUILD_APP OR MOTE_BUILD_BENCHMARKS)
  find_package(CLI11 REQUIRED)
endif ()
if (MOTE_BUILD_BENCHMARKS)
  find_package(embree 3 REQUIRED)
endif ()
if (MOTE_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif ()
