/**
 * @class   vtkMoteAreaPicker
 * @brief   Finds the particles and cells in a rectangle of the window: those that are seen, or all.
 *
 * Looks at the visible, pickable props of the renderer that have a vtkMoteParticleMapper, and needs
 * no OpenGL. Without Through, rays are cast at the pixels of the rectangle, and what they meet
 * first is found; Mote's other surfaces hide particles, while volumes and ordinary props do not.
 * With Through, all particles whose centres lie in the rectangle are found, whatever stands before
 * them. Particles that ranges hide are not found.
 *
 * With PickCells the cells of meshes, isosurfaces and volumes are found too, without Through: those
 * that vtkMoteParticlePicker finds at the centres of the rectangle's pixels with PickClouds.
 */

#ifndef vtkMoteAreaPicker_h
#define vtkMoteAreaPicker_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for what was found

#include <memory> // for the implementation
#include <vector> // for what was found

class vtkIdTypeArray;
class vtkProp3D;
class vtkRenderer;

namespace mote
{
class MoteProp;
struct Camera;
struct Scene;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteAreaPicker : public vtkObject
{
public:
  static vtkMoteAreaPicker* New();
  vtkTypeMacro(vtkMoteAreaPicker, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether particles are found that others hide from the camera. Off by default.
   */
  vtkSetMacro(Through, vtkTypeBool);
  vtkGetMacro(Through, vtkTypeBool);
  vtkBooleanMacro(Through, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether cells are found that are seen. Off by default.
   */
  vtkSetMacro(PickCells, vtkTypeBool);
  vtkGetMacro(PickCells, vtkTypeBool);
  vtkBooleanMacro(PickCells, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether the values are found that colour what is seen, without Through. Off by default.
   */
  vtkSetMacro(PickValues, vtkTypeBool);
  vtkGetMacro(PickValues, vtkTypeBool);
  vtkBooleanMacro(PickValues, vtkTypeBool);
  //@}

  //@{
  /**
   * Rays a pixel, in [1, 65536], without Through. Default 4. The first goes through the pixel's
   * centre. With more rays smaller particles are found.
   */
  vtkSetClampMacro(SamplesPerPixel, int, 1, 65536);
  vtkGetMacro(SamplesPerPixel, int);
  //@}

  //@{
  /**
   * Threads to look with; 0, the default, for all.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  /**
   * Looks at the rectangle with these corners, both included, in display coordinates (pixels from
   * the window's lower left corner). Returns how many particles and cells were found.
   */
  vtkIdType Pick(double x0, double y0, double x1, double y1, vtkRenderer* renderer);

  /**
   * The least and the greatest value that colours what the last Pick() with PickValues met, as
   * vtkMoteParticlePicker has it at the centres of the rectangle's pixels with PickClouds; both NaN
   * where nothing that was met is coloured by values.
   */
  vtkGetVector2Macro(ValueRange, double);

  //@{
  /**
   * What the last Pick() found: props, and for each the indices in its mapper's input, ascending,
   * of particles or of cells. Null for numbers that are none, and for what is not of that kind.
   */
  int GetNumberOfProps();
  vtkProp3D* GetProp(int i);
  vtkIdTypeArray* GetParticles(int i);
  vtkIdTypeArray* GetCells(int i);
  //@}

protected:
  vtkMoteAreaPicker();
  ~vtkMoteAreaPicker() override;

  vtkTypeBool Through = 0;
  vtkTypeBool PickCells = 0;
  vtkTypeBool PickValues = 0;
  double ValueRange[2];
  int SamplesPerPixel = 4;
  int NumberOfThreads = 0;

private:
  struct Rectangle;
  void FindSeen(const Rectangle& rectangle, vtkRenderer* renderer);
  void FindAll(const Rectangle& rectangle, vtkRenderer* renderer);
#ifndef __VTK_WRAP__
  void LookAtPixels(const Rectangle& rectangle, const mote::Scene& scene,
    const mote::Camera& camera, const std::vector<std::shared_ptr<mote::MoteProp>>& props);
#endif
  void Add(vtkProp3D* prop, const std::vector<vtkIdType>& ids, bool areCells);

  struct Found
  {
    vtkSmartPointer<vtkProp3D> Prop;
    vtkSmartPointer<vtkIdTypeArray> Ids;
    bool AreCells;
  };
  std::vector<Found> All;

  vtkMoteAreaPicker(const vtkMoteAreaPicker&) = delete;
  void operator=(const vtkMoteAreaPicker&) = delete;
};

#endif
