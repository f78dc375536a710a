#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mote::app
{

/// The files of a simulation that runs: those that were named, and those that come after the last
/// of a series, which differ from it in their number. They may grow, shrink or go at any time.
class FollowedFiles
{
public:
  explicit FollowedFiles(const std::vector<std::string>& files);

  /// Whether there are other files than at the last look, or they have changed. A new file of a
  /// series counts when it is whole, as far as can be told, and only after those before it.
  bool lookAgain();

  /// All, as of the last look.
  const std::vector<std::string>& files() const { return files_; }

private:
  /// Size and time of the last change; of a file that is gone -1, 0.
  using Stamp = std::pair<std::int64_t, std::int64_t>;
  static Stamp stampOf(const std::string& file);
  bool isWhole(const std::string& file);
  void addNew();

  std::vector<std::string> files_;
  std::map<std::string, Stamp> stamps_;  ///< of `files_`
  std::map<std::string, Stamp> growing_; ///< of new ones that may not be whole yet
};

} // namespace mote::app
