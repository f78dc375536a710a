#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace mote::testing
{

vtkSmartPointer<vtkPolyData> makeParticles(const std::vector<Ball>& balls)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::vector<double> radii;
  for (const Ball& ball : balls)
  {
    points->InsertNextPoint(ball.x, ball.y, ball.z);
    radii.push_back(ball.r);
  }
  data->SetPoints(points);
  addValues(data, "radius", radii, false);
  return data;
}

std::vector<Ball> someBalls(int count, unsigned seed)
{
  std::mt19937 engine(seed);
  const auto random = [&](double from, double to)
  { return from + (to - from) * (engine() / 4294967296.0); };
  std::vector<Ball> balls(static_cast<std::size_t>(count));
  for (Ball& ball : balls)
  {
    ball.x = random(-1, 1);
    ball.y = random(-1, 1);
    ball.z = random(-1, 1);
    ball.r = random(0.05, 0.2);
  }
  return balls;
}

vtkDataArray* addValues(
  vtkDataSet* data, const char* name, const std::vector<double>& values, bool active)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
    array->InsertNextValue(value);
  if (active)
    data->GetPointData()->SetScalars(array);
  else
    data->GetPointData()->AddArray(array);
  return array;
}

Complaints::Complaints(vtkObject* object)
  : m_object(object)
{
  m_errorTag = object->AddObserver(vtkCommand::ErrorEvent, this, &Complaints::note);
  m_warningTag = object->AddObserver(vtkCommand::WarningEvent, this, &Complaints::note);
}

Complaints::~Complaints()
{
  m_object->RemoveObserver(m_errorTag);
  m_object->RemoveObserver(m_warningTag);
}

void Complaints::note(vtkObject*, unsigned long event, void* data)
{
  ++(event == vtkCommand::ErrorEvent ? errors : warnings);
  text = static_cast<const char*>(data);
}

namespace
{

template <typename T>
const T* values(const Picture& picture, const char* name)
{
  return static_cast<const T*>(picture.image->GetPointData()->GetArray(name)->GetVoidPointer(0));
}

} // namespace

const float* Picture::color(int pixel) const
{
  return values<float>(*this, "color") + 4 * pixel;
}
float Picture::depth(int pixel) const
{
  return values<float>(*this, "depth")[pixel];
}
const float* Picture::normal(int pixel) const
{
  return values<float>(*this, "normal") + 3 * pixel;
}
long long Picture::particle(int pixel) const
{
  return values<vtkTypeInt64>(*this, "particle")[pixel];
}
int Picture::object(int pixel) const
{
  return values<int>(*this, "object")[pixel];
}

int Picture::covered() const
{
  int sum = 0;
  for (int i = 0; i < count(); ++i)
    sum += std::isfinite(depth(i)) ? 1 : 0;
  return sum;
}

std::vector<long long> Picture::particles() const
{
  std::vector<long long> ids;
  for (int i = 0; i < count(); ++i)
    ids.push_back(particle(i));
  return ids;
}

double mostBetween(const Picture& a, const Picture& b)
{
  double most = 0.0;
  for (int i = 0; i < a.count(); ++i)
    for (int c = 0; c < 4; ++c)
      most = std::max(most, double(std::abs(a.color(i)[c] - b.color(i)[c])));
  return most;
}

Picture trace(vtkRenderer* renderer, int width, int height, int samples)
{
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(renderer);
  source->SetSize(width, height);
  source->SetSamplesPerPixel(samples);
  source->DepthOn();
  source->NormalsOn();
  source->IdsOn();
  source->TransparentBackgroundOn();
  source->Update();
  return {width, height, source->GetOutput()};
}

Stage::Stage(vtkPointSet* data, bool parallel)
{
  if (data)
    mapper->SetInputData(data);
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewAngle(2.0 * 180.0 / M_PI * std::atan(1.5 / 10.0));
  camera->SetParallelScale(1.5);
  camera->SetParallelProjection(parallel);
}

Picture Stage::trace(int width, int height) const
{
  return mote::testing::trace(renderer, width, height);
}

double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point minus(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point unit(const Point& a)
{
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

TrueView::TrueView(vtkCamera* camera, int width, int height)
  : m_width(width)
  , m_height(height)
{
  vtkMatrix4x4* matrix =
    camera->GetCompositeProjectionTransformMatrix(double(width) / height, -1.0, 1.0);
  vtkMatrix4x4::DeepCopy(m_toView, matrix);
  vtkMatrix4x4::Invert(m_toView, m_toWorld);
  camera->GetPosition(m_eye.data());
  camera->GetDirectionOfProjection(m_axis.data());
}

Point TrueView::unproject(double x, double y, double z) const
{
  const double in[4] = {2.0 * x / m_width - 1.0, 2.0 * y / m_height - 1.0, z, 1.0};
  double out[4];
  vtkMatrix4x4::MultiplyPoint(m_toWorld, in, out);
  return {out[0] / out[3], out[1] / out[3], out[2] / out[3]};
}

TrueView::Line TrueView::line(double x, double y) const
{
  const Point start = unproject(x, y, -1.0);
  Line line;
  line.direction = unit(minus(unproject(x, y, 1.0), start));
  line.along = dot(line.direction, m_axis);
  const double back = dot(minus(start, m_eye), m_axis) / line.along;
  for (std::size_t k = 0; k < 3; ++k)
    line.origin[k] = start[k] - back * line.direction[k];
  return line;
}

std::optional<TrueView::Hit> TrueView::hit(double x, double y, const std::vector<Ball>& balls) const
{
  const Point start = unproject(x, y, -1.0);
  const Point along = minus(unproject(x, y, 1.0), start);
  std::optional<Hit> best;
  double nearest = 1.0;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const Ball& b = balls[i];
    const Point toStart = minus(start, {b.x, b.y, b.z});
    const double a = dot(along, along), half = dot(toStart, along);
    const double root = half * half - a * (dot(toStart, toStart) - b.r * b.r);
    if (root < 0.0)
      continue;
    double t = (-half - std::sqrt(root)) / a;
    if (t < 0.0)
      t = (-half + std::sqrt(root)) / a; // the near plane cuts it: its inside is seen
    if (t < 0.0 || t >= nearest)
      continue;
    nearest = t;
    Hit found;
    found.ball = static_cast<int>(i);
    for (int k = 0; k < 3; ++k)
      found.position[k] = start[k] + t * along[k];
    found.normal = unit(minus(found.position, {b.x, b.y, b.z}));
    found.depth = dot(minus(found.position, m_eye), m_axis);
    const double in[4] = {found.position[0], found.position[1], found.position[2], 1.0};
    double out[4];
    vtkMatrix4x4::MultiplyPoint(m_toView, in, out);
    found.window = 0.5 * out[2] / out[3] + 0.5;
    best = found;
  }
  return best;
}

bool TrueView::isClear(double x, double y, const std::vector<Ball>& balls, double margin) const
{
  const auto ballAt = [&](double dx, double dy)
  {
    const auto found = hit(x + dx * margin, y + dy * margin, balls);
    return found ? found->ball : -1;
  };
  const int middle = ballAt(0, 0);
  for (const double dx : {-1.0, 0.0, 1.0})
    for (const double dy : {-1.0, 0.0, 1.0})
      if (ballAt(dx, dy) != middle)
        return false;
  return true;
}

void expectBounds(vtkMoteParticleMapper* mapper, const std::array<double, 6>& expected)
{
  const double* bounds = mapper->GetBounds();
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(bounds[k], expected[k], 1e-6) << "bound " << k;
}

} // namespace mote::testing
