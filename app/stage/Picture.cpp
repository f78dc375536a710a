#include "Picture.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "settings/ErrorBudget.h"

#include <kernels/core/ScratchSpace.h>

#include <vtkLightCollection.h>
#include <vtkLookupTable.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouettes.h>

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

Picture::Picture(Stage& stage, const std::array<int, 2>& size)
  : stage_(stage)
  , size_(size)
{
  source_->SetRenderer(renderer_);
  renderer_->AutomaticLightCreationOff();
  source_->SetSize(size[0], size[1]);
  source_->SetShading(stage.lighting().shading());
  source_->SetSilhouettes(stage.silhouettes());
  legend_->SetInputConnection(source_->GetOutputPort());
}

namespace
{

/// Throws Failure, with the way to one, for the name of a film.
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

} // namespace

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
  writer_->SetInputConnection(labelled_ ? legend_->GetOutputPort() : source_->GetOutputPort());
}

void Picture::takeStage()
{
  vtkRenderer* stage = stage_.renderer();
  renderer_->RemoveAllViewProps();
  for (const auto& part : stage_.parts())
    renderer_->AddViewProp(part->prop());
  renderer_->RemoveAllLights();
  vtkCollectionSimpleIterator next;
  stage->GetLights()->InitTraversal(next);
  while (vtkLight* light = stage->GetLights()->GetNextLight(next))
    renderer_->AddLight(light);
  renderer_->SetActiveCamera(stage->GetActiveCamera());
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
  source_->SetDepth(exr_);
  source_->SetNormals(exr_);
  source_->SetIds(exr_);
  source_->SetVariance(exr_ && shares.noise);
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
  if (labelled_ && picture.legend && stage_.coloring().legendTable())
    (picture.legendSide == "left" ? margins.left : margins.right) += 0.13 * size_[1] / size_[0];
  if (labelled_)
    margins.bottom += 0.03;
  return margins;
}

void Picture::write(const std::string& caption, ProgressRelay& progress)
{
  this->draw(caption, progress);
  if (!writer_->Write())
    throw Failure(writer_->GetErrorMessage());
}

vtkImageData* Picture::draw(const std::string& caption, ProgressRelay& progress)
{
  this->takeStage();
  this->takeSettings();
  legend_->SetCaption(stage_.settings().picture.caption.value_or(caption));
  Messages::takeError();
  source_->Modified(); // parts and camera may have changed
  try
  {
    {
      ProgressRelay::Work work(progress, "Tracing", source_);
      source_->Update();
      work.finish();
    }
    if (const std::string error = Messages::takeError(); error == std::bad_alloc().what())
      throw std::bad_alloc(); // VTK's pipeline lets no exception through
    else if (!error.empty())
      throw Failure(error);
    if (!labelled_)
      return source_->GetOutput();
    legend_->Update();
    return legend_->GetOutput();
  }
  catch (const std::bad_alloc&)
  {
    throw Failure("there is not enough memory: " + this->needs());
  }
}

std::string Picture::quality() const
{
  std::string text = counted(source_->GetNumberOfSamples(), "sample") + " per pixel";
  if (stage_.settings().picture.noise)
    text += ", noise " + asNumber(source_->GetNoise(), 3);
  if (isColorError(stage_.settings().picture))
    text += ", expected error " + stage_.expectedErrorText(source_->GetNoise());
  return text;
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
