# Half the time of a first build goes into reading the same headers. So first builds read them
# precompiled, and compile sources a few at a time. Compiler caches do not take files that come with
# precompiled headers, so where there is a cache there is neither.

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

# mote_unite(TARGET [SOURCE...]): compiles the target's sources in about four groups a folder, but for
# the named ones, whose headers define macros. Names in unnamed namespaces must differ within a group; a
# file's group depends on its own name alone, so that a new file does not change the others'.
function (mote_unite target)
  if (NOT MOTE_PRECOMPILE_HEADERS)
    return ()
  endif ()
  get_target_property(_sources ${target} SOURCES)
  if (ARGN)
    list(REMOVE_ITEM _sources ${ARGN})
  endif ()
  foreach (_source IN LISTS _sources)
    get_filename_component(_folder "${_source}" DIRECTORY)
    get_filename_component(_name "${_source}" NAME)
    string(MD5 _hash "${_name}")
    string(SUBSTRING "${_hash}" 0 1 _digit)
    math(EXPR _group "0x${_digit} % 4")
    string(MAKE_C_IDENTIFIER "${_folder}_${_group}" _group)
    set_source_files_properties("${_source}" TARGET_DIRECTORY ${target}
      PROPERTIES UNITY_GROUP "${_group}")
  endforeach ()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction ()
