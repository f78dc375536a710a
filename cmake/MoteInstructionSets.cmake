# For which SIMD instruction sets the kernels are compiled. Highway picks the best one when the
# program runs; each costs as much to build as the others.

option(MOTE_NATIVE "Compile kernels for the best instruction set of this machine alone, and scalar" OFF)

# No machine of today has SSSE3 as its best.
set(MOTE_DISABLED_TARGETS HWY_SSSE3)
if (MOTE_NATIVE)
  file(WRITE "${CMAKE_BINARY_DIR}/native/native.cpp" [[
#include <hwy/targets.h>

#include <cstdio>

int main()
{
  // A lower bit is a better set. What stands above the static targets is portable and stays.
  const long long all = hwy::SupportedTargets() & HWY_ATTAINABLE_TARGETS;
  const long long best = all & -all;
  std::printf("%#llx", ~(best | HWY_STATIC_TARGET) & (HWY_ATTAINABLE_TARGETS));
}
]])
  try_run(_ran _compiled "${CMAKE_BINARY_DIR}/native" "${CMAKE_BINARY_DIR}/native/native.cpp"
    LINK_LIBRARIES hwy::hwy CXX_STANDARD 20 RUN_OUTPUT_VARIABLE _others)
  if (_compiled AND _ran EQUAL 0)
    set(MOTE_DISABLED_TARGETS "${_others}LL")
  else ()
    message(WARNING "MOTE_NATIVE: the instruction sets of this machine are not known; all are built")
  endif ()
endif ()
