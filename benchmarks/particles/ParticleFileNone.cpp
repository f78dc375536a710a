#include "ParticleInput.h"

#include <kernels/core/Error.h>

namespace mote::bench
{

ParticleInput readParticles(const std::string&)
{
  throw Error("This mote-bench was built without file readers.");
}

} // namespace mote::bench
