#include "Script.h"

#include "CommandLine.h"
#include "ScriptParts.h"
#include "ScriptText.h"
#include "settings/ErrorBudget.h"
#include "stage/Framing.h"
#include "stage/SideBySide.h"
#include "stage/Silhouettes.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLookupTable.h>
#include <vtkMoteAreaLight.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>

#include <algorithm>
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
  script.line("from vtkmodules.vtkCommonCore import (");
  script.line("    vtkDoubleArray, vtkLookupTable, vtkPoints, vtkUnsignedCharArray)");
  script.line("from vtkmodules.vtkCommonDataModel import (");
  script.line("    vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPiecewiseFunction,");
  script.line("    vtkPlane, vtkPolyData)");
  script.line("from vtkmodules.vtkCommonTransforms import vtkTransform");
  script.line("from vtkmodules.vtkFiltersCore import (");
  script.line("    vtkArrayCalculator, vtkCellDataToPointData, vtkGlyph3D, vtkPolyDataNormals, "
              "vtkThreshold)");
  script.line("from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter");
  script.line("from vtkmodules.vtkFiltersSources import vtkArrowSource");
  script.line("from vtkmodules.vtkRenderingCore import (");
  script.line(
    "    vtkActor, vtkColorTransferFunction, vtkLight, vtkProperty, vtkRenderer, vtkVolume)");
  script.line();
  script.line("parts = []  # the data sets");
  script.line("props = []  # what is seen of them");
  script.line();
  script.line();
  script.line("def with_cells(data):");
  script.line("    return mote.vtkMoteLinearCells.Of(mote.vtkMoteStructuredCells.Of(data))");
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
  script.line("        parts.append(with_cells(data))");
  script.line("        return");
  script.line("    leaves = data.NewIterator()");
  script.line("    while not leaves.IsDoneWithTraversal():");
  script.line("        parts.append(with_cells(leaves.GetCurrentDataObject()))");
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
  if (table->GetUseBelowRangeColor())
  {
    script.vector("colors", "SetBelowRangeColor", table->GetBelowRangeColor(), 4);
    script.line("colors.UseBelowRangeColorOn()");
  }
  if (table->GetUseAboveRangeColor())
  {
    script.vector("colors", "SetAboveRangeColor", table->GetAboveRangeColor(), 4);
    script.line("colors.UseAboveRangeColorOn()");
  }
  script.call("colors", "SetVectorMode", table->GetVectorMode());
  script.call("colors", "SetVectorComponent", table->GetVectorComponent());
  script.line("for entry, color in enumerate((");
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i)
    script.line("    (" + python(table->GetTableValue(i), 4) + "),");
  script.line(")):");
  script.line("    colors.SetTableValue(entry, color)");
  script.line();
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

/// What draws a view into the whole picture.
void writeViewFunction(Script& script)
{
  script.line();
  script.line();
  script.line("def view(numbers, caption, left, bottom, width, height):");
  script.line("    renderer.RemoveAllViewProps()");
  script.line("    for number in numbers:");
  script.line("        renderer.AddViewProp(props[number])");
  script.line("    source.SetSize(width, height)");
  script.line("    source.Modified()");
  script.line("    source.Update()");
  script.line("    name.SetInputData(source.GetOutput())");
  script.line("    name.SetCaption(caption)");
  script.line("    name.Update()");
  script.line("    drawn = name.GetOutput().GetPointData().GetScalars()");
  script.line("    if not whole.GetPointData().GetScalars():");
  script.line("        made = drawn.NewInstance()");
  script.line("        made.SetName(drawn.GetName())");
  script.line("        made.SetNumberOfComponents(drawn.GetNumberOfComponents())");
  script.line("        made.SetNumberOfTuples(whole.GetNumberOfPoints())");
  script.line("        whole.GetPointData().SetScalars(made)");
  script.line("    pixels = whole.GetPointData().GetScalars()");
  script.line("    for y in range(height):");
  script.line("        to = (bottom + y) * whole.GetDimensions()[0] + left");
  script.line("        pixels.InsertTuples(to, width, y * width, drawn)");
  script.line();
  script.line();
}

/// Views beside one another, with their names: see Picture.
void writeViews(Script& script, const Stage& stage, const Settings& settings)
{
  const std::array<int, 2>& size = settings.picture.size;
  const auto views = stage.views();
  const SideBySide sides(stage, views.size(), size, true);
  script.line();
  script.line("whole = vtkImageData()");
  script.call("whole", "SetDimensions", size[0], size[1], 1);
  script.line("name = mote.vtkMoteColorLegend()");
  script.line("name.CaptionOnTopOn()");
  script.call("name", "SetFontScale", settings.picture.fontScale);
  writeViewFunction(script);
  const auto view = [&](const std::string& numbers, const std::string& caption, int left,
                      int bottom, int width, int height)
  {
    script.line("view((" + numbers + "), " + python(caption) + ", " + python(left) + ", " +
                python(bottom) + ", " + python(width) + ", " + python(height) + ")");
  };
  const std::vector<vtkProp3D*> written = writtenProps(stage);
  vtkNew<vtkCamera> camera;
  bool isAside = false; // the camera, by now
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    std::string numbers;
    for (vtkProp3D* prop : stage.propsOf(views[i]))
      if (const auto at = std::find(written.begin(), written.end(), prop); at != written.end())
        numbers += std::to_string(at - written.begin()) + ",";
    if (const auto aside = stage.asideOf(views[i]); isAside || aside != std::array<double, 3>())
    {
      moveAside(camera, stage.renderer()->GetActiveCamera(), aside);
      script.vector("camera", "SetPosition", camera->GetPosition());
      script.vector("camera", "SetFocalPoint", camera->GetFocalPoint());
      isAside = true;
    }
    view(
      numbers, stage.viewName(views[i]), sides.left(i), sides.bottom(i), sides.width, sides.height);
  }
  if (sides.legend > 0)
    view("", "", sides.first > 0 ? 0 : sides.right(), 0, sides.legend, size[1]);
  for (auto i = views.size(); i < static_cast<std::size_t>(sides.columns * sides.rows); ++i)
    view("", "", sides.left(i), sides.bottom(i), sides.width, sides.height);
  if (const int below = size[1] - sides.rows * sides.height; below > 0)
    view("", "", sides.first, 0, sides.right() - sides.first, below);
  const Color ink = dividerInk(stage.renderer());
  const auto lines = sides.dividers();
  if (lines.empty())
    return;
  script.line("pixels = whole.GetPointData().GetScalars()");
  script.line("for left, right, bottom, top in (  # the lines between views");
  for (const auto& [left, right, bottom, top] : lines)
    script.line("    (" + python(left) + ", " + python(right) + ", " + python(bottom) + ", " +
                python(top) + "),");
  script.line("):");
  script.line("    for y in range(bottom, top):");
  script.line("        for x in range(left, right):");
  script.line("            for c, ink in enumerate((" + python(ink.data(), 3) + ")):");
  script.line("                pixels.SetComponent(y * " + python(size[0]) + " + x, c, ink)");
}

void writeLegend(
  Script& script, const Stage& stage, const Settings& settings, const std::string& caption)
{
  const PictureSettings& picture = settings.picture;
  const bool isAlone = stage.views().size() < 2;
  script.line("legend = mote.vtkMoteColorLegend()");
  script.line(
    isAlone ? "legend.SetInputConnection(source.GetOutputPort())" : "legend.SetInputData(whole)");
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
  script.call("legend", "SetCaption", picture.caption.value_or(isAlone ? caption : ""));
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
  if (stage.views().size() > 1)
    writeViews(script, stage, settings);
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
