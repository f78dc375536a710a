#pragma once

#include "../../core/RawVector.h"
#include "../TriangleMesh.h"

#include <cstdint>

namespace mote
{

/// The valid triangles of a mesh along a space-filling curve: 30 bits of the Morton code of the
/// middle of the triangle's box above, the triangle's index below. Triangles of equal code stand
/// in the input's order.
RawVector<std::uint64_t> mortonOrder(const TriangleMesh& mesh);

constexpr int mortonBits = 30;

} // namespace mote
