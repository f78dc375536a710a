/**
 * @class   vtkMoteParticlePicker
 * @brief   Finds the particle or iso-surface under a point of the window by casting one exact ray.
 *
 * Looks at the visible, pickable props of the renderer that Mote traces, and needs no OpenGL.
 * Clouds are looked through unless PickClouds is on. GetViewProp(), GetActor() and
 * GetPickPosition() answer as in other pickers. Ordinary props in front are not seen; use
 * vtkPropPicker for those.
 */

#ifndef vtkMoteParticlePicker_h
#define vtkMoteParticlePicker_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkAbstractPropPicker.h"

class vtkPropCollection;

class MOTERENDERINGVTK_EXPORT vtkMoteParticlePicker : public vtkAbstractPropPicker
{
public:
  static vtkMoteParticlePicker* New();
  vtkTypeMacro(vtkMoteParticlePicker, vtkAbstractPropPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Picks at a position in display coordinates (pixels from the window's lower left corner, z is
   * not used). Returns 1 where a particle or an iso-surface is met, else 0.
   */
  int Pick(double x, double y, double z, vtkRenderer* renderer) override;
  using Superclass::Pick;
  //@}

  /**
   * The particle's index in its mapper's input, or -1.
   */
  vtkGetMacro(ParticleId, vtkIdType);

  /**
   * The cell's index in its mapper's input where an iso-surface or a volume was picked, or -1.
   */
  vtkGetMacro(CellId, vtkIdType);

  //@{
  /**
   * Whether volumes are picked, too: the cell that keeps back more of the ray's light than any
   * other, where there is no surface on the ray, or where the volumes in front of the surface keep
   * back more than half of the light. PickPosition is then the most opaque place of the ray in that
   * cell, Value the volume's scalar there, PickNormal 0. Off by default.
   */
  vtkSetMacro(PickClouds, vtkTypeBool);
  vtkGetMacro(PickClouds, vtkTypeBool);
  vtkBooleanMacro(PickClouds, vtkTypeBool);
  //@}

  /**
   * The opacity of the volumes along the ray, in (0, 1], where a cell of a volume was picked for
   * it; 0 where a surface was picked.
   */
  vtkGetMacro(CloudOpacity, double);

  /**
   * The value that colours it, NaN where none does; of an iso-surface its iso-value.
   */
  vtkGetMacro(Value, double);

  /**
   * Distance from the camera along the view axis, in world units.
   */
  vtkGetMacro(Distance, double);

  /**
   * Outward unit normal of the surface at the picked position, in world coordinates.
   */
  vtkGetVector3Macro(PickNormal, double);

protected:
  vtkMoteParticlePicker();
  ~vtkMoteParticlePicker() override;

  vtkIdType ParticleId = -1;
  vtkIdType CellId = -1;
  vtkTypeBool PickClouds = 0;
  double CloudOpacity = 0.0;
  double Value = 0.0;
  double Distance = 0.0;
  double PickNormal[3] = {0.0, 0.0, 0.0};

private:
  void CastRay(double x, double y, vtkPropCollection* props);

  vtkMoteParticlePicker(const vtkMoteParticlePicker&) = delete;
  void operator=(const vtkMoteParticlePicker&) = delete;
};

#endif
