# Installs BINARY_DIR, then configures, builds and runs the project in CONSUMER_DIR against it.

function (step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${said}")
  endif ()
  message(STATUS "${what}: done")
  set(said "${said}" PARENT_SCOPE)
endfunction ()

function (expect_file path)
  if (NOT EXISTS "${path}")
    message(FATAL_ERROR "There is no ${path}.")
  endif ()
endfunction ()

if (SANITIZE)
  message(STATUS "A consumer without sanitizers cannot load a library with them: skipped.")
  return ()
endif ()

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
step("install" "${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${prefix}"
  --config "${CONFIGURATION}")

# Headers are there, and only those that are meant for others.
expect_file("${prefix}/include/mote/kernels/tracing/RayCaster.h")
expect_file("${prefix}/include/mote/vtkMoteParticleMapper.h")
file(GLOB_RECURSE inner "${prefix}/include/*-inl.h" "${prefix}/include/*Bridge.h"
  "${prefix}/include/*FrameTracer.h" "${prefix}/include/*.cxx" "${prefix}/include/*.cpp"
  "${prefix}/include/*/detail/*")
if (inner)
  message(FATAL_ERROR "Installed, but nobody else's business: ${inner}")
endif ()
# VTK's own users need not know the kernels.
file(GLOB headers "${prefix}/include/mote/vtkMote*.h")
foreach (header IN LISTS headers)
  file(STRINGS "${header}" kernels REGEX "#include.*kernels/")
  if (kernels)
    message(FATAL_ERROR "${header} includes kernels: ${kernels}")
  endif ()
endforeach ()

# Nothing points back at the source or build tree.
file(GLOB_RECURSE configs "${prefix}/*.cmake")
foreach (config IN LISTS configs)
  file(READ "${config}" text)
  string(FIND "${text}" "${BINARY_DIR}/" found)
  if (NOT found EQUAL -1)
    message(FATAL_ERROR "${config} names the build tree.")
  endif ()
endforeach ()

# It can be moved.
file(RENAME "${prefix}" "${WORK_DIR}/moved")
set(prefix "${WORK_DIR}/moved")

step("configure" "${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIGURATION}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_PREFIX_PATH=${prefix}")
step("build" "${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config "${CONFIGURATION}")
step("run kernels" "${WORK_DIR}/build/kernels_consumer")
step("run" "${CMAKE_COMMAND}" -E chdir "${WORK_DIR}" "${WORK_DIR}/build/vtk_consumer")
expect_file("${WORK_DIR}/picture.png")
expect_file("${WORK_DIR}/picture.exr")
file(READ "${WORK_DIR}/picture.png" magic LIMIT 8 HEX)
if (NOT magic STREQUAL "89504e470d0a1a0a")
  message(FATAL_ERROR "picture.png is not a PNG: ${magic}")
endif ()

if (PYTHON AND PYTHON_DESTINATION)
  step("import" "${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_DESTINATION}"
    "PYTHONDONTWRITEBYTECODE=1" "${PYTHON}" -c
    "import mote\nmote.vtkMoteParticleMapper().GetBounds()\nprint(mote.__file__)")
  string(FIND "${said}" "${prefix}" found)
  if (found EQUAL -1)
    message(FATAL_ERROR "Another mote was imported: ${said}")
  endif ()
endif ()
