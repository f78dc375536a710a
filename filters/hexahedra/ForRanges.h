#ifndef MoteForRanges_h
#define MoteForRanges_h

#include "vtkType.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{

/// Calls work(begin, end) for parts of [0, count), in parallel. VTK 9.1's own vtkSMPTools.h is no
/// C++20.
template <class Work>
void forRanges(vtkIdType count, const Work& work)
{
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 1024),
    [&](const tbb::blocked_range<vtkIdType>& range) { work(range.begin(), range.end()); });
}

/// Calls work(i) for i in [0, count), in parallel, one at a time.
template <class Work>
void forEach(vtkIdType count, const Work& work)
{
  tbb::parallel_for(vtkIdType{0}, count, work);
}

} // namespace mote

#endif
