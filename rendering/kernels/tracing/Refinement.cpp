#include "Refinement.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

double standardError(const Film& film)
{
  if (film.samples() < 2)
    return std::numeric_limits<double>::infinity();
  struct Sum
  {
    double variance = 0.0;
    std::size_t pixels = 0;
  };
  // Deterministic: whether a picture is done must not depend on the threads.
  const Sum all = tbb::parallel_deterministic_reduce(
    tbb::blocked_range<std::size_t>(0, film.pixels(), 1 << 14), Sum{},
    [&](const tbb::blocked_range<std::size_t>& range, Sum sum)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        if (film.color()[4 * i + 3] > 0.0f)
        {
          const float* c = film.color() + 4 * i;
          const double bright = std::max({1.0f, c[0], c[1], c[2]});
          sum.variance += film.variance(i) / (bright * bright);
          ++sum.pixels;
        }
      return sum;
    },
    [](const Sum& a, const Sum& b) {
      return Sum{a.variance + b.variance, a.pixels + b.pixels};
    });
  const double samples = static_cast<double>(std::max<std::size_t>(all.pixels, 1)) * film.samples();
  return std::sqrt(all.variance / samples);
}

bool Refinement::isDone(const Film& film) const
{
  if (film.samples() >= samples)
    return true;
  return noise > 0.0 && film.samples() >= fewestSamples && standardError(film) <= noise;
}

double Refinement::progress(const Film& film) const
{
  const double counted = double(film.samples()) / std::max(1, samples);
  if (!(noise > 0.0) || film.samples() < fewestSamples)
    return counted;
  return std::clamp(std::pow(noise / standardError(film), 2.0), counted, 1.0);
}

} // namespace mote
