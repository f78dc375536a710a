#include "ParticleOcclusion.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <functional>

namespace mote
{

bool wereBakedWith(const StoredOcclusion& stored, const OcclusionBakeOptions& options)
{
  return stored.side == options.side && stored.samples == options.samples &&
         stored.reach == options.reach && stored.adaptive == options.adaptive &&
         (!options.adaptive || stored.tolerance == options.tolerance) &&
         stored.dilate == options.dilate && stored.maps.sky() == options.sky;
}

void ParticleOcclusion::begin(
  const ParticleStructure& structure, const OcclusionBakeOptions& options)
{
  options_ = options;
  options_.selected = {};
  options_.reach = occlusionReach(structure, options);
  statistics_ = {};
  shown_ = shownBits(structure);
  maps_ = std::make_shared<OcclusionMaps>(
    withStructure(structure, [](const auto& s) { return s.size(); }), options.sky);
}

void ParticleOcclusion::begin(const ParticleStructure& structure,
  const OcclusionBakeOptions& options, const StoredOcclusion& stored)
{
  this->begin(structure, options);
  options_.side = stored.side;
  options_.samples = stored.samples;
  options_.reach = stored.reach;
  options_.tolerance = stored.tolerance;
  options_.adaptive = stored.adaptive;
  options_.dilate = stored.dilate;
  options_.sky = stored.maps.sky();
  maps_ = std::make_shared<OcclusionMaps>(stored.maps.inSlotOrder(structure));
  withStructure(structure,
    [&](const auto& s)
    {
      for (std::size_t slot = 0; slot < s.size(); ++slot)
      {
        const std::uint64_t bit = std::uint64_t{1} << (slot % 64);
        std::uint64_t& word = shown_[slot / 64];
        word = stored.isShown(s.inputIndex(slot)) ? word | bit : word & ~bit;
      }
    });
  this->update(structure);
}

void ParticleOcclusion::update(const ParticleStructure& structure)
{
  ParticleBits shown = shownBits(structure);
  if (shown == shown_)
    return;
  maps_ = std::make_shared<OcclusionMaps>(stillValid(*maps_, structure, shown_, options_.reach));
  shown_ = std::move(shown);
}

std::size_t ParticleOcclusion::countMissing(const ParticleBits& wanted) const
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, maps_->size(), std::size_t{1} << 16), std::size_t{0},
    [&](const tbb::blocked_range<std::size_t>& slots, std::size_t count)
    {
      for (std::size_t slot = slots.begin(); slot != slots.end(); ++slot)
        count += isMissing(wanted, slot);
      return count;
    },
    std::plus<>());
}

bool ParticleOcclusion::bake(
  const ParticleStructure& structure, const ParticleBits& wanted, const Progress& progress)
{
  if (countMissing(wanted) == 0)
    return true;
  OcclusionBakeOptions options = options_;
  options.selected = [&](std::size_t slot) { return isMissing(wanted, slot); };
  OcclusionBakeStatistics statistics;
  maps_ = std::make_shared<OcclusionMaps>(
    bakeOcclusion(structure, options, progress, &statistics, maps_.get()));
  statistics_.particles += statistics.particles;
  statistics_.rays += statistics.rays;
  statistics_.seconds += statistics.seconds;
  statistics_.finished = statistics.finished;
  for (std::size_t level = 0; level < statistics.levels.size(); ++level)
    statistics_.levels[level] += statistics.levels[level];
  return statistics.finished;
}

StoredOcclusion ParticleOcclusion::stored(
  const ParticleStructure& structure, std::size_t inputs, const ContentHash& content) const
{
  StoredOcclusion stored;
  stored.maps = maps_->inInputOrder(structure, inputs);
  stored.content = content;
  stored.shown.resize((inputs + 63) / 64);
  const bool all = withStructure(structure,
    [&](const auto& s)
    {
      std::size_t count = 0;
      for (std::size_t slot = 0; slot < s.size(); ++slot)
        if (const std::uint64_t input = s.inputIndex(slot); hasBit(shown_, slot))
        {
          stored.shown[input / 64] |= std::uint64_t{1} << (input % 64);
          ++count;
        }
      return count == s.size();
    });
  if (all)
    stored.shown.clear();
  stored.side = options_.side;
  stored.samples = options_.samples;
  stored.reach = options_.reach;
  stored.tolerance = options_.tolerance;
  stored.adaptive = options_.adaptive;
  stored.dilate = options_.dilate;
  return stored;
}

} // namespace mote
