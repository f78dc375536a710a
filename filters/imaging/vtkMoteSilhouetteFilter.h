/**
 * @class   vtkMoteSilhouetteFilter
 * @brief   Finds silhouettes in a depth image, by steps of the depth.
 *
 * The input is a vtkImageData with an array of depths, such as vtkMoteRendererSource makes and
 * vtkMoteImageReader reads; each slice is an image by itself. The output has the float array
 * `silhouettes`, the share of each pixel that the lines cover, in [0, 1], as its scalars; or, with
 * OutputMode OVERLAY, the float RGBA array `color` (premultiplied): the lines drawn over the
 * input's colours, or over nothing where it has none.
 *
 * A silhouette stands where the 3x3 Laplacian (8 at the centre, -1 around) of ray distances says
 * that a pixel is farther than its neighbours by more than the threshold (mote::findSilhouettes, in
 * kernels/imaging/Silhouettes.h, has the rule). Only the farther pixel has it, so no line is
 * double. Depths that are not finite, or not below BackgroundDepth, are background; surfaces have
 * one line against it.
 *
 * The result does not depend on how the image is divided, into threads or pieces.
 *
 * Errors: no image, no depth or group array, arrays of several components or without numbers. Each
 * is reported by vtkErrorMacro as one sentence and kept in GetErrorMessage(); the output is empty
 * then.
 *
 * Source: Bigler, "Use of Silhouette Edges and Ambient Occlusion in Particle Visualization",
 * University of Utah 2004; docs/silhouettes.md.
 */

#ifndef vtkMoteSilhouetteFilter_h
#define vtkMoteSilhouetteFilter_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkThreadedImageAlgorithm.h"

#include <memory> // for what one run needs
#include <string> // for attributes

namespace mote
{
struct SilhouetteOptions;
}

class MOTEFILTERSIMAGING_EXPORT vtkMoteSilhouetteFilter : public vtkThreadedImageAlgorithm
{
public:
  static vtkMoteSilhouetteFilter* New();
  vtkTypeMacro(vtkMoteSilhouetteFilter, vtkThreadedImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The point array of depths: one number of any type a pixel, in world units. Empty, the default:
   * `depth`, or, without one, the active scalars.
   */
  vtkSetMacro(DepthArrayName, std::string);
  vtkGetMacro(DepthArrayName, std::string);
  ///@}

  ///@{
  /**
   * Point array with one number a pixel, such as `object`, `particle` or a material: a silhouette
   * stands also where it changes between two surfaces. Default: none.
   */
  vtkSetMacro(GroupArrayName, std::string);
  vtkGetMacro(GroupArrayName, std::string);
  ///@}

  enum DepthModes
  {
    ALONG_AXIS,
    ALONG_RAYS,
    ORTHOGRAPHIC
  };
  ///@{
  /**
   * What depths are: distances along the view axis of a perspective view (default), distances along
   * its rays, or distances in an orthographic view.
   */
  vtkSetClampMacro(DepthMode, int, ALONG_AXIS, ORTHOGRAPHIC);
  vtkGetMacro(DepthMode, int);
  void SetDepthModeToAlongAxis() { this->SetDepthMode(ALONG_AXIS); }
  void SetDepthModeToAlongRays() { this->SetDepthMode(ALONG_RAYS); }
  void SetDepthModeToOrthographic() { this->SetDepthMode(ORTHOGRAPHIC); }
  ///@}

  ///@{
  /**
   * Of perspective views: the angle that the whole image spans from bottom to top, in degrees, in
   * [1e-8, 179]. Default 30, as vtkCamera's.
   */
  vtkSetClampMacro(ViewAngle, double, 1e-8, 179.0);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * Of orthographic views: half the height of the whole image in world units, as vtkCamera's.
   * Default 0: not known, and StepInPixels means nothing.
   */
  vtkSetClampMacro(ParallelScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ParallelScale, double);
  ///@}

  ///@{
  /**
   * Depths from here on are background, for programs that write a large number there. Default
   * infinity.
   */
  vtkSetMacro(BackgroundDepth, double);
  vtkGetMacro(BackgroundDepth, double);
  ///@}

  enum ThresholdModes
  {
    WORLD,
    RADII,
    SCENE_SIZE
  };
  ///@{
  /**
   * The least step of depth that is a silhouette, in the unit that ThresholdMode says: world units,
   * particle radii (ParticleRadius), or shares of the scene's size (SceneSize). Not less than 0.
   * Default 0.01 of the scene's size. In world units it is the same at every zoom.
   */
  vtkSetClampMacro(Threshold, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Threshold, double);
  vtkSetClampMacro(ThresholdMode, int, WORLD, SCENE_SIZE);
  vtkGetMacro(ThresholdMode, int);
  void SetThresholdModeToWorld() { this->SetThresholdMode(WORLD); }
  void SetThresholdModeToRadii() { this->SetThresholdMode(RADII); }
  void SetThresholdModeToSceneSize() { this->SetThresholdMode(SCENE_SIZE); }
  ///@}

  ///@{
  /**
   * World units that a threshold of 1 means by RADII. Default 1.
   */
  vtkSetClampMacro(ParticleRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ParticleRadius, double);
  ///@}

  ///@{
  /**
   * World units that a threshold of 1 means by SCENE_SIZE. Default 0: the diagonal of the box,
   * along the image's edges and the view axis, around all the surfaces that the image shows. That
   * changes with the view; programs that know their scene's size give it.
   */
  vtkSetClampMacro(SceneSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SceneSize, double);
  ///@}

  ///@{
  /**
   * No step is a silhouette that is less than the width of so many pixels at its distance, whatever
   * the threshold: relief finer than pixels has no outlines. 0: off. Default 2.
   */
  vtkSetClampMacro(StepInPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(StepInPixels, double);
  ///@}

  ///@{
  /**
   * Whether surfaces have silhouettes against the background. Default on.
   */
  vtkSetMacro(Hulls, vtkTypeBool);
  vtkGetMacro(Hulls, vtkTypeBool);
  vtkBooleanMacro(Hulls, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Width of the lines in pixels of the output, in [0, 100]: Thickness that of the strongest
   * silhouettes, default 1, and LeastThickness that of the weakest; 0, the default: all alike.
   */
  vtkSetClampMacro(Thickness, double, 0.0, 100.0);
  vtkGetMacro(Thickness, double);
  vtkSetClampMacro(LeastThickness, double, 0.0, 100.0);
  vtkGetMacro(LeastThickness, double);
  ///@}

  ///@{
  /**
   * Grey levels: opacity of the weakest silhouettes, in [0, 1]. Default 1: all alike.
   */
  vtkSetClampMacro(LeastOpacity, double, 0.0, 1.0);
  vtkGetMacro(LeastOpacity, double);
  ///@}

  ///@{
  /**
   * Multiples of the threshold, from which on a silhouette is as strong as silhouettes get; weaker
   * ones follow the step's logarithm. Above 1, default 8. Silhouettes of hulls and groups are
   * always strong.
   */
  vtkSetClampMacro(FullStep, double, 1.0001, VTK_DOUBLE_MAX);
  vtkGetMacro(FullStep, double);
  ///@}

  ///@{
  /**
   * Whether a line's middle is on the border between two pixels, and covers both by halves, which
   * is where the outline is on average; or on the farther pixel, as published, which is crisper and
   * half a pixel outside. Default on.
   */
  vtkSetMacro(Centered, vtkTypeBool);
  vtkGetMacro(Centered, vtkTypeBool);
  vtkBooleanMacro(Centered, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Smooth silhouettes from a depth image of higher resolution: the output has one pixel for a
   * square of so many along each side, and is their mean. In [1, 64], default 1.
   */
  vtkSetClampMacro(ReductionFactor, int, 1, 64);
  vtkGetMacro(ReductionFactor, int);
  ///@}

  enum OutputModes
  {
    SILHOUETTES,
    OVERLAY
  };
  ///@{
  /**
   * The silhouettes alone (default), or drawn over the colours.
   */
  vtkSetClampMacro(OutputMode, int, SILHOUETTES, OVERLAY);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToSilhouettes() { this->SetOutputMode(SILHOUETTES); }
  void SetOutputModeToOverlay() { this->SetOutputMode(OVERLAY); }
  ///@}

  ///@{
  /**
   * Of OVERLAY: the point array of colours, one to four components (grey, with alpha, RGB, RGBA
   * premultiplied), floats in [0, 1] or bytes. Default "color".
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  ///@}

  ///@{
  /**
   * Of OVERLAY: the lines' colour, as shown on a screen. Default black.
   */
  vtkSetVector3Macro(EdgeColor, double);
  vtkGetVector3Macro(EdgeColor, double);
  ///@}

  /**
   * The step in world units that the last update took for a silhouette; 0 before.
   */
  double GetStep() const { return this->Step; }

  /**
   * Why the last update failed, as one sentence; empty if it did not.
   */
  std::string GetErrorMessage() const { return this->ErrorMessage; }

  void ThreadedRequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, vtkImageData*** inData, vtkImageData** outData,
    int extent[6], int threadId) override;

protected:
  vtkMoteSilhouetteFilter();
  ~vtkMoteSilhouetteFilter() override;

  int RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void CopyAttributeData(
    vtkImageData* input, vtkImageData* output, vtkInformationVector** inputVector) override;

  std::string DepthArrayName;
  std::string GroupArrayName;
  std::string ColorArrayName = "color";
  int DepthMode = ALONG_AXIS;
  double ViewAngle = 30.0;
  double ParallelScale = 0.0;
  double BackgroundDepth = VTK_DOUBLE_MAX;
  double Threshold = 0.01;
  int ThresholdMode = SCENE_SIZE;
  double ParticleRadius = 1.0;
  double SceneSize = 0.0;
  double StepInPixels = 2.0;
  vtkTypeBool Hulls = 1;
  double Thickness = 1.0;
  double LeastThickness = 0.0;
  double LeastOpacity = 1.0;
  double FullStep = 8.0;
  vtkTypeBool Centered = 1;
  int ReductionFactor = 1;
  int OutputMode = SILHOUETTES;
  double EdgeColor[3] = {0.0, 0.0, 0.0};

private:
  vtkMoteSilhouetteFilter(const vtkMoteSilhouetteFilter&) = delete;
  void operator=(const vtkMoteSilhouetteFilter&) = delete;

  struct Run;

  mote::SilhouetteOptions MakeOptions() const;
  void Describe(Run& run, vtkImageData* image, vtkInformation* information);

  std::unique_ptr<Run> Present; // what the threads share, while data are requested
  std::string ErrorMessage;
  double Step = 0.0;
};

#endif
