#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace mote
{

/// A number that looks random, the same for the same two.
std::uint32_t mixedBits(std::uint32_t a, std::uint32_t b);

/// Point `index` of a sequence that fills the unit square [0, 1)^2 evenly; every `seed` has its own
/// sequence, independent of the others.
///
/// Any run of 2^k points that begins at a multiple of 2^k is stratified: every rectangle of area
/// 2^-k with sides that are powers of two, at its own place in the grid of such rectangles, holds
/// one of them. A mean over N points so converges much faster than over random ones. The (0,2)
/// sequence of Sobol and van der Corput with Owen's scrambling by hashing: Burley, "Practical
/// Hash-based Owen Scrambling", JCGT 9(4), 2020.
glm::dvec2 samplePoint(std::uint32_t index, std::uint32_t seed);

} // namespace mote
