#ifndef MoteHDF5Particles_h
#define MoteHDF5Particles_h

#include "StepSource.h"

namespace mote
{

/// Whether bytes begin like an HDF5 file.
bool looksLikeHDF5(std::string_view beginning);

/// Particles in HDF5: snapshots of Gadget, SWIFT and AREPO (one step; groups PartType0 and so on),
/// H5Part (groups "Step#0" and so on) and openPMD (particles of its iterations). Sources: the user
/// guide of GADGET-2, section 6.4; the H5Part format; the openPMD standard 1.1.0.
///
/// Every array of a number or a row of numbers a particle is read, as Float64, or Int64 where all
/// kinds of particles have whole numbers; what a kind lacks is not a number. Gadget's Velocities,
/// Masses and ParticleIDs are "v", "mass" and "id", and arrays that differ in a last x, y and z are
/// one, as "v" of vx, vy and vz. "type" (Int32) tells the kinds, where there may be several.
/// Lengths are in the file's units; in metres where openPMD gives positions and their offsets in
/// units that differ. Throws FileError.
std::unique_ptr<StepSource> openHDF5Particles(const std::string& path);

} // namespace mote

#endif
