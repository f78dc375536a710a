#include "AmbientBaker.h"

#include "../Report.h"
#include "../Timing.h"

#include <bit>

namespace mote::bench
{

namespace
{

bool has(const SlotBits& slots, std::size_t slot)
{
  return slots.empty() || (slots[slot / 64] >> (slot % 64) & 1) != 0;
}

/// Baked to find the fastest way of Embree.
constexpr std::size_t trialParticles = 200;

} // namespace

AmbientBaker::AmbientBaker(const Options& options, const ParticleInput& input,
  const ParticleStructure& structure, double reach)
  : samples_(options.samples)
  , input_(input)
  , structure_(structure)
  , size_(withStructure(structure, [](const auto& s) { return s.size(); }))
  , reach_(reach)
{
}

std::size_t AmbientBaker::count(const SlotBits& slots) const
{
  if (slots.empty())
    return size_;
  std::size_t count = 0;
  for (const std::uint64_t word : slots)
    count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

SlotBits AmbientBaker::thinned(const SlotBits& slots, std::size_t count) const
{
  constexpr std::size_t run = 16;
  const std::size_t stride = (this->count(slots) + count - 1) / count;
  SlotBits thin((size_ + 63) / 64, 0);
  std::size_t seen = 0;
  for (std::size_t slot = 0; slot < size_; ++slot)
    if (has(slots, slot) && seen++ / run % stride == 0)
      thin[slot / 64] |= std::uint64_t{1} << (slot % 64);
  return thin;
}

OcclusionBakeOptions AmbientBaker::baking(
  const AmbientMethod& method, const SlotBits& slots, int threads, std::size_t mode)
{
  OcclusionBakeOptions like;
  like.samples = samples_;
  like.reach = reach_;
  like.threads = threads;
  if (!slots.empty())
    like.selected = [&slots](std::size_t slot) { return has(slots, slot); };
  if (method.embree)
  {
    if (!embree_)
    {
      progress("building Embree's spheres");
      embree_ = std::make_unique<EmbreeBake>(threadCount(0));
      embree_->build(input_);
    }
    like.occlude = [this, mode](RayPacket& packet) { embree_->occlude(mode, packet); };
  }
  return method.baking(like);
}

std::size_t AmbientBaker::bestEmbreeMode(const SlotBits& slots, int threads)
{
  if (embreeModeKnown_)
    return embreeMode_;
  AmbientMethod method;
  method.embree = true;
  const SlotBits some = thinned(slots, trialParticles);
  double least = 0.0;
  for (std::size_t mode = 0; mode < EmbreeBake::modes().size(); ++mode)
  {
    OcclusionBakeStatistics done;
    bakeOcclusion(structure_, baking(method, some, threads, mode), {}, &done);
    progress("bake by Embree, %s: %.2f Mrays/s", EmbreeBake::modes()[mode].c_str(),
      1e-6 * done.raysPerSecond());
    if (mode == 0 || done.seconds < least)
    {
      least = done.seconds;
      embreeMode_ = mode;
    }
  }
  embreeModeKnown_ = true;
  return embreeMode_;
}

BakedMaps AmbientBaker::bakeQuickly(const AmbientMethod& method, const SlotBits& slots, int threads)
{
  const int samples = samples_;
  samples_ = method.adaptive ? samples : 1;
  BakedMaps baked = bake(method, slots, threads);
  samples_ = samples;
  return baked;
}

BakedMaps AmbientBaker::bake(const AmbientMethod& method, const SlotBits& slots, int threads)
{
  const std::size_t mode = method.embree ? bestEmbreeMode(slots, threads) : 0;
  BakedMaps baked;
  baked.mode =
    method.embree ? EmbreeBake::modes()[mode] : particleStructureNames()[1 + structure_.index()];
  baked.maps = std::make_shared<const OcclusionMaps>(
    bakeOcclusion(structure_, baking(method, slots, threads, mode), {}, &baked.statistics));
  return baked;
}

} // namespace mote::bench
