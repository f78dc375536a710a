#pragma once

// What the tests of files of particles share.

#include "FileParts.h"

#include <kernels/particles/PkdTreeFile.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <string>
#include <vector>

namespace mote::testing
{

/// Particles with arrays: `energy` (float), `v` (three double), `kind` (bytes), and a fact, `box`.
struct Example
{
  Particles particles;
  std::vector<float> energy;
  std::vector<double> velocity;
  std::vector<std::int8_t> kind;
  std::vector<double> box = {-1.0, 1.0, -2.0, 2.0};
  PkdTree tree;

  explicit Example(std::size_t count, double smallest = 0.01, double largest = 0.04)
    : particles(randomParticles(count, count + 5, smallest, largest))
  {
    for (std::size_t i = 0; i < count / 50; ++i) // some coincide
      particles.add(particles.center(7 * i % count), particles.radii[7 * i % count]);
    this->finish();
  }

  PkdTreeFileContents contents() const
  {
    const std::size_t n = particles.size();
    PkdTreeFileContents c;
    c.arrays = {{"energy", ArrayView(energy.data(), n, 1), {}},
      {"v", ArrayView(velocity.data(), n, 3), {"vx", "vy", "vz"}},
      {"kind", ArrayView(kind.data(), ArrayView::Type::Int8, n, 1), {}}};
    c.facts = {{"box", ArrayView(box.data(), 2, 2), {}}};
    c.time = 12.5;
    c.spacing = 0.25;
    c.indexArray = "index";
    return c;
  }

private:
  void finish()
  {
    Random random(9);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      energy.push_back(static_cast<float>(random(-3.0, 5.0)));
      for (int k = 0; k < 3; ++k)
        velocity.push_back(random(-1.0, 1.0));
      kind.push_back(static_cast<std::int8_t>(random(0.0, 4.0)));
    }
    tree.build(particles.set());
  }
};

inline const FileArray& arrayOf(const PkdTreeFile& file, const std::string& name)
{
  for (const FileArray& array : file.arrays())
    if (array.name == name)
      return array;
  throw std::runtime_error("no array " + name);
}

} // namespace mote::testing
