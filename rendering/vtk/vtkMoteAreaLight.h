/**
 * @class   vtkMoteAreaLight
 * @brief   A light that casts shadows: soft ones, since it has a size.
 *
 * Everything of vtkLight holds: colour, intensity, positional or not, headlight, camera or scene
 * light. Mote's props throw and receive its shadows, among one another; ordinary VTK props, drawn
 * by OpenGL, are lit as by a plain vtkLight. A plain vtkLight casts no shadows.
 *
 * Shadows are found by Samples x Samples rays to points spread over the light: with one sample, or
 * without size, they are hard. While the view moves one sample is taken, so that the frame rate
 * holds; see vtkMoteRayCastPass. A scene may have any number of such lights.
 *
 * A good picture has one of them from the side and a plain vtkLight, weaker, from the eye, without
 * which shadows are black but for the ambient part of the actors' properties.
 */

#ifndef vtkMoteAreaLight_h
#define vtkMoteAreaLight_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkLight.h"

class MOTERENDERINGVTK_EXPORT vtkMoteAreaLight : public vtkLight
{
public:
  static vtkMoteAreaLight* New();
  vtkTypeMacro(vtkMoteAreaLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether the light casts shadows. On by default.
   */
  vtkSetMacro(Shadows, vtkTypeBool);
  vtkGetMacro(Shadows, vtkTypeBool);
  vtkBooleanMacro(Shadows, vtkTypeBool);
  //@}

  //@{
  /**
   * How large the light is: the larger, the softer the shadows. Of a positional light the edge of
   * the square that shines, in world units; it faces what it lights. Of one that is not, the angle
   * under which its edge is seen, in degrees, up to 90 (the sun's is 0.53, an overcast sky's
   * large). Default 0: a point, or parallel rays, with hard shadows.
   */
  vtkSetClampMacro(Size, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Size, double);
  //@}

  //@{
  /**
   * Side of the square of sample points, in [1, 64]: 4, the default, takes 16 points. The more, the
   * smoother the rims of the shadows and the longer it takes. A change rebuilds nothing.
   */
  vtkSetClampMacro(Samples, int, 1, 64);
  vtkGetMacro(Samples, int);
  //@}

  /**
   * A light of this class with the same values, as vtkLight's.
   */
  vtkLight* ShallowClone() override;

  /**
   * Takes over all values of another light; those of this class, too, where it is one.
   */
  void DeepCopy(vtkLight* light);

protected:
  vtkMoteAreaLight() = default;
  ~vtkMoteAreaLight() override = default;

  vtkTypeBool Shadows = 1;
  double Size = 0.0;
  int Samples = 4;

private:
  vtkMoteAreaLight(const vtkMoteAreaLight&) = delete;
  void operator=(const vtkMoteAreaLight&) = delete;

  void CopyShadows(vtkLight* light);
};

#endif
