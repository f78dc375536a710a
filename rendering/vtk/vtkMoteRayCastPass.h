/**
 * @class   vtkMoteRayCastPass
 * @brief   A render pass that ray casts all Mote props of a renderer together.
 *
 * Set it on a renderer with SetPass(). Ordinary props are drawn by VTK as ever (by the delegate
 * pass, a vtkRenderStepsPass by default: lights, opaque, translucent, volumetric and overlay
 * steps); after the opaque ones the props that have a Mote mapper are traced in one scene, so that
 * they hide one another exactly, and written into the framebuffer with colour and depth. Edges are
 * blended over what lies behind them.
 *
 * Where there is a volume (a vtkVolume with a vtkMoteVolumeMapper) among them, the depth of the
 * opaque props is read first, and rays end there: a volume is seen up to what stands inside of it.
 * Clouds are blended over the opaque props and write no depth, iso-surfaces and particles do.
 * Translucent props come after, over all of that but what surfaces hide. A prop that moves in a
 * renderer with volumes has the picture traced again. Without volumes nothing is read.
 *
 * While the view moves (the window's desired update rate is 1 or more, as interactors set it) one
 * ray a pixel is cast, or fewer, so that a frame takes no longer than InteractiveFrameTime. At
 * rest every pixel gets SamplesPerPixel rays. A frame in which nothing that Mote draws has changed
 * is shown again without tracing.
 *
 * Tracing fires ProgressEvents of this object with the share done, and stops where the render
 * window's CheckAbortStatus() says so; frames while the view moves, and the first after a change of
 * a Progressive picture, are short and do neither.
 */

#ifndef vtkMoteRayCastPass_h
#define vtkMoteRayCastPass_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h" // for Shading and Silhouettes

#include <memory> // for the implementation

class vtkMoteShading;
class vtkMoteSilhouettes;

class MOTERENDERINGVTK_EXPORT vtkMoteRayCastPass : public vtkRenderPass
{
public:
  static vtkMoteRayCastPass* New();
  vtkTypeMacro(vtkMoteRayCastPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Rays a pixel at rest, in [1, 65536]. Default 4. The first goes through the pixel's centre.
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
   * When on, a picture at rest comes bit by bit, and each Render() shows what there is; render
   * until IsConverged(). After a change the first is as fine as a tenth of a second allows (or
   * InteractiveFrameTime, if that is more); nothing stops it. Then come finer ones, tile by tile in
   * the place of the one before, and samples, as many in a Render() as fit into
   * InteractiveFrameTime, and each again shown after a tenth of a second. What is stopped between
   * two tiles goes on with the next Render(). The last picture is that which one Render() traces
   * where this is off, the default.
   */
  vtkSetMacro(Progressive, vtkTypeBool);
  vtkGetMacro(Progressive, vtkTypeBool);
  vtkBooleanMacro(Progressive, vtkTypeBool);
  //@}

  //@{
  /**
   * When off, a Render() of a Progressive picture at rest shows what there is and traces nothing,
   * as long as it shows this view at all: for frames in which only other things of the window
   * change. On by default.
   */
  vtkSetMacro(Refining, vtkTypeBool);
  vtkGetMacro(Refining, vtkTypeBool);
  vtkBooleanMacro(Refining, vtkTypeBool);
  //@}

  /**
   * Whether the picture shown last has full resolution and all its samples, or little enough noise,
   * and is no preview.
   */
  bool IsConverged();

  /**
   * Whether anything in the picture shown last is a preview: see
   * vtkMoteParticleMapper::PreviewOn().
   */
  bool IsPreview();

  //@{
  /**
   * Whether resolution is lowered while the view moves. On by default.
   */
  vtkSetMacro(AutoAdjustResolution, vtkTypeBool);
  vtkGetMacro(AutoAdjustResolution, vtkTypeBool);
  vtkBooleanMacro(AutoAdjustResolution, vtkTypeBool);
  //@}

  //@{
  /**
   * Seconds that a frame may take while the view moves. Default 0.08, at least 0.001.
   */
  vtkSetClampMacro(InteractiveFrameTime, double, 0.001, VTK_DOUBLE_MAX);
  vtkGetMacro(InteractiveFrameTime, double);
  //@}

  //@{
  /**
   * The most that neighbouring rays may be apart while the view moves, in pixels from 1 to 32,
   * whatever time the frame takes then: edges are half of that away from where they are, at most.
   * Default 32.
   */
  vtkSetClampMacro(MostDistance, double, 1.0, 32.0);
  vtkGetMacro(MostDistance, double);
  //@}

  //@{
  /**
   * Whether clouds may be integrated and interpolated more roughly than mappers and shading say
   * while the view moves and until a progressive picture is sharp. Default on.
   */
  vtkSetMacro(RoughDrafts, vtkTypeBool);
  vtkGetMacro(RoughDrafts, vtkTypeBool);
  vtkBooleanMacro(RoughDrafts, vtkTypeBool);
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
   * with them. Other options change those of a picture at rest without tracing its colours again.
   */
  void SetSilhouettes(vtkMoteSilhouettes* silhouettes);
  vtkMoteSilhouettes* GetSilhouettes();
  //@}

  //@{
  /**
   * Facts of the last Render(): distance of neighbouring rays in pixels (1: full resolution),
   * samples a pixel shown so far, the share of the picture that the next finer one covers already
   * (in [0, 1)), the standard error of the picture with these samples (infinite where NoiseLevel is
   * 0, and before there are two), rays cast in it, and seconds spent tracing and drawing (0 traced:
   * the picture was still good). SilhouetteTime is the part of TraceTime in which silhouettes were
   * looked for.
   */
  double GetImageSampleDistance();
  int GetNumberOfSamples();
  double GetFinerShare();
  double GetBakedShare();
  double GetNoise();
  vtkTypeInt64 GetNumberOfRays();
  double GetTraceTime();
  double GetDisplayTime();
  double GetSilhouetteTime();
  //@}

  //@{
  /**
   * What draws the ordinary props. By default a vtkRenderStepsPass. A pass of your own must render
   * GetImagePass() where the traced picture belongs: after opaque props, before translucent ones.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  vtkRenderPass* GetImagePass();
  //@}

protected:
  vtkMoteRayCastPass();
  ~vtkMoteRayCastPass() override;

  int SamplesPerPixel = 4;
  double NoiseLevel = 0.0;
  vtkTypeBool Progressive = 0;
  vtkTypeBool Refining = 1;
  vtkTypeBool AutoAdjustResolution = 1;
  double InteractiveFrameTime = 0.08;
  double MostDistance = 32.0;
  vtkTypeBool RoughDrafts = 1;
  int NumberOfThreads = 0;
  vtkSmartPointer<vtkMoteShading> Shading;
  vtkSmartPointer<vtkMoteSilhouettes> Silhouettes;

private:
  vtkMoteRayCastPass(const vtkMoteRayCastPass&) = delete;
  void operator=(const vtkMoteRayCastPass&) = delete;

  void DrawImage(vtkRenderer* renderer);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
