#ifndef MotePumpPart_h
#define MotePumpPart_h

#include "PumpFlow.h"

#include "kernels/core/Vec.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkUnstructuredGrid;

namespace mote::pump
{

enum class PartName
{
  Inlet,
  Rotor,
  Diffuser,
};

/// Where the pump is and how fast it turns.
struct Frame
{
  Vec3d origin, axis;  ///< the axis has length 1
  double radius;       ///< of the impeller, m
  double angularSpeed; ///< radians a second
};

/// The mesh of a part with the steady half of its flow.
class Part
{
public:
  Part(PartName name, double scale, const Frame& frame, int precision);

  /// The mesh: points and cells, no arrays.
  vtkUnstructuredGrid* mesh() const { return mesh_; }

  /// Another grid with the same points and cells, and the arrays of a moment.
  vtkSmartPointer<vtkUnstructuredGrid> at(double seconds) const;

private:
  void makePoints(const Plane& plane, int precision);
  void makeCells(const Plane& plane);

  PartName name_;
  Frame frame_;
  Mat3d basis_; // columns: x, y and z of the pump
  Rhythm rhythm_;
  vtkSmartPointer<vtkUnstructuredGrid> mesh_;
  std::vector<SteadyFlow> flow_; // of the points
};

} // namespace mote::pump

#endif
