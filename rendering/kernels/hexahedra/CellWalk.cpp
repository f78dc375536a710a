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
/// cells have different signs: with these factors, of bounds, of a ray's share of them, and of
/// estimates, the largest error of a picture was below the tolerance wherever it was tried, see
/// docs/hexahedra.md.
constexpr double bounds = 60.0, shares = 30.0, estimates = 10.0;
/// The same for colours that change on the way through a cell.
constexpr double colorShare = 150.0;

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

/// A ray as WalkCells has places.
struct CellWalk::Line
{
  Vec3d origin, direction;

  /// The axis that it runs along most of all, twice; one more where it runs backwards.
  int order() const
  {
    const Vec3d size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
  }
  /// The order; or -1 where it runs nearly as much along another axis.
  int clearOrder() const
  {
    const int clear = order();
    const Vec3d size = glm::abs(direction);
    const int axis = clear / 2;
    const double other = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    return other < (1.0 - 1e-9) * size[axis] ? clear : -1;
  }
  /// t of a depth, see WalkRays.
  double timeOf(double depth, const WalkTask& task) const
  {
    const double from = origin[task.axis];
    return (depth - (task.isBackwards ? -from : from)) / std::abs(direction[task.axis]);
  }
};

inline CellWalk::Line CellWalk::lineAt(const Place& place) const
{
  return {own_.originAt(place.x, place.y), own_.directionAt(place.x, place.y)};
}

/// Integrates parts as CellIntegral does.
class CellWalk::Seldom final : public SeldomParts
{
public:
  Seldom(const CellWalk& walk, const Part* parts, const WalkTask& task)
    : walk_(walk)
    , parts_(parts)
    , task_(task)
  {
  }

  void add(const WalkPart& part, float* color) override
  {
    const Place& place = parts_[task_.rays.index[static_cast<std::size_t>(part.ray)]].place;
    const Line line = walk_.lineAt(place);
    const HexRay ray{
      walk_.local_.originAt(place.x, place.y), walk_.local_.directionAt(place.x, place.y)};
    const double speed = glm::length(walk_.world_.directionAt(place.x, place.y));
    RayGatherer gatherer(nullptr);
    gatherer.color() = {{color[0], color[1], color[2]}, color[3]};
    CellIntegral integral(
      walk_.cells_.mesh(), walk_.field_, walk_.settings_, walk_.lighting_, ray, speed, gatherer);
    ValuedSpan span;
    span.span.cell = part.cell;
    span.span.tIn = line.timeOf(part.z[0], task_);
    span.span.tOut = line.timeOf(part.z[1], task_);
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
  const Part* parts_;
  const WalkTask& task_;
};

CellWalk::CellWalk(const WalkCells& cells, const HexField& field, const CloudSettings& settings,
  const CloudLighting* lighting, const CameraRays& rays, const Mat4d& toLocal, int width,
  int height, const HiddenCells* hidden)
  : cells_(cells)
  , field_(field)
  , settings_(settings)
  , lighting_(lighting)
  , hidden_(hidden)
  , transfer_(std::make_unique<WalkTransfer>(
      settings.transfer, field.lower() - field.offset(), field.upper() - field.offset()))
  , world_(rays)
  , local_(rays.transformed(toLocal))
  , own_(local_)
{
  constexpr double most = std::numeric_limits<float>::max(), least = 1e-30;
  rate_ = static_cast<float>(std::clamp(steepestOf(settings.transfer), least, most));
  own_.o0 = cells.toLocal(own_.o0);
  for (Vec3d* step : {&own_.ox, &own_.oy, &own_.d0, &own_.dx, &own_.dy})
    *step /= cells.size();
  view_ = cells.views().view(cells, local_, width, height);
}

CellWalk::~CellWalk() = default;

bool CellWalk::isSupported()
{
  return canWalk();
}

void CellWalk::gather(
  const Part* parts, int count, RayColor* colors, std::vector<RayRun>* runs) const
{
  std::fill_n(colors, count, RayColor());
  thread_local std::vector<std::uint32_t> faces; // keeps its memory
  double left = parts->place.x, right = left, lower = parts->place.y, upper = lower;
  for (int i = 1; i < count; ++i)
  {
    left = std::min(left, parts[i].place.x);
    right = std::max(right, parts[i].place.x);
    lower = std::min(lower, parts[i].place.y);
    upper = std::max(upper, parts[i].place.y);
  }
  faces.clear();
  view_->gather(left, right, lower, upper, faces);
  if (faces.empty())
    return;
  thread_local WalkTask task; // keeps its memory
  task.cells = &cells_;
  task.view = view_.get();
  task.transfer = transfer_.get();
  task.hidden = hidden_;
  task.isAllSeldom = lighting_ != nullptr;
  task.leastTransmittance = static_cast<float>(settings_.leastTransmittance);
  task.rate = rate_;
  task.allowed = static_cast<float>(bounds * settings_.tolerance / settings_.size);
  task.allowedShare = static_cast<float>(shares * settings_.tolerance / settings_.size);
  task.allowedOff = static_cast<float>(estimates * settings_.tolerance / settings_.size);
  task.share = static_cast<float>(colorShare * settings_.tolerance);
  task.steps = task.fallbacks = task.seldomParts = 0;
  Seldom seldom(*this, parts, task);
  task.seldom = &seldom;
  std::vector<std::vector<RayRun>> found(runs ? static_cast<std::size_t>(count) : 0);
  task.runs = runs ? found.data() : nullptr;
  // Rays along the same axis together: nearly always all of them.
  std::array<int, mostRays> orders;
  const int common = this->commonOrder(left, right, lower, upper);
  for (int i = 0; i < count; ++i)
    orders[static_cast<std::size_t>(i)] = common >= 0 ? common : lineAt(parts[i].place).order();
  for (int order = 0; order < 6; ++order)
  {
    if (std::find(orders.data(), orders.data() + count, order) == orders.data() + count)
      continue;
    task.axis = order / 2;
    task.isBackwards = order % 2 != 0;
    task.rays.count = 0;
    for (int i = 0; i < count; ++i)
      if (orders[static_cast<std::size_t>(i)] == order)
        this->addRay(task, parts[i], i);
    for (auto& run : found)
      run.clear();
    task.entries.clear();
    testEntries(task, faces);
    walkRays(task);
    this->takeAnswers(task, parts, colors, runs);
  }
  steps_ += task.steps;
  fallbacks_ += task.fallbacks;
  seldom_ += task.seldomParts;
}

/// The order of all rays in a rectangle, or -1. Directions of one order are convex: what four
/// corners have is that of those between them.
int CellWalk::commonOrder(double left, double right, double lower, double upper) const
{
  const int order = lineAt({left, lower}).clearOrder();
  for (const Place& corner : {Place{right, lower}, Place{left, upper}, Place{right, upper}})
    if (lineAt(corner).clearOrder() != order)
      return -1;
  return order;
}

/// Puts a ray beside the others of its order.
void CellWalk::addRay(WalkTask& task, const Part& part, int index) const
{
  const Line line = lineAt(part.place);
  const Vec3d &o = line.origin, &d = line.direction;
  const int z = task.axis, x = (z + 1) % 3, y = (z + 2) % 3;
  const double per = 1.0 / d[z], dx = d[x] * per, dy = d[y] * per, perTime = std::abs(d[z]);
  const double from = task.isBackwards ? -o[z] : o[z];
  const double speed = glm::length(world_.directionAt(part.place.x, part.place.y));
  WalkRays& rays = task.rays;
  const auto i = static_cast<std::size_t>(rays.count++);
  rays.placeX[i] = static_cast<float>(part.place.x);
  rays.placeY[i] = static_cast<float>(part.place.y);
  rays.dx[i] = static_cast<float>(dx);
  rays.dy[i] = static_cast<float>(dy);
  rays.x[i] = static_cast<float>(o[x] - dx * o[z]);
  rays.y[i] = static_cast<float>(o[y] - dy * o[z]);
  rays.from[i] = static_cast<float>(from + perTime * part.from);
  rays.to[i] = static_cast<float>(from + perTime * part.to);
  rays.length[i] = static_cast<float>(speed * std::abs(per));
  rays.color[i] = {0.0f, 0.0f, 0.0f, 1.0f};
  rays.index[i] = index;
}

void CellWalk::takeAnswers(
  const WalkTask& task, const Part* parts, RayColor* colors, std::vector<RayRun>* runs) const
{
  for (int k = 0; k < task.rays.count; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const std::array<float, 4>& c = task.rays.color[i];
    const int index = task.rays.index[i];
    colors[index] = {{c[0], c[1], c[2]}, c[3]};
    if (!runs)
      continue;
    const Line line = lineAt(parts[index].place);
    for (RayRun run : task.runs[i])
    {
      run.tIn = line.timeOf(run.tIn, task);
      runs[index].push_back(run);
    }
  }
}

WalkSteps CellWalk::counts() const
{
  return {steps_, fallbacks_, seldom_};
}

} // namespace mote
