/**
 * @class   vtkMoteSlice
 * @brief   Where a vtkMoteVolumeMapper shows its cells sliced: a plane, a half plane that ends at
 * an axis, a cylinder, or a cylinder rolled out flat.
 *
 * Slices are drawn as surfaces with the colours of the cells' values, which vary in the cells as
 * they do in the cloud. Rays are met with the shape and the cell is looked up: nothing is built,
 * and a slice that is moved is traced anew and no more.
 *
 * A meridional section is a half plane; a blade-to-blade section is a cylinder. Rolled out it lies
 * on the plane that touches the cylinder towards Outwards: there arcs are as long as they are on
 * the cylinder, and it goes half a turn to either side.
 */

#ifndef vtkMoteSlice_h
#define vtkMoteSlice_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkObject.h"

class MOTERENDERINGVTK_EXPORT vtkMoteSlice : public vtkObject
{
public:
  static vtkMoteSlice* New();
  vtkTypeMacro(vtkMoteSlice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    PLANE = 0,        ///< through Center, across Axis
    HALF_PLANE,       ///< from the axis on towards Outwards
    CYLINDER,         ///< of Radius about the axis
    UNROLLED_CYLINDER ///< the same, flat
  };

  //@{
  /**
   * One of Shapes; a plane by default.
   */
  vtkSetClampMacro(Shape, int, PLANE, UNROLLED_CYLINDER);
  vtkGetMacro(Shape, int);
  void SetShapeToPlane() { this->SetShape(PLANE); }
  void SetShapeToHalfPlane() { this->SetShape(HALF_PLANE); }
  void SetShapeToCylinder() { this->SetShape(CYLINDER); }
  void SetShapeToUnrolledCylinder() { this->SetShape(UNROLLED_CYLINDER); }
  //@}

  //@{
  /**
   * A point of the plane or on the axis, and the plane's normal or the axis, of any length but 0;
   * in the coordinates of the input. The z axis through the origin by default.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  //@}

  //@{
  /**
   * Where a half plane goes from the axis, and where a cylinder that is rolled out touches its
   * plane: the part of this vector across the axis. Default 1 0 0; planes and cylinders do not need
   * it.
   */
  vtkSetVector3Macro(Outwards, double);
  vtkGetVector3Macro(Outwards, double);
  //@}

  //@{
  /**
   * Of cylinders, above 0. Default 1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  //@}

protected:
  vtkMoteSlice() = default;
  ~vtkMoteSlice() override = default;

  int Shape = PLANE;
  double Center[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  double Outwards[3] = {1.0, 0.0, 0.0};
  double Radius = 1.0;

private:
  vtkMoteSlice(const vtkMoteSlice&) = delete;
  void operator=(const vtkMoteSlice&) = delete;
};

#endif
