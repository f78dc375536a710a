#pragma once

#include "../../core/detail/FileHeader.h"

#include <cstdint>

namespace mote
{

/// The layout of a file of particles: docs/mote-file.md.
struct PkdTreeFileHeader : FileBeginning
{
  static constexpr std::array<char, 8> theMagic = {'M', 'O', 'T', 'E', 'P', 'K', 'D', '\n'};
  static constexpr std::uint32_t theVersion = 1;
  static constexpr const char* what = "particles";

  enum Role : std::uint32_t ///< of arrays
  {
    ofParticles = 0,
    ofWhole = 1
  };
  static constexpr std::uint32_t roles = 2;

  std::uint32_t nodeBytes = 0, rowBytes = 0, fanout = 0, bucketSize = 0;
  std::uint64_t count = 0; ///< particles
  std::uint32_t levels = 0, rowsABucket = 0;
  std::uint32_t ownRadii = 0, hasTime = 0;
  double time = 0.0, spacing = 0.0;
  double origin[3] = {}, unit = 1.0, step = 1.0, coarse = 1.0, radius = 0.0;
  double centers[6] = {}, bounds[6] = {}; ///< least x y z, greatest x y z
  double smallestRadius = 0.0, largestRadius = 0.0;
  FileSection nodes{}, rows{};
  std::uint64_t arrays = 0; ///< entries of the table behind this

  PkdTreeFileHeader()
  {
    magic = theMagic;
    version = theVersion;
  }
};
static_assert(sizeof(PkdTreeFileHeader) == 304);

} // namespace mote
