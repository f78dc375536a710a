#include "FilmFill.h"

#include "Film.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace mote
{

namespace
{

/// A place between two pixels of a row or a column of `count` pixels.
struct Between
{
  int low, high, nearest;
  float share; ///< of the high one

  /// Of the middle of a pixel of as long a row of `newCount` pixels.
  Between(int pixel, int count, int newCount)
  {
    const double at = (pixel + 0.5) * count / newCount;
    nearest = std::min(static_cast<int>(at), count - 1);
    const double between = std::clamp(at - 0.5, 0.0, count - 1.0);
    low = static_cast<int>(between);
    high = std::min(low + 1, count - 1);
    share = static_cast<float>(between - low);
  }
};

} // namespace

void fillFrom(const Film& other, Film& film)
{
  const bool hasIds = film.has(Film::Id) && other.has(Film::Id);
  tbb::parallel_for(0, film.height(),
    [&](int row)
    {
      const Between y(row, other.height(), film.height());
      const auto rowOf = [&](int r) { return static_cast<std::size_t>(r) * other.width(); };
      for (int column = 0; column < film.width(); ++column)
      {
        const Between x(column, other.width(), film.width());
        const std::size_t pixel = static_cast<std::size_t>(row) * film.width() + column;
        const float* bottom[2] = {
          other.color() + 4 * (rowOf(y.low) + x.low), other.color() + 4 * (rowOf(y.low) + x.high)};
        const float* top[2] = {other.color() + 4 * (rowOf(y.high) + x.low),
          other.color() + 4 * (rowOf(y.high) + x.high)};
        for (int c = 0; c < 4; ++c)
        {
          const float below = bottom[0][c] + x.share * (bottom[1][c] - bottom[0][c]);
          const float above = top[0][c] + x.share * (top[1][c] - top[0][c]);
          film.color()[4 * pixel + c] = below + y.share * (above - below);
        }
        const std::size_t nearest = rowOf(y.nearest) + x.nearest;
        film.depth()[pixel] = other.nearestDepth()[nearest];
        if (hasIds)
        {
          film.id()[pixel] = other.id()[nearest];
          film.object()[pixel] = other.object()[nearest];
        }
      }
    });
}

void fillWithNothing(Film& film)
{
  const std::size_t n = film.pixels();
  std::fill_n(film.color(), 4 * n, 0.0f);
  std::fill_n(film.depth(), n, std::numeric_limits<float>::infinity());
  std::fill_n(film.id(), film.has(Film::Id) ? n : 0, Film::noId);
  std::fill_n(film.object(), film.has(Film::Id) ? n : 0, -1);
  std::fill_n(film.normal(), film.has(Film::Normal) ? 3 * n : 0, 0.0f);
  std::fill_n(film.squares(), film.has(Film::Variance) ? n : 0, 0.0f);
}

} // namespace mote
