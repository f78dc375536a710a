#pragma once

// The structure that a test program is about: the tests of what all have in common are built once
// for each.

#include <kernels/particles/CoherentGrid.h>
#include <kernels/particles/PkdPaperTree.h>
#include <kernels/particles/PkdTree.h>

namespace mote::testing
{

#ifdef MOTE_TEST_STRUCTURE
using Structure = MOTE_TEST_STRUCTURE;
#else
using Structure = CoherentGrid;
#endif

} // namespace mote::testing
