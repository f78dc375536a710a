#include "Silhouettes.h"

#include "detail/LineStamps.h"
#include "detail/SilhouetteSteps.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Rows of the output that one thread takes at a time.
constexpr int bandRows = 64;

/// The rounding of distances, as a share of the distance and for the sum over eight: it must not
/// make silhouettes.
constexpr float roundingShare = 16.0f * std::numeric_limits<float>::epsilon();

StepLimit limitOf(const DepthImage& image, const SilhouetteOptions& options)
{
  const double pixels = 3.0 * std::max(0.0, options.stepInPixels);
  const double angle = std::max(std::abs(image.dx), std::abs(image.dy));
  StepLimit limit;
  limit.least = static_cast<float>(std::max(3.0 * options.step, pixels * image.pixelSize));
  limit.share = std::max(static_cast<float>(pixels * angle), roundingShare);
  limit.hulls = options.hulls;
  return limit;
}

SilhouetteGrades gradesOf(const SilhouetteOptions& options)
{
  SilhouetteGrades grades;
  grades.leastOpacity = static_cast<float>(std::clamp(options.leastOpacity, 0.0, 1.0));
  grades.graded = options.leastOpacity < 1.0 || options.leastThickness != 1.0;
  grades.perStep = static_cast<float>(1.0 / std::max(options.step, 1e-30));
  grades.perLog = static_cast<float>(1.0 / std::log2(std::max(options.fullStep, 1.0 + 1e-6)));
  return grades;
}

/// What is constant over an image.
struct Work
{
  Work(const DepthImage& depths, const SilhouetteOptions& options)
    : image(depths)
    , limit(limitOf(depths, options))
    , grades(gradesOf(options))
    , stamps(options)
    , reduction(std::max(1, options.reduction))
  {
  }

  const DepthImage& image;
  StepLimit limit;
  SilhouetteGrades grades;
  LineStamps stamps;
  int reduction;
};

/// Finds the silhouette pixels of a part of the depth image row after row, from below.
class RowFinder
{
public:
  RowFinder(const Work& work, const PixelBox& box)
    : work_(work)
    , box_(box)
    , begin_(std::max(0, box.x0 - 1))
    , end_(std::min(work.image.width, box.x1 + 1))
    , values_(3 * static_cast<std::size_t>(end_ - begin_))
  {
  }

  /// Sets `found` to the silhouette pixels of row `y`. Rows must be asked for in rising order.
  void find(int y, SilhouetteRows& found)
  {
    const DepthImage& image = work_.image;
    const int down = std::max(0, y - 1), up = std::min(image.height - 1, y + 1);
    for (int row = std::max(next_, down); row <= up; ++row)
      rayDistances(image, row, begin_, end_, at(row));
    next_ = up + 1;
    // The image's border: what is beyond counts not, and neither does what is opposite to it.
    const bool inner = down < y && up > y;
    const DistanceRows rows = {at(inner ? down : y), at(y), at(inner ? up : y)};
    const SilhouetteRow row = found.cleared(y);
    findSteps(rows, work_.limit, work_.grades, image.width, box_.x0, box_.x1, row);
    if (image.group == nullptr)
      return;
    const std::ptrdiff_t stride = image.groupStride != 0 ? image.groupStride : image.width;
    const auto groups = [&](int row) { return image.group + row * stride; };
    findGroupChanges(rows, {groups(inner ? down : y), groups(y), groups(inner ? up : y)},
      image.width, box_.x0, box_.x1, row);
  }

private:
  /// Distances of a row, counted from column 0.
  float* at(int row)
  {
    const std::size_t length = values_.size() / 3;
    return values_.data() + static_cast<std::size_t>(row % 3) * length - begin_;
  }

  const Work& work_;
  PixelBox box_;
  int begin_, end_; ///< columns whose distances are kept
  std::vector<float> values_;
  int next_ = 0; ///< first row whose distances are not there yet
};

/// Silhouettes of the pixels `box` of the depth image itself. `covered` as in SilhouetteFinder, or
/// null where `out` has been cleared.
void drawBox(const Work& work, const PixelBox& box, float* out, std::ptrdiff_t stride,
  std::uint8_t* covered = nullptr)
{
  const std::ptrdiff_t blocks =
    (box.x1 - box.x0 + SilhouetteFinder::coveredColumns - 1) / SilhouetteFinder::coveredColumns;
  const int reach = work.stamps.reach();
  const PixelBox wider = {std::max(0, box.x0 - reach), std::max(0, box.y0 - reach),
    std::min(work.image.width, box.x1 + reach), std::min(work.image.height, box.y1 + reach)};
  RowFinder finder(work, wider);
  SilhouetteRows rows(wider.x0, wider.x1, reach);
  int found = wider.y0;
  for (int y = box.y0; y < box.y1; ++y)
  {
    for (; found < std::min(wider.y1, y + reach + 1); ++found)
      finder.find(found, rows);
    coverRow(rows, work.stamps, work.grades.leastOpacity < 1.0f, y, wider.y0, wider.y1 - 1, box.x0,
      box.x1, {out + (y - box.y0) * stride, covered ? covered + (y - box.y0) * blocks : nullptr});
  }
}

/// Means over the squares of `factor` x `factor` fine pixels; the last may be cut off.
void addMeans(const std::vector<float>& fine, const PixelBox& fineBox, int factor,
  const PixelBox& box, float* out, std::ptrdiff_t stride)
{
  const int width = fineBox.x1 - fineBox.x0;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
    {
      const int x0 = x * factor, x1 = std::min(fineBox.x1, x0 + factor);
      const int y0 = y * factor, y1 = std::min(fineBox.y1, y0 + factor);
      float sum = 0.0f;
      for (int j = y0; j < y1; ++j)
        for (int i = x0; i < x1; ++i)
          sum += fine[static_cast<std::size_t>(j - fineBox.y0) * width + (i - fineBox.x0)];
      float& covered = out[(y - box.y0) * stride + (x - box.x0)];
      covered = std::max(covered, sum / static_cast<float>((x1 - x0) * (y1 - y0)));
    }
}

/// Silhouettes of the pixels `box` of the output, in this thread.
void findInBox(const Work& work, const PixelBox& box, float* coverage, std::ptrdiff_t stride)
{
  const int factor = work.reduction;
  if (factor == 1)
    return drawBox(work, box, coverage, stride);
  for (int y0 = box.y0; y0 < box.y1; y0 += bandRows)
  {
    const PixelBox band = {box.x0, y0, box.x1, std::min(box.y1, y0 + bandRows)};
    const PixelBox fineBox = {band.x0 * factor, band.y0 * factor,
      std::min(work.image.width, band.x1 * factor), std::min(work.image.height, band.y1 * factor)};
    const std::size_t width = fineBox.x1 - fineBox.x0;
    std::vector<float> fine(width * (fineBox.y1 - fineBox.y0), 0.0f);
    drawBox(work, fineBox, fine.data(), static_cast<std::ptrdiff_t>(width));
    addMeans(fine, fineBox, factor, band, coverage + (y0 - box.y0) * stride, stride);
  }
}

bool isEmpty(const PixelBox& box)
{
  return box.x0 >= box.x1 || box.y0 >= box.y1;
}

} // namespace

int silhouetteMargin(const SilhouetteOptions& options)
{
  // One more for the neighbours of the pixels whose lines reach in.
  return reducedSize(LineStamps(options).reach() + 1, options.reduction);
}

void findSilhouettes(
  const DepthImage& image, const SilhouetteOptions& options, float* coverage, int threads)
{
  const PixelBox all = {0, 0, reducedSize(image.width, options.reduction),
    reducedSize(image.height, options.reduction)};
  if (isEmpty(all))
    return;
  const Work work(image, options);
  const auto band = [&](int first, int last)
  {
    const PixelBox box = {0, first * bandRows, all.x1, std::min(all.y1, last * bandRows)};
    findInBox(work, box, coverage + std::ptrdiff_t(box.y0) * all.x1, all.x1);
  };
  const int bands = reducedSize(all.y1, bandRows);
  if (threads == 1 || bands == 1)
    return band(0, bands);
  const auto run = [&]
  {
    tbb::parallel_for(tbb::blocked_range<int>(0, bands),
      [&](const tbb::blocked_range<int>& range) { band(range.begin(), range.end()); });
  };
  if (threads > 0)
    tbb::task_arena(threads).execute(run);
  else
    run();
}

void findSilhouettes(const DepthImage& image, const SilhouetteOptions& options, const PixelBox& box,
  float* coverage, std::ptrdiff_t stride)
{
  if (!isEmpty(box))
    findInBox(Work(image, options), box, coverage, stride);
}

struct SilhouetteFinder::Work : mote::Work
{
  using mote::Work::Work;
};

SilhouetteFinder::SilhouetteFinder(const DepthImage& image, const SilhouetteOptions& options)
  : work_(std::make_unique<Work>(image, options))
{
}

SilhouetteFinder::~SilhouetteFinder() = default;

void SilhouetteFinder::find(
  const PixelBox& box, float* coverage, std::ptrdiff_t stride, std::uint8_t* covered) const
{
  if (!isEmpty(box))
    drawBox(*work_, box, coverage, stride, covered);
}

} // namespace mote
