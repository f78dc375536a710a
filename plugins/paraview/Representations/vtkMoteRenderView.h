/**
 * @class   vtkMoteRenderView
 * @brief   a render view in which all props of Mote are traced together
 *
 * Shadows, ambient occlusion, reflected light and silhouettes then go from one to the other. All
 * else is ParaView's own render view. On several ranks each traces what it has: light does not
 * cross from rank to rank.
 */

#ifndef vtkMoteRenderView_h
#define vtkMoteRenderView_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkNew.h"                            // For members
#include "vtkPVRenderView.h"

class vtkLight;
class vtkMoteAreaLight;
class vtkMoteRayCastPass;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteRenderView : public vtkPVRenderView
{
public:
  static vtkMoteRenderView* New();
  vtkTypeMacro(vtkMoteRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * See vtkMoteRayCastPass and vtkMoteShading. On several ranks a reach of 0 stands for a tenth of
   * the longest side of what all of them show.
   */
  void SetSamplesPerPixel(int samples);
  void SetAmbientOcclusion(int how);
  void SetAmbientOcclusionReach(double reach);
  void SetPathTracing(int on);
  void SetCloudTolerance(double tolerance);
  double GetTraceTime();
  //@}

  //@{
  /**
   * A light with shadows, fixed to the camera. Size in degrees, as seen from the data: 0 has hard
   * shadows.
   */
  void SetMoteShadows(int on);
  void SetMoteLightSize(double degrees);
  //@}

  /// Never: rays are cast as often as is asked for, and FXAA, which a server would add, blurs.
  void SetUseFXAA(bool) override { this->Superclass::SetUseFXAA(false); }

  //@{
  /**
   * See vtkMoteSilhouettes; the threshold counts radii of typical particles.
   */
  void SetSilhouettes(int on);
  void SetSilhouetteThreshold(double radii);
  void SetSilhouetteThickness(double pixels);
  void SetSilhouetteColor(double r, double g, double b);
  //@}

protected:
  vtkMoteRenderView();
  ~vtkMoteRenderView() override;

  void AboutToRenderOnLocalProcess(bool interactive) override;

private:
  vtkMoteRenderView(const vtkMoteRenderView&) = delete;
  void operator=(const vtkMoteRenderView&) = delete;

  vtkNew<vtkMoteRayCastPass> Pass;
  vtkNew<vtkMoteAreaLight> Light;
  vtkNew<vtkLight> Fill; ///< without which shadows are black
  bool HasShadows = false;
  double OcclusionReach = 0.0; ///< as it was set
};

#endif
