#include "PathLines.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace mote::app
{

PathLines::PathLines(vtkRenderer* renderer)
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

void PathLines::update(const ParticlePaths* paths, const std::vector<std::size_t>& parts)
{
  if (paths && !parts.empty())
    paths->fill(lines_, parts);
  actor_->SetVisibility(paths && !parts.empty() && lines_->GetNumberOfLines() > 0);
}

} // namespace mote::app
