#include "BoxEdges.h"

#include "stage/SimulationBox.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkDataSet.h>
#include <vtkMath.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3D.h>
#include <vtkProperty.h>

namespace mote::app
{

namespace
{

/// The twelve edges.
vtkSmartPointer<vtkPolyData> edgesOf(const SimulationBox& box)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(cornerOf(box, corner).data());
    for (int v = 0; v < 3; ++v)
      if (!((corner >> v) & 1))
      {
        const vtkIdType edge[2] = {corner, corner | (1 << v)};
        lines->InsertNextCell(2, edge);
      }
  }
  auto edges = vtkSmartPointer<vtkPolyData>::New();
  edges->SetPoints(points);
  edges->SetLines(lines);
  return edges;
}

/// The first box that the data of the parts say, or that of their bounds.
SimulationBox boxOf(const Stage& stage, const std::vector<std::size_t>& parts)
{
  vtkBoundingBox around;
  for (const std::size_t k : parts)
  {
    const Part& part = *stage.parts()[k];
    if (const auto own = simulationBoxOf(part.data()))
      return replicated(*own, stage.settings().particles.replicate);
    const double* bounds = part.prop()->GetVisibility() ? part.prop()->GetBounds() : nullptr;
    if (bounds && vtkMath::AreBoundsInitialized(bounds))
      around.AddBounds(bounds);
  }
  double bounds[6];
  stage.bounds(bounds);
  if (around.IsValid())
    around.GetBounds(bounds);
  return boxOfBounds(bounds);
}

/// Whether nothing but slices is shown, and these lie where the data's bounds are not.
bool isRolledOut(const Stage& stage)
{
  const VolumeSettings& volume = stage.shown().volume;
  return volume.unroll && volume.cloud != "on" && !(volume.walls.value_or(0.0) > 0.0) &&
         volume.isoValues.empty();
}

} // namespace

BoxEdges::BoxEdges(vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetLineWidth(1.0);
  actor_->UseBoundsOff();
  actor_->VisibilityOff();
  renderer->AddActor(actor_);
}

void BoxEdges::update(const Stage& stage, const std::vector<std::size_t>& parts)
{
  actor_->SetVisibility(stage.settings().picture.box && !parts.empty() && !isRolledOut(stage));
  if (actor_->GetVisibility())
    static_cast<vtkPolyDataMapper*>(actor_->GetMapper())
      ->SetInputData(edgesOf(boxOf(stage, parts)));
}

void BoxEdges::setInk(const Color& ink, const double ground[3])
{
  double quiet[3];
  for (std::size_t i = 0; i < 3; ++i)
    quiet[i] = 0.6 * ink[i] + 0.4 * ground[i];
  actor_->GetProperty()->SetColor(quiet);
}

} // namespace mote::app
