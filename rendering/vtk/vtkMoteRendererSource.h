/**
 * @class   vtkMoteRendererSource
 * @brief   An image of the Mote props of a renderer, traced without OpenGL and without a display.
 *
 * The renderer needs no window. Its camera, lights, background (also a gradient) and those of its
 * actors and volumes that have a Mote mapper are used; other props need OpenGL and are left out
 * (with one warning, counted by GetNumberOfIgnoredProps()). The camera's clipping range is set to
 * enclose the props, as a window would do, where ResetClippingRange is on.
 *
 * The output is a vtkImageData whose row 0 is the bottom row, with the point arrays
 *  - `color`: float RGBA in [0, 1], the active scalars: over the background with alpha 1, or, with
 *    TransparentBackground on, premultiplied by an alpha that is the covered share of the pixel;
 *  - `depth` (Depth on): float, distance along the view axis in world units, infinity if nothing;
 *  - `normal` (Normals on): float x y z, unit length in world coordinates, 0 0 0 if nothing;
 *  - `variance` (Variance on): float, of one sample of the pixel, the mean over the channels of the
 *    premultiplied colour; 0 with one sample;
 *  - `particle` (Ids on): 64-bit index of the particle, or of an iso-surface's cell, in its
 * mapper's input, -1 if nothing;
 *  - `object` (Ids on): 32-bit place of its prop among the Mote props traced, those with particles
 *    first, then volumes; -1 if nothing.
 *  - `silhouettes` (SilhouetteCoverage on): float, the share of the pixel that the lines of
 *    Silhouettes cover, in [0, 1]; 0 where these are not Enabled. They are in `color` already.
 *
 * Clouds have colour and nothing else.
 */

#ifndef vtkMoteRendererSource_h
#define vtkMoteRendererSource_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for Renderer, Shading, Silhouettes

#include <memory> // for lists of props
#include <vector>

class vtkMoteShading;
class vtkMoteSilhouettes;
class vtkRenderer;

namespace mote
{
class FrameTracer;
class MoteProp;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteRendererSource : public vtkImageAlgorithm
{
public:
  static vtkMoteRendererSource* New();
  vtkTypeMacro(vtkMoteRendererSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The renderer to trace. Required.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  //@}

  //@{
  /**
   * Width and height in pixels, in [1, 65536] each. Default 1024 by 1024.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  //@}

  //@{
  /**
   * Rays a pixel, in [1, 65536]. Default 16. Depth, normals and ids belong to the pixel's centre.
   */
  vtkSetClampMacro(SamplesPerPixel, int, 1, 65536);
  vtkGetMacro(SamplesPerPixel, int);
  //@}

  //@{
  /**
   * Noise at which a picture is good enough although it has not yet SamplesPerPixel: its standard
   * error, the root mean square over covered pixels and channels of what the mean of a pixel's
   * samples may err by, in units of colours from 0 to 1. 0.01 is smooth to the eye. It is judged
   * from the fourth sample on. Default 0: all samples are taken, and nothing is judged.
   */
  vtkSetClampMacro(NoiseLevel, double, 0.0, 1.0);
  vtkGetMacro(NoiseLevel, double);
  //@}

  //@{
  /**
   * Threads to trace with; 0, the default, for all.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * How rays find light on what is drawn: see there. There is one of its own to begin with; null
   * is the same as a new one.
   */
  void SetShading(vtkMoteShading* shading);
  vtkMoteShading* GetShading();
  //@}

  //@{
  /**
   * Silhouettes on what is drawn: see there. To begin with there is one object of its own, which is
   * not Enabled; null is none. They are found in the depths of each of a pixel's rays, and smoothed
   * with them.
   */
  void SetSilhouettes(vtkMoteSilhouettes* silhouettes);
  vtkMoteSilhouettes* GetSilhouettes();
  //@}

  //@{
  /**
   * Which arrays to make besides `color`. All off by default.
   */
  vtkSetMacro(Depth, vtkTypeBool);
  vtkGetMacro(Depth, vtkTypeBool);
  vtkBooleanMacro(Depth, vtkTypeBool);
  vtkSetMacro(Normals, vtkTypeBool);
  vtkGetMacro(Normals, vtkTypeBool);
  vtkBooleanMacro(Normals, vtkTypeBool);
  vtkSetMacro(Variance, vtkTypeBool);
  vtkGetMacro(Variance, vtkTypeBool);
  vtkBooleanMacro(Variance, vtkTypeBool);
  vtkSetMacro(Ids, vtkTypeBool);
  vtkGetMacro(Ids, vtkTypeBool);
  vtkBooleanMacro(Ids, vtkTypeBool);
  vtkSetMacro(SilhouetteCoverage, vtkTypeBool);
  vtkGetMacro(SilhouetteCoverage, vtkTypeBool);
  vtkBooleanMacro(SilhouetteCoverage, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether what is not covered stays transparent instead of showing the renderer's background.
   */
  vtkSetMacro(TransparentBackground, vtkTypeBool);
  vtkGetMacro(TransparentBackground, vtkTypeBool);
  vtkBooleanMacro(TransparentBackground, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether the camera's clipping range is set to enclose the visible props first. Default on.
   */
  vtkSetMacro(ResetClippingRange, vtkTypeBool);
  vtkGetMacro(ResetClippingRange, vtkTypeBool);
  vtkBooleanMacro(ResetClippingRange, vtkTypeBool);
  //@}

  /**
   * Visible props of the last update that have no Mote mapper and so were not traced.
   */
  vtkGetMacro(NumberOfIgnoredProps, int);

  //@{
  /**
   * Samples a pixel of the last update, and its standard error: infinite where neither NoiseLevel
   * nor Variance asked for it, or with one sample.
   */
  vtkGetMacro(NumberOfSamples, int);
  vtkGetMacro(Noise, double);
  //@}

  /**
   * Seconds of the last update that were spent tracing.
   */
  vtkGetMacro(TraceTime, double);

  /**
   * The part of them in which silhouettes were looked for.
   */
  vtkGetMacro(SilhouetteTime, double);

  vtkMTimeType GetMTime() override;

protected:
  vtkMoteRendererSource();
  ~vtkMoteRendererSource() override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Size[2] = {1024, 1024};
  int SamplesPerPixel = 16;
  double NoiseLevel = 0.0;
  int NumberOfThreads = 0;
  vtkTypeBool Depth = 0;
  vtkTypeBool Normals = 0;
  vtkTypeBool Ids = 0;
  vtkTypeBool Variance = 0;
  vtkTypeBool SilhouetteCoverage = 0;
  int NumberOfSamples = 0;
  double Noise = 0.0;
  vtkTypeBool TransparentBackground = 0;
  vtkTypeBool ResetClippingRange = 1;
  int NumberOfIgnoredProps = 0;
  double TraceTime = 0.0;
  double SilhouetteTime = 0.0;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkMoteShading> Shading;
  vtkSmartPointer<vtkMoteSilhouettes> Silhouettes;
  bool WarnedOfIgnoredProps = false;

private:
  vtkMoteRendererSource(const vtkMoteRendererSource&) = delete;
  void operator=(const vtkMoteRendererSource&) = delete;

#ifndef __VTK_WRAP__
  std::vector<std::shared_ptr<mote::MoteProp>> CollectProps();
  bool Trace(mote::FrameTracer& tracer);
  void FillImage(const mote::FrameTracer& tracer, vtkImageData* image);
#endif
};

#endif
