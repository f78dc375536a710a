#ifndef MoteFileCollection_h
#define MoteFileCollection_h

#include <string>
#include <vector>

namespace mote
{

/// A file of a collection.
struct CollectedFile
{
  std::string path; ///< with the folder of the collection before it, where it was relative
  std::string name; ///< what it is called at its step; may be empty
};

/// The files of one time, in the order of the collection.
struct CollectedStep
{
  double time = 0.0;
  std::vector<CollectedFile> files;
};

/// The steps of a collection, ascending by time: of a .pvd file of ParaView, or of its .series
/// files, which are JSON. What has no time is at 0. Throws FileError for what is neither, or names
/// no file.
std::vector<CollectedStep> stepsOfCollection(const std::string& path);

} // namespace mote

#endif
