#include "VolumeReference.h"

#include <kernels/hexahedra/CellCrossings.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace mote::bench
{

namespace
{

/// Colour and transmittance of a piece of a ray.
struct Light
{
  Vec3d color{0.0};
  double through = 1.0;

  /// What is seen through this is put behind it.
  void put(const Light& behind)
  {
    color += through * behind.color;
    through *= behind.through;
  }
};

double distance(const Light& a, const Light& b)
{
  const Vec3d d = glm::abs(a.color - b.color);
  return std::max({d.x, d.y, d.z, std::abs(a.through - b.through)});
}

/// What a value emits, its colour times its extinction, and the extinction.
struct Emission
{
  Vec3d color{0.0};
  double extinction = 0.0;
};

/// The transfer function by its definition.
Emission emissionOf(const TransferFunction& transfer, double value)
{
  const std::vector<TransferFunction::Knot>& knots = transfer.knots;
  std::size_t k = 0;
  while (k < knots.size() && knots[k].value <= value)
    ++k;
  Vec4d c(knots[std::min(k, knots.size() - 1)].color);
  if (k > 0)
  {
    const Vec4d before(knots[k - 1].color);
    c = k == knots.size() ? before
                          : before + (value - knots[k - 1].value) /
                                       (knots[k].value - knots[k - 1].value) * (c - before);
  }
  const double extinction = -std::log1p(-c.a) / transfer.unitDistance;
  return {extinction * Vec3d(c), extinction};
}

/// A cell along a ray; places are in world units along it.
class CellLight
{
public:
  CellLight(const HexMesh& mesh, const HexField& field, const TransferFunction& transfer,
    std::uint32_t cell, const Vec3d& origin, const Vec3d& direction)
    : shape_(mesh, cell)
    , transfer_(transfer)
    , offset_(field.offset())
    , origin_(origin)
    , direction_(direction)
  {
    if (field.isOfCells())
      values_.fill(field.ofCell(cell));
    else
      values_ = field.corners(mesh.cell(cell));
  }

  bool isNaN() const
  {
    return std::any_of(values_.begin(), values_.end(), [](double v) { return std::isnan(v); });
  }

  Light between(double from, double to)
  {
    const Emission a = at(from), b = at(0.5 * (from + to)), c = at(to);
    return halved(from, to, a, b, c, step(to - from, a, b, c), 0);
  }

private:
  static constexpr double tolerance = 1e-9;
  static constexpr int deepest = 40;

  Emission at(double s)
  {
    const Vec3d p = origin_ + s * direction_;
    if (!shape_.coordinates(p, rst_, rst_))
      shape_.coordinates(p, rst_);
    const Vec3d rst = glm::clamp(rst_, Vec3d(0.0), Vec3d(1.0));
    return emissionOf(transfer_, offset_ + weighted(values_, TrilinearCell::weights(rst)));
  }

  /// One step of length h of the classical Runge-Kutta method.
  static Light step(double h, const Emission& a, const Emission& b, const Emission& c)
  {
    const double t1 = 1.0, t2 = 1.0 - 0.5 * h * a.extinction * t1;
    const double t3 = 1.0 - 0.5 * h * b.extinction * t2, t4 = 1.0 - h * b.extinction * t3;
    Light light;
    light.color = h / 6.0 * (t1 * a.color + 2.0 * (t2 + t3) * b.color + t4 * c.color);
    light.through =
      1.0 - h / 6.0 * (t1 * a.extinction + 2.0 * (t2 + t3) * b.extinction + t4 * c.extinction);
    return light;
  }

  Light halved(double from, double to, const Emission& a, const Emission& b, const Emission& c,
    const Light& whole, int depth)
  {
    const double middle = 0.5 * (from + to), h = middle - from;
    const Emission ab = at(0.5 * (from + middle)), bc = at(0.5 * (middle + to));
    const Light first = step(h, a, ab, b), second = step(h, b, bc, c);
    Light both = first;
    both.put(second);
    if (depth > 0 && (distance(whole, both) < tolerance || depth == deepest))
      return both;
    both = halved(from, middle, a, ab, b, first, depth + 1);
    both.put(halved(middle, to, b, bc, c, second, depth + 1));
    return both;
  }

  TrilinearCell shape_;
  const TransferFunction& transfer_;
  double offset_;
  Vec3d origin_, direction_;
  CornerValues values_{};
  Vec3d rst_{0.5};
};

/// The part of a pixel's ray in a cell.
struct PixelSpan
{
  std::size_t pixel = 0; ///< of the reference
  CellSpan span;
};

bool isBefore(const PixelSpan& a, const PixelSpan& b)
{
  return a.pixel != b.pixel ? a.pixel < b.pixel : a.span.tIn < b.span.tIn;
}

/// The rays of the reference's pixels.
class PixelRays
{
public:
  PixelRays(const ReferencePixels& pixels, const CameraRays& rays)
    : pixels_(pixels)
    , rays_(rays)
    , toImage_(glm::inverse(Mat3d(rays.d0, rays.dx, rays.dy)))
  {
    for (int j = 0; j < pixels.rows(); ++j)
      for (int i = 0; i < pixels.columns(); ++i)
        lines_.emplace_back(rays.o0, direction(i, j));
  }

  std::size_t count() const { return lines_.size(); }
  const Vec3d& origin() const { return rays_.o0; }
  Vec3d direction(std::size_t pixel) const
  {
    const auto columns = static_cast<std::size_t>(pixels_.columns());
    return direction(static_cast<int>(pixel % columns), static_cast<int>(pixel / columns));
  }

  /// Adds the spans of all rays in the cell.
  void cut(const HexMesh& mesh, std::size_t cell, std::vector<PixelSpan>& spans) const
  {
    const HexCorners corners = mesh.corners(cell);
    double lower[2] = {infinity, infinity}, upper[2] = {-infinity, -infinity};
    for (const Vec3d& p : corners)
    {
      const Vec3d q = toImage_ * (p - rays_.o0); // t, t x and t y
      for (int k = 0; k < 2; ++k)
      {
        lower[k] = std::min(lower[k], q[k + 1] / q[0]);
        upper[k] = std::max(upper[k], q[k + 1] / q[0]);
      }
    }
    const int i0 = from(lower[0]), i1 = to(upper[0], pixels_.columns());
    const int j0 = from(lower[1]), j1 = to(upper[1], pixels_.rows());
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(pixels_.columns()) +
          static_cast<std::size_t>(i);
        CellIntervals intervals;
        if (lines_[pixel].intersect(corners, intervals))
          for (const CellInterval& part : intervals)
            spans.push_back({pixel, {static_cast<std::uint32_t>(cell), part.in, part.out}});
      }
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double margin = 0.01; ///< pixels, far above rounding

  static double center(int k) { return ReferencePixels::first + k * ReferencePixels::stride + 0.5; }
  Vec3d direction(int i, int j) const { return rays_.directionAt(center(i), center(j)); }
  static double place(double pixel) { return (pixel - center(0)) / ReferencePixels::stride; }
  static int from(double pixel)
  {
    return static_cast<int>(std::ceil(std::clamp(place(pixel - margin), 0.0, 1e6)));
  }
  static int to(double pixel, int count)
  {
    return static_cast<int>(std::floor(std::clamp(place(pixel + margin), -1.0, count - 1.0)));
  }

  const ReferencePixels& pixels_;
  const CameraRays& rays_;
  Mat3d toImage_;
  std::vector<CrossingLine> lines_;
};

std::vector<PixelSpan> spansOf(const HexMesh& mesh, const PixelRays& rays)
{
  tbb::enumerable_thread_specific<std::vector<PixelSpan>> parts;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cellCount(), 4096),
    [&](const tbb::blocked_range<std::size_t>& cells)
    {
      std::vector<PixelSpan>& spans = parts.local();
      for (std::size_t cell = cells.begin(); cell != cells.end(); ++cell)
        rays.cut(mesh, cell, spans);
    });
  std::vector<PixelSpan> spans;
  for (const std::vector<PixelSpan>& part : parts)
    spans.insert(spans.end(), part.begin(), part.end());
  std::sort(spans.begin(), spans.end(), isBefore);
  return spans;
}

} // namespace

ReferencePixels referencePixels(const HexMesh& mesh, const HexField& field,
  const TransferFunction& transfer, const CameraRays& rays, int width, int height)
{
  ReferencePixels pixels{width, height, {}};
  const PixelRays pixelRays(pixels, rays);
  const std::vector<PixelSpan> spans = spansOf(mesh, pixelRays);
  pixels.colors.assign(pixelRays.count(), Vec4d(0.0));
  tbb::parallel_for(std::size_t{0}, pixelRays.count(),
    [&](std::size_t pixel)
    {
      const Vec3d direction = pixelRays.direction(pixel);
      const double length = glm::length(direction);
      Light light;
      double done = 0.0; // what two cells claim counts once
      for (auto at = std::lower_bound(
             spans.begin(), spans.end(), PixelSpan{pixel, {0, -1.0, 0.0}}, isBefore);
           at != spans.end() && at->pixel == pixel; ++at)
      {
        const double from = std::max(at->span.tIn, done), to = at->span.tOut;
        done = std::max(done, to);
        CellLight cell(
          mesh, field, transfer, at->span.cell, pixelRays.origin(), direction / length);
        if (from < to && !cell.isNaN())
          light.put(cell.between(from * length, to * length));
      }
      pixels.colors[pixel] = Vec4d(light.color, 1.0 - light.through);
    });
  return pixels;
}

ColorErrors compare(const ReferencePixels& reference, const float* rgba)
{
  ColorErrors errors;
  double sum = 0.0, most = 0.0;
  for (int j = 0; j < reference.rows(); ++j)
    for (int i = 0; i < reference.columns(); ++i)
    {
      const int x = ReferencePixels::first + i * ReferencePixels::stride;
      const int y = ReferencePixels::first + j * ReferencePixels::stride;
      const float* c =
        rgba + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width) +
                     static_cast<std::size_t>(x));
      const Vec4d is(c[0], c[1], c[2], c[3]);
      const Vec4d right = reference.colors[static_cast<std::size_t>(j * reference.columns() + i)];
      if (is == Vec4d(0.0) && right == Vec4d(0.0))
        continue;
      ++errors.checked;
      const Vec4d d = glm::abs(is - right);
      sum += glm::dot(d, d);
      most = std::max({most, d.x, d.y, d.z, d.w});
    }
  if (errors.checked > 0)
  {
    errors.rms = std::sqrt(0.25 * sum / static_cast<double>(errors.checked));
    errors.max = most;
  }
  return errors;
}

} // namespace mote::bench
