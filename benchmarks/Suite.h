#pragma once

#include "Options.h"
#include "Report.h"

#include <string>
#include <utility>
#include <vector>

namespace mote::bench
{

/// Name and one line about it.
using Named = std::pair<std::string, std::string>;

/// One benchmark of the program: a row of the table in Suites.cpp.
struct Suite
{
  std::string name;
  std::string summary;
  std::vector<Named> inputs;
  std::vector<Named> methods;
  std::vector<Named> views; ///< none where no images are cast
  std::vector<Named> tables;
  std::string tablesInput; ///< that --tables takes where no other is named
  bool cells = true;       ///< whether a method has a grid, so that it reads --lambda
  bool squares = false;    ///< whether it reads --sizes, not --size
  bool bundles = false;    ///< whether it reads --packet
  bool raysOfHits = false; ///< whether it reads --rays
  bool lods = false;       ///< whether it reads --poe
  bool maps = false;       ///< whether it reads what concerns occlusion maps
  bool volumes = false;    ///< whether it reads --step, --integrator and --lambda2, not --lambda
  std::string size = "1024x1024"; ///< that images have unless told otherwise
  Report (*run)(const Options& options);
};

/// All of them.
const std::vector<Suite>& suites();

/// What is measured how, for --help.
std::string describe(const Suite& suite);

} // namespace mote::bench
