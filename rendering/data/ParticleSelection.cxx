#include "ParticleSelection.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

namespace mote
{

namespace
{

constexpr std::size_t mostAttributes = 4;
constexpr std::size_t grain = 1 << 15;

/// What lies on both sides of the two limits of a range, among the values that are stored as the
/// limit is. Bits: 1, 2: outside and inside of the lower limit; 4, 8: of the upper.
enum Side : unsigned
{
  belowLow = 1,
  fromLow = 2,
  aboveHigh = 4,
  toHigh = 8
};

bool isFloat(const ArrayView& values, int component)
{
  using Type = ArrayView::Type;
  if (component == ArrayView::magnitude)
    return false;
  const Type type = values.type();
  return type == Type::Float32 || type == Type::Int8 || type == Type::UInt8 ||
         type == Type::Int16 || type == Type::UInt16;
}

/// Looks for values that are rounded to the very floats that the limits are rounded to.
unsigned tiesOf(const ArrayView& values, int component, double low, double high)
{
  const auto lowFloat = static_cast<float>(low), highFloat = static_cast<float>(high);
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, values.count(), grain), 0u,
    [&](const tbb::blocked_range<std::size_t>& range, unsigned sides)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
      {
        const double v = values.value(i, component);
        const auto stored = static_cast<float>(v);
        if (stored == lowFloat)
          sides |= v < low ? belowLow : fromLow;
        if (stored == highFloat)
          sides |= v > high ? aboveHigh : toHigh;
      }
      return sides;
    },
    [](unsigned a, unsigned b) { return a | b; });
}

/// Turns a range of values into one of the floats that they are stored as. False where there is
/// none that parts them alike.
bool findFloatLimits(const ArrayView& values, int component, double& low, double& high)
{
  constexpr double infinity = ParticleRanges::infinity;
  if (low == -infinity && high == infinity)
    return false; // leaves out NaN only, and for the structure is no range at all
  if (isFloat(values, component) || low > high)
    return true;
  const auto lowFloat = static_cast<float>(low), highFloat = static_cast<float>(high);
  if ((std::isinf(lowFloat) && !std::isinf(low)) || (std::isinf(highFloat) && !std::isinf(high)))
    return false; // beyond what float holds
  const unsigned ties = tiesOf(values, component, low, high);
  const auto both = [ties](unsigned a, unsigned b) { return (ties & a) && (ties & b); };
  if (both(belowLow, fromLow) || both(aboveHigh, toHigh))
    return false;
  constexpr float far = std::numeric_limits<float>::infinity();
  low = ties & belowLow ? std::nextafter(lowFloat, far) : lowFloat;
  high = ties & aboveHigh ? std::nextafter(highFloat, -far) : highFloat;
  return true;
}

/// Near a limit: the greatest stored value outside of it and the least inside, for a lower limit.
/// An upper limit is one of negative values.
struct Border
{
  double outside = -ParticleRanges::infinity;
  double inside = ParticleRanges::infinity;

  void add(double stored, bool isInside)
  {
    if (isInside)
      inside = std::min(inside, stored);
    else
      outside = std::max(outside, stored);
  }
  void add(const Border& other)
  {
    outside = std::max(outside, other.outside);
    inside = std::min(inside, other.inside);
  }
  /// A limit between the two; false where stored values of both sides are mixed.
  bool between(double limit, double tolerance, double& found) const
  {
    const double from = std::max(outside, limit - tolerance);
    const double to = std::min(inside, limit + tolerance);
    if (!(from < to))
      return false;
    found = 0.5 * (from + to);
    if (!(found > from))
      found = to;
    return true;
  }
};

/// Where the stored value of a particle may lie from the exact one, generously.
double toleranceOf(const ParticleStatistics& s, int k, double limit)
{
  if (k == 3)
    return 1e-6 * std::abs(limit);
  const Vec3d size = s.centers.size();
  return 1e-6 * std::max({size.x, size.y, size.z, s.largestRadius}) + 1e-15 * std::abs(limit);
}

/// Calls `use` with the axis, or 3 for radii, as a constant: loops over all particles want it.
template <typename Use>
auto withAxis(int k, const Use& use)
{
  using std::integral_constant;
  return k == 0   ? use(integral_constant<int, 0>{})
         : k == 1 ? use(integral_constant<int, 1>{})
         : k == 2 ? use(integral_constant<int, 2>{})
                  : use(integral_constant<int, 3>{});
}

template <int k, typename Structure>
double storedPlaceOf(const Structure& structure, std::size_t slot)
{
  if constexpr (k < 3)
    return structure.center(slot)[k];
  else
    return structure.radius(slot);
}

double placeOf(const ParticleInput& particles, std::uint64_t input, int k)
{
  return k < 3 ? particles.set.position(input)[k] : particles.set.radiusOf(input);
}

/// Whether a centre and a radius lie in the ranges, without a branch.
bool contains(const PlaceRanges& ranges, const Vec3d& center, double radius)
{
  const auto& [low, high] = ranges;
  return static_cast<bool>(unsigned(center.x >= low[0]) & unsigned(center.x <= high[0]) &
                           unsigned(center.y >= low[1]) & unsigned(center.y <= high[1]) &
                           unsigned(center.z >= low[2]) & unsigned(center.z <= high[2]) &
                           unsigned(radius >= low[3]) & unsigned(radius <= high[3]));
}

/// Turns one limit into one of the stored values. False where there is none that parts them alike.
template <typename Structure>
bool findPlaceLimit(
  const Structure& s, const ParticleInput& particles, int k, bool isUpper, double& limit)
{
  const double tolerance = toleranceOf(s.statistics(), k, limit);
  const auto runs = s.slotsBetween(k, limit - 2.0 * tolerance, limit + 2.0 * tolerance);
  const auto look = [&](auto axis)
  {
    return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, runs.size()), Border{},
      [&](const tbb::blocked_range<std::size_t>& range, Border border)
      {
        for (std::size_t r = range.begin(); r != range.end(); ++r)
          for (std::size_t slot = runs[r].first; slot != runs[r].last; ++slot)
            if (const double stored = storedPlaceOf<axis()>(s, slot);
                std::abs(stored - limit) <= tolerance)
            {
              const double exact = placeOf(particles, s.inputIndex(slot), k);
              border.add(isUpper ? -stored : stored, isUpper ? exact <= limit : exact >= limit);
            }
        return border;
      },
      [](Border a, const Border& b)
      {
        a.add(b);
        return a;
      });
  };
  double found = limit;
  if (!withAxis(k, look).between(isUpper ? -limit : limit, tolerance, found))
    return false;
  limit = isUpper ? -found : found;
  return true;
}

/// As findFloatLimits(), of centres and radii, whose rounding is the structure's own affair.
template <typename Structure>
bool findPlaceLimits(
  const Structure& s, const ParticleInput& particles, int k, double& low, double& high)
{
  if (k == 3 && particles.enlargement != 1.0)
    return false; // what is stored are not the radii that the range speaks of
  // What leaves nothing out needs no look.
  const Box& centers = s.statistics().centers;
  if (k < 3 && low <= centers.lower[k])
    low = -ParticleRanges::infinity;
  if (k < 3 && high >= centers.upper[k])
    high = ParticleRanges::infinity;
  if (std::isinf(low) && std::isinf(high))
    return true;
  const bool lowFound = std::isinf(low) || findPlaceLimit(s, particles, k, false, low);
  return lowFound && (std::isinf(high) || findPlaceLimit(s, particles, k, true, high));
}

/// NaN as a limit leaves nothing, as no value compares with it.
void makeComparable(double& low, double& high)
{
  if (!std::isnan(low) && !std::isnan(high))
    return;
  low = ParticleRanges::infinity;
  high = -ParticleRanges::infinity;
}

} // namespace

bool ParticleSelection::KeptRange::contains(double value) const
{
  return value >= low && value <= high &&
         (parts.empty() || std::any_of(parts.begin(), parts.end(),
                             [value](const auto& p) { return value >= p[0] && value <= p[1]; }));
}

bool ParticleSelection::showsValues(std::uint64_t input) const
{
  for (const KeptRange& range : values_)
    if (!range.contains(range.values.view.value(input, range.component)))
      return false;
  return true;
}

bool ParticleSelection::shows(std::uint64_t input) const
{
  if (!this->showsValues(input))
    return false;
  for (int k = 0; k < 4; ++k)
    if (places_.isLimited(k))
      if (const double v = placeOf(particles_, input, k);
          !(v >= places_.low[k] && v <= places_.high[k]))
        return false;
  return true;
}

void ParticleSelection::setAttributes(ParticleStructure& structure)
{
  std::vector<ParticleAttribute> attributes;
  for (const KeptRange& range : values_)
    if (attributes.size() < mostAttributes)
      attributes.push_back({range.values.view, range.component});
  std::visit([&](auto& s) { s.setAttributes(attributes); }, structure);
}

bool ParticleSelection::findLimits(const ParticleStructure& structure, ParticleRanges& limits) const
{
  bool complete = values_.size() <= mostAttributes;
  for (std::size_t i = 0; i < std::min(values_.size(), mostAttributes); ++i)
  {
    double low = values_[i].low, high = values_[i].high;
    complete = complete && values_[i].parts.empty();
    if (!findFloatLimits(values_[i].values.view, values_[i].component, low, high))
    {
      complete = false;
      continue;
    }
    limits.lower[4 + i] = low;
    limits.upper[4 + i] = high;
  }
  for (int k = 0; k < 4; ++k)
  {
    double low = places_.low[k], high = places_.high[k];
    const bool found = !places_.isLimited(k) || low > high ||
                       withStructure(structure, [&](const auto& s)
                         { return findPlaceLimits(s, particles_, k, low, high); });
    complete = complete && found;
    limits.lower[k] = found ? low : -ParticleRanges::infinity;
    limits.upper[k] = found ? high : ParticleRanges::infinity;
  }
  return complete;
}

bool ParticleSelection::apply(ParticleStructure& structure, std::vector<ValueRange> values,
  const PlaceRanges& places, const std::function<ParticleInput()>& particles)
{
  InputKey attributesKey, key;
  for (ValueRange& range : values)
  {
    addArray(attributesKey, range.array);
    attributesKey.push_back(range.component);
    makeComparable(range.low, range.high);
    key.insert(key.end(), {range.low, range.high, double(range.parts.size())});
    for (const auto& part : range.parts)
      key.insert(key.end(), part.begin(), part.end());
  }
  key.insert(key.end(), attributesKey.begin(), attributesKey.end());
  if (!values.empty())
    key.push_back(double(values.size()));
  if (places.anyLimited())
    for (int k = 0; k < 4; ++k)
      key.insert(key.end(), {places.low[k], places.high[k]});
  if (key == key_)
    return false;
  key_ = key;
  count_.reset();
  bounds_.reset();
  places_ = places;
  particles_ = places.anyLimited() ? particles() : ParticleInput{};
  if (attributesKey != attributesKey_ || values.size() != values_.size())
  {
    values_.clear();
    for (const ValueRange& range : values)
      values_.push_back({DataArrayView(range.array), range.component});
    setAttributes(structure);
    attributesKey_ = attributesKey;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values_[i].low = values[i].low;
    values_[i].high = values[i].high;
    values_[i].parts = std::move(values[i].parts);
  }

  this->setLimits(structure);
  return true;
}

/// Tells the structure what it can compare itself, and else which particles to show.
void ParticleSelection::setLimits(ParticleStructure& structure)
{
  const bool wasMasked = masked_;
  ParticleRanges limits;
  masked_ = !findLimits(structure, limits);
  for (int k = 0; k < 4; ++k)
  {
    storedPlaces_.low[k] = limits.lower[k];
    storedPlaces_.high[k] = limits.upper[k];
  }
  std::visit(
    [&](auto& s)
    {
      if (wasMasked && !masked_)
        s.setVisibility({});
      s.setRanges(limits);
      if (masked_)
        s.setVisibility([&](std::size_t slot) { return this->shows(s.inputIndex(slot)); });
    },
    structure);
}

/// Visits the slots of a part of the structure that are shown, with their centres and radii.
template <typename Structure, typename Visit>
void ParticleSelection::forShown(
  const Structure& s, std::size_t begin, std::size_t end, const Visit& visit) const
{
  // Where the structure needs no bits, what it stores of places tells, in its own order.
  const PlaceRanges stored = masked_ ? PlaceRanges{} : storedPlaces_;
  const bool byValues = !masked_ && !values_.empty();
  for (std::size_t slot = begin; slot != end; ++slot)
  {
    const Vec3d center = s.center(slot);
    const double radius = s.radius(slot);
    if (contains(stored, center, radius) && (!byValues || this->showsValues(s.inputIndex(slot))) &&
        (!masked_ || this->shows(s.inputIndex(slot))))
      visit(slot, center, radius);
  }
}

template <typename Structure, typename Sum, typename Add>
Sum ParticleSelection::sumOfShown(const Structure& s, const Add& add) const
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, s.size(), grain), Sum{},
    [&](const tbb::blocked_range<std::size_t>& range, Sum sum)
    {
      this->forShown(s, range.begin(), range.end(),
        [&](std::size_t, const Vec3d& center, double radius) { add(sum, center, radius); });
      return sum;
    },
    [](Sum a, const Sum& b)
    {
      a += b;
      return a;
    });
}

void ParticleSelection::markShown(const ParticleStructure& structure, unsigned char* marks) const
{
  withStructure(structure,
    [&](const auto& s)
    {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, s.size(), grain),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
          this->forShown(s, range.begin(), range.end(),
            [&](std::size_t slot, const Vec3d&, double) { marks[s.inputIndex(slot)] = 1; });
        });
    });
}

std::size_t ParticleSelection::shownCount(const ParticleStructure& structure) const
{
  if (!count_)
    count_ = withStructure(structure, [](const auto& s) { return s.shownCount(); });
  return *count_;
}

const Box& ParticleSelection::shownBounds(const ParticleStructure& structure) const
{
  struct Bounds : Box
  {
    void operator+=(const Bounds& other) { this->add(static_cast<const Box&>(other)); }
  };
  const auto look = [&](const auto& s) -> Box
  {
    if (key_.empty())
      return s.statistics().bounds;
    return this->sumOfShown<std::decay_t<decltype(s)>, Bounds>(s,
      [](Bounds& bounds, const Vec3d& center, double radius)
      {
        bounds.add(center - radius);
        bounds.add(center + radius);
      });
  };
  if (!bounds_)
    bounds_ = withStructure(structure, look);
  return *bounds_;
}

} // namespace mote
