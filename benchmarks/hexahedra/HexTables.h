#pragma once

#include "../Suite.h"
#include "VolumeTask.h"

namespace mote::bench
{

/// The tables by their names.
std::vector<Named> hexTables();

/// Makes the tables that the options name, of pump:SCALE for all of its parts where a table
/// compares structures or peers and of the diffuser otherwise.
Report makeHexTables(const Options& options);

/// What stands below every table: what is drawn, from where, and what errors are.
std::vector<std::string> volumeNotes(const VolumeTask& task);

/// About VTK's mappers: how they are drawn, or why they are not.
extern const char* const peerSentence;
extern const char* const noDisplaySentence;

} // namespace mote::bench
