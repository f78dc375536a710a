#pragma once

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkMoteParticleMapper.h"
#include "vtkMoteRendererSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

class vtkCamera;
class vtkDataArray;
class vtkDataSet;

/// What the tests of rendering/vtk share. Nothing here needs a display.
namespace mote::testing
{

using Point = std::array<double, 3>;

struct Ball
{
  double x, y, z, r;
};

/// Points with a double point array "radius".
vtkSmartPointer<vtkPolyData> makeParticles(const std::vector<Ball>& balls);

/// `count` particles in [-1, 1]^3 with radii in [0.05, 0.2], the same ones every time.
std::vector<Ball> someBalls(int count, unsigned seed = 1);

/// Adds a double point array with one value a point; as the active scalars where asked.
vtkDataArray* addValues(
  vtkDataSet* data, const char* name, const std::vector<double>& values, bool active = true);

/// Counts what an object complains of, which then stays off the terminal.
class Complaints
{
public:
  explicit Complaints(vtkObject* object);
  ~Complaints();
  Complaints(const Complaints&) = delete;
  void operator=(const Complaints&) = delete;

  int errors = 0;
  int warnings = 0;
  std::string text; ///< of the last one

private:
  void note(vtkObject* caller, unsigned long event, void* data);
  vtkSmartPointer<vtkObject> m_object;
  unsigned long m_errorTag, m_warningTag;
};

/// A traced image.
struct Picture
{
  int width = 0, height = 0;
  vtkSmartPointer<vtkImageData> image;

  int count() const { return width * height; }
  const float* color(int pixel) const;
  float depth(int pixel) const;
  const float* normal(int pixel) const;
  long long particle(int pixel) const;
  int object(int pixel) const;
  int at(int x, int y) const { return y * width + x; }
  /// Pixels that show something.
  int covered() const;
  std::vector<long long> particles() const;
};

/// The greatest difference of a colour, over all pixels.
double mostBetween(const Picture& a, const Picture& b);

/// Traces with all arrays and a transparent background.
Picture trace(vtkRenderer* renderer, int width, int height, int samples = 1);

/// One mapper and actor in a renderer with a camera on the z axis that sees [-1.5, 1.5]^2.
struct Stage
{
  explicit Stage(vtkPointSet* data = nullptr, bool parallel = false);

  vtkNew<vtkMoteParticleMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkRenderer> renderer;

  Picture trace(int width = 64, int height = 64) const;
};

/// The truth about a view, from VTK's own projection matrices and closed formulas.
class TrueView
{
public:
  TrueView(vtkCamera* camera, int width, int height);

  struct Hit
  {
    int ball;
    Point position, normal;
    double depth;  ///< along the view axis
    double window; ///< value in the depth buffer
  };
  /// A ray from the eye, or from the plane through it: `along` is what the unit direction has of
  /// the view axis.
  struct Line
  {
    Point origin, direction;
    double along;
  };
  Line line(double x, double y) const;
  /// What the ray through image position (x, y), in pixels, meets between the clipping planes.
  std::optional<Hit> hit(double x, double y, const std::vector<Ball>& balls) const;
  /// Whether all positions within `margin` pixels meet the same ball, or none does.
  bool isClear(double x, double y, const std::vector<Ball>& balls, double margin = 0.25) const;

private:
  Point unproject(double x, double y, double z) const;

  double m_toView[16], m_toWorld[16];
  Point m_eye, m_axis;
  int m_width, m_height;
};

void expectBounds(vtkMoteParticleMapper* mapper, const std::array<double, 6>& expected);

double dot(const Point& a, const Point& b);
Point minus(const Point& a, const Point& b);
Point unit(const Point& a);

} // namespace mote::testing
