#include "GhostPixels.h"

#include "kernels/core/Film.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mote
{

namespace
{

/// The marks of each prop, or null.
std::vector<vtkUnsignedCharArray*> marksOf(const MoteProps& props)
{
  std::vector<vtkUnsignedCharArray*> marks;
  for (const auto& prop : props)
    marks.push_back(prop->ghosts());
  return marks;
}

static_assert(
  int(vtkDataSetAttributes::DUPLICATEPOINT) == int(vtkDataSetAttributes::DUPLICATECELL));

/// Whether the ray through the middle of a pixel met a ghost first.
bool isGhost(const Film& film, std::size_t pixel, const std::vector<vtkUnsignedCharArray*>& ofProps)
{
  const std::int32_t object = film.object()[pixel];
  if (!std::isfinite(film.depth()[pixel]) || object < 0 ||
      static_cast<std::size_t>(object) >= ofProps.size())
    return false;
  vtkUnsignedCharArray* marks = ofProps[static_cast<std::size_t>(object)];
  const auto id = static_cast<vtkIdType>(film.id()[pixel]);
  return marks && id >= 0 && id < marks->GetNumberOfValues() &&
         (marks->GetValue(id) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
}

} // namespace

unsigned GhostPixels::channels(const MoteProps& props)
{
  return std::any_of(props.begin(), props.end(), [](const auto& prop) { return prop->ghosts(); })
           ? unsigned(Film::Id)
           : 0u;
}

void GhostPixels::find(
  const Film& seen, const Film& film, const SilhouetteLayer& lines, const MoteProps& props)
{
  marks_.clear();
  if (channels(props) == 0 || !seen.has(Film::Id))
    return;
  const auto ofProps = marksOf(props);
  marks_.resize(film.pixels());
  const int width = film.width(), height = film.height();
  // What other rays of a pixel met, and lines, belong to what is nearest beside it.
  const auto besideIsGhost = [&](std::size_t i, int reach)
  {
    std::size_t nearest = i;
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach); ++u)
        if (const std::size_t beside = static_cast<std::size_t>(v) * width + u;
            seen.depth()[beside] < seen.depth()[nearest])
          nearest = beside;
    return isGhost(seen, nearest, ofProps);
  };
  tbb::parallel_for(0, height,
    [&](int row)
    {
      const auto first = static_cast<std::size_t>(row) * width;
      for (std::size_t i = first; i != first + width; ++i)
        marks_[i] = std::isfinite(seen.depth()[i]) ? isGhost(seen, i, ofProps)
                    : film.color()[4 * i + 3] > 0  ? besideIsGhost(i, 1)
                                                   : false;
      // Lines of other samples than the first lie up to a pixel aside.
      if (lines.film)
        lines.forCovered(row, row + 1,
          [&](std::size_t i, float) { marks_[i] = besideIsGhost(i, lines.film->reach() + 1); });
    });
}

std::vector<float> GhostPixels::spared(const Film& seen, const float* limits, int border) const
{
  std::vector<float> spared(seen.pixels(), std::numeric_limits<float>::infinity());
  if (limits)
    std::copy_n(limits, seen.pixels(), spared.begin());
  const int width = seen.width(), height = seen.height();
  const auto isDrawn = [&](int x, int y)
  {
    const std::size_t i = static_cast<std::size_t>(y) * width + x;
    return marks_[i] == 0 && std::isfinite(seen.depth()[i]);
  };
  tbb::parallel_for(0, marks_.empty() ? 0 : height,
    [&](int y)
    {
      for (int x = 0; x < width; ++x)
        if (const std::size_t i = static_cast<std::size_t>(y) * width + x; marks_[i] != 0)
        {
          bool isBeside = false;
          for (int v = std::max(0, y - border); v <= std::min(height - 1, y + border); ++v)
            for (int u = std::max(0, x - border); u <= std::min(width - 1, x + border); ++u)
              isBeside = isBeside || isDrawn(u, v);
          if (!isBeside)
            spared[i] = 0.0f;
        }
    });
  return spared;
}

} // namespace mote
