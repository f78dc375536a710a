#include "OcclusionBake.h"

#include "../core/Error.h"
#include "detail/OcclusionSampler.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

namespace mote
{

namespace
{

/// Particles a task.
constexpr std::size_t pieceSize = 256;
/// Texels a side of the maps that adaptive ones begin with, and that any are made from.
constexpr int firstSide = 4;
/// So many rays, none of which gets out, tell that a particle is dark.
constexpr std::size_t enoughRays = 190;
/// Texels that must lie at least partly outside of other particles for a map to tell how much finer
/// ones would differ: what is seen of a particle may be a fraction of one texel of 4 x 4.
constexpr std::size_t enoughTexels = 40;

void check(const OcclusionBakeOptions& options)
{
  OcclusionMaps::levelOf(options.side);
  if (!(options.reach >= 0.0))
    throw Error("The reach of ambient occlusion must be a length of at least 0.");
  if (!(options.tolerance >= 0.0))
    throw Error("The tolerance of occlusion maps must be at least 0.");
}

/// A bake at work.
class Bake
{
public:
  Bake(const ParticleStructure& structure, const OcclusionBakeOptions& options,
    const OcclusionMaps* known);

  OcclusionMaps run(const Progress& progress, OcclusionBakeStatistics& statistics);

private:
  struct Worker
  {
    OcclusionSampler sampler;
    OcclusionTexels texels;
    OcclusionBakeStatistics done;
  };

  bool isWanted(std::size_t slot) const;
  void bakePiece(std::size_t piece, Worker& worker);
  OcclusionMaps::Level bakeParticle(
    std::size_t slot, Worker& worker, RawVector<std::uint8_t>& texels) const;
  OcclusionMaps::Level bakeFully(Worker& worker, RawVector<std::uint8_t>& texels) const;
  OcclusionMaps::Level bakeAdaptively(Worker& worker, RawVector<std::uint8_t>& texels) const;
  OcclusionMaps::Level store(const OcclusionTexels& map, RawVector<std::uint8_t>& texels) const;

  const ParticleStructure& structure_;
  const OcclusionBakeOptions& options_;
  const OcclusionMaps* known_;
  std::size_t count_;
  OcclusionMaps coding_;
  OcclusionDirectionSets directions_;
  std::vector<OcclusionPlaces> places_; ///< of maps of firstSide and more texels a side
  std::vector<OcclusionMaps::Piece> pieces_;
};

Bake::Bake(const ParticleStructure& structure, const OcclusionBakeOptions& options,
  const OcclusionMaps* known)
  : structure_(structure)
  , options_(options)
  , known_(known)
  , count_(withStructure(structure, [](const auto& s) { return s.size(); }))
  , coding_(0, options.sky)
  , directions_(std::clamp(options.samples, 4, 65536))
  , pieces_((count_ + pieceSize - 1) / pieceSize)
{
  if (known != nullptr && (known->size() != count_ || known->sky() != options.sky))
    throw Error("The occlusion maps known before belong to other particles or to another sky.");
  for (int side = firstSide; side <= std::max(firstSide, options.side); side *= 2)
    places_.emplace_back(side);
}

bool Bake::isWanted(std::size_t slot) const
{
  const bool selected =
    options_.selected ? options_.selected(slot) : known_ == nullptr || !known_->isBaked(slot);
  return selected && withStructure(structure_, [&](const auto& s) { return s.isShown(slot); });
}

OcclusionMaps::Level Bake::store(const OcclusionTexels& map, RawVector<std::uint8_t>& texels) const
{
  map.append(coding_, texels);
  return OcclusionMaps::levelOf(map.side);
}

OcclusionMaps::Level Bake::bakeFully(Worker& worker, RawVector<std::uint8_t>& texels) const
{
  OcclusionTexels& map = worker.texels;
  worker.sampler.askFew(places_.back());
  worker.sampler.askMany(false, map);
  if (worker.sampler.asked() == 0)
    return OcclusionMaps::Dark;
  map.dilate();
  while (map.side > options_.side)
    map = map.coarser();
  return store(map, texels);
}

OcclusionMaps::Level Bake::bakeAdaptively(Worker& worker, RawVector<std::uint8_t>& texels) const
{
  OcclusionSampler& sampler = worker.sampler;
  OcclusionTexels& map = worker.texels;
  bool isOpen = true;
  std::size_t asked = 0, open = 0;
  for (const OcclusionPlaces& places : places_)
  {
    sampler.askFew(places);
    asked += sampler.asked();
    open += sampler.open();
    if (open == 0 && asked >= enoughRays)
      return OcclusionMaps::Dark;
    // Where there seems to be nothing in the way, a better look.
    isOpen = isOpen && sampler.open() == sampler.asked();
    const bool isLast = &places == &places_.back();
    if (open == 0 || (!isOpen && !isLast && sampler.texels() < enoughTexels))
      continue;
    sampler.askMany(isOpen, map);
    isOpen = isOpen && sampler.open() == sampler.asked();
    if (isOpen)
      return OcclusionMaps::Open;
    map.dilate();
    // The coarsest of these that will do. Texels are cheap where maps are coarse: the allowed error
    // halves with the side, so that a byte more takes about as much off the error everywhere.
    OcclusionTexels best = map, coarse = map;
    double half = 0.0; // error of half as many texels a side
    while (coarse.side > 1)
    {
      coarse = coarse.coarser();
      const double error = map.error(coarse, options_.sky.brightest());
      if (2 * coarse.side == map.side)
        half = error;
      const double allowed =
        options_.tolerance * 2.0 * coarse.side / std::max(options_.side, map.side);
      if (error > allowed && coarse.side < options_.side)
        break;
      best = coarse;
    }
    // Where the error goes on falling with the texels' width, these are enough.
    if (best.side < map.side || map.side >= options_.side || half <= 2.0 * options_.tolerance)
      return store(best, texels);
  }
  return OcclusionMaps::Dark;
}

OcclusionMaps::Level Bake::bakeParticle(
  std::size_t slot, Worker& worker, RawVector<std::uint8_t>& texels) const
{
  worker.sampler.begin(slot);
  if (worker.sampler.isSwallowed())
    return OcclusionMaps::Dark;
  return options_.adaptive ? bakeAdaptively(worker, texels) : bakeFully(worker, texels);
}

void Bake::bakePiece(std::size_t piece, Worker& worker)
{
  OcclusionMaps::Piece& to = pieces_[piece];
  const std::size_t first = piece * pieceSize, end = std::min(count_, first + pieceSize);
  to.levels.assign(end - first, OcclusionMaps::NotBaked);
  for (std::size_t slot = first; slot < end; ++slot)
  {
    if (!isWanted(slot))
      continue;
    const OcclusionMaps::Level level = bakeParticle(slot, worker, to.texels);
    to.levels[slot - first] = level;
    ++worker.done.levels[level];
    ++worker.done.particles;
  }
  to.texels.shrink_to_fit();
}

OcclusionMaps Bake::run(const Progress& progress, OcclusionBakeStatistics& statistics)
{
  tbb::enumerable_thread_specific<Worker> workers(
    [this] {
      return Worker{OcclusionSampler(structure_, options_, directions_), {}, {}};
    });
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stopped = false;
  std::mutex telling;
  const auto bakeAll = [&]
  {
    tbb::parallel_for(std::size_t{0}, pieces_.size(),
      [&](std::size_t piece)
      {
        if (stopped)
        {
          pieces_[piece].levels.assign(
            std::min(pieceSize, count_ - piece * pieceSize), OcclusionMaps::NotBaked);
          return;
        }
        bakePiece(piece, workers.local());
        const std::size_t share = ++done;
        const std::unique_lock lock(telling, std::try_to_lock);
        if (progress && lock && share < pieces_.size() && !stopped &&
            !progress(static_cast<double>(share) / static_cast<double>(pieces_.size())))
          stopped = true;
      });
  };
  tbb::task_arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic)
    .execute(bakeAll);
  statistics.finished = done == pieces_.size();
  if (statistics.finished && progress)
    progress(1.0);
  for (const Worker& worker : workers)
  {
    statistics.particles += worker.done.particles;
    statistics.rays += worker.sampler.rays();
    for (std::size_t level = 0; level < statistics.levels.size(); ++level)
      statistics.levels[level] += worker.done.levels[level];
  }
  OcclusionMaps maps(pieces_, options_.sky);
  pieces_ = {};
  return known_ == nullptr ? maps : known_->updated(maps);
}

} // namespace

double occlusionReach(const ParticleStructure& structure, const OcclusionBakeOptions& options)
{
  if (options.reach > 0.0)
    return options.reach;
  const Vec3d size =
    withStructure(structure, [](const auto& s) { return s.statistics().bounds.size(); });
  return 0.1 * std::max({size.x, size.y, size.z});
}

OcclusionMaps bakeOcclusion(const ParticleStructure& structure, const OcclusionBakeOptions& options,
  const Progress& progress, OcclusionBakeStatistics* statistics, const OcclusionMaps* known)
{
  check(options);
  const auto start = std::chrono::steady_clock::now();
  OcclusionBakeStatistics done;
  OcclusionMaps maps = Bake(structure, options, known).run(progress, done);
  done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (statistics != nullptr)
    *statistics = done;
  return maps;
}

} // namespace mote
