#ifndef MoteHDF5Steps_h
#define MoteHDF5Steps_h

#include "HDF5File.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// Some components of a field: an array, or one value for all particles.
struct HDF5Part
{
  std::string array;
  std::size_t columns = 1;
  std::optional<double> constant;
  double scale = 1.0;
};

/// Numbers that each particle of a kind has.
struct HDF5Field
{
  std::string name;
  std::vector<HDF5Part> parts;
  bool isWhole = false;

  std::size_t components() const;
};

/// Particles of one kind: gas, or electrons.
struct HDF5Kind
{
  int type = 0;
  std::size_t file = 0; ///< of the snapshot's, that it is in
  std::string name;
  std::uint64_t particles = 0;
  HDF5Field positions;
  HDF5Field offsets; ///< that are added to the positions; or without parts
  std::vector<HDF5Field> fields;

  const HDF5Field* field(const std::string& wanted) const;
};

struct HDF5Step
{
  double time = 0;
  std::vector<HDF5Kind> kinds;
  std::optional<std::array<double, 9>> box;
};

/// What a file holds of particles.
struct HDF5Steps
{
  std::vector<HDF5Step> steps; ///< by ascending times; never none
  bool hasKinds = false;       ///< particles may be of several kinds
  std::uint64_t files = 1;     ///< that the snapshot is spread over; this is one of them
};

/// Finds the particles of a snapshot of Gadget, of H5Part or of openPMD. Throws FileError where
/// there are none, or where arrays do not fit together.
HDF5Steps findHDF5Steps(const HDF5File& file);

} // namespace mote

#endif
