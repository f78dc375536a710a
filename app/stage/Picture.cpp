#include "Picture.h"

#include "Framing.h"
#include "PictureMarks.h"
#include "SideBySide.h"
#include "Silhouettes.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "settings/ErrorBudget.h"

#include <kernels/core/MemoryLimit.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkLookupTable.h>
#include <vtkMoteShading.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <new>

namespace mote::app
{

void applyLook(vtkMoteColorLegend* legend, const PictureSettings& look)
{
  legend->SetSide(look.legendSide == "left" ? vtkMoteColorLegend::LEFT : vtkMoteColorLegend::RIGHT);
  legend->SetLabelFormat(look.legendFormat);
  legend->SetFontScale(look.fontScale);
}

vtkSmartPointer<vtkImageData> inBytes(vtkImageData* image)
{
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(image->GetDimensions());
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkDataArray* colors = image->GetPointData()->GetArray("color");
  const auto* from = static_cast<const float*>(colors->GetVoidPointer(0));
  auto* to = static_cast<unsigned char*>(bytes->GetScalarPointer());
  const int components = colors->GetNumberOfComponents();
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
    for (int c = 0; c < 3; ++c)
      to[3 * i + c] = static_cast<unsigned char>(
        255.0f * std::clamp(from[components * i + c], 0.0f, 1.0f) + 0.5f);
  return bytes;
}

Picture::Picture(Stage& stage, const std::array<int, 2>& size)
  : stage_(stage)
  , size_(size)
{
  source_->SetRenderer(renderer_);
  renderer_->AutomaticLightCreationOff();
  source_->SetSize(size[0], size[1]);
  source_->SetShading(stage.lighting().shading());
  source_->SetSilhouettes(stage.silhouettes());
  legend_->SetInputConnection(traced_->GetOutputPort());
  name_->CaptionOnTopOn();
}

double Picture::aspect() const
{
  const auto views = stage_.views();
  const SideBySide sides(stage_, views.size(), size_, labelled_ && views.size() > 1);
  return double(sides.width) / sides.height;
}

void refuseFilm(const std::string& file)
{
  const std::string ending = lowerCase(std::filesystem::path(file).extension().string());
  for (const char* film : {".mp4", ".avi", ".mov", ".mkv", ".webm", ".gif", ".ogv", ".mpg", ".m4v"})
    if (ending == film)
      throw Failure(
        "mote render writes pictures, and no films such as " + file +
        "; those are written by: mote animate FILE -o " +
        (ending == std::string(".mpg") || ending == std::string(".m4v") ? "film.ogv" : file));
}

void Picture::aim(const std::string& file)
{
  refuseFilm(file);
  writer_->SetFileName(file.c_str());
  if (!writer_->CheckFileName())
    throw Failure(writer_->GetErrorMessage());
  checkOutput(file, stage_.settings().data.files);
  exr_ = lowerCase(std::filesystem::path(file).extension().string()) == ".exr";
  // An EXR is for further work: everything there is, and nothing drawn over it.
  labelled_ = !exr_;
  this->requireMemory();
  writer_->SetInputConnection(labelled_ ? legend_->GetOutputPort() : traced_->GetOutputPort());
}

void Picture::takeStage(const View& view)
{
  vtkRenderer* stage = stage_.renderer();
  renderer_->RemoveAllViewProps();
  for (vtkProp* prop : stage_.propsOf(view))
    renderer_->AddViewProp(prop);
  renderer_->RemoveAllLights();
  vtkCollectionSimpleIterator next;
  stage->GetLights()->InitTraversal(next);
  while (vtkLight* light = stage->GetLights()->GetNextLight(next))
    renderer_->AddLight(light);
  renderer_->SetActiveCamera(stage->GetActiveCamera());
  if (const auto aside = stage_.asideOf(view); aside != std::array<double, 3>())
  {
    moveAside(camera_, stage->GetActiveCamera(), aside);
    renderer_->SetActiveCamera(camera_);
    renderer_->ResetCameraClippingRange();
  }
  renderer_->SetBackground(stage->GetBackground());
  renderer_->SetBackground2(stage->GetBackground2());
  renderer_->SetGradientBackground(stage->GetGradientBackground());
}

void Picture::takeSettings()
{
  const Settings& settings = stage_.settings();
  const PictureSettings& picture = settings.picture;
  source_->SetSamplesPerPixel(picture.mostSamples(settings.light.pathTrace));
  const ErrorShares shares = errorShares(settings);
  source_->SetNoiseLevel(shares.noise.value_or(0.0));
  source_->SetDepth(exr_ || this->hasMarks());
  source_->SetNormals(exr_);
  source_->SetIds(exr_);
  source_->SetVariance(exr_ && shares.noise);
  if (lineScale_ != 1.0)
  {
    choose(scaled(settings.silhouettes, lineScale_), vtkMoteSilhouettes::RADII, lines_);
    source_->SetSilhouettes(lines_);
  }
  source_->SetSilhouetteCoverage(exr_ && stage_.silhouettes()->GetEnabled());
  source_->SetTransparentBackground(exr_);
  legend_->SetLookupTable(picture.legend ? stage_.coloring().legendTable() : nullptr);
  legend_->SetTitle(picture.title.value_or(stage_.coloring().title()));
  applyLook(legend_, picture);
}

Margins Picture::margins()
{
  Margins margins;
  const PictureSettings& picture = stage_.settings().picture;
  const bool isAlone = stage_.views().size() == 1; // else the legend has a strip of its own
  if (labelled_ && isAlone && picture.legend && stage_.coloring().legendTable())
    (picture.legendSide == "left" ? margins.left : margins.right) += 0.13 * size_[1] / size_[0];
  if (labelled_)
    (isAlone ? margins.bottom : margins.top) += 0.03;
  return margins;
}

void Picture::write(const std::string& caption, ProgressRelay& progress)
{
  this->draw(caption, progress);
  this->save();
}

void Picture::save()
{
  if (!writer_->Write())
    throw Failure(writer_->GetErrorMessage());
}

vtkImageData* Picture::draw(const std::string& caption, ProgressRelay& progress)
{
  const auto views = stage_.views();
  const bool isAlone = views.size() == 1;
  this->takeSettings();
  // Views beside one another have names in its place.
  legend_->SetCaption(stage_.settings().picture.caption.value_or(isAlone ? caption : ""));
  Messages::takeError();
  traceTime_ = noise_ = 0.0;
  samples_ = 0;
  try
  {
    if (isAlone)
      traced_->SetOutput(this->trace(views.front(), size_, progress));
    else
      traced_->SetOutput(this->traceAll(views, progress));
    if (!labelled_)
      return vtkImageData::SafeDownCast(traced_->GetOutputDataObject(0));
    legend_->Update();
    return legend_->GetOutput();
  }
  catch (const std::bad_alloc&)
  {
    throw Failure("there is not enough memory: " + this->needs());
  }
}

vtkImageData* Picture::trace(
  const View& view, const std::array<int, 2>& size, ProgressRelay& progress)
{
  this->takeStage(view);
  source_->SetSize(size[0], size[1]);
  source_->Modified(); // parts and camera may have changed
  {
    ProgressRelay::Work work(progress, "Tracing", source_);
    source_->Update();
    work.finish();
  }
  Messages::throwError();
  traceTime_ += source_->GetTraceTime();
  samples_ = std::max(samples_, source_->GetNumberOfSamples());
  noise_ = std::max(noise_, source_->GetNoise());
  return this->marked(view, size);
}

bool Picture::hasMarks() const
{
  const bool isPicked = !picked_.value_or(stage_.settings().marks.picked).empty();
  return labelled_ && (isPicked || paths_);
}

/// What was traced, with what is marked in it.
vtkImageData* Picture::marked(const View& view, const std::array<int, 2>& size)
{
  if (!this->hasMarks() || view.empty())
    return source_->GetOutput();
  PictureMarks marks(renderer_->GetActiveCamera(), size, marks_);
  if (paths_)
  {
    vtkNew<vtkPolyData> lines;
    paths_->fill(lines, view);
    marks.addPaths(lines);
  }
  PickedSet picked;
  picked.addNamed(stage_.parts(), picked_.value_or(stage_.settings().marks.picked));
  marks.addPicked(stage_.parts(), picked, view);
  marks_->SetInputConnection(source_->GetOutputPort());
  marks_->Update();
  return marks_->GetOutput();
}

/// Views beside one another, with their names, and the background below the legend.
vtkSmartPointer<vtkImageData> Picture::traceAll(
  const std::vector<View>& views, ProgressRelay& progress)
{
  const SideBySide sides(stage_, views.size(), size_, labelled_);
  auto whole = vtkSmartPointer<vtkImageData>::New();
  whole->SetDimensions(size_[0], size_[1], 1);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    name_->SetInputData(this->trace(views[i], {sides.width, sides.height}, progress));
    name_->SetCaption(labelled_ ? stage_.viewName(views[i]) : "");
    name_->SetFontScale(stage_.settings().picture.fontScale);
    name_->Update();
    this->paste(name_->GetOutput(), sides.left(i), sides.bottom(i), whole);
  }
  // The background where no view is.
  if (sides.legend > 0)
    this->paste(this->trace({}, {sides.legend, size_[1]}, progress),
      sides.first > 0 ? 0 : sides.right(), 0, whole);
  for (auto i = views.size(); i < static_cast<std::size_t>(sides.columns * sides.rows); ++i)
    this->paste(this->trace({}, {sides.width, sides.height}, progress), sides.left(i),
      sides.bottom(i), whole);
  if (const int below = size_[1] - sides.rows * sides.height; below > 0)
    this->paste(
      this->trace({}, {sides.right() - sides.first, below}, progress), sides.first, 0, whole);
  if (labelled_)
    this->drawDividers(sides, whole);
  name_->SetInputData(nullptr);
  return whole;
}

/// Puts an image there, with all its arrays.
void Picture::paste(vtkImageData* from, int x, int bottom, vtkImageData* to) const
{
  const int width = from->GetDimensions()[0], height = from->GetDimensions()[1];
  for (int a = 0; a < from->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* part = from->GetPointData()->GetArray(a);
    vtkDataArray* all = to->GetPointData()->GetArray(part->GetName());
    if (!all)
    {
      const auto made = vtk::TakeSmartPointer(part->NewInstance());
      made->SetName(part->GetName());
      made->SetNumberOfComponents(part->GetNumberOfComponents());
      made->SetNumberOfTuples(to->GetNumberOfPoints());
      to->GetPointData()->AddArray(made);
      if (part == from->GetPointData()->GetScalars())
        to->GetPointData()->SetScalars(made);
      all = made;
    }
    for (int y = 0; y < height; ++y)
      all->InsertTuples(static_cast<vtkIdType>(bottom + y) * size_[0] + x, width,
        static_cast<vtkIdType>(y) * width, part);
  }
}

/// Lines between columns and rows of views.
void Picture::drawDividers(const SideBySide& sides, vtkImageData* image) const
{
  const Color ink = dividerInk(renderer_);
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  for (const auto& [left, right, bottom, top] : sides.dividers())
    for (int y = bottom; y < top; ++y)
      for (int x = left; x < right; ++x)
        for (int c = 0; c < 3; ++c)
          colors->SetComponent(
            static_cast<vtkIdType>(y) * size_[0] + x, c, ink[static_cast<std::size_t>(c)]);
}

std::string Picture::quality() const
{
  std::string text = counted(samples_, "sample") + " per pixel";
  if (stage_.settings().picture.noise)
    text += ", noise " + asNumber(noise_, 3);
  return text + stage_.errorText(1.0, noise_);
}

/// Throws Failure for a picture that the machine has no memory for.
void Picture::requireMemory() const
{
  const auto there = static_cast<double>(physicalMemory());
  if (this->bytes() > there)
    throw Failure(this->needs() + ", and this machine has " + asBytes(there));
}

/// About what a picture takes: colour and depth, twice over with the legend, and in an EXR's
/// layers normals, ids, variance and edges.
double Picture::bytes() const
{
  return (labelled_ ? 60.0 : 130.0) * size_[0] * size_[1];
}

std::string Picture::needs() const
{
  return "a picture of " + std::to_string(size_[0]) + "x" + std::to_string(size_[1]) +
         " pixels needs about " + asBytes(this->bytes());
}

} // namespace mote::app
