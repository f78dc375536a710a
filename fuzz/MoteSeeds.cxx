// Writes small .mote files, or with them a .moteao file, for libFuzzer to begin with.

#include "kernels/meshes/RlodTreeFile.h"
#include "kernels/meshes/TriangleMesh.h"
#include "kernels/occlusion/OcclusionBake.h"
#include "kernels/occlusion/OcclusionFile.h"
#include "kernels/particles/ParticleStructure.h"
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

void writeMesh(const std::string& name, int rows)
{
  std::vector<float> points, heights;
  std::vector<std::int32_t> corners;
  for (int i = 0; i < rows * rows; ++i)
  {
    const auto x = static_cast<float>(i % rows), y = static_cast<float>(i / rows);
    heights.push_back(std::sin(x) * std::cos(y));
    points.insert(points.end(), {x, y, heights.back()});
    if (i % rows + 1 < rows && i / rows + 1 < rows)
      for (const int corner : {i, i + 1, i + rows, i + 1, i + rows + 1, i + rows})
        corners.push_back(corner);
  }
  const mote::ArrayView places(points.data(), heights.size(), 3);
  const mote::TriangleMesh mesh(
    places, mote::ArrayView(corners.data(), mote::ArrayView::Type::Int32, corners.size() / 3, 3));
  mote::RlodTree tree;
  tree.build(mesh);
  tree.makeLods();
  mote::RlodTreeFileContents contents;
  contents.places = places;
  contents.points = {{"height", mote::ArrayView(heights.data(), heights.size(), 1), {}}};
  mote::writeRlodTreeFile(name, tree, mesh, contents);
}

void writeMaps(const std::string& name, bool adaptive)
{
  const std::vector<double> positions = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.1, 0.0};
  const std::vector<double> radii = {0.5, 0.5, 0.4};
  mote::ParticleSet set;
  set.positions = mote::ArrayView(positions.data(), radii.size(), 3);
  set.radii = mote::ArrayView(radii.data(), radii.size(), 1);
  mote::OcclusionBakeOptions options;
  options.side = 4;
  options.adaptive = adaptive;
  mote::StoredOcclusion stored;
  stored.maps = mote::bakeOcclusion(*mote::makeParticleStructure(set), options);
  stored.side = options.side;
  stored.samples = options.samples;
  stored.adaptive = adaptive;
  mote::writeOcclusionFile(name, stored);
}

} // namespace

int main(int count, char** words)
{
  if (count != 3)
    return std::fprintf(stderr, "usage: fuzz-mote-seeds mote|moteao FOLDER\n"), 2;
  const std::string folder = words[2];
  if (words[1] == std::string("moteao"))
  {
    writeMaps(folder + "/seed-adaptive", true);
    writeMaps(folder + "/seed-full", false);
    return 0;
  }
  writeMesh(folder + "/seed-mesh", 3);
  writeMesh(folder + "/seed-mesh-lods", 12);
  writeParticles(folder + "/seed-none", 0, false);
  writeParticles(folder + "/seed-few", 7, false);
  writeParticles(folder + "/seed-lods", 40, true);
  return 0;
}
