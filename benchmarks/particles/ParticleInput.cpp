#include "ParticleInput.h"

#include "Random.h"

#include <kernels/core/Error.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <charconv>
#include <cmath>
#include <filesystem>

namespace mote::bench
{

namespace
{

constexpr std::size_t largestCount = std::size_t{1} << 31; // embree counts in 32 bits

template <typename T>
T number(const std::string& text, const std::string& specification)
{
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !(value > T{0}))
    throw Error(
      "\"" + text + "\" in the input \"" + specification + "\" is not a number above zero.");
  return value;
}

ParticleInput fromPositions(std::shared_ptr<std::vector<float>> positions, double radius)
{
  ParticleInput input;
  input.set.positions = ArrayView(positions->data(), positions->size() / 3, 3);
  input.set.radius = radius;
  input.owner = std::move(positions);
  return input;
}

ParticleInput makeLattice(std::size_t count)
{
  auto n = static_cast<std::size_t>(std::cbrt(static_cast<double>(count)));
  const auto miss = [&](std::size_t m)
  { return std::abs(static_cast<double>(m * m * m) - static_cast<double>(count)); };
  n = n < 1 || miss(n + 1) < miss(n) ? n + 1 : n;
  auto positions = std::make_shared<std::vector<float>>(3 * n * n * n);
  const double spacing = 1.0 / static_cast<double>(n), jitter = 0.2;
  tbb::parallel_for(std::size_t{0}, n * n * n,
    [&](std::size_t i)
    {
      const std::size_t cell[3] = {i % n, (i / n) % n, i / (n * n)};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double shift = jitter * (2.0 * uniform(1, 3 * i + axis) - 1.0);
        (*positions)[3 * i + axis] =
          static_cast<float>((static_cast<double>(cell[axis]) + 0.5 + shift) * spacing);
      }
    });
  return fromPositions(std::move(positions), 0.5 * spacing);
}

ParticleInput makeRandom(std::size_t count, double radius)
{
  auto positions = std::make_shared<std::vector<float>>(3 * count);
  tbb::parallel_for(std::size_t{0}, 3 * count,
    [&](std::size_t k) { (*positions)[k] = static_cast<float>(uniform(2, k)); });
  return fromPositions(std::move(positions), radius);
}

double sumOfSquares(const std::vector<float>& values)
{
  // Deterministic: the same sum on any number of threads.
  return tbb::parallel_deterministic_reduce(
    tbb::blocked_range<std::size_t>(0, values.size(), 1 << 16), 0.0,
    [&](const tbb::blocked_range<std::size_t>& range, double sum)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        sum += double(values[i]) * values[i];
      return sum;
    },
    std::plus<double>());
}

/// Radii over four decades. They cover as much as `count` spheres of equalRadius(count) do: then a
/// ray meets as many of them, and times compare.
ParticleInput makeVaried(std::size_t count)
{
  ParticleInput input = makeRandom(count, 1.0);
  auto radii = std::make_shared<std::vector<float>>(count);
  tbb::parallel_for(std::size_t{0}, count,
    [&](std::size_t i) { (*radii)[i] = static_cast<float>(std::pow(10.0, -4.0 * uniform(3, i))); });
  const double covered = static_cast<double>(count) * std::pow(equalRadius(count), 2);
  const double largest = std::sqrt(covered / sumOfSquares(*radii));
  input.set.radii = ArrayView(radii->data(), count, 1);
  input.set.radiusScale = largest;
  using Owners = std::pair<std::shared_ptr<const void>, std::shared_ptr<const void>>;
  input.owner = std::make_shared<Owners>(input.owner, std::move(radii));
  return input;
}

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::size_t particleCount(const std::string& text, const std::string& specification)
{
  const auto count = number<std::size_t>(text, specification);
  if (count > largestCount)
    throw Error("The input \"" + specification + "\" has more than " +
                std::to_string(largestCount) + " particles.");
  return count;
}

ParticleInput makeOrRead(const std::string& specification)
{
  const std::vector<std::string> parts = split(specification);
  const bool isFile = std::filesystem::exists(specification);
  if (parts[0] == "lattice" && parts.size() == 2 && !isFile)
    return makeLattice(particleCount(parts[1], specification));
  if (parts[0] == "random" && parts.size() == 3 && !isFile)
    return makeRandom(
      particleCount(parts[1], specification), number<double>(parts[2], specification));
  if (parts[0] == "varied" && parts.size() == 2 && !isFile)
    return makeVaried(particleCount(parts[1], specification));
  if (isFile)
    return readParticles(specification);
  throw Error("The input \"" + specification +
              "\" is neither lattice:N nor random:N:R nor varied:N nor a file that exists.");
}

} // namespace

double equalRadius(std::size_t count)
{
  return 0.3 / std::cbrt(static_cast<double>(count));
}

ParticleInput makeParticleInput(const std::string& specification)
{
  ParticleInput input = makeOrRead(specification);
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
