#pragma once

#include "../core/ContentHash.h"
#include "OcclusionMaps.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mote
{

/// Occlusion maps with what they were baked from, as they are kept beside the data.
struct StoredOcclusion
{
  OcclusionMaps maps;  ///< by index of the input
  ContentHash content; ///< of the particles, see hashOf(ParticleSet)
  /// The particles that were there to occlude: bit i % 64 of word i / 64 for particle i of the
  /// input; empty where all were.
  std::vector<std::uint64_t> shown;
  int side = 16;          ///< texels along a side, at most
  int samples = 49;       ///< rays a texel
  double reach = 0.0;     ///< of the rays, in the units of the particles' positions
  double tolerance = 0.0; ///< that smaller maps were chosen by, where `adaptive`
  bool adaptive = true;
  bool dilate = true;

  /// Which particles of the input were there to occlude.
  bool isShown(std::size_t particle) const
  {
    return shown.empty() || (shown[particle / 64] >> (particle % 64) & 1) != 0;
  }
};

/// Writes a .moteao file, which appears under its name complete or not at all. Throws WriteError.
void writeOcclusionFile(const std::string& name, const StoredOcclusion& stored);

/// Reads it again. Throws Error, in one sentence that names the file, where it is missing or
/// unreadable, of another format, version or kind of machine, cut short or damaged.
StoredOcclusion readOcclusionFile(const std::string& name);

} // namespace mote
