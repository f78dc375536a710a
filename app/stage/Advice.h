#pragma once

#include "Stage.h"

#include <string>
#include <vector>

namespace mote::app
{

/// A sentence for each of the settings that does nothing to what the stage shows, such as shadows
/// where there are only clouds, and for isosurfaces and colours outside of the data's range.
std::vector<std::string> adviceOn(const Stage& stage);

/// Where particles are limited so that none is shown: a sentence that names the limit; else
/// nothing.
std::string whatLeavesNothing(const Stage& stage);

/// Sentences on what is shown of the files: unlikeSizes(), and boundaries that are hidden.
std::vector<std::string> adviceOnData(const Stage& stage);

/// A sentence where files that are shown together are so unlike in size that one is hardly seen;
/// else nothing.
std::string unlikeSizes(const Stage& stage);

} // namespace mote::app
