#include "CloudPicking.h"

#include "../hexahedra/CellSampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote
{

namespace
{

/// A piece of the ray within a cell, as if it looked the same all the way.
struct Piece
{
  const CloudObject* cloud = nullptr;
  std::uint32_t cell = 0;
  double tIn = 0.0, tOut = 0.0;
  double extinction = 0.0; ///< per world unit
  double value = 0.0;
};

/// Adds up what the pieces of a ray keep of its light, in their order.
class Sum
{
public:
  explicit Sum(double speed)
    : speed_(speed)
  {
  }

  void add(const Piece& piece)
  {
    // The pieces of a cell count together; the one that keeps back most says where.
    if (piece.cloud != last_.cloud || piece.cell != last_.cell)
      this->endCell();
    last_ = piece;
    const double kept =
      through_ * -std::expm1(-piece.extinction * (piece.tOut - piece.tIn) * speed_);
    through_ -= kept;
    ofCell_ += kept;
    if (kept > most_)
      most_ = kept, densest_ = piece;
  }
  void endCell()
  {
    if (ofCell_ > best_)
      best_ = ofCell_, found_ = densest_;
    ofCell_ = most_ = 0.0;
  }

  /// Whether no cell behind can keep more than the best one has, and the ray is half opaque.
  bool isDecided() const
  {
    const bool isBest = ofCell_ > best_ ? through_ <= ofCell_ : ofCell_ + through_ <= best_;
    return isBest && through_ < 0.5;
  }
  double opacity() const { return 1.0 - through_; }
  const Piece& found() const { return found_; } ///< of no cloud where there is none

private:
  double speed_;
  double through_ = 1.0, best_ = 0.0, ofCell_ = 0.0, most_ = 0.0;
  Piece last_, densest_, found_;
};

/// Pieces of the ray in one cloud, in order.
template <typename Add>
class Pieces
{
public:
  Pieces(const CloudObject& cloud, const TransferTable& transfer, const HexMesh& mesh,
    const HexRay& ray, const Add& add)
    : cloud_(cloud)
    , transfer_(transfer)
    , sampler_(mesh, *cloud.field)
    , ray_(ray)
    , add_(add)
  {
  }

  bool operator()(const CellSpan& span)
  {
    constexpr int perCell = 8;
    if (cloud_.hidden && (*cloud_.hidden)[span.cell])
      return true;
    sampler_.enter(span.cell);
    const auto [low, high] =
      std::minmax_element(sampler_.values().begin(), sampler_.values().end());
    if (!sampler_.isNaN() && !transfer_.isVisible(*low, *high))
      return true;
    const double length = (span.tOut - span.tIn) / perCell;
    for (int i = 0; i < perCell && length > 0.0; ++i)
    {
      Piece piece{&cloud_, span.cell, span.tIn + i * length, span.tIn + (i + 1) * length};
      const Vec3d middle = ray_.origin + 0.5 * (piece.tIn + piece.tOut) * ray_.direction;
      const double value = sampler_.isNaN() ? std::nan("") : sampler_.trilinear(middle);
      piece.extinction = (sampler_.isNaN() ? transfer_.ofNaN() : transfer_(value)).extinction;
      piece.value = value + cloud_.field->offset();
      if (piece.extinction > 0.0 && !add_(piece))
        return false;
    }
    return true;
  }

private:
  const CloudObject& cloud_;
  const TransferTable& transfer_;
  CellSampler sampler_;
  const HexRay& ray_;
  const Add& add_;
};

/// Calls add(piece) for the pieces of a ray in a cloud, until it says false.
template <typename Add>
void forPieces(
  const CloudObject& cloud, const TransferTable& transfer, const HexRay& ray, const Add& add)
{
  const HexMesh& mesh = meshOf(cloud);
  Pieces<Add> pieces(cloud, transfer, mesh, ray, add);
  if (!cloud.structure)
  {
    for (const CellSpan& span : cloud.walk->views().runs(mesh).spansOf(mesh, ray))
      if (!pieces(span))
        return;
    return;
  }
  withStructure(*cloud.structure,
    [&](const auto& s)
    {
      s.forCellsAlong(
        ray, [&](const CellSpan& span) { return pieces(span); },
        [&](const ScalarRange& range) { return transfer.isVisible(range.lower, range.upper); },
        NoCounts{});
    });
}

} // namespace

CloudPicker::CloudPicker(const Scene& scene)
{
  for (const CloudObject& cloud : scene.clouds)
    looks_.push_back(
      {&cloud, glm::inverse(cloud.toWorld), TransferTable(cloud.transfer, cloud.field->offset())});
}

std::optional<CloudPick> CloudPicker::pick(
  const Vec3d& origin, const Vec3d& direction, double tMin, double tMax, Wanted wanted) const
{
  Sum sum(glm::length(direction));
  // The parts of the ray where a cloud is shown, in its coordinates.
  const auto raysIn = [&](const Look& look)
  {
    RaySpan spans[ClipRegion::mostSpans];
    const int count = look.cloud->clip.spansOf(origin, direction, tMin, tMax, spans);
    std::vector<HexRay> rays;
    for (int k = 0; k < count; ++k)
      rays.push_back({transformPoint(look.toLocal, origin),
        transformVector(look.toLocal, direction), spans[k].tIn, spans[k].tOut});
    return rays;
  };
  if (looks_.size() == 1) // spans come in order
  {
    const auto goesOn = [&] { return wanted == Wanted::All || !sum.isDecided(); };
    for (const HexRay& ray : raysIn(looks_.front()))
      if (goesOn())
        forPieces(*looks_.front().cloud, looks_.front().transfer, ray,
          [&](const Piece& piece)
          {
            sum.add(piece);
            return goesOn();
          });
  }
  else
  {
    std::vector<Piece> pieces;
    for (const Look& look : looks_)
      for (const HexRay& ray : raysIn(look))
        forPieces(*look.cloud, look.transfer, ray,
          [&](const Piece& piece)
          {
            pieces.push_back(piece);
            return true;
          });
    std::stable_sort(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.tIn < b.tIn; });
    for (const Piece& piece : pieces)
      sum.add(piece);
  }
  sum.endCell();
  const Piece& found = sum.found();
  if (!found.cloud)
    return std::nullopt;
  CloudPick pick;
  pick.object = found.cloud->id;
  pick.cell = meshOf(*found.cloud).inputCell(found.cell);
  pick.value = found.value;
  pick.t = 0.5 * (found.tIn + found.tOut);
  pick.position = origin + pick.t * direction;
  pick.opacity = sum.opacity();
  return pick;
}

std::optional<CloudPick> pickCloud(
  const Scene& scene, const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
{
  return CloudPicker(scene).pick(origin, direction, tMin, tMax);
}

} // namespace mote
