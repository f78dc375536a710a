#include "CellIntegral.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

constexpr double overcaution = 6.0; ///< of bounds, see integrate()

} // namespace

CellIntegral::CellIntegral(const HexMesh& mesh, const HexField& field,
  const CloudSettings& settings, const CloudLighting* lighting, const HexRay& ray, double speed,
  RayGatherer& gatherer)
  : settings_(settings)
  , lighting_(lighting)
  , ray_(ray)
  , line_(ray.origin, ray.direction)
  , speed_(speed)
  , gatherer_(gatherer)
  , cell_(mesh, field)
  , end_(-std::numeric_limits<double>::infinity())
{
}

bool CellIntegral::take(const CellSpan& span, const ValuedSpan* values)
{
  if (span.tIn > end_)
    gatherer_.begin(span.tIn);
  end_ = std::max(end_, span.tOut);
  cell_.enter(span.cell);
  const double length = (span.tOut - span.tIn) * speed_;
  if (cell_.isNaN())
    gatherer_.color().add(settings_.transfer.ofNaN(), length);
  else if (cell_.isConstant())
    gatherer_.color().add(settings_.transfer(cell_.values()[0]), length);
  else
  {
    const auto [low, high] = std::minmax_element(cell_.values().begin(), cell_.values().end());
    lower_ = *low;
    upper_ = *high;
    if (!settings_.transfer.isVisible(lower_, upper_))
      return true;
    // Each cell takes the values of its own points: where they coincide with the neighbour's and
    // have other values, the field jumps.
    const double entry =
      values != nullptr && span.inFace != noFace ? values->valueIn : cell_.entry(line_, span, ray_);
    const double exit = values != nullptr && span.outFace != noFace ? values->valueOut
                                                                    : cell_.exit(line_, span, ray_);
    if (lighting_ != nullptr)
      light(0.5 * (span.tIn + span.tOut), light_);
    const double bend =
      values != nullptr ? values->bend : bendOf(cell_.mesh().corners(span.cell), cell_.values());
    integrate(span.tIn, entry, span.tOut, exit, bend, 0);
  }
  return gatherer_.transmittance() > settings_.leastTransmittance;
}

/// The light at t, as what it does to colours: it is linear in them.
void CellIntegral::light(double t, Light& light)
{
  const Vec3d p = ray_.origin + t * ray_.direction, gradient = cell_.gradient(p);
  light.isOn = true;
  light.plus = (*lighting_)(Vec3d(0.0), p, gradient, ray_.direction);
  light.times = (*lighting_)(Vec3d(1.0), p, gradient, ray_.direction) - light.plus;
}

/// What is not linear in the cell's own coordinates.
double CellIntegral::ownBend() const
{
  const CornerValues& v = cell_.values();
  const double rs = (v[2] - v[3]) - (v[1] - v[0]), st = (v[7] - v[4]) - (v[3] - v[0]);
  const double tr = (v[5] - v[1]) - (v[4] - v[0]);
  const double rst = ((v[6] - v[7]) - (v[5] - v[4])) - ((v[2] - v[3]) - (v[1] - v[0]));
  return 0.25 * (std::abs(rs) + std::abs(st) + std::abs(tr) + std::abs(rst));
}

/// `bend` is how far the scalar may be from the line between the ends.
void CellIntegral::integrate(double t0, double v0, double t1, double v1, double bend, int depth)
{
  const double length = (t1 - t0) * speed_;
  // An error e of the scalar changes the picture by e rate length at most; each length of the ray
  // may have its share of the tolerance. Bounds are for the worst way through a cell, and errors of
  // cells have different signs: what comes of them was less than a tenth (tested).
  const double allowed =
    overcaution * settings_.tolerance / (settings_.size * gatherer_.transmittance());
  const double rate = settings_.transfer.steepest(lower_, upper_);
  if (bend == 0.0 || rate * bend < allowed)
    return addMonotonic(CubicPiece::line(v0, v1), 0.0, 1.0, length);
  const double middle = valueAt(0.5 * (t0 + t1)), bent = middle - 0.5 * (v0 + v1);
  // A parabola is off by less than what it differs from the line by, unless the cell bends to both
  // sides: a share of what bends it in its own coordinates stands for that.
  if (rate * (0.5 * std::abs(bent) + 0.05 * ownBend()) < allowed)
    return addCubic(CubicPiece{{v0, v1 - v0 + 4.0 * bent, -4.0 * bent, 0.0}}, length);
  const CubicPiece cubic =
    CubicPiece::through(v0, valueAt(t0 + 0.25 * (t1 - t0)), valueAt(t0 + 0.75 * (t1 - t0)), v1);
  if (depth >= 8 || rate * 2.0 * std::abs(cubic(0.5) - middle) < allowed)
    return addCubic(cubic, length);
  const double t = 0.5 * (t0 + t1);
  integrate(t0, v0, t, middle, 0.25 * bend, depth + 1);
  if (gatherer_.transmittance() > settings_.leastTransmittance)
    integrate(t, middle, t1, v1, 0.25 * bend, depth + 1);
}

void CellIntegral::addCubic(const CubicPiece& piece, double length)
{
  double turns[2];
  const int count = piece.turns(turns);
  double from = 0.0;
  for (int i = 0; i < count; ++i)
  {
    addMonotonic(piece, from, turns[i], length);
    from = turns[i];
  }
  addMonotonic(piece, from, 1.0, length);
}

void CellIntegral::addMonotonic(const CubicPiece& piece, double from, double to, double length)
{
  const TransferTable& transfer = settings_.transfer;
  const double first = piece(from), last = piece(to);
  const bool rises = last > first;
  std::size_t knots = transfer.pieceOf(first);
  const std::size_t end = transfer.pieceOf(last);
  while (knots != end)
  {
    const double knot = rises ? transfer.upperEnd(knots) : transfer.lowerEnd(knots);
    const double at = rootIn(piece, knot, from, to);
    addPiece(piece, knots, from, at, length, 0);
    from = at;
    knots += rises ? 1 : -1;
  }
  addPiece(piece, knots, from, to, length, 0);
}

TransferTable::Sample CellIntegral::look(std::size_t knots, double value) const
{
  TransferTable::Sample sample = settings_.transfer.inPiece(knots, value);
  if (light_.isOn)
    sample.color = sample.color * light_.times + light_.plus;
  return sample;
}

/// Adds a part of a piece that lies between two knots.
void CellIntegral::addPiece(
  const CubicPiece& piece, std::size_t knots, double from, double to, double length, int depth)
{
  if (!(to > from))
    return;
  const double h = (to - from) * length;
  const TransferTable::Sample a = look(knots, piece(from)), b = look(knots, piece(to));
  RayColor& out = gatherer_.color();
  const double most = std::max(a.extinction, b.extinction);
  const double least = std::min(a.extinction, b.extinction);
  if (most == 0.0)
    return;
  if (std::isinf(least))
    return out.add(a, h);
  // Near an opacity of 1 the extinction is no polynomial: the parts must be short there.
  const double thick = most * h;
  const bool smooth = thick <= 0.5 && (most - least) * h <= 0.25;
  if (!smooth && depth < 48)
  {
    const double middle = 0.5 * (from + to);
    addPiece(piece, knots, from, middle, length, depth + 1);
    if (gatherer_.transmittance() > settings_.leastTransmittance)
      addPiece(piece, knots, middle, to, length, depth + 1);
    return;
  }
  if (std::isinf(most))
    return out.add(std::isinf(a.extinction) ? b : a, h);
  if (!addBySimpson(piece, knots, from, to, h, a, b))
    addByGauss(piece, knots, from, to, h);
}

/// Adds it as one colour of one opacity, those of Simpson's rule. False where that is not enough.
bool CellIntegral::addBySimpson(const CubicPiece& piece, std::size_t knots, double from, double to,
  double h, const TransferTable::Sample& a, const TransferTable::Sample& b)
{
  const TransferTable::Sample m = look(knots, piece(0.5 * (from + to)));
  TransferTable::Sample mean;
  mean.extinction = (a.extinction + 4.0 * m.extinction + b.extinction) / 6.0;
  const Vec3d change = b.color - a.color, size = glm::abs(change);
  const double through = gatherer_.transmittance(), thick = mean.extinction * h;
  const double variation = std::abs(b.extinction - a.extinction) * h;
  const double uneven = std::abs(m.extinction - 0.5 * (a.extinction + b.extinction)) * h;
  const double error =
    through *
    (0.1 * std::max({size.x, size.y, size.z}) * thick * (variation + thick * thick) + 0.1 * uneven);
  // Each length of the ray has its share of the tolerance, and so has each part of the opacity.
  if (error > 0.5 * settings_.tolerance * (h / settings_.size + through * thick))
    return false;
  // Of what is coloured evenly along the way, the front hides a part of the back: by x / 12 of the
  // change of colour, where x is the optical depth, but for a term of x^3.
  mean.color = (a.extinction * a.color + 4.0 * m.extinction * m.color + b.extinction * b.color) /
                 (6.0 * mean.extinction) -
               (thick / 12.0) * change;
  gatherer_.color().add(mean, h);
  return true;
}

/// The same where it is smooth.
void CellIntegral::addByGauss(
  const CubicPiece& piece, std::size_t knots, double from, double to, double h)
{
  RayColor& out = gatherer_.color();
  // Gauss' nodes, and the integrals up to them of the polynomial through the nodes.
  constexpr double r = 3.872983346207417; // sqrt(15)
  constexpr double node[3] = {0.5 - r / 10.0, 0.5, 0.5 + r / 10.0};
  constexpr double upTo[3][3] = {{5.0 / 36.0, 2.0 / 9.0 - r / 15.0, 5.0 / 36.0 - r / 30.0},
    {5.0 / 36.0 + r / 24.0, 2.0 / 9.0, 5.0 / 36.0 - r / 24.0},
    {5.0 / 36.0 + r / 30.0, 2.0 / 9.0 + r / 15.0, 5.0 / 36.0}};
  constexpr double weight[3] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
  TransferTable::Sample s[3];
  for (int i = 0; i < 3; ++i)
    s[i] = look(knots, piece(from + node[i] * (to - from)));
  double depthOfAll = 0.0;
  Vec3d color(0.0);
  for (int i = 0; i < 3; ++i)
  {
    double before = 0.0;
    for (int j = 0; j < 3; ++j)
      before += upTo[i][j] * s[j].extinction;
    color += weight[i] * h * s[i].extinction * std::exp(-before * h) * s[i].color;
    depthOfAll += weight[i] * h * s[i].extinction;
  }
  out.color += out.transmittance * color;
  out.transmittance *= std::exp(-depthOfAll);
}

} // namespace mote
