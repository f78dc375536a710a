#pragma once

#include <hwy/highway.h>

#include <cstdint>
#include <vector>

namespace mote::testing
{

/// Lets Highway choose among `targets` only, until it goes.
class OnlyTargets
{
public:
  explicit OnlyTargets(std::int64_t targets) { set(targets); }
  ~OnlyTargets() { set(0); }
  OnlyTargets(const OnlyTargets&) = delete;
  OnlyTargets& operator=(const OnlyTargets&) = delete;

private:
  static void set(std::int64_t targets)
  {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().DeInit();
  }
};

/// Every SIMD instruction set that this machine has and Highway was compiled for.
inline std::vector<std::int64_t> everyTarget()
{
  std::vector<std::int64_t> targets;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    targets.push_back(left & -left);
  return targets;
}

} // namespace mote::testing
