#include "GeneratedParticles.h"

#include "../core/Error.h"
#include "PkdTree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

namespace mote
{

namespace
{

/// What particles of a simulation are written as.
double asFloat(double v)
{
  return static_cast<float>(v);
}

class Lattice : public ParticleSource
{
public:
  explicit Lattice(std::size_t count)
  {
    side_ = static_cast<std::size_t>(std::cbrt(static_cast<double>(count)));
    const auto miss = [&](std::size_t m)
    { return std::abs(static_cast<double>(m * m * m) - static_cast<double>(count)); };
    side_ = side_ < 1 || miss(side_ + 1) < miss(side_) ? side_ + 1 : side_;
  }

  std::size_t count() const override { return side_ * side_ * side_; }
  double radius() const override { return 0.5 / static_cast<double>(side_); }
  void positions(std::size_t first, std::size_t last, Vec3d* positions) const override
  {
    const std::size_t n = side_;
    const double spacing = 1.0 / static_cast<double>(n), jitter = 0.2;
    std::array<std::size_t, 3> cell = {first % n, (first / n) % n, first / (n * n)};
    for (std::size_t i = first; i < last; ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double shift = jitter * (2.0 * uniformNumber(1, 3 * i + axis) - 1.0);
        positions[i - first][static_cast<int>(axis)] =
          asFloat((static_cast<double>(cell[axis]) + 0.5 + shift) * spacing);
      }
      for (std::size_t axis = 0; axis < 3 && ++cell[axis] == n; ++axis)
        cell[axis] = 0;
    }
  }

private:
  std::size_t side_;
};

class Random : public ParticleSource
{
public:
  Random(std::size_t count, double radius)
    : count_(count)
    , radius_(radius)
  {
  }

  std::size_t count() const override { return count_; }
  double radius() const override { return radius_; }
  void positions(std::size_t first, std::size_t last, Vec3d* positions) const override
  {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        positions[i - first][static_cast<int>(axis)] = asFloat(uniformNumber(2, 3 * i + axis));
  }

private:
  std::size_t count_;
  double radius_;
};

class Varied : public Random
{
public:
  explicit Varied(std::size_t count)
    : Random(count, 1.0)
  {
    // Deterministic: the same sum on any number of threads.
    const double squares = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, count, 1 << 14), 0.0,
      [](const tbb::blocked_range<std::size_t>& range, double sum)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          sum += std::pow(radiusOf(i), 2);
        return sum;
      },
      std::plus<double>());
    largest_ = std::sqrt(static_cast<double>(count) * std::pow(equalRadius(count), 2) / squares);
  }

  bool hasRadii() const override { return true; }
  double radius() const override { return largest_; }
  void radii(std::size_t first, std::size_t last, double* radii) const override
  {
    for (std::size_t i = first; i < last; ++i)
      radii[i - first] = radiusOf(i);
  }

private:
  static double radiusOf(std::size_t i)
  {
    return asFloat(std::pow(10.0, -4.0 * uniformNumber(3, i)));
  }

  double largest_ = 1.0;
};

template <typename T>
T numberIn(std::string_view text, const std::string& specification)
{
  T value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value > T{0}) ||
      !std::isfinite(static_cast<double>(value)))
    throw Error(specification + ": \"" + std::string(text) + "\" is not a number above zero");
  return value;
}

std::size_t countIn(std::string_view text, const std::string& specification)
{
  const auto count = numberIn<std::size_t>(text, specification);
  if (count > PkdTree::mostParticles)
    throw Error(specification + ": these are more than " + std::to_string(PkdTree::mostParticles) +
                " particles");
  return count;
}

std::vector<std::string_view> split(std::string_view text)
{
  std::vector<std::string_view> parts;
  for (std::size_t colon = text.find(':'); colon != text.npos; colon = text.find(':'))
  {
    parts.push_back(text.substr(0, colon));
    text.remove_prefix(colon + 1);
  }
  parts.push_back(text);
  return parts;
}

} // namespace

bool namesGeneratedParticles(const std::string& name)
{
  const std::vector<std::string_view> parts = split(name);
  return parts.size() > 1 &&
         (parts[0] == "lattice" || parts[0] == "random" || parts[0] == "varied");
}

std::shared_ptr<const ParticleSource> makeParticles(const std::string& specification)
{
  const std::vector<std::string_view> parts = split(specification);
  if (parts[0] == "lattice" && parts.size() == 2)
    return std::make_shared<Lattice>(countIn(parts[1], specification));
  if (parts[0] == "random" && parts.size() == 3)
    return std::make_shared<Random>(
      countIn(parts[1], specification), numberIn<double>(parts[2], specification));
  if (parts[0] == "varied" && parts.size() == 2)
    return std::make_shared<Varied>(countIn(parts[1], specification));
  throw Error(specification + ": this is neither lattice:N nor random:N:R nor varied:N");
}

double equalRadius(std::size_t count)
{
  return 0.3 / std::cbrt(static_cast<double>(count));
}

} // namespace mote
