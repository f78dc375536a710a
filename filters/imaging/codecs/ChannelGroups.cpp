#include "ChannelGroups.h"

#include <algorithm>
#include <cctype>

namespace mote::imaging
{
namespace
{

using Names = std::vector<std::string>;

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "a.b.X" is the layer "a.b" and the part "X".
std::string layerOf(const std::string& name)
{
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string partOf(const std::string& name)
{
  return name.substr(name.rfind('.') + 1);
}

class Grouping
{
public:
  explicit Grouping(const std::vector<ChannelFacts>& channels)
    : m_channels(channels)
    , m_taken(channels.size(), false)
  {
  }

  std::vector<ChannelGroup> run()
  {
    if (m_channels.size() == 1 && m_channels[0].isFloat)
      return {{"depth", {0}, ChannelGroup::Kind::Numbers}};
    this->takeColors();
    this->takeDepth();
    for (std::size_t i = 0; i < m_channels.size(); ++i)
      if (!m_taken[i])
        this->takeWith(m_channels[i].name);
    return std::move(m_groups);
  }

private:
  int find(const std::string& name) const
  {
    for (std::size_t i = 0; i < m_channels.size(); ++i)
      if (!m_taken[i] && m_channels[i].name == name)
        return static_cast<int>(i);
    return -1;
  }

  /// As many of the parts of a layer as there are, from the first.
  std::vector<int> parts(const std::string& layer, const Names& names) const
  {
    std::vector<int> found;
    for (const std::string& name : names)
    {
      const int channel = this->find(layer.empty() ? name : layer + "." + name);
      if (channel < 0)
        break;
      found.push_back(channel);
    }
    return found;
  }

  void take(const std::string& name, const std::vector<int>& channels, ChannelGroup::Kind kind)
  {
    for (const int channel : channels)
      m_taken[channel] = true;
    m_groups.push_back({name, channels, kind});
  }

  void takeColors()
  {
    Names layers = {""};
    for (const ChannelFacts& channel : m_channels)
      layers.push_back(layerOf(channel.name));
    for (const std::string& layer : layers)
    {
      const std::vector<int> channels = this->parts(layer, {"R", "G", "B", "A"});
      if (channels.size() >= 3)
        return this->take("color", channels, ChannelGroup::Kind::Colors);
    }
    const std::vector<int> grey = this->parts("", {"Y", "A"});
    // A vector without a name has a Y, too.
    if (!grey.empty() && this->find("X") < 0)
      this->take("color", grey, ChannelGroup::Kind::Colors);
  }

  void takeDepth()
  {
    int depth = this->find("Z");
    for (std::size_t i = 0; i < m_channels.size() && depth < 0; ++i)
    {
      const std::string& name = m_channels[i].name;
      const std::string layer = layerOf(name), part = lowerCase(partOf(name));
      const bool isVector = part == "z" && this->parts(layer, {"X", "Y"}).size() == 2;
      if (!m_taken[i] && !isVector &&
          (part == "z" || part == "depth" || lowerCase(partOf(layer)) == "depth"))
        depth = static_cast<int>(i);
    }
    if (depth >= 0)
      this->take("depth", {depth}, ChannelGroup::Kind::Numbers);
  }

  /// The channel and those that belong to it.
  void takeWith(const std::string& name)
  {
    const std::string layer = layerOf(name);
    Names numbers;
    for (std::size_t i = 0; i < m_channels.size(); ++i)
      numbers.push_back(std::to_string(i));
    const std::vector<int> halves = this->parts(layer, {"high", "low"});
    if (!layer.empty() && halves.size() == 2 && m_channels[halves[0]].isInteger &&
        m_channels[halves[1]].isInteger)
      return this->take(layer, halves, ChannelGroup::Kind::HalvesOfIntegers);
    for (const Names& kind : {Names{"X", "Y", "Z"}, Names{"R", "G", "B", "A"}, numbers})
    {
      const std::vector<int> channels = this->parts(layer, kind);
      const bool isAmong =
        std::find(channels.begin(), channels.end(), this->find(name)) != channels.end();
      if (!layer.empty() && channels.size() >= 2 && isAmong)
        return this->take(layer == "N" ? "normal" : layer, channels, ChannelGroup::Kind::Numbers);
    }
    this->take(name, {this->find(name)}, ChannelGroup::Kind::Numbers);
  }

  const std::vector<ChannelFacts>& m_channels;
  std::vector<bool> m_taken;
  std::vector<ChannelGroup> m_groups;
};

} // namespace

std::vector<ChannelGroup> groupChannels(const std::vector<ChannelFacts>& channels)
{
  return Grouping(channels).run();
}

} // namespace mote::imaging
