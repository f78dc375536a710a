#ifndef MoteParticleArchives_h
#define MoteParticleArchives_h

// Points of Houdini, and archives of Uintah: made byte by byte as their programs' sources say, for
// no files of these programs are at hand.

#include "ParticleFormatsTest.h"

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>
#include <zlib.h>

namespace samples
{

constexpr bool isLittle = std::endian::native == std::endian::little;

template <class Number>
std::string big(const std::vector<Number>& numbers)
{
  return bytesOf(numbers, isLittle);
}

inline std::string named(const std::string& name)
{
  return big<std::uint16_t>({static_cast<std::uint16_t>(name.size())}) + name;
}

/// Three points with a vector, a whole number and a word each; and one particle system over them.
inline std::string bgeo(int version = 5, int points = 3)
{
  std::string text = "BgeoV" + big<std::int32_t>({version, points, 1, 0, 0, 3, 0, 0, 0});
  text += named("velocity") + big<std::uint16_t>({3}) + big<std::int32_t>({5}) +
          big<float>({0.0f, 0.0f, 0.0f});
  text += named("id") + big<std::uint16_t>({1}) + big<std::int32_t>({1, 0});
  text += named("phase") + big<std::uint16_t>({1}) + big<std::int32_t>({4, 2}) + named("water") +
          named("oil");
  for (int i = 0; i < 3; ++i)
  {
    const auto f = static_cast<float>(i);
    text += big<float>({f, 10.0f + f, -0.5f, 1.0f, 0.25f * f, 0.0f, 2.0f});
    text += big<std::int32_t>({7 + i, i == 2 ? -1 : i});
  }
  return text;
}

/// An archive of two steps, two processors and two materials, the second of which has no
/// temperature.
class Archive
{
public:
  Archive(const std::string& folder, bool swapped, bool gzip, int bits = 64)
    : m_folder(folder)
    , m_isSwapped(swapped)
    , m_isGzip(gzip)
    , m_bits(bits)
  {
    std::filesystem::create_directories(folder);
    const bool isBig = swapped == isLittle;
    m_meta = std::string("<Meta><endianness>") + (isBig ? "big_endian" : "little_endian") +
             "</endianness><nBits>" + std::to_string(bits) + "</nBits></Meta>\n";
    this->put("index.xml",
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<Uintah_DataArchive>\n" + m_meta +
        "<outputFormat>UDA</outputFormat>\n<ParticlePosition>p.x</ParticlePosition>\n<timesteps>\n"
        "<timestep href=\"t00000/timestep.xml\" time=\"0.0\" oldDelt=\"0.1\">0</timestep>\n"
        "<timestep href=\"t00010/timestep.xml\" time=\"0.25\" oldDelt=\"0.1\">10</timestep>\n"
        "</timesteps>\n</Uintah_DataArchive>\n");
    for (int step : {0, 10})
      this->addStep(step);
  }

  std::string index() const { return m_folder + "/index.xml"; }

private:
  void put(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories(std::filesystem::path(m_folder + "/" + name).parent_path());
    std::ofstream(m_folder + "/" + name, std::ios::binary) << text;
  }

  void addStep(int step)
  {
    const std::string folder = step == 0 ? "t00000/" : "t00010/";
    const std::string list = "<Data>\n<Datafile href=\"global.xml\"/>\n"
                             "<Datafile href=\"l0/p00000.xml\" proc=\"0\"/>\n"
                             "<Datafile href=\"l0/p00001.xml\" proc=\"1\"/>\n</Data>\n";
    // Older archives hold the list of files in timestep.xml, newer ones apart.
    const bool isApart = step > 0;
    this->put(folder + "timestep.xml",
      "<Uintah_timestep>\n" + m_meta + (isApart ? "" : list) + "</Uintah_timestep>\n");
    if (isApart)
      this->put(folder + "data.xml", list);
    for (int processor = 0; processor < 2; ++processor)
      this->addProcessor(folder, processor, 0.5 * step);
  }

  void addProcessor(const std::string& folder, int processor, double shift)
  {
    const std::string name = "p0000" + std::to_string(processor);
    m_xml = "<Uintah_Output>\n";
    m_data.clear();
    for (int material = 0; material < 2; ++material)
    {
      const int count = processor + 2 * material; // 0, 2, 1, 3
      std::vector<double> x, temperature, stress;
      std::vector<std::int64_t> ids;
      for (int i = 0; i < count; ++i)
      {
        for (const double v : {i + shift, double(processor), double(material)})
          x.push_back(v);
        temperature.push_back(300.0 + i);
        ids.push_back((std::int64_t{1} << 40) + 10 * material + i);
        for (int k = 0; k < 9; ++k)
          stress.push_back(k + 0.5);
      }
      this->add("p.x", "Point", material, processor, name, count, bytesOf(x, m_isSwapped));
      if (material == 0)
        this->add("p.temperature", "double", material, processor, name, count,
          bytesOf(temperature, m_isSwapped));
      this->add(
        "p.particleID", "long64", material, processor, name, count, bytesOf(ids, m_isSwapped));
      this->add(
        "p.stress", "Matrix3", material, processor, name, count, bytesOf(stress, m_isSwapped));
    }
    m_xml += "<Variable type=\"CCVariable&lt;double&gt;\"><variable>press_CC</variable>"
             "<index>0</index><patch>0</patch><start>0</start><end>8</end><filename>" +
             name + ".data</filename></Variable>\n</Uintah_Output>\n";
    this->put(folder + "l0/" + name + ".xml", m_xml);
    this->put(folder + "l0/" + name + ".data", m_data + "12345678");
  }

  void add(const std::string& variable, const std::string& type, int material, int patch,
    const std::string& name, int count, const std::string& bytes)
  {
    const std::size_t start = m_data.size();
    if (m_isGzip && count > 0)
    {
      std::string packed(compressBound(bytes.size()), '\0');
      uLongf size = packed.size();
      compress(reinterpret_cast<Bytef*>(packed.data()), &size,
        reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
      packed.resize(size);
      m_data += m_bits == 32
                  ? bytesOf<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}, m_isSwapped)
                  : bytesOf<std::uint64_t>({bytes.size()}, m_isSwapped);
      m_data += packed;
    }
    else
      m_data += bytes;
    m_xml += "<Variable type=\"ParticleVariable&lt;" + type + "&gt;\">\n<variable>" + variable +
             "</variable><index>" + std::to_string(material) + "</index><patch>" +
             std::to_string(patch) + "</patch>\n<start>" + std::to_string(start) + "</start><end>" +
             std::to_string(m_data.size()) + "</end>\n<filename>" + name +
             ".data</filename><numParticles>" + std::to_string(count) + "</numParticles>" +
             (m_isGzip && count > 0 ? "<compression>gzip</compression>" : "") + "</Variable>\n";
  }

  std::string m_folder;
  bool m_isSwapped, m_isGzip;
  int m_bits;
  std::string m_meta, m_xml, m_data;
};

} // namespace samples

#endif
