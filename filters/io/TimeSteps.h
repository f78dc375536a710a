#ifndef MoteTimeSteps_h
#define MoteTimeSteps_h

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace mote
{

/// Says in an output's information which steps there are: their times, ascending; none if the data
/// have no time.
inline void offerTimeSteps(vtkInformation* information, const std::vector<double>& times)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  information->Remove(Pipeline::TIME_STEPS());
  information->Remove(Pipeline::TIME_RANGE());
  if (!times.empty())
  {
    const double range[2] = {times.front(), times.back()};
    information->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    information->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

/// The step that an output is asked for: the nearest at or before the requested time; the first one
/// for earlier times, and where no time is requested. There must be a step; they ascend by `time`.
template <class Step>
const Step& requestedStep(
  vtkInformation* information, const std::vector<Step>& steps, double Step::*time)
{
  auto* key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  if (!information->Has(key))
    return steps.front();
  const auto after =
    std::ranges::upper_bound(steps, information->Get(key), std::ranges::less(), time);
  return after == steps.begin() ? *after : *(after - 1);
}

} // namespace mote

#endif
