#include "FoamMesh.h"

#include "FoamListFile.h"
#include "TextFile.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace mote
{

namespace
{

/// How many faces there are, which name points below `points`.
std::int64_t checkFaces(FoamListFile& file, std::int64_t points)
{
  const auto requirePoint = [&](std::int64_t point)
  {
    if (point < 0 || point >= points)
      file.fail("a face names the point " + std::to_string(point) + ", and there are " +
                std::to_string(points));
  };
  if (!file.isBinary() || file.kind() != "faceCompactList")
    return file.isBinary() ? -1 : file.faces(requirePoint);
  std::int64_t last = -1;
  const std::int64_t begins = file.labels(
    [&](std::int64_t begin)
    {
      if (begin < last || (last < 0 && begin != 0))
        file.fail("the places where faces begin do not ascend from 0");
      last = begin;
    });
  const std::int64_t corners = file.labels(requirePoint);
  if (begins == 0 || last != corners)
    file.fail("the places where faces begin do not fit their corners");
  return begins - 1;
}

/// Throws FileError where the cells on one side of the faces do not fit them.
void checkCells(FoamListFile& file, bool isOwner, std::int64_t faces)
{
  const std::int64_t least = isOwner ? 0 : -1; // of faces that have none
  const std::int64_t count = file.labels(
    [&](std::int64_t cell)
    {
      if (cell < least || cell >= faces) // a mesh has more faces than cells
        file.fail("there is no cell " + std::to_string(cell));
    });
  if (isOwner ? count != faces : count > faces)
    file.fail(
      "there are " + std::to_string(count) + " cells for " + std::to_string(faces) + " faces");
}

/// A simulation that runs may take files away meanwhile.
bool isThere(const std::string& path)
{
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool isFoamFile(const std::string& path)
{
  return isThere(path) && readBeginning(path, 2048).find("FoamFile") != std::string::npos;
}

} // namespace

std::optional<std::string> findFoamFile(const std::string& folder, const std::string& name)
{
  for (const std::string& one : {folder + "/" + name, folder + "/" + name + ".gz"})
    if (isThere(one))
      return one;
  return std::nullopt;
}

FoamMeshFacts checkFoamMesh(const FoamMesh& mesh)
{
  if (const auto path = findFoamFile(mesh.faces, "boundary")) // looked at before others are missed
  {
    FoamListFile boundary(*path);
    boundary.requireShallow();
    boundary.patches();
  }
  for (const char* name : {"cellZones", "faceZones", "pointZones"})
    if (const auto path = findFoamFile(mesh.faces, name))
      FoamListFile(*path).requireShallow();
  const auto open = [](const std::string& folder, const char* name)
  {
    const auto path = findFoamFile(folder, name);
    auto file = path ? std::make_unique<FoamListFile>(*path) : nullptr;
    if (file)
      file->requireShallow(true);
    return file;
  };
  std::int64_t points = -1, faces = -1; // not known
  FoamMeshFacts facts;
  if (const auto file = open(mesh.points, "points"))
  {
    points = file->places();
    facts = {points, file->arePlaces(points)};
  }
  if (const auto file = open(mesh.faces, "faces"); file && points >= 0)
  {
    faces = checkFaces(*file, points);
    facts.places = std::max(points, faces < 0 ? file->length() : faces);
  }
  for (const char* name : {"owner", "neighbour"})
    if (const auto file = open(mesh.faces, name); file && faces >= 0)
      checkCells(*file, name[0] == 'o', faces);
  return facts;
}

void checkFoamDepth(const std::string& path)
{
  if (isFoamFile(path))
    FoamListFile(path).requireShallow();
}

void checkFoamFile(const std::string& path, std::int64_t places)
{
  if (!isFoamFile(path))
    return;
  FoamListFile file(path);
  file.requireShallow();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  // A cloud has a value for each of its positions.
  const auto particles = [&]
  {
    std::int64_t count = 0;
    for (const char* name : {"positions", "coordinates"})
      if (const auto of = findFoamFile(folder.string(), name))
        count = std::max(count, FoamListFile(*of).length());
    return count;
  };
  if (folder.parent_path().filename() == "lagrangian")
    file.valueList(particles);
  else if (file.kind().find("Field") != std::string::npos)
  {
    file.valueLists([&] { return places; });
    file.boundaryField();
  }
}

} // namespace mote
