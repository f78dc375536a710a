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
 * What is drawn where, and how, a vtkMoteSilhouettes says. Its thicknesses are in pixels of the
 * output. mote::findSilhouettes() (kernels/imaging/Silhouettes.h) has the rule. Depths that are not
 * finite, or not below BackgroundDepth, are background.
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
#include "vtkSmartPointer.h"          // for Silhouettes
#include "vtkThreadedImageAlgorithm.h"

#include <memory> // for what one run needs
#include <string> // for attributes

class vtkMoteSilhouettes;

class MOTEFILTERSIMAGING_EXPORT vtkMoteSilhouetteFilter : public vtkThreadedImageAlgorithm
{
public:
  static vtkMoteSilhouetteFilter* New();
  vtkTypeMacro(vtkMoteSilhouetteFilter, vtkThreadedImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The point array of depths: one number of any type a pixel, in world units. Empty, the default:
   * `depth`, or, without one, the active scalars.
   */
  vtkSetMacro(DepthArrayName, std::string);
  vtkGetMacro(DepthArrayName, std::string);
  //@}

  //@{
  /**
   * What is drawn: see there. To begin with there is one object of its own, which is Enabled and
   * has a threshold of 0.01 of the scene's size; null is none. GroupArrayName is an array of the
   * image, such as `object`, `particle` or a material.
   */
  void SetSilhouettes(vtkMoteSilhouettes* silhouettes);
  vtkMoteSilhouettes* GetSilhouettes();
  //@}

  enum DepthModes
  {
    ALONG_AXIS,
    ALONG_RAYS,
    ORTHOGRAPHIC
  };
  //@{
  /**
   * What depths are: distances along the view axis of a perspective view (default), distances along
   * its rays, or distances in an orthographic view.
   */
  vtkSetClampMacro(DepthMode, int, ALONG_AXIS, ORTHOGRAPHIC);
  vtkGetMacro(DepthMode, int);
  void SetDepthModeToAlongAxis() { this->SetDepthMode(ALONG_AXIS); }
  void SetDepthModeToAlongRays() { this->SetDepthMode(ALONG_RAYS); }
  void SetDepthModeToOrthographic() { this->SetDepthMode(ORTHOGRAPHIC); }
  //@}

  //@{
  /**
   * Of perspective views: the angle that the whole image spans from bottom to top, in degrees, in
   * [1e-8, 179]. Default 30, as vtkCamera's.
   */
  vtkSetClampMacro(ViewAngle, double, 1e-8, 179.0);
  vtkGetMacro(ViewAngle, double);
  //@}

  //@{
  /**
   * Of orthographic views: half the height of the whole image in world units, as vtkCamera's.
   * Default 0: not known, and StepInPixels of Silhouettes means nothing.
   */
  vtkSetClampMacro(ParallelScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ParallelScale, double);
  //@}

  //@{
  /**
   * Depths from here on are background, for programs that write a large number there. Default
   * infinity.
   */
  vtkSetMacro(BackgroundDepth, double);
  vtkGetMacro(BackgroundDepth, double);
  //@}

  //@{
  /**
   * World units that a threshold of 1 means by RADII. Default 1.
   */
  vtkSetClampMacro(ParticleRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ParticleRadius, double);
  //@}

  //@{
  /**
   * World units that a threshold of 1 means by SCENE_SIZE. Default 0: the diagonal of the box,
   * along the image's edges and the view axis, around all the surfaces that the image shows. That
   * changes with the view; programs that know their scene's size give it.
   */
  vtkSetClampMacro(SceneSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SceneSize, double);
  //@}

  //@{
  /**
   * Smooth lines from a depth image of higher resolution: the output has one pixel for a
   * square of so many along each side, and is their mean. In [1, 64], default 1.
   */
  vtkSetClampMacro(ReductionFactor, int, 1, 64);
  vtkGetMacro(ReductionFactor, int);
  //@}

  enum OutputModes
  {
    SILHOUETTES,
    OVERLAY
  };
  //@{
  /**
   * The silhouettes alone (default), or drawn over the colours.
   */
  vtkSetClampMacro(OutputMode, int, SILHOUETTES, OVERLAY);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToSilhouettes() { this->SetOutputMode(SILHOUETTES); }
  void SetOutputModeToOverlay() { this->SetOutputMode(OVERLAY); }
  //@}

  //@{
  /**
   * Of OVERLAY: the point array of colours, one to four components (grey, with alpha, RGB, RGBA
   * premultiplied), floats in [0, 1] or bytes. Default "color".
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  //@}

  /**
   * The threshold of the last update in world units; 0 before.
   */
  double GetStep() const { return this->Step; }

  /**
   * Why the last update failed, as one sentence; empty if it did not.
   */
  std::string GetErrorMessage() const { return this->ErrorMessage; }

  vtkMTimeType GetMTime() override;

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

  vtkSmartPointer<vtkMoteSilhouettes> Silhouettes;
  std::string DepthArrayName;
  std::string ColorArrayName = "color";
  int DepthMode = ALONG_AXIS;
  double ViewAngle = 30.0;
  double ParallelScale = 0.0;
  double BackgroundDepth = VTK_DOUBLE_MAX;
  double ParticleRadius = 1.0;
  double SceneSize = 0.0;
  int ReductionFactor = 1;
  int OutputMode = SILHOUETTES;

private:
  vtkMoteSilhouetteFilter(const vtkMoteSilhouetteFilter&) = delete;
  void operator=(const vtkMoteSilhouetteFilter&) = delete;

  struct Run;

  void Describe(Run& run, vtkImageData* image, vtkInformation* information);

  std::unique_ptr<Run> Present; // what the threads share, while data are requested
  std::string ErrorMessage;
  double Step = 0.0;
};

#endif
