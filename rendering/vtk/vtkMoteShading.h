/**
 * @class   vtkMoteShading
 * @brief   How rays find the light on what Mote draws, besides the lights' own shadows.
 *
 * One object may serve any number of vtkMoteRayCastPass and vtkMoteRendererSource, which then make
 * the same picture: SetShading() of either.
 *
 * Ambient occlusion. The ambient part of an actor's vtkProperty is the light of an even sky; with
 * AmbientOcclusionSamples above 0 a surface receives the share of it that it sees: of all
 * directions above the surface, each weighted by its cosine to the normal, those along which no
 * particle stands within AmbientOcclusionReach. Crevices darken. Lights and their shadows add to
 * that as ever; properties with no ambient part show nothing of it.
 */

#ifndef vtkMoteShading_h
#define vtkMoteShading_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkObject.h"

class MOTERENDERINGVTK_EXPORT vtkMoteShading : public vtkObject
{
public:
  static vtkMoteShading* New();
  vtkTypeMacro(vtkMoteShading, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Rays that look for the sky at each hit of each of a pixel's rays, in [0, 4096]; 0, the default,
   * for none. 4, with 16 rays a pixel, make a smooth picture; powers of two spread best.
   */
  vtkSetClampMacro(AmbientOcclusionSamples, int, 0, 4096);
  vtkGetMacro(AmbientOcclusionSamples, int);
  ///@}

  ///@{
  /**
   * How far those rays go, in world units: what is farther away darkens nothing. VTK_DOUBLE_MAX
   * for all that there is; 0, the default, for a tenth of the longest side of what is drawn.
   */
  vtkSetClampMacro(AmbientOcclusionReach, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AmbientOcclusionReach, double);
  ///@}

protected:
  vtkMoteShading() = default;
  ~vtkMoteShading() override = default;

  int AmbientOcclusionSamples = 0;
  double AmbientOcclusionReach = 0.0;

private:
  vtkMoteShading(const vtkMoteShading&) = delete;
  void operator=(const vtkMoteShading&) = delete;
};

#endif
