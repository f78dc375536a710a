#pragma once

#include <string>
#include <vector>

namespace mote::bench
{

/// What the command line says; every suite reads the part that concerns it.
struct Options
{
  std::string input;
  std::vector<std::string> methods; ///< empty: all of the suite
  std::vector<std::string> views;   ///< empty: all of the suite
  int threads = 0;                  ///< 0: as many as the machine has
  int repeat = 5;
  int width = 1024;
  int height = 1024;
  std::string json; ///< file for the records, or empty
};

} // namespace mote::bench
