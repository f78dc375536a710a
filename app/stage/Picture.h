#pragma once

#include "ParticlePaths.h"
#include "Stage.h"
#include "base/ProgressRelay.h"

#include <vtkCamera.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteImageMarks.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteRendererSource.h>
#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTrivialProducer.h>

#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

struct SideBySide;

/// Side, numbers and letters of a legend as the settings say.
void applyLook(vtkMoteColorLegend* legend, const PictureSettings& look);

/// The colours of a picture in eight bits each, without alpha: backgrounds are opaque.
vtkSmartPointer<vtkImageData> inBytes(vtkImageData* image);

/// Throws Failure, with the way to one, for the name of a film.
void refuseFilm(const std::string& file);

/// The pipeline from a stage to a picture file, without a window: that of `mote render`, and of the
/// window's saved pictures.
class Picture
{
public:
  /// Of the size in pixels that the stage's settings have, or of this one.
  Picture(Stage& stage, const std::array<int, 2>& size);

  /// Throws Failure if the file could not be written, as far as can be told beforehand.
  void aim(const std::string& file);

  /// Whether legend and caption are drawn: not in an EXR, which is for further work.
  bool labelled() const { return labelled_; }

  /// Room for the legend at its side and for the caption below.
  Margins margins();

  /// Of the picture, or of each view in it: width to height.
  double aspect() const;

  /// Traces and writes. `caption` stands where the settings have none. Throws Failure and
  /// Interrupted.
  void write(const std::string& caption, ProgressRelay& progress);

  /// Writes what was drawn last to the file that was aimed at. Throws Failure.
  void save();

  /// Traces, and returns the image with what is drawn over it, which is the picture's own. As
  /// write() else.
  vtkImageData* draw(const std::string& caption, ProgressRelay& progress);

  /// A factor on how thick silhouettes are. Default 1.
  void setLineScale(double scale) { lineScale_ = scale; }

  /// Draws these paths, and marks what is picked by the settings or else this; kept by the caller.
  void setPaths(const ParticlePaths* paths) { paths_ = paths; }
  void setPicked(const std::vector<std::string>& words) { picked_ = words; }

  double traceTime() const { return traceTime_; }

  /// "16 samples per pixel", and with --noise what came of it.
  std::string quality() const;

private:
  using View = std::vector<std::size_t>; ///< numbers of the stage's parts
  void takeStage(const View& view);
  void takeSettings();
  vtkImageData* trace(const View& view, const std::array<int, 2>& size, ProgressRelay& progress);
  vtkSmartPointer<vtkImageData> traceAll(const std::vector<View>& views, ProgressRelay& progress);
  vtkImageData* marked(const View& view, const std::array<int, 2>& size);
  bool hasMarks() const;
  void paste(vtkImageData* from, int x, int bottom, vtkImageData* to) const;
  void drawDividers(const SideBySide& sides, vtkImageData* image) const;
  void requireMemory() const;
  double bytes() const;
  std::string needs() const;

  Stage& stage_;
  std::array<int, 2> size_;
  vtkNew<vtkRenderer> renderer_; ///< of the stage's data alone, without what a window adds
  vtkNew<vtkCamera> camera_;     ///< of views of what lies elsewhere
  vtkNew<vtkMoteRendererSource> source_;
  vtkNew<vtkTrivialProducer> traced_; ///< the image, of one view or of several
  vtkNew<vtkMoteColorLegend> legend_, name_;
  vtkNew<vtkMoteImageMarks> marks_;
  vtkNew<vtkMoteSilhouettes> lines_; ///< instead of those of the stage, where they are scaled
  double lineScale_ = 1.0;
  vtkNew<vtkMoteImageWriter> writer_;
  const ParticlePaths* paths_ = nullptr;
  std::optional<std::vector<std::string>> picked_; ///< else the settings'
  bool labelled_ = true;
  bool exr_ = false;
  double traceTime_ = 0.0; ///< s
  int samples_ = 0;
  double noise_ = 0.0;
};

} // namespace mote::app
