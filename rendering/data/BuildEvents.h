#pragma once

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

namespace mote
{

/// Tells that a mapper's build starts and, however it goes, that it has ended.
class BuildEvents
{
public:
  explicit BuildEvents(vtkAlgorithm* mapper)
    : mapper_(mapper)
  {
    mapper_->SetAbortExecute(0);
    mapper_->InvokeEvent(vtkCommand::StartEvent, nullptr);
  }
  ~BuildEvents() { mapper_->InvokeEvent(vtkCommand::EndEvent, nullptr); }
  BuildEvents(const BuildEvents&) = delete;
  BuildEvents& operator=(const BuildEvents&) = delete;

private:
  vtkAlgorithm* mapper_;
};

} // namespace mote
