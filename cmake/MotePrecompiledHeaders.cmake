# Half the time of a first build goes into reading the same headers. Compiler caches do not take
# files that come with precompiled ones, so where there is a cache there are none of these.

if (CMAKE_CXX_COMPILER_LAUNCHER)
  set(_precompile OFF)
else ()
  set(_precompile ON)
endif ()
option(MOTE_PRECOMPILE_HEADERS "Precompile the headers that many files include" ${_precompile})

set(MOTE_STANDARD_HEADERS <algorithm> <array> <atomic> <bit> <cmath> <cstdint> <cstdio> <cstring>
  <functional> <limits> <map> <memory> <optional> <string> <utility> <vector> <tbb/blocked_range.h>
  <tbb/parallel_for.h> <tbb/parallel_reduce.h>)
set(MOTE_VTK_HEADERS <vtkCommand.h> <vtkDataArray.h> <vtkDataArrayRange.h> <vtkDataSet.h>
  <vtkFieldData.h> <vtkImageData.h> <vtkInformation.h> <vtkInformationVector.h> <vtkNew.h>
  <vtkObjectFactory.h> <vtkPointData.h> <vtkPoints.h> <vtkPolyData.h> <vtkSmartPointer.h>)

# mote_precompile(TARGET [VTK] [HEADER...]): headers of the standard, of VTK, and others.
function (mote_precompile target)
  if (NOT MOTE_PRECOMPILE_HEADERS)
    return ()
  endif ()
  set(_headers ${MOTE_STANDARD_HEADERS})
  foreach (_header IN LISTS ARGN)
    if (_header STREQUAL "VTK")
      list(APPEND _headers ${MOTE_VTK_HEADERS})
    else ()
      list(APPEND _headers "${_header}")
    endif ()
  endforeach ()
  target_precompile_headers(${target} PRIVATE ${_headers})
endfunction ()

# mote_share_precompiled(FROM TARGET...): the targets take the headers of another one, which are as
# much work as the rest of a small target. Its options must be theirs, and definitions that differ must
# mean nothing to the headers.
function (mote_share_precompiled from)
  if (NOT MOTE_PRECOMPILE_HEADERS)
    return ()
  endif ()
  foreach (_target IN LISTS ARGN)
    if (NOT _target STREQUAL from)
      target_precompile_headers(${_target} REUSE_FROM ${from})
    endif ()
  endforeach ()
endfunction ()
