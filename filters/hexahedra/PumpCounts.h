#ifndef MotePumpCounts_h
#define MotePumpCounts_h

#include <cstdint>

namespace mote::pump
{

// How many cells lie along which direction of a part. At scale 1 the parts have 0.86, 2.15 and 3.44
// million cells, as the case of Wang, Elshehaly and Cao has, and at every scale the same share of
// that, to a few percent at the least scale and to less than one where parts have 20,000 cells.

inline constexpr double leastScale = 5e-4, greatestScale = 10.0;
inline constexpr double inletCells = 860e3, rotorCells = 2150e3, diffuserCells = 3440e3;

struct InletCounts
{
  int core;  ///< along a side of the middle square; odd, so that cells hold the axis
  int rings; ///< from there to the wall
  int axial;

  std::int64_t cells() const;
};

struct RotorCounts
{
  int pitch; ///< from blade to blade
  int span;  ///< from hub to shroud
  int stream;

  std::int64_t cells() const;
};

struct DiffuserCounts
{
  int pitch;  ///< from vane to vane
  int span;   ///< along the axis
  int radial; ///< in the ring with vanes

  int volute() const; ///< from the ring to the volute's outer wall
  int outlet() const; ///< along the straight pipe
  std::int64_t cells() const;
};

InletCounts inletCounts(double scale);
RotorCounts rotorCounts(double scale);
DiffuserCounts diffuserCounts(double scale);

} // namespace mote::pump

#endif
