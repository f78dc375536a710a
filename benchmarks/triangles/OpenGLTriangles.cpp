// VTK's own way to draw triangles: its mapper for OpenGL, as the machine's driver draws it.

#include "../Display.h"
#include "TriangleMethod.h"

#include <kernels/core/Error.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstdlib>

namespace mote::bench
{

namespace
{

class OpenGLTriangles : public TriangleMethod
{
public:
  /// Mesa's llvmpipe, which draws where there is no graphics card, reads the number of threads from
  /// its environment; 0 stands for that which asks.
  explicit OpenGLTriangles(int threads)
  {
    if (!hasDisplay())
      throw Error("There is no display, and vtk-opengl draws into a window.");
    ::setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 0);
  }

  void build(const TriangleInput& input) override
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(static_cast<vtkIdType>(input.pointCount()));
    std::copy_n(
      &input.points[0].x, 3 * input.pointCount(), static_cast<float*>(points->GetVoidPointer(0)));
    const auto count = static_cast<vtkIdType>(input.triangles.size());
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(3 * count);
    std::copy_n(input.triangles.front().data(), 3 * input.triangles.size(),
      reinterpret_cast<std::uint32_t*>(corners->GetPointer(0)));
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, corners);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    mapper_->SetInputData(data);
    mapper_->ScalarVisibilityOff();
    actor_->SetMapper(mapper_);
    renderer_->AddActor(actor_);
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(16, 16);
    window_->AddRenderer(renderer_);
    window_->Render(); // which makes the buffers
    // Points and corners, as the mapper hands them to the driver.
    bytes_ = 12 * (input.pointCount() + input.triangles.size());
  }
  std::size_t bytes() const override { return bytes_; }

  std::vector<std::string> modes(TriangleTask task) const override
  {
    return task == TriangleTask::Primary ? std::vector<std::string>{"frame"}
                                         : std::vector<std::string>{};
  }

  void cast(std::size_t /*mode*/, const CameraRays& rays, TriangleImage& image) const override
  {
    const int width = image.width(), height = image.height();
    window_->SetSize(width, height);
    vtkCamera* camera = renderer_->GetActiveCamera();
    place(camera, rays, width, height);
    renderer_->ResetCameraClippingRange();
    window_->Render();
    window_->GetZbufferData(0, 0, width - 1, height - 1, depths_);
    double range[2];
    camera->GetClippingRange(range);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
      {
        const float z = depths_->GetValue(vtkIdType{y} * width + x);
        TriangleImage::Block& block = image.blockAt(x, y);
        const int k = TriangleImage::place(x, y);
        block.t[k] = z < 1.0f ? static_cast<float>(range[0] * range[1] /
                                                   (range[1] - double(z) * (range[1] - range[0])))
                              : std::numeric_limits<float>::infinity();
        block.triangle[k] = 0; // nobody knows
        for (auto& normal : block.normal)
          normal[k] = 0.0f;
      }
  }

  void occlude(TriangleTask, std::size_t, const SecondaryRays&, OcclusionAnswers&) const override {}

private:
  static void place(vtkCamera* camera, const CameraRays& rays, int width, int height)
  {
    const double x = 0.5 * width, y = 0.5 * height;
    const Vec3d eye = rays.originAt(x, y), way = rays.directionAt(x, y), focus = eye + way;
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(rays.dy.x, rays.dy.y, rays.dy.z);
    camera->SetViewAngle(
      glm::degrees(2.0 * std::atan(y * glm::length(rays.dy) / glm::length(way))));
  }

  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkFloatArray> depths_;
  std::size_t bytes_ = 0;
};

} // namespace

std::unique_ptr<TriangleMethod> makeOpenGLTriangles(int threads)
{
  return std::make_unique<OpenGLTriangles>(threads);
}

} // namespace mote::bench
