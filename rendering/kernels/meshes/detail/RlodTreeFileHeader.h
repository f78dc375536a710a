#pragma once

#include "../../core/detail/FileHeader.h"

#include <cstdint>

namespace mote
{

/// The layout of a file of triangles: docs/mote-file.md.
struct RlodTreeFileHeader : FileBeginning
{
  static constexpr std::array<char, 8> theMagic = {'M', 'O', 'T', 'E', 'T', 'R', 'I', '\n'};
  static constexpr std::uint32_t theVersion = 1;
  static constexpr const char* what = "triangles";

  enum Role : std::uint32_t ///< of arrays
  {
    ofPoints = 0,
    ofWhole = 1,
    ofCells = 2
  };
  static constexpr std::uint32_t roles = 3;

  std::uint32_t nodeBytes = 0, clusterBytes = 0, planesBytes = 0, wordsBytes = 0;
  std::uint64_t triangles = 0, points = 0;
  std::uint32_t firstLevel = 0, levelStep = 1; ///< of error radii: see ErrorLevels
  std::uint32_t hasTime = 0;
  std::uint32_t normals = 0;    ///< of the arrays of points the one with them, from 1; 0: none
  std::uint32_t placeBytes = 4; ///< of a coordinate: 4 or 8
  std::uint32_t unused = 0;
  double time = 0.0;
  double origin[3] = {}, unit = 1.0, cost = 0.0;
  double lower[3] = {}, upper[3] = {}; ///< of all triangles, from origin in units
  double bounds[6] = {};               ///< of the points: least x y z, greatest x y z
  FileSection nodes{}, words{}, planes{}, clusters{}, corners{}, offsets{}, places{};
  std::uint64_t arrays = 0; ///< entries of the table behind this

  RlodTreeFileHeader()
  {
    magic = theMagic;
    version = theVersion;
  }
};
static_assert(sizeof(RlodTreeFileHeader) == 360);

} // namespace mote
