#ifndef MoteIOTestSupport_h
#define MoteIOTestSupport_h

#include <atomic>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>
#include <zlib.h>

/// A folder of its own for every test, removed afterwards.
class FileTest : public testing::Test
{
protected:
  FileTest()
  {
    static std::atomic<int> count{0};
    m_folder = std::filesystem::temp_directory_path() /
               ("mote-io-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(m_folder);
  }

  ~FileTest() override { std::filesystem::remove_all(m_folder); }

  std::string path(const std::string& name) const { return (m_folder / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// `append` adds another gzip member.
  std::string writeGzip(const std::string& name, const std::string& text, bool append = false) const
  {
    gzFile file = gzopen(path(name).c_str(), append ? "ab" : "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    return path(name);
  }

  std::string textOf(const std::string& name) const
  {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// Packs the mesh and the fields of an OpenFOAM case, as writeCompression on; does.
  void packFoam(const std::string& folder) const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder)))
      if (entry.is_regular_file() && entry.file_size() > 0 &&
          entry.path().filename() != "controlDict")
        names.push_back(std::filesystem::relative(entry.path(), m_folder).string());
    for (const std::string& name : names)
    {
      writeGzip(name + ".gz", textOf(name));
      std::filesystem::remove(path(name));
    }
  }

  /// Has a writer of VTK write a data object.
  template <class Writer, class Data>
  std::string writeWith(const std::string& name, const Data& data) const
  {
    auto* writer = Writer::New();
    writer->SetInputDataObject(data);
    writer->SetFileName(path(name).c_str());
    writer->Write();
    writer->Delete();
    return path(name);
  }

  void truncate(const std::string& name, std::uintmax_t bytes) const
  {
    std::filesystem::resize_file(path(name), bytes);
  }

private:
  std::filesystem::path m_folder;
};

/// The text of a dump's frame; `rows` end with line ends.
inline std::string dumpFrame(long step, long atoms, const std::string& columns,
  const std::string& rows, const std::string& box = "pp pp pp\n0 10\n0 20\n0 40\n")
{
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
         std::to_string(atoms) + "\nITEM: BOX BOUNDS " + box + "ITEM: ATOMS " + columns + "\n" +
         rows;
}

/// A particle file of the shared collection, or nothing where that is missing.
inline std::string sharedParticles(const std::string& name)
{
  const std::string file = std::string(MOTE_SHARED_DATA_DIR) + "/particles/" + name;
  return std::filesystem::exists(file) ? file : std::string();
}

#define MOTE_REQUIRE_SHARED(variable, name)                                                        \
  const std::string variable = sharedParticles(name);                                              \
  if (variable.empty())                                                                            \
    GTEST_SKIP() << "needs particles/" << (name) << " of the shared data in "                      \
                 << MOTE_SHARED_DATA_DIR;

#endif
