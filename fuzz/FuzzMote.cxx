// Any bytes as a .mote file: readers give data or a sentence, and rays cast at what a file holds
// look at nothing outside of it.

#include "ScratchFile.h"

#include "kernels/core/Error.h"
#include "kernels/core/RayPacket.h"
#include "kernels/meshes/RlodTreeFile.h"
#include "kernels/particles/PkdTreeFile.h"

#include <cstddef>
#include <cstdint>

namespace
{

/// Rays along the three axes through places in a box.
template <typename Tree>
void castAt(const Tree& tree, const mote::Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    mote::RayPacket packet;
    packet.count = mote::RayPacket::capacity;
    for (int i = 0; i < packet.count; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double share = (i * (k + 1) % packet.count + 0.5) / packet.count;
        const double place = box.lower[k] + share * (box.upper[k] - box.lower[k]);
        packet.origin[k][i] = k == axis ? box.lower[k] - 1.0 : place;
        packet.direction[k][i] = k == axis ? 1.0 : 1e-3 * k;
      }
      packet.tMin[i] = 0.0;
      packet.t[i] = 1e30;
      packet.slot[i] = mote::RayPacket::noHit;
      packet.object[i] = -1;
    }
    tree.cast(packet, 1);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static ScratchFile file(".mote");
  file.write(bytes, size);
  readAsUsersDo(file.path());
  try
  {
    const mote::PkdTreeFile opened(file.path());
    const mote::PkdTree tree = opened.tree();
    castAt(tree, tree.statistics().bounds);
  }
  catch (const mote::Error&)
  {
  }
  try
  {
    const mote::RlodTreeFile opened(file.path());
    const auto tree = opened.tree();
    castAt(*tree, tree->bounds());
  }
  catch (const mote::Error&)
  {
  }
  return 0;
}
