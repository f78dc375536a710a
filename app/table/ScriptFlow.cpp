#include "ScriptFlow.h"

#include "ScriptActor.h"
#include "ScriptCuts.h"
#include "ScriptText.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkMoteMeshMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <vector>

namespace mote::app
{

namespace
{

/// The numbers of an array, as Python's list.
std::string numbersOf(vtkDataArray* array)
{
  std::string text;
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple.data());
    text += (i > 0 ? ", " : "") + python(tuple.data(), array->GetNumberOfComponents());
  }
  return "[" + text + "]";
}

/// Makes `places` of arrows on slices, number by number.
void writePlaces(Script& script, vtkPolyData* places, const std::string& colored)
{
  script.line("places = vtkPolyData()");
  script.line("points = vtkPoints()");
  script.line("points.SetDataTypeToDouble()");
  script.line("numbers = " + numbersOf(places->GetPoints()->GetData()));
  script.line("for i in range(0, len(numbers), 3):");
  script.line("    points.InsertNextPoint(numbers[i:i + 3])");
  script.line("places.SetPoints(points)");
  for (const std::string& name : {std::string("arrow"), colored})
  {
    vtkDataArray* array = places->GetPointData()->GetArray(name.c_str());
    if (!array)
      continue;
    script.line("array = vtkDoubleArray()");
    script.call("array", "SetName", name);
    script.call("array", "SetNumberOfComponents", array->GetNumberOfComponents());
    script.line("for number in " + numbersOf(array) + ":");
    script.line("    array.InsertNextValue(number)");
    script.line("places.GetPointData().AddArray(array)");
  }
  script.line("places.GetPointData().SetActiveVectors(\"arrow\")");
}

/// The volumes as they have turned, in `turned`.
void writeTurned(Script& script, const Part& part, const std::string& volume)
{
  script.line("turned = " + volume + ".NewInstance()");
  script.line("turned.ShallowCopy(" + volume + ")");
  script.line("placement = vtkDoubleArray()");
  script.call("placement", "SetName", "Placement");
  vtkMatrix4x4* matrix = part.placements().front()->GetMatrix();
  script.line("for number in [" + python(matrix->GetData(), 16) + "]:");
  script.line("    placement.InsertNextValue(number)");
  script.line("turned.GetFieldData().AddArray(placement)");
}

/// Makes `shape` of the lines, or of the places, that a vtkMoteStreamlines has found.
void writeFlowShape(Script& script, const Flow& flow, bool isLines)
{
  if (isLines)
  {
    script.line("shape = mote.vtkMoteLineTubes()");
    script.line("shape.SetInputData(found.GetOutput(0))");
    script.call("shape", "SetRadius", flow.built().tubeRadius);
    return;
  }
  if (flow.built().key.flow.arrowsOn != "slices")
    for (const char* line :
      {"places = found.GetOutput(1)", "vectors = places.GetPointData().GetVectors()",
        "arrows = vectors.NewInstance()", "arrows.DeepCopy(vectors)", "arrows.SetName(\"arrow\")",
        "places.GetPointData().AddArray(arrows)",
        "places.GetPointData().SetActiveVectors(\"arrow\")"})
      script.line(line);
  for (const char* line : {"arrow = vtkArrowSource()", "arrow.SetTipResolution(12)",
         "arrow.SetShaftResolution(8)", "shape = vtkGlyph3D()", "shape.SetInputData(places)",
         "shape.SetSourceConnection(arrow.GetOutputPort())", "shape.SetVectorModeToUseVector()",
         "shape.SetScaleModeToScaleByVector()"})
    script.line(line);
  script.call("shape", "SetScaleFactor", flow.built().arrowFactor);
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
      double bounds[6];
      part.data()->GetBounds(bounds);
      moveBounds(part.placements().front(), bounds);
      all.AddBounds(bounds);
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
  unsigned block = 0;
  for (std::size_t i = 0; i < stage.parts().size(); ++i)
    if (const Part& part = *stage.parts()[i]; part.kind() == Part::Kind::Volume && !part.isHidden())
    {
      if (part.turn().degrees != 0.0)
      {
        writeTurned(script, part, "parts[" + std::to_string(i) + "]");
        script.line("volumes.SetBlock(" + std::to_string(block) + ", turned)");
      }
      ++block;
    }
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
    if (!isLines && flow.arrowsOn == "slices")
      writePlaces(script, stage.flow().built().places, stage.coloring().choice().name);
    else
    {
      script.call("found", "SetNumberOfSeeds", isLines ? flow.lines : flow.arrows);
      script.line("found.Update()");
    }
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
