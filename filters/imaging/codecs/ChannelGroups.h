/**
 * Which channels of an image file belong together.
 */

#ifndef MoteChannelGroups_h
#define MoteChannelGroups_h

#include <string>
#include <vector>

namespace mote::imaging
{

/**
 * One array, and the channels, by their place in the file, that are its components.
 */
struct ChannelGroup
{
  enum class Kind
  {
    Numbers,
    Colors,
    HalvesOfIntegers // high and low
  };

  std::string name;
  std::vector<int> channels;
  Kind kind = Kind::Numbers;
};

/**
 * What is known of a channel.
 */
struct ChannelFacts
{
  std::string name;
  bool isInteger = false; // of 32 bits
  bool isFloat = false;   // of 32 bits
};

/// The arrays of a file: colours first, then depth. The rule is in vtkMoteImageReader.h.
std::vector<ChannelGroup> groupChannels(const std::vector<ChannelFacts>& channels);

} // namespace mote::imaging

#endif
