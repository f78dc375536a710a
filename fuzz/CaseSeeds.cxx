// fuzz-case-seeds FORMAT FOLDER: small cases of several files each, OpenFOAM's (foam) or EnSight's
// (ensight), for libFuzzer to begin with.

#include "FilePack.h"
#include "MeshSamples.h"

#include <fstream>

int main(int count, char** words)
{
  if (count != 3)
    return 1;
  const std::string format = words[1], folder = words[2], place = folder + "/case";
  const auto keep = [&](const std::string& name, const std::string& opened)
  {
    const std::filesystem::path file(opened);
    std::filesystem::rename(file, file.parent_path() / ("a" + file.extension().string()));
    std::ofstream(folder + "/seed-" + name, std::ios::binary) << packed(place);
    std::filesystem::remove_all(place);
  };
  for (const bool isBinary : {false, true})
  {
    const std::string kind = isBinary ? "binary" : "text";
    std::filesystem::create_directories(place);
    if (format == "foam")
    {
      keep(kind, samples::writeFoam(place, {isBinary}));
      std::filesystem::create_directories(place);
      keep("moving-" + kind, samples::writeFoam(place, {isBinary, -1, true, true}));
      std::filesystem::create_directories(place);
      const std::string points = samples::writeFoam(place, {isBinary, -1, true});
      for (const char* name : {"faces", "owner", "neighbour", "boundary"})
        std::filesystem::remove(place + "/0.5/polyMesh/" + name);
      keep("points-" + kind, points);
      std::filesystem::create_directories(place);
      keep("decomposed-" + kind, samples::writeDecomposedFoam(place, isBinary));
      continue;
    }
    keep(kind, samples::writeEnSight(place, isBinary));
    std::filesystem::create_directories(place);
    keep("steps-" + kind, samples::writeEnSightSteps(place, isBinary));
  }
  return 0;
}
