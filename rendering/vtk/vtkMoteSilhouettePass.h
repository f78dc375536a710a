/**
 * @class   vtkMoteSilhouettePass
 * @brief   A render pass that draws silhouettes over what another one drew.
 *
 * Set it on a renderer with SetPass(). The delegate pass, by default one that draws as a renderer
 * without passes does, may draw anything: surfaces, glyphs, volumes of VTK or of Mote. Silhouettes
 * are found in the depth buffer when it is done, and blended over the picture. The default delegate
 * has them below the overlay (texts, 2D actors) and over everything else; so has a pass of your
 * own that renders GetLinePass() where they belong.
 *
 * Where the delegate is a vtkMoteRayCastPass, it is handed the Silhouettes for the time of its
 * rendering instead: silhouettes then come from the traced rays, are smooth, and stand on what Mote
 * draws and nothing else. DepthSource decides.
 *
 * The depth buffer of a window with multi-sampling is read with one of its samples a pixel. What
 * writes no depth, such as translucent props, has no silhouettes. Groups are not in depth buffers.
 */

#ifndef vtkMoteSilhouettePass_h
#define vtkMoteSilhouettePass_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h" // for Silhouettes

#include <memory> // for the implementation

class vtkMoteSilhouettes;

class MOTERENDERINGVTK_EXPORT vtkMoteSilhouettePass : public vtkRenderPass
{
public:
  static vtkMoteSilhouettePass* New();
  vtkTypeMacro(vtkMoteSilhouettePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * What is drawn: see there. There is one of its own to begin with, which is Enabled; null is
   * none. ThresholdMode RADII asks for particles of Mote among the props.
   */
  void SetSilhouettes(vtkMoteSilhouettes* silhouettes);
  vtkMoteSilhouettes* GetSilhouettes();
  //@}

  //@{
  /**
   * What draws the scene.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  //@}

  /**
   * For delegates of your own: draws the silhouettes in what has been drawn so far.
   */
  vtkRenderPass* GetLinePass();

  enum DepthSources
  {
    AUTOMATIC,   ///< the rays of a delegate that casts any, else the depth buffer
    DEPTH_BUFFER ///< of all that is drawn
  };

  //@{
  /**
   * Where depths come from. Default AUTOMATIC.
   */
  vtkSetClampMacro(DepthSource, int, AUTOMATIC, DEPTH_BUFFER);
  vtkGetMacro(DepthSource, int);
  void SetDepthSourceToAutomatic() { this->SetDepthSource(AUTOMATIC); }
  void SetDepthSourceToDepthBuffer() { this->SetDepthSource(DEPTH_BUFFER); }
  //@}

  /**
   * Seconds of the last Render() in which silhouettes were looked for: 0 where the rays' pass did
   * that, which tells its own.
   */
  double GetSilhouetteTime();

protected:
  vtkMoteSilhouettePass();
  ~vtkMoteSilhouettePass() override;

  int DepthSource = AUTOMATIC;
  vtkSmartPointer<vtkMoteSilhouettes> Silhouettes;

private:
  vtkMoteSilhouettePass(const vtkMoteSilhouettePass&) = delete;
  void operator=(const vtkMoteSilhouettePass&) = delete;

  void DrawSilhouettes(vtkRenderer* renderer);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
