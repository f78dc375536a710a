#include "ScriptParts.h"

#include "ScriptActor.h"
#include "ScriptCuts.h"
#include "ScriptFlow.h"
#include "ScriptText.h"
#include "stage/Calculated.h"
#include "stage/Ids.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLookupTable.h>
#include <vtkMoteLineTubes.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

namespace mote::app
{

namespace
{

/// The ranges to show, of particles.
void writeRanges(Script& script, const Part& part, const Settings& settings)
{
  const std::vector<std::string> places = {"x", "y", "z"};
  for (const ShowRange& range : settings.selection.ranges)
  {
    const auto place = std::find(places.begin(), places.end(), range.name);
    const auto [low, high] = range.intervals.front();
    if (place != places.end())
      script.call("mapper", "SetCenterRange", static_cast<int>(place - places.begin()), low, high);
    else if (range.name == "radius")
      script.call("mapper", "SetRadiusRange", low, high);
    else if (const ArrayChoice choice = findArray(part.data(), range.name); choice)
      for (const Interval& interval : range.intervals)
        script.call(
          "mapper", "AddToRange", choice.name, choice.component, interval.low, interval.high);
  }
  if (arrayOf(part.data(), {whereArray, 0, false}))
    script.call("mapper", "AddToRange", whereArray, 0, 1.0, 1.0);
  vtkMoteParticleMapper* mapper = part.particles();
  if (!mapper->GetUseVisibilityRange())
    return;
  script.call("mapper", "SetUseVisibilityRange", true);
  script.call("mapper", "SetVisibilityArrayName", mapper->GetVisibilityArrayName());
  script.call("mapper", "SetVisibilityComponent", mapper->GetVisibilityComponent());
  script.vector("mapper", "SetVisibilityRange", mapper->GetVisibilityRange(), 2);
}

void writeProp(Script& script, const Part& part)
{
  if (part.isHidden())
    script.line("prop.VisibilityOff()");
  if (const auto& [axis, degrees] = part.turn(); degrees != 0.0)
  {
    script.line("turn = vtkTransform()");
    script.vector("turn", "Translate", axis.point.data());
    const double turned[] = {degrees, axis.direction[0], axis.direction[1], axis.direction[2]};
    script.vector("turn", "RotateWXYZ", turned, 4);
    const double back[] = {-axis.point[0], -axis.point[1], -axis.point[2]};
    script.vector("turn", "Translate", back);
    script.line("prop.SetUserTransform(turn)");
    script.line("mapper.TurnVectorsOn()");
  }
  script.line("props.append(prop)");
  script.line("renderer.AddViewProp(prop)");
}

/// The boundary of a volume whose cells the script has found.
void writeWalls(Script& script, const Part& part)
{
  auto* mapper =
    vtkMoteMeshMapper::SafeDownCast(vtkActor::SafeDownCast(part.props().back())->GetMapper());
  script.line("mapper = mote.vtkMoteMeshMapper()");
  script.line("mapper.SetInputData(part)");
  if (part.cells().mask())
    script.line("mapper.SetVisibleCells(cells.GetVisibleCells())");
  writeRepetitions(script, mapper);
  writeCuts(script, mapper, mapper->GetClipCylinder());
  script.call("mapper", "SetTwoSidedSheets", mapper->GetTwoSidedSheets());
  script.call("mapper", "SetCastsShadows", mapper->GetCastsShadows());
  writeActor(script, vtkActor::SafeDownCast(part.props().back()));
  writeProp(script, part);
}

void writeParticles(Script& script, const Part& part, const Settings& settings)
{
  vtkMoteParticleMapper* mapper = part.particles();
  script.line("mapper = mote.vtkMoteParticleMapper()");
  script.line("mapper.SetInputData(part)");
  script.call("mapper", "SetStructureName", mapper->GetStructureName());
  script.call("mapper", "SetStructureForm", mapper->GetStructureForm());
  script.call("mapper", "SetRadiusMode", mapper->GetRadiusMode());
  script.call("mapper", "SetRadius", mapper->GetRadius());
  script.call("mapper", "SetRadiusScale", mapper->GetRadiusScale());
  script.call("mapper", "SetRadiusArrayName", mapper->GetRadiusArrayName());
  for (const auto& [type, radius] : settings.particles.typeRadius)
    script.call("mapper", "SetTypeRadius", type, radius);
  if (part.images() > 1)
  {
    const int* counts = mapper->GetReplication();
    script.call("mapper", "SetReplication", counts[0], counts[1], counts[2]);
    script.line(
      "mapper.SetReplicationVectors((" + python(mapper->GetReplicationVectors(), 9) + "))");
  }
  if (mapper->GetPixelsOfError() > 0.0)
    script.call("mapper", "SetPixelsOfError", mapper->GetPixelsOfError());
  writeRanges(script, part, settings);
  writeCuts(script, mapper, mapper->GetClipCylinder());
  writeActor(script, vtkActor::SafeDownCast(part.props().back()));
}

/// Finds the cells that limits leave, but for those of the array `within`; whether any are hidden.
bool writeCells(Script& script, const Part& part, const Settings& settings,
  const ArrayChoice& colored, const ArrayChoice& within)
{
  std::vector<CellLimit> limits = cellLimitsOf(part.data(), settings.selection, colored);
  std::erase_if(
    limits, [&](const CellLimit& limit) { return limit.place < 0 && limit.choice == within; });
  if (!part.cells().mask())
    return false;
  script.line("cells = mote.vtkMoteCellSelection()");
  script.line("cells.SetDataSet(part)");
  for (const CellLimit& limit : limits)
  {
    for (const auto& [low, high] : limit.intervals)
      script.call("cells", "AddInterval", low, high);
    if (limit.place >= 0)
      script.call("cells", "LimitPlace", limit.place);
    else
      script.call(
        "cells", "Limit", limit.choice.name, limit.choice.component, limit.choice.ofCells);
  }
  return true;
}

void writeTubes(Script& script, vtkMoteLineTubes& tubes)
{
  script.line("faces = mote.vtkMoteLineTubes()");
  if (tubes.GetRadius() > 0.0)
    script.call("faces", "SetRadius", tubes.GetRadius());
  if (!tubes.GetRadiusArrayName().empty())
    script.call("faces", "SetRadiusArrayName", tubes.GetRadiusArrayName());
  if (tubes.GetRadiusScale() != 1.0)
    script.call("faces", "SetRadiusScale", tubes.GetRadiusScale());
}

void writeSurface(
  Script& script, const Part& part, const Settings& settings, const ArrayChoice& colored)
{
  const Surface& surface = *part.surface();
  const bool isLimited = writeCells(script, part, settings, colored, {});
  script.line("mapper = mote.vtkMoteMeshMapper()");
  if (isLimited && surface.isMade())
  {
    // Cells have another order there.
    script.line("shown = cells.GetVisibleCells()");
    script.line("shown.SetName(\"shown\")");
    script.line("part.GetCellData().AddArray(shown)");
  }
  if (isLimited && surface.takesFaces())
  {
    script.line("faces = vtkThreshold()");
    script.line("faces.SetInputArrayToProcess(0, 0, 0, 1, \"shown\")");
    script.line("faces.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)");
    script.line("faces.SetUpperThreshold(1.0)");
  }
  else if (surface.tubes())
    writeTubes(script, *surface.tubes());
  else if (surface.isMade())
    script.line(surface.makesNormals() ? "faces = vtkPolyDataNormals()"
                                       : "faces = vtkDataSetSurfaceFilter()");
  if (surface.isMade())
  {
    script.line("faces.SetInputData(part)");
    script.line("mapper.SetInputConnection(faces.GetOutputPort())");
  }
  else
    script.line("mapper.SetInputData(part)");
  if (isLimited && surface.isMade() && !surface.takesFaces())
  {
    script.line("faces.Update()");
    script.line("mapper.SetVisibleCells(faces.GetOutput().GetCellData().GetArray(\"shown\"))");
  }
  else if (isLimited && !surface.takesFaces())
    script.line("mapper.SetVisibleCells(cells.GetVisibleCells())");
  if (surface.mapper()->GetPixelsOfError() > 0.0)
    script.call("mapper", "SetPixelsOfError", surface.mapper()->GetPixelsOfError());
  writeRepetitions(script, surface.mapper());
  writeCuts(script, surface.mapper(), surface.mapper()->GetClipCylinder());
  writeActor(script, vtkActor::SafeDownCast(part.props().back()));
}

void writeFunctions(Script& script, vtkVolumeProperty* look)
{
  script.line("curve = vtkColorTransferFunction()");
  vtkColorTransferFunction* curve = look->GetRGBTransferFunction();
  script.line("for point in (");
  for (int i = 0; i < curve->GetSize(); ++i)
  {
    double node[6];
    curve->GetNodeValue(i, node);
    script.line("    (" + python(node, 6) + "),");
  }
  script.line("):");
  script.line("    curve.AddRGBPoint(*point)");
  script.line("look.SetColor(curve)");
  script.line("opacity = vtkPiecewiseFunction()");
  vtkPiecewiseFunction* opacity = look->GetScalarOpacity();
  script.call("opacity", "SetAllowDuplicateScalars", opacity->GetAllowDuplicateScalars() != 0);
  script.line("for point in (");
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    script.line("    (" + python(node, 4) + "),");
  }
  script.line("):");
  script.line("    opacity.AddPoint(*point)");
  script.line("look.SetScalarOpacity(opacity)");
}

void writeSlices(Script& script, vtkMoteVolumeMapper* mapper)
{
  for (int i = 0; i < mapper->GetNumberOfSlices(); ++i)
  {
    vtkMoteSlice* slice = mapper->GetSlice(i);
    script.line("slice = mote.vtkMoteSlice()");
    script.call("slice", "SetShape", slice->GetShape());
    script.vector("slice", "SetCenter", slice->GetCenter());
    script.vector("slice", "SetAxis", slice->GetAxis());
    script.vector("slice", "SetOutwards", slice->GetOutwards());
    script.call("slice", "SetRadius", slice->GetRadius());
    script.line("mapper.AddSlice(slice)");
  }
  for (int i = 0; i < mapper->GetNumberOfSliceRanges(); ++i)
  {
    double range[2];
    mapper->GetSliceRange(i, range);
    script.call("mapper", "AddSliceRange", range[0], range[1]);
  }
  script.call("mapper", "SetEdgeWidth", mapper->GetEdgeWidth());
}

void writeVolume(
  Script& script, const Part& part, const Settings& settings, const ArrayChoice& colored)
{
  auto* volume = vtkVolume::SafeDownCast(part.prop());
  auto* mapper = vtkMoteVolumeMapper::SafeDownCast(volume->GetMapper());
  const bool isLimited = writeCells(script, part, settings, colored, colored);
  script.line("mapper = mote.vtkMoteVolumeMapper()");
  script.line("mapper.SetInputData(part)");
  if (isLimited)
    script.line("mapper.SetVisibleCells(cells.GetVisibleCells())");
  if (mapper->GetStructureName())
    script.call("mapper", "SetStructureName", mapper->GetStructureName());
  script.call("mapper", "SetIntegratorName", mapper->GetIntegratorName());
  script.call("mapper", "SetSampleDistance", mapper->GetSampleDistance());
  script.call("mapper", "SetTolerance", mapper->GetTolerance());
  script.call("mapper", "SetShowCloud", mapper->GetShowCloud() != 0);
  script.call("mapper", "SetShowIsoSurfaces", mapper->GetShowIsoSurfaces() != 0);
  if (mapper->GetIsoArrayName()[0] != '\0')
    script.call("mapper", "SetIsoArray", mapper->GetIsoArrayName(), mapper->GetIsoArrayOfCells(),
      mapper->GetIsoArrayComponent());
  script.vector("mapper", "SetNanColor", mapper->GetNanColor());
  script.call("mapper", "SetNanOpacity", mapper->GetNanOpacity());
  script.call("mapper", "SetScalarMode", mapper->GetScalarMode());
  script.call("mapper", "SelectScalarArray", mapper->GetArrayName());
  script.call("mapper", "SetVectorMode", mapper->GetVectorMode());
  script.call("mapper", "SetVectorComponent", mapper->GetVectorComponent());
  writeSlices(script, mapper);
  writeRepetitions(script, mapper);
  writeCuts(script, mapper, mapper->GetClipCylinder());
  script.line("prop = vtkVolume()");
  script.line("prop.SetMapper(mapper)");
  vtkVolumeProperty* look = volume->GetProperty();
  script.line("look = prop.GetProperty()");
  writeFunctions(script, look);
  script.call("look", "SetScalarOpacityUnitDistance", look->GetScalarOpacityUnitDistance());
  script.call("look", "SetShade", look->GetShade());
  script.call("look", "SetAmbient", look->GetAmbient());
  script.call("look", "SetDiffuse", look->GetDiffuse());
  script.call("look", "SetSpecular", look->GetSpecular());
  vtkContourValues* values = look->GetIsoSurfaceValues();
  for (int i = 0; i < values->GetNumberOfContours(); ++i)
    script.call("look.GetIsoSurfaceValues()", "SetValue", i, values->GetValue(i));
}

/// The array of a coordinate, where one colours; see addCoordinate().
void writeCoordinate(Script& script, const std::string& name)
{
  const std::size_t axis = std::string("xyz").find(name);
  if (name.size() != 1 || axis == std::string::npos)
    return;
  script.line("if not part.GetPointData().HasArray(" + python(name) + "):");
  script.line("    calculator = vtkArrayCalculator()");
  script.line("    calculator.SetInputData(part)");
  script.call("    calculator", "AddCoordinateScalarVariable", name, static_cast<int>(axis));
  script.call("    calculator", "SetFunction", name);
  script.call("    calculator", "SetResultArrayName", name);
  script.line("    calculator.Update()");
  script.line("    part.GetPointData().AddArray(");
  script.line("        calculator.GetOutput().GetPointData().GetArray(" + python(name) + "))");
}

/// The positions of --positions, and the arrays of --calculate and --where that the part has.
void writeCalculated(Script& script, const Part& part, const Settings& settings)
{
  if (part.particles() && settings.data.lines == "particles")
  {
    script.line("if mote.vtkMoteLineTubes.IsOfLines(part):  # points have the values of lines");
    script.line("    values = vtkCellDataToPointData()");
    script.line("    values.SetInputData(part)");
    script.line("    values.Update()");
    script.line("    part.GetPointData().ShallowCopy(values.GetOutput().GetPointData())");
  }
  if (part.particles() && settings.data.positions != "file")
    script.line("mote.vtkMotePeriodicPositions.Move(part, mote.vtkMotePeriodicPositions." +
                std::string(settings.data.positions == "wrapped" ? "WRAPPED" : "UNWRAPPED") + ")");
  std::vector<Calculation> all = settings.data.calculations;
  if (!settings.selection.where.empty())
    all.push_back({whereArray, settings.selection.where});
  for (const Calculation& one : all)
    for (const bool ofCells : {false, true})
      if (vtkDataArray* array = arrayOf(part.data(), {one.name, 0, ofCells}))
      {
        const bool isForCells = one.name == whereArray && Part::isMesh(part.data());
        script.line(std::string("mote.vtkMoteExpression.") +
                    (isForCells ? "AddToCells(part, " : "AddTo(part, ") + python(one.expression) +
                    ", " + python(one.name) + ", " + python(array->GetDataType()) + ")");
        break;
      }
}

bool isOfKind(const IdRanges& ids, const Stage& stage, bool meshes)
{
  return std::any_of(ids.list().begin(), ids.list().end(),
    [&](const IdRange& range)
    {
      const auto k = static_cast<std::size_t>(range.part) - 1;
      return range.part == 0 ||
             (k < stage.parts().size() && Part::isMesh(stage.parts()[k]->data()) == meshes);
    });
}

/// What --hide-ids and --only-ids leave, of the data set with this number, which counts from 1.
void writeIds(Script& script, const Stage& stage, const Part& part, int number,
  const SelectionSettings& selection)
{
  const bool isMesh = Part::isMesh(part.data());
  if ((selection.hidden.empty() && selection.only.empty()) ||
      !arrayOf(part.data(), {whereArray, 0, isMesh}))
    return;
  vtkDataArray* ids = isMesh ? nullptr : idArrayOf(part.data());
  const std::string arrays = isMesh ? "part.GetCellData()" : "part.GetPointData()";
  const std::string count = isMesh ? "part.GetNumberOfCells()" : "part.GetNumberOfPoints()";
  script.line("marks = " + arrays + ".GetArray(" + python(whereArray) + ")");
  script.line("if not marks:");
  script.line("    marks = vtkUnsignedCharArray()");
  script.call("    marks", "SetName", whereArray);
  script.line("    marks.SetNumberOfValues(" + count + ")");
  script.line("    marks.Fill(1)");
  script.line("    " + arrays + ".AddArray(marks)");
  const auto list = [&](const char* name, const IdRanges& ranges)
  {
    script.line(std::string(name) + " = (");
    for (const auto& [low, high] : ranges.of(number))
      script.line("    range(" + std::to_string(low) + ", " + std::to_string(high) + " + 1),");
    script.line(")");
  };
  list("hidden", selection.hidden);
  list("only", selection.only);
  // Ids of other kinds of data leave all of these.
  const bool isAll = !isOfKind(selection.only, stage, isMesh);
  if (ids)
    script.line("ids = part.GetPointData().GetArray(" + python(ids->GetName()) + ")");
  script.line("for i in range(" + count + "):");
  script.line(std::string("    name = ") + (ids ? "int(ids.GetComponent(i, 0))" : "i"));
  script.line(std::string("    if any(name in r for r in hidden)") +
              (isAll ? ":" : " or not any(name in r for r in only):"));
  script.line("        marks.SetValue(i, 0)");
}

} // namespace

void writeParts(Script& script, const Stage& stage, const Settings& settings)
{
  for (std::size_t i = 0; i < stage.parts().size(); ++i)
  {
    const Part& part = *stage.parts()[i];
    script.line();
    script.line("part = parts[" + std::to_string(i) + "]  # " + part.name());
    writeCalculated(script, part, settings);
    writeIds(script, stage, part, static_cast<int>(i) + 1, settings.selection);
    writeCoordinate(script, settings.color.array);
    if (part.particles())
      writeParticles(script, part, settings);
    else if (part.surface())
      writeSurface(script, part, settings, stage.coloring().choice());
    else
      writeVolume(script, part, settings, stage.coloring().choice());
    writeProp(script, part);
    if (part.hasWalls())
      writeWalls(script, part);
  }
  writeFlow(script, stage, settings.flow);
}

std::vector<vtkProp3D*> writtenProps(const Stage& stage)
{
  std::vector<vtkProp3D*> written;
  for (const auto& part : stage.parts())
  {
    written.push_back(part->prop());
    if (part->hasWalls())
      written.push_back(part->props().back());
  }
  for (vtkActor* actor : stage.flow().actors())
    if (actor->GetVisibility())
      written.push_back(actor);
  return written;
}

} // namespace mote::app
