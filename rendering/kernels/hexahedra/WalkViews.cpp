#include "WalkViews.h"

#include "detail/WalkView.h"

#include <algorithm>

namespace mote
{

std::shared_ptr<const WalkView> WalkViews::find(const CameraRays& rays, int width, int height)
{
  const auto same = [&](const Kept& one)
  {
    const CameraRays& r = one.rays;
    return one.width == width && one.height == height && r.o0 == rays.o0 && r.ox == rays.ox &&
           r.oy == rays.oy && r.d0 == rays.d0 && r.dx == rays.dx && r.dy == rays.dy;
  };
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), same);
  if (found == kept_.end())
    return nullptr;
  std::rotate(kept_.begin(), found, found + 1);
  return kept_.front().view;
}

std::shared_ptr<const WalkView> WalkViews::view(
  const WalkCells& cells, const CameraRays& rays, int width, int height)
{
  if (auto view = this->find(rays, width, height))
    return view;
  auto view = std::make_shared<const WalkView>(cells, rays, width, height);
  const std::lock_guard lock(mutex_);
  kept_.insert(kept_.begin(), {rays, width, height, view});
  if (kept_.size() > most)
    kept_.pop_back();
  return view;
}

const CellRuns& WalkViews::runs(const HexMesh& mesh)
{
  const std::lock_guard lock(mutex_);
  if (!runs_)
    runs_ = std::make_unique<const CellRuns>(mesh);
  return *runs_;
}

std::size_t WalkViews::bytes() const
{
  const std::lock_guard lock(mutex_);
  return runs_ ? runs_->bytes() : 0;
}

} // namespace mote
