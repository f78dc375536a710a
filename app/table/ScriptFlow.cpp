#include "ScriptFlow.h"

#include "ScriptActor.h"
#include "ScriptCuts.h"
#include "ScriptText.h"

#include <vtkBoundingBox.h>
#include <vtkMoteMeshMapper.h>

namespace mote::app
{

namespace
{

/// Makes `shape` of the lines, or of the places, that a vtkMoteStreamlines has found.
void writeFlowShape(Script& script, const Flow& flow, bool isLines)
{
  if (isLines)
  {
    script.line("shape = vtkTubeFilter()");
    script.line("shape.SetInputData(found.GetOutput(0))");
    script.line("shape.SetNumberOfSides(8)");
    script.line("shape.CappingOn()");
    script.call("shape", "SetRadius", flow.tubeRadius());
    return;
  }
  for (const char* line :
    {"places = found.GetOutput(1)", "vectors = places.GetPointData().GetVectors()",
      "arrows = vectors.NewInstance()", "arrows.DeepCopy(vectors)", "arrows.SetName(\"arrow\")",
      "places.GetPointData().AddArray(arrows)", "places.GetPointData().SetActiveVectors(\"arrow\")",
      "arrow = vtkArrowSource()", "arrow.SetTipResolution(12)", "arrow.SetShaftResolution(8)",
      "shape = vtkGlyph3D()", "shape.SetInputData(places)",
      "shape.SetSourceConnection(arrow.GetOutputPort())", "shape.SetVectorModeToUseVector()",
      "shape.SetScaleModeToScaleByVector()"})
    script.line(line);
  script.call("shape", "SetScaleFactor", flow.arrowFactor());
}

/// The volumes that are not hidden, as Python names them; and their size.
std::string shownVolumes(const Stage& stage, double& size)
{
  std::string volumes;
  vtkBoundingBox all;
  for (std::size_t i = 0; i < stage.parts().size(); ++i)
    if (const Part& part = *stage.parts()[i]; part.kind() == Part::Kind::Volume && !part.isHidden())
    {
      volumes += (volumes.empty() ? "" : ", ") + std::string("parts[") + std::to_string(i) + "]";
      all.AddBounds(part.data()->GetBounds());
    }
  size = volumes.empty() ? 0.0 : all.GetDiagonalLength();
  return volumes;
}

} // namespace

void writeFlow(Script& script, const Stage& stage, const FlowSettings& flow)
{
  double size = 0.0;
  const std::string volumes = shownVolumes(stage, size);
  if (volumes.empty() || (flow.lines == 0 && flow.arrows == 0))
    return;
  script.line();
  script.line("volumes = vtkMultiBlockDataSet()");
  script.line("for i, volume in enumerate([" + volumes + "]):");
  script.line("    volumes.SetBlock(i, volume)");
  script.line("found = mote.vtkMoteStreamlines()");
  script.line("found.SetInputDataObject(volumes)");
  if (!flow.array.empty())
    script.call("found", "SetInputArrayToProcess", 0, 0, 0, 0, flow.array);
  if (flow.from.size() == 6)
  {
    script.line("found.SeedsOnLineOn()");
    script.vector("found", "SetPoint1", flow.from.data());
    script.vector("found", "SetPoint2", flow.from.data() + 3);
  }
  script.call("found", "SetMaximumLength", flow.length.value_or(size));
  const std::vector<vtkActor*> actors = stage.flow().actors();
  for (vtkActor* actor : actors)
  {
    if (!actor->GetVisibility())
      continue;
    const bool isLines = actor == actors.front();
    script.call("found", "SetNumberOfSeeds", isLines ? flow.lines : flow.arrows);
    script.line("found.Update()");
    writeFlowShape(script, stage.flow(), isLines);
    script.line("shape.Update()");
    script.line("mapper = mote.vtkMoteMeshMapper()");
    script.line("mapper.SetInputData(shape.GetOutput())");
    auto* mapper = vtkMoteMeshMapper::SafeDownCast(actor->GetMapper());
    writeRepetitions(script, mapper);
    writeCuts(script, mapper, mapper->GetClipCylinder());
    writeActor(script, actor);
    script.line("prop.PickableOff()");
    script.line("props.append(prop)");
    script.line("renderer.AddViewProp(prop)");
  }
}

} // namespace mote::app
