#pragma once

#include "settings/Settings.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

/// The colours of a map that a file holds.
struct ColorMapFile
{
  std::vector<Color> colors; ///< two or more, at even distances
  bool isStepped = false;    ///< whether each fills its share, without others between them
  std::optional<Color> none; ///< of what has no value
};

/// The colour map of a text: JSON as ParaView exports it, or lines with red, green and blue from 0
/// to 1 or from 0 to 255, or #rrggbb. Of several maps in JSON that of this name, or the first.
/// `file` is for messages. Throws Failure.
ColorMapFile parseColorMap(
  const std::string& text, const std::string& file, const std::string& map = {});

/// Reads the file of one. `named` is its name, or FILE:MAP for one of several. Throws Failure.
ColorMapFile readColorMapFile(const std::string& named);

/// The same, which is read once, and again where the file was written since. Throws Failure where
/// it was never read.
std::shared_ptr<const ColorMapFile> keptColorMapFile(const std::string& named);

} // namespace mote::app
