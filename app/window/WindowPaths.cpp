#include "WindowPaths.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace mote::app
{

WindowPaths::WindowPaths(vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines_);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetLineWidth(3.0f);
  actor_->PickableOff();
  actor_->VisibilityOff();
  renderer->AddViewProp(actor_);
}

void WindowPaths::follow(const Settings& settings, const Input& input)
{
  const IdRanges& wanted = settings.output.trajectories;
  if (wanted.empty() || input.files().empty())
    return this->clear();
  if (paths_ && wanted == ids_ && settings.data.positions == positions_ &&
      input.files() == files_ && input.times() == times_)
    return;
  ids_ = wanted;
  positions_ = settings.data.positions;
  files_ = input.files();
  times_ = input.times();
  shown_ = 0;
  paths_ = nullptr; // before the next one reads
  paths_ = std::make_unique<ParticlePaths>(input.again(), wanted, settings);
}

void WindowPaths::clear()
{
  paths_ = nullptr;
  actor_->VisibilityOff();
}

bool WindowPaths::update()
{
  if (!paths_ || paths_->stepsRead() == shown_)
    return false;
  shown_ = paths_->stepsRead();
  paths_->fill(lines_);
  actor_->SetVisibility(lines_->GetNumberOfLines() > 0);
  return true;
}

} // namespace mote::app
