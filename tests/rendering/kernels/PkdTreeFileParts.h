#pragma once

// What the tests of files of particles share.

#include <kernels/particles/PkdTreeFile.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

namespace mote::testing
{

/// A folder of its own that goes with the test.
class Folder
{
public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "mote-file-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name = "a.mote") const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }

private:
  std::filesystem::path path_;
};

using Bytes = std::vector<unsigned char>;

inline Bytes readBytes(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

inline void writeBytes(const std::string& name, const Bytes& bytes)
{
  std::ofstream stream(name, std::ios::binary);
  stream.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

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

inline const PkdTreeFile::Array& arrayOf(const PkdTreeFile& file, const std::string& name)
{
  for (const PkdTreeFile::Array& array : file.arrays())
    if (array.name == name)
      return array;
  throw std::runtime_error("no array " + name);
}

} // namespace mote::testing
