#include "ParticleInput.h"

#include <kernels/core/Error.h>
#include <kernels/particles/GeneratedParticles.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>

namespace mote::bench
{

namespace
{

constexpr std::size_t largestCount = std::size_t{1} << 31; // embree counts in 32 bits

/// Whoever owns the numbers of made particles.
struct MadeParticles
{
  std::vector<float> positions, radii;
};

/// The source's particles in memory: what builds a structure is not to be timed making them.
ParticleSet inMemory(const ParticleSource& source, MadeParticles& owner)
{
  const std::size_t n = source.count(), piece = 4096;
  owner.positions.resize(3 * n);
  owner.radii.resize(source.hasRadii() ? n : 0);
  tbb::parallel_for(std::size_t{0}, (n + piece - 1) / piece,
    [&](std::size_t k)
    {
      const std::size_t first = k * piece, last = std::min(n, first + piece);
      std::vector<Vec3d> places(last - first);
      std::vector<double> sizes(last - first);
      source.positions(first, last, places.data());
      source.radii(first, last, sizes.data());
      for (std::size_t i = first; i < last; ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
          owner.positions[3 * i + static_cast<std::size_t>(axis)] =
            static_cast<float>(places[i - first][axis]);
        if (source.hasRadii())
          owner.radii[i] = static_cast<float>(sizes[i - first]);
      }
    });
  ParticleSet set;
  set.positions = ArrayView(owner.positions.data(), n, 3);
  if (source.hasRadii())
    set.radii = ArrayView(owner.radii.data(), n, 1);
  (source.hasRadii() ? set.radiusScale : set.radius) = source.radius();
  return set;
}

std::shared_ptr<const ParticleSource> sourceNamed(const std::string& specification)
{
  try
  {
    return makeParticles(specification);
  }
  catch (const Error& error)
  {
    throw Error(std::string("The input ") + error.what() + ".");
  }
}

ParticleInput make(const std::string& specification, bool onTheFly)
{
  const std::shared_ptr<const ParticleSource> source = sourceNamed(specification);
  if (source->count() > largestCount)
    throw Error("The input \"" + specification + "\" has more than " +
                std::to_string(largestCount) + " particles.");
  ParticleInput input;
  if (onTheFly)
  {
    input.set = ParticleSet::of(source);
    return input;
  }
  const auto owner = std::make_shared<MadeParticles>();
  input.set = inMemory(*source, *owner);
  input.owner = owner;
  return input;
}

ParticleInput makeOrRead(const std::string& specification, bool onTheFly)
{
  const bool isFile = std::filesystem::exists(specification);
  if (!isFile && namesGeneratedParticles(specification))
    return make(specification, onTheFly);
  if (isFile)
    return readParticles(specification);
  throw Error("The input \"" + specification +
              "\" is neither lattice:N nor random:N:R nor varied:N nor a file that exists.");
}

} // namespace

ParticleInput makeParticleInput(const std::string& specification, bool onTheFly)
{
  ParticleInput input = makeOrRead(specification, onTheFly);
  input.name = specification;
  input.statistics = examine(input.set);
  if (input.statistics.valid == 0)
    throw Error("The input \"" + specification + "\" has no particle.");
  return input;
}

std::vector<Named> particleInputs()
{
  return {
    {"lattice:N", "cubic lattice in the unit cube, n^3 particles nearest to N, each moved by up "
                  "to 0.2 spacings an axis, radius half a spacing"},
    {"random:N:R", "N particles evenly at random in the unit cube, radius R"},
    {"varied:N", "N particles evenly at random in the unit cube, radii log-uniform over four "
                 "decades; the largest is such that the sum of the cross sections is that of "
                 "random:N:R with R = 0.3 / cbrt(N)"},
    {"FILE",
      "what Mote's readers read; arrays radius or diameter count, half the spacing otherwise"}};
}

} // namespace mote::bench
