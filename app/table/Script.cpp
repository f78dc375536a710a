#include "Script.h"

#include "CommandLine.h"
#include "ScriptText.h"
#include "settings/ErrorBudget.h"
#include "stage/Calculated.h"
#include "stage/Ids.h"
#include "stage/Silhouettes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLookupTable.h>
#include <vtkMoteAreaLight.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouettes.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <initializer_list>

namespace mote::app
{

namespace
{

void writeImports(Script& script)
{
  script.line("# Draws the view that mote showed, with VTK's and Mote's classes.");
  script.line("import math");
  script.line();
  script.line("import mote");
  script.line("from vtkmodules.vtkCommonCore import vtkLookupTable, vtkUnsignedCharArray");
  script.line(
    "from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPiecewiseFunction");
  script.line("from vtkmodules.vtkFiltersCore import vtkArrayCalculator, vtkPolyDataNormals");
  script.line("from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter");
  script.line("from vtkmodules.vtkRenderingCore import (");
  script.line("    vtkActor, vtkColorTransferFunction, vtkLight, vtkRenderer, vtkVolume)");
  script.line();
  script.line("parts = []  # the data sets");
  script.line();
  script.line();
  script.line("def read(name, time=None):");
  script.line("    reader = mote.vtkMoteReaderTable.NewReader(name)");
  script.line("    if time is None:");
  script.line("        reader.Update()");
  script.line("    else:");
  script.line("        reader.UpdateInformation()");
  script.line("        reader.UpdateTimeStep(time)");
  script.line("    data = reader.GetOutputDataObject(0)");
  script.line("    if not data.IsA(\"vtkCompositeDataSet\"):");
  script.line("        parts.append(data)");
  script.line("        return");
  script.line("    leaves = data.NewIterator()");
  script.line("    while not leaves.IsDoneWithTraversal():");
  script.line("        parts.append(leaves.GetCurrentDataObject())");
  script.line("        leaves.GoToNextItem()");
  script.line();
  script.line();
}

void writeTable(Script& script, vtkLookupTable* table)
{
  script.line("colors = vtkLookupTable()");
  script.call(
    "colors", "SetNumberOfTableValues", static_cast<int>(table->GetNumberOfTableValues()));
  script.call("colors", "SetScale", table->GetScale());
  script.vector("colors", "SetTableRange", table->GetTableRange(), 2);
  script.vector("colors", "SetNanColor", table->GetNanColor(), 4);
  script.call("colors", "SetVectorMode", table->GetVectorMode());
  script.call("colors", "SetVectorComponent", table->GetVectorComponent());
  script.line("for entry, color in enumerate((");
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i)
    script.line("    (" + python(table->GetTableValue(i), 4) + "),");
  script.line(")):");
  script.line("    colors.SetTableValue(entry, color)");
  script.line();
}

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

/// The colours of a mapper, and its actor with what it looks like.
void writeActor(Script& script, vtkMapper* mapper, const Part& part)
{
  script.call("mapper", "SetScalarVisibility", mapper->GetScalarVisibility() != 0);
  if (mapper->GetScalarVisibility())
  {
    script.call("mapper", "SetScalarMode", mapper->GetScalarMode());
    script.call("mapper", "SelectColorArray", mapper->GetArrayName());
    script.line("mapper.SetLookupTable(colors)");
    script.call("mapper", "SetUseLookupTableScalarRange", true);
  }
  script.line("prop = vtkActor()");
  script.line("prop.SetMapper(mapper)");
  vtkProperty* look = vtkActor::SafeDownCast(part.prop())->GetProperty();
  script.line("look = prop.GetProperty()");
  script.vector("look", "SetColor", look->GetColor());
  script.call("look", "SetAmbient", look->GetAmbient());
  script.call("look", "SetDiffuse", look->GetDiffuse());
  script.call("look", "SetSpecular", look->GetSpecular());
  script.call("look", "SetSpecularPower", look->GetSpecularPower());
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
  writeActor(script, mapper, part);
}

void writeSurface(Script& script, const Part& part)
{
  const Surface& surface = *part.surface();
  script.line("mapper = mote.vtkMoteMeshMapper()");
  if (surface.makesNormals() || surface.takesFaces())
  {
    script.line(surface.makesNormals() ? "faces = vtkPolyDataNormals()"
                                       : "faces = vtkDataSetSurfaceFilter()");
    script.line("faces.SetInputData(part)");
    script.line("mapper.SetInputConnection(faces.GetOutputPort())");
  }
  else
    script.line("mapper.SetInputData(part)");
  if (surface.mapper()->GetPixelsOfError() > 0.0)
    script.call("mapper", "SetPixelsOfError", surface.mapper()->GetPixelsOfError());
  writeActor(script, surface.mapper(), part);
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

void writeVolume(Script& script, vtkVolume* volume)
{
  auto* mapper = vtkMoteVolumeMapper::SafeDownCast(volume->GetMapper());
  script.line("mapper = mote.vtkMoteVolumeMapper()");
  script.line("mapper.SetInputData(part)");
  if (mapper->GetStructureName())
    script.call("mapper", "SetStructureName", mapper->GetStructureName());
  script.call("mapper", "SetIntegratorName", mapper->GetIntegratorName());
  script.call("mapper", "SetSampleDistance", mapper->GetSampleDistance());
  script.call("mapper", "SetTolerance", mapper->GetTolerance());
  script.call("mapper", "SetShowCloud", mapper->GetShowCloud() != 0);
  script.call("mapper", "SetShowIsoSurfaces", mapper->GetShowIsoSurfaces() != 0);
  script.vector("mapper", "SetNanColor", mapper->GetNanColor());
  script.call("mapper", "SetNanOpacity", mapper->GetNanOpacity());
  script.call("mapper", "SetScalarMode", mapper->GetScalarMode());
  script.call("mapper", "SelectScalarArray", mapper->GetArrayName());
  script.call("mapper", "SetVectorMode", mapper->GetVectorMode());
  script.call("mapper", "SetVectorComponent", mapper->GetVectorComponent());
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
        script.line("mote.vtkMoteExpression.AddTo(part, " + python(one.expression) + ", " +
                    python(one.name) + ", " + python(array->GetDataType()) + ")");
        break;
      }
}

/// What --hide-ids and --only-ids leave, of the data set with this number, which counts from 1.
void writeIds(Script& script, const Part& part, int number, const SelectionSettings& selection)
{
  if ((selection.hidden.empty() && selection.only.empty()) || !part.particles())
    return;
  vtkDataArray* ids = idArrayOf(part.data());
  script.line("marks = part.GetPointData().GetArray(" + python(whereArray) + ")");
  script.line("if not marks:");
  script.line("    marks = vtkUnsignedCharArray()");
  script.call("    marks", "SetName", whereArray);
  script.line("    marks.SetNumberOfValues(part.GetNumberOfPoints())");
  script.line("    marks.Fill(1)");
  script.line("    part.GetPointData().AddArray(marks)");
  const auto list = [&](const char* name, const IdRanges& ranges)
  {
    script.line(std::string(name) + " = (");
    for (const auto& [low, high] : ranges.of(number))
      script.line("    range(" + std::to_string(low) + ", " + std::to_string(high) + " + 1),");
    script.line(")");
  };
  list("hidden", selection.hidden);
  list("only", selection.only);
  if (ids)
    script.line("ids = part.GetPointData().GetArray(" + python(ids->GetName()) + ")");
  script.line("for i in range(part.GetNumberOfPoints()):");
  script.line(std::string("    name = ") + (ids ? "int(ids.GetComponent(i, 0))" : "i"));
  script.line(std::string("    if any(name in r for r in hidden)") +
              (selection.only.empty() ? ":" : " or not any(name in r for r in only):"));
  script.line("        marks.SetValue(i, 0)");
}

void writeParts(Script& script, const Stage& stage, const Settings& settings)
{
  for (std::size_t i = 0; i < stage.parts().size(); ++i)
  {
    const Part& part = *stage.parts()[i];
    script.line();
    script.line("part = parts[" + std::to_string(i) + "]  # " + part.name());
    writeCalculated(script, part, settings);
    writeIds(script, part, static_cast<int>(i) + 1, settings.selection);
    writeCoordinate(script, settings.color.array);
    if (part.particles())
      writeParticles(script, part, settings);
    else if (part.surface())
      writeSurface(script, part);
    else
      writeVolume(script, vtkVolume::SafeDownCast(part.prop()));
    if (part.isHidden())
      script.line("prop.VisibilityOff()");
    script.line("renderer.AddViewProp(prop)");
  }
}

void writeLights(Script& script, vtkRenderer* renderer)
{
  script.line();
  script.line("renderer.AutomaticLightCreationOff()");
  vtkCollectionSimpleIterator next;
  renderer->GetLights()->InitTraversal(next);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(next))
  {
    auto* area = vtkMoteAreaLight::SafeDownCast(light);
    script.line(area ? "light = mote.vtkMoteAreaLight()" : "light = vtkLight()");
    script.call("light", "SetLightType", light->GetLightType());
    script.vector("light", "SetPosition", light->GetPosition());
    script.vector("light", "SetFocalPoint", light->GetFocalPoint());
    script.call("light", "SetIntensity", light->GetIntensity());
    if (area)
    {
      script.call("light", "SetSize", area->GetSize());
      script.call("light", "SetShadows", area->GetShadows());
      script.call("light", "SetSamples", area->GetSamples());
    }
    script.line("renderer.AddLight(light)");
  }
}

void writeCamera(Script& script, const Settings& settings, vtkRenderer* renderer)
{
  const std::vector<double>& camera = settings.camera.camera;
  script.line();
  script.vector("renderer", "SetBackground", renderer->GetBackground());
  script.vector("renderer", "SetBackground2", renderer->GetBackground2());
  script.call("renderer", "SetGradientBackground", renderer->GetGradientBackground());
  script.line("camera = renderer.GetActiveCamera()");
  script.call("camera", "SetParallelProjection", settings.camera.orthographic);
  script.vector("camera", "SetPosition", camera.data());
  script.vector("camera", "SetFocalPoint", camera.data() + 3);
  script.vector("camera", "SetViewUp", camera.data() + 6);
  script.call(
    "camera", settings.camera.orthographic ? "SetParallelScale" : "SetViewAngle", camera[9]);
}

void writeShading(Script& script, vtkMoteShading* shading)
{
  script.line("shading = source.GetShading()");
  script.call("shading", "SetMode", shading->GetMode());
  script.call("shading", "SetAmbientOcclusion", shading->GetAmbientOcclusion());
  if (shading->GetAmbientOcclusion() == vtkMoteShading::OCCLUSION_LIVE)
    script.call("shading", "SetAmbientOcclusionSamples", shading->GetAmbientOcclusionSamples());
  script.call("shading", "SetAmbientOcclusionReach", shading->GetAmbientOcclusionReach());
  script.call("shading", "SetCloudTolerance", shading->GetCloudTolerance());
  script.vector("shading", "SetSkyTop", shading->GetSkyTop());
  script.vector("shading", "SetSkyBottom", shading->GetSkyBottom());
}

void writeSilhouettes(Script& script, const SilhouetteSettings& settings)
{
  vtkNew<vtkMoteSilhouettes> silhouettes; // as thick as of the picture, not of the view
  choose(settings, vtkMoteSilhouettes::RADII, silhouettes);
  if (!silhouettes->GetEnabled())
    return;
  script.line("silhouettes = mote.vtkMoteSilhouettes()");
  script.call("silhouettes", "SetEnabled", true);
  script.call("silhouettes", "SetThreshold", silhouettes->GetThreshold());
  script.call("silhouettes", "SetThresholdMode", silhouettes->GetThresholdMode());
  script.call("silhouettes", "SetThickness", silhouettes->GetThickness());
  script.call("silhouettes", "SetLeastThickness", silhouettes->GetLeastThickness());
  script.call("silhouettes", "SetLeastOpacity", silhouettes->GetLeastOpacity());
  script.call("silhouettes", "SetStepInPixels", silhouettes->GetStepInPixels());
  script.call("silhouettes", "SetHulls", silhouettes->GetHulls());
  script.call("silhouettes", "SetCentered", silhouettes->GetCentered());
  script.vector("silhouettes", "SetColor", silhouettes->GetColor());
  script.call("silhouettes", "SetGroupArrayName", silhouettes->GetGroupArrayName());
  script.line("source.SetSilhouettes(silhouettes)");
}

void writeLegend(
  Script& script, const Stage& stage, const Settings& settings, const std::string& caption)
{
  const PictureSettings& picture = settings.picture;
  script.line("legend = mote.vtkMoteColorLegend()");
  script.line("legend.SetInputConnection(source.GetOutputPort())");
  if (vtkLookupTable* table = picture.legend ? stage.coloring().legendTable() : nullptr)
  {
    if (table == stage.coloring().table())
      script.line("legend.SetLookupTable(colors)");
    else
    {
      writeTable(script, table);
      script.line("colors.IndexedLookupOn()");
      for (vtkIdType i = 0; i < table->GetNumberOfAnnotatedValues(); ++i)
        script.call("colors", "SetAnnotation", std::string(table->GetAnnotatedValue(i).ToString()),
          std::string(table->GetAnnotation(i)));
      script.line("legend.SetLookupTable(colors)");
    }
  }
  script.call("legend", "SetTitle", picture.title.value_or(stage.coloring().title()));
  script.call("legend", "SetCaption", picture.caption.value_or(caption));
  script.call("legend", "SetSide", picture.legendSide == "left" ? 1 : 0);
  script.call("legend", "SetLabelFormat", picture.legendFormat);
  script.call("legend", "SetFontScale", picture.fontScale);
}

} // namespace

namespace
{

/// Without what makes no other picture: of the window alone.
Settings forPicture(Settings settings)
{
  const PictureSettings usual;
  settings.views.saved.clear();
  settings.picture.fps = usual.fps;
  settings.picture.box = usual.box;
  settings.picture.axes = usual.axes;
  return settings;
}

} // namespace

std::string commandOf(const Settings& settings, const std::string& output)
{
  std::vector<std::string> words = {"mote"};
  if (!output.empty())
    words.emplace_back("render");
  for (const std::string& option : asOptions(output.empty() ? settings : forPicture(settings)))
    words.push_back(option);
  if (!output.empty())
    words.insert(words.end(), {"-o", output});
  return asShellLine(words);
}

std::string scriptOf(
  const Stage& stage, const Input& input, const Settings& settings, const std::string& output)
{
  Script script;
  writeImports(script);
  int step = input.chosenStep(settings);
  for (const auto& [file, time] : input.filesAt(step))
    script.line("read(" + python(file) + (time ? ", " + python(*time) : "") + ")");
  script.line();
  if (vtkLookupTable* table = stage.coloring().table())
    writeTable(script, table);
  script.line("renderer = vtkRenderer()");
  writeParts(script, stage, settings);
  writeLights(script, stage.renderer());
  writeCamera(script, settings, stage.renderer());
  script.line();
  script.line("source = mote.vtkMoteRendererSource()");
  script.line("source.SetRenderer(renderer)");
  script.call("source", "SetSize", settings.picture.size[0], settings.picture.size[1]);
  script.call(
    "source", "SetSamplesPerPixel", settings.picture.mostSamples(settings.light.pathTrace));
  script.call("source", "SetNoiseLevel", errorShares(settings).noise.value_or(0.0));
  writeShading(script, stage.lighting().shading());
  writeSilhouettes(script, settings.silhouettes);
  writeLegend(script, stage, settings, captionOf(input, step, stage.contents()));
  script.line();
  script.line("writer = mote.vtkMoteImageWriter()");
  script.line("writer.SetInputConnection(legend.GetOutputPort())");
  script.call("writer", "SetFileName", output);
  script.line("if not writer.Write():");
  script.line("    raise SystemExit(writer.GetErrorMessage())");
  return script.text();
}

} // namespace mote::app
