/**
 * @class   vtkMoteClipCylinder
 * @brief   What of a volume or mesh is shown, in cylindrical coordinates about an axis.
 *
 * Points are shown whose radius, height and angle lie in three ranges. It is for machines that
 * turn: a range of angles opens them like a cake, ranges of radii and heights show a passage.
 * Rays are cut where the surfaces of the piece are, exactly; nothing is built for it.
 */

#ifndef vtkMoteClipCylinder_h
#define vtkMoteClipCylinder_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkObject.h"

class MOTERENDERINGVTK_EXPORT vtkMoteClipCylinder : public vtkObject
{
public:
  static vtkMoteClipCylinder* New();
  vtkTypeMacro(vtkMoteClipCylinder, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * A point on the axis, in world coordinates, where the height is 0; and the axis, of any length
   * but 0. The z axis through the origin by default.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  //@}

  //@{
  /**
   * Where the angle is 0: the part of this vector across the axis. By default the x axis, or the y
   * axis where that is nearer to across. Angles grow by the right-hand rule about the axis.
   */
  void SetZeroAngle(double x, double y, double z);
  void GetZeroAngle(double direction[3]);
  //@}

  //@{
  /**
   * What is shown, both ends included: distances from the axis and heights along it in world units,
   * angles in degrees, from the first on to the second, past 360 where that is less. All by
   * default; angles a whole turn apart or more are all.
   */
  vtkSetVector2Macro(RadiusRange, double);
  vtkGetVector2Macro(RadiusRange, double);
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  vtkSetVector2Macro(AngleRange, double);
  vtkGetVector2Macro(AngleRange, double);
  //@}

protected:
  vtkMoteClipCylinder() = default;
  ~vtkMoteClipCylinder() override = default;

  double Center[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  double ZeroAngle[3] = {0.0, 0.0, 0.0}; ///< 0: by default
  double RadiusRange[2] = {0.0, VTK_DOUBLE_MAX};
  double HeightRange[2] = {-VTK_DOUBLE_MAX, VTK_DOUBLE_MAX};
  double AngleRange[2] = {0.0, 360.0};

private:
  vtkMoteClipCylinder(const vtkMoteClipCylinder&) = delete;
  void operator=(const vtkMoteClipCylinder&) = delete;
};

#endif
