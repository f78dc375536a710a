#include "CellWalk.h"

#include "CellIntegral.h"
#include "detail/WalkTask.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// An error e of the scalar changes the picture by e rate length at most; each length of a ray may
/// have its share of the tolerance. Bounds are for the worst way through a cell, and errors of
/// cells have different signs: with these factors, of bounds and of estimates, the largest error of
/// a picture was below the tolerance wherever it was tried, see docs/hexahedra.md.
constexpr double bounds = 60.0, estimates = 10.0;
/// The same for colours that change on the way through a cell.
constexpr double colorShare = 50.0;

/// The axis that a ray runs along most of all, and twice that; one more where it runs backwards.
int orderOf(const Vec3d& direction)
{
  const Vec3d size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}

/// How fast the look changes with the scalar, at most.
double steepestOf(const TransferTable& transfer)
{
  constexpr double far = std::numeric_limits<double>::max();
  for (std::size_t piece = 1; piece + 1 < transfer.pieces(); ++piece)
    if (transfer.lowerEnd(piece) == transfer.upperEnd(piece))
      return far; // a step
  return transfer.steepest(-far, far);
}

} // namespace

/// Integrates parts as CellIntegral does.
class CellWalk::Seldom final : public SeldomParts
{
public:
  Seldom(const CellWalk& walk, const Ray* rays, const WalkTask& task)
    : walk_(walk)
    , rays_(rays)
    , task_(task)
  {
  }

  void add(const WalkPart& part, float* color) override
  {
    const Ray& ray = rays_[task_.rays.index[static_cast<std::size_t>(part.ray)]];
    RayGatherer gatherer(nullptr);
    gatherer.color() = {{color[0], color[1], color[2]}, color[3]};
    CellIntegral integral(walk_.cells_.mesh(), walk_.field_, walk_.settings_, walk_.lighting_,
      ray.ray, ray.speed, gatherer);
    const int axis = task_.axis;
    const double perDepth = walk_.perDepth(ray.ray, axis);
    const double origin = walk_.cells_.toLocal(ray.ray.origin)[axis];
    ValuedSpan span;
    span.span.cell = part.cell;
    span.span.tIn = perDepth * (part.z[0] - (task_.isBackwards ? -origin : origin));
    span.span.tOut = perDepth * (part.z[1] - (task_.isBackwards ? -origin : origin));
    span.span.inFace = part.isCut[0] ? noFace : 0; // whichever: values are told
    span.span.outFace = part.isCut[1] ? noFace : 0;
    span.valueIn = part.value[0];
    span.valueOut = part.value[1];
    span.bend = part.bend;
    integral(span);
    integral.finish();
    const RayColor& total = gatherer.total();
    for (int k = 0; k < 3; ++k)
      color[k] = static_cast<float>(total.color[k]);
    color[3] = static_cast<float>(total.transmittance);
  }

private:
  const CellWalk& walk_;
  const Ray* rays_;
  const WalkTask& task_;
};

CellWalk::CellWalk(const WalkCells& cells, const HexField& field, const CloudSettings& settings,
  const CloudLighting* lighting, const CameraRays& rays, int width, int height)
  : cells_(cells)
  , field_(field)
  , settings_(settings)
  , lighting_(lighting)
  , transfer_(std::make_unique<WalkTransfer>(
      settings.transfer, field.lower() - field.offset(), field.upper() - field.offset()))
  , view_(std::make_unique<WalkView>(cells, rays, width, height))
{
  constexpr double most = std::numeric_limits<float>::max(), least = 1e-30;
  rate_ = static_cast<float>(std::clamp(steepestOf(settings.transfer), least, most));
}

CellWalk::~CellWalk() = default;

bool CellWalk::isSupported()
{
  return canWalk();
}

void CellWalk::gather(const Ray* rays, int count, RayColor* colors, std::vector<RayRun>* runs) const
{
  thread_local WalkTask task; // keeps its memory
  task.cells = &cells_;
  task.view = view_.get();
  task.transfer = transfer_.get();
  task.isAllSeldom = lighting_ != nullptr;
  task.leastTransmittance = static_cast<float>(settings_.leastTransmittance);
  task.rate = rate_;
  task.allowed = static_cast<float>(bounds * settings_.tolerance / settings_.size);
  task.allowedOff = static_cast<float>(estimates * settings_.tolerance / settings_.size);
  task.share = static_cast<float>(colorShare * settings_.tolerance);
  task.steps = task.fallbacks = task.seldomParts = 0;
  Seldom seldom(*this, rays, task);
  task.seldom = &seldom;
  std::vector<std::vector<RayRun>> found(runs ? static_cast<std::size_t>(count) : 0);
  std::array<int, 6> wanted{};
  for (int i = 0; i < count; ++i)
    ++wanted[static_cast<std::size_t>(orderOf(rays[i].ray.direction / cells_.size()))];
  for (int order = 0; order < 6; ++order)
  {
    if (wanted[static_cast<std::size_t>(order)] == 0)
      continue;
    task.axis = order / 2;
    task.isBackwards = order % 2 != 0;
    task.rays.count = 0;
    for (int i = 0; i < count; ++i)
      if (orderOf(rays[i].ray.direction / cells_.size()) == order)
        addRay(task, rays[i], i);
    for (auto& run : found)
      run.clear();
    task.runs = runs ? found.data() : nullptr;
    findEntries(task);
    walkRays(task);
    this->takeAnswers(task, rays, colors, runs);
  }
  steps_ += task.steps;
  fallbacks_ += task.fallbacks;
  seldom_ += task.seldomParts;
}

/// How much t grows with depth.
double CellWalk::perDepth(const HexRay& ray, int axis) const
{
  return cells_.size()[axis] / std::abs(ray.direction[axis]);
}

/// Puts a ray beside the others of its order.
void CellWalk::addRay(WalkTask& task, const Ray& ray, int index) const
{
  const Vec3d o = cells_.toLocal(ray.ray.origin), d = ray.ray.direction / cells_.size();
  const int z = task.axis, x = (z + 1) % 3, y = (z + 2) % 3;
  const double perTime = std::abs(d[z]);
  const double from = task.isBackwards ? -o[z] : o[z];
  WalkRays& rays = task.rays;
  const auto i = static_cast<std::size_t>(rays.count++);
  rays.placeX[i] = static_cast<float>(ray.x);
  rays.placeY[i] = static_cast<float>(ray.y);
  rays.dx[i] = static_cast<float>(d[x] / d[z]);
  rays.dy[i] = static_cast<float>(d[y] / d[z]);
  rays.x[i] = static_cast<float>(o[x] - d[x] / d[z] * o[z]);
  rays.y[i] = static_cast<float>(o[y] - d[y] / d[z] * o[z]);
  rays.from[i] = static_cast<float>(from + perTime * ray.ray.tMin);
  rays.to[i] = static_cast<float>(from + perTime * ray.ray.tMax);
  rays.length[i] = static_cast<float>(ray.speed / perTime);
  rays.color[i] = {0.0f, 0.0f, 0.0f, 1.0f};
  rays.index[i] = index;
}

void CellWalk::takeAnswers(
  const WalkTask& task, const Ray* rays, RayColor* colors, std::vector<RayRun>* runs) const
{
  for (int k = 0; k < task.rays.count; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const std::array<float, 4>& c = task.rays.color[i];
    const int index = task.rays.index[i];
    colors[index] = {{c[0], c[1], c[2]}, c[3]};
    if (!runs)
      continue;
    const HexRay& ray = rays[index].ray;
    const double origin = cells_.toLocal(ray.origin)[task.axis];
    for (RayRun run : task.runs[i])
    {
      run.tIn = perDepth(ray, task.axis) * (run.tIn - (task.isBackwards ? -origin : origin));
      runs[index].push_back(run);
    }
  }
}

void findEntries(WalkTask& task)
{
  thread_local std::vector<std::uint32_t> faces; // keeps its memory
  faces.clear();
  const WalkRays& rays = task.rays;
  const auto x = std::minmax_element(rays.placeX.data(), rays.placeX.data() + rays.count);
  const auto y = std::minmax_element(rays.placeY.data(), rays.placeY.data() + rays.count);
  task.view->gather(*x.first, *x.second, *y.first, *y.second, faces);
  task.entries.clear();
  testEntries(task, faces);
}

WalkSteps CellWalk::counts() const
{
  return {steps_, fallbacks_, seldom_};
}

} // namespace mote
