#pragma once

// Bundles of rays through the hierarchy. Included where they are asked.

#include "BundleFrustum.h"
#include "HexBvhWalk.h"
#include "LineBundle.h"

namespace mote
{

namespace detail
{

/// A bundle's state while it goes through leaves. As in LeafVisits, what a leaf refers to is on its
/// way from memory for some steps before it is looked at.
template <typename Visit>
class BundleVisits
{
public:
  BundleVisits(const HexMesh& mesh, const LineBundle& lines, int count, const HexField* field,
    BundleSpans& spans, const Visit& visit)
    : mesh_(mesh)
    , lines_(lines)
    , field_(field)
    , spans_(spans)
    , visit_(visit)
    , wanted_(~std::uint64_t(0) >> (LineBundle::capacity - count))
    , enough_(spansOfRay * static_cast<std::size_t>(count))
    , limit_(enough_)
  {
    spans_.clear();
  }

  /// The bundle comes to a leaf, not before `t`. False where no ray wants more.
  bool leaf(const std::uint32_t* first, std::uint32_t count, double t)
  {
    __builtin_prefetch(first);
    return step({first, first + count, t});
  }
  void finish()
  {
    for (int i = 0; i < stages; ++i)
      if (!step({nullptr, nullptr, std::numeric_limits<double>::infinity()}))
        return;
    tell(std::numeric_limits<double>::infinity());
  }

private:
  static constexpr int stages = 3;
  static constexpr std::size_t spansOfRay = 8; ///< that are kept before they are told of
  struct Leaf
  {
    const std::uint32_t *first = nullptr, *last = nullptr;
    double t = 0.0;
  };

  bool step(const Leaf& leaf)
  {
    const auto behind = [&](int count) -> Leaf&
    { return leaves_[(came_ - static_cast<unsigned>(count)) % leaves_.size()]; };
    ++came_;
    behind(0) = leaf;
    for (const std::uint32_t* cell = behind(1).first; cell < behind(1).last; ++cell)
      __builtin_prefetch(&mesh_.cell(*cell));
    for (const std::uint32_t* cell = behind(2).first; cell < behind(2).last; ++cell)
      for (const std::uint32_t point : mesh_.cell(*cell))
      {
        __builtin_prefetch(&mesh_.point(point));
        if (field_ != nullptr)
          field_->prefetch(point);
      }
    for (const std::uint32_t* cell = behind(3).first; cell < behind(3).last; ++cell)
      lines_.addSpans(mesh_, *cell, field_, wanted_, spans_);
    return spans_.size() < limit_ || tell(behind(2).t);
  }

  /// Tells of the spans that begin before `t`, ray by ray.
  bool tell(double t)
  {
    for (std::uint64_t rays = wanted_; rays != 0; rays &= rays - 1)
    {
      const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
      std::size_t told = 0;
      bool more = true;
      for (const ValuedSpan& span : spans_.of(ray))
      {
        if (span.span.tIn >= t)
          break;
        ++told;
        if (!(more = visit_(ray, span)))
          break;
      }
      if (!more)
        wanted_ &= ~(std::uint64_t(1) << ray);
      spans_.dropFirst(ray, more ? told : spans_.of(ray).size());
    }
    limit_ = spans_.size() + enough_;
    return wanted_ != 0;
  }

  const HexMesh& mesh_;
  const LineBundle& lines_;
  const HexField* field_;
  BundleSpans& spans_;
  const Visit& visit_;
  std::uint64_t wanted_; ///< rays, a bit each
  std::size_t enough_, limit_;
  std::array<Leaf, stages + 1> leaves_{};
  unsigned came_ = stages + 1;
};

} // namespace detail

template <typename Space>
template <typename Visit, typename Keep>
bool HexBvh<Space>::forCellsAlongBundle(const HexRay* rays, int count,
  const BundleFrustum::Sides& sides, const HexField* field, BundleSpans& spans, const Visit& visit,
  const Keep& keep) const
{
  const BundleFrustum frustum(rays, count, sides, space_.origin());
  const LineBundle lines(rays, count);
  if (!frustum.exists() || !lines.isCoherent())
    return false;
  detail::BundleVisits<Visit> visits(*mesh_, lines, count, field, spans, visit);
  detail::NodeQueue queue;
  const auto push = [&](std::uint32_t n)
  {
    double t;
    if ((!ranges_.empty() && !keep(ranges_[n])) || !frustum.meets(nodes_[n].region.bounds(), t))
      return;
    if (nodes_[n].count == 0)
      __builtin_prefetch(&nodes_[nodes_[n].first]);
    queue.push(n, t);
  };
  if (!nodes_.empty())
    push(0);
  double t = queue.least();
  for (std::uint32_t n = 0; queue.pop(n); t = queue.least())
  {
    const Node& node = nodes_[n];
    if (node.count > 0 && !visits.leaf(&cells_[node.first], node.count, t))
      return true;
    for (std::uint32_t i = 0; node.count == 0 && i < 2; ++i)
      push(node.first + i);
  }
  visits.finish();
  return true;
}

} // namespace mote
