// Writes small .mote files for libFuzzer to begin with.

#include "kernels/particles/PkdTreeFile.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

void writeParticles(const std::string& name, std::size_t count, bool withLods)
{
  std::vector<double> positions, radii;
  std::vector<float> energies;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i);
    positions.insert(positions.end(), {std::sin(t), std::cos(1.7 * t), std::sin(0.3 * t)});
    radii.push_back(0.05 + 0.01 * std::cos(t));
    energies.push_back(static_cast<float>(std::cos(t)));
  }
  mote::ParticleSet set;
  set.positions = mote::ArrayView(positions.data(), count, 3);
  set.radii = mote::ArrayView(radii.data(), count, 1);
  mote::PkdTree tree;
  tree.build(set);
  if (withLods)
    tree.makeLods();
  mote::PkdTreeFileContents contents;
  contents.arrays = {{"energy", mote::ArrayView(energies.data(), count, 1), {}}};
  contents.time = 0.5;
  contents.indexArray = "index";
  mote::writePkdTreeFile(name, tree, contents);
}

} // namespace

int main(int count, char** words)
{
  if (count != 2)
    return std::fprintf(stderr, "usage: fuzz-mote-seeds FOLDER\n"), 2;
  const std::string folder = words[1];
  writeParticles(folder + "/seed-none", 0, false);
  writeParticles(folder + "/seed-few", 7, false);
  writeParticles(folder + "/seed-lods", 40, true);
  return 0;
}
