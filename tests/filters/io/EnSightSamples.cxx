#include "BoxParts.h"
#include "EnSightFile.h"

#include <filesystem>
#include <fstream>

namespace samples
{

namespace
{

void writeEnSightGeometry(EnSightFile file, bool isBinary)
{
  if (isBinary)
    file.text("C Binary");
  file.text("a box");
  file.text("of a test");
  file.text("node id off");
  file.text("element id off");
  const auto points = places();
  file.text("part");
  file.whole(1);
  file.text("fluid");
  file.text("coordinates");
  file.whole(pointCount);
  for (int axis = 0; axis < 3; ++axis)
    for (const Place& place : points)
      file.real(place[axis]);
  file.text("hexa8");
  file.whole(count);
  forCells(
    [&](int i, int j, int k)
    {
      std::vector<int> corners;
      for (const int corner : hexahedron(i, j, k))
        corners.push_back(corner + 1);
      file.whole(corners);
    });
  // A part has points of its own.
  const auto faces = facesAt(0, false);
  file.text("part");
  file.whole(2);
  file.text("inlet");
  file.text("coordinates");
  file.whole(static_cast<int>(4 * faces.size()));
  for (int axis = 0; axis < 3; ++axis)
    for (const Face& face : faces)
      for (const int point : face.points)
        file.real(points[point][axis]);
  file.text("quad4");
  file.whole(static_cast<int>(faces.size()));
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
    file.whole({4 * i + 1, 4 * i + 2, 4 * i + 3, 4 * i + 4});
}

} // namespace

std::string writeEnSight(const std::string& folder, bool isBinary)
{
  const std::filesystem::path at(folder);
  std::filesystem::create_directories(at);
  writeEnSightGeometry(EnSightFile(at / "box.geo", isBinary), isBinary);
  const auto faces = facesAt(0, false);
  for (int step = 0; step < 2; ++step)
  {
    EnSightFile p(at / ("box.p." + std::to_string(step)), isBinary);
    p.text("p");
    p.text("part");
    p.whole(1);
    p.text("coordinates");
    for (const Place& place : places())
      p.real(place[0] + 10.0 * place[1] + 100.0 * place[2]);
    p.text("part");
    p.whole(2);
    p.text("coordinates");
    for (std::size_t i = 0; i < 4 * faces.size(); ++i)
      p.real(0.0);
    EnSightFile velocity(at / ("box.U." + std::to_string(step)), isBinary);
    velocity.text("U");
    velocity.text("part");
    velocity.whole(1);
    velocity.text("hexa8");
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < count; ++i)
        velocity.real(axis == 0 ? 0.5 * step : axis == 1 ? double(i) : 0.0);
  }
  const std::string name = (at / "box.case").string();
  std::ofstream(name, std::ios::binary)
    << "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: box.geo\nVARIABLE\nscalar per node: 1 p "
       "box.p.*\nvector per element: 1 U box.U.*\nTIME\ntime set: 1\nnumber of steps: 2\n"
       "filename start number: 0\nfilename increment: 1\ntime values: 0 0.5\n";
  return name;
}

std::string writeEnSightSteps(const std::string& folder, bool isBinary)
{
  const std::filesystem::path at(folder);
  std::filesystem::create_directories(at);
  EnSightFile geometry(at / "steps.geo", isBinary), p(at / "steps.p", isBinary);
  if (isBinary)
    geometry.text("C Binary");
  for (const double step : {0.0, 1.0})
  {
    for (const char* line :
      {"BEGIN TIME STEP", "a triangle", "of a test", "node id off", "element id off", "part"})
      geometry.text(line);
    geometry.whole(1);
    geometry.text("all");
    geometry.text("coordinates");
    geometry.whole(3);
    geometry.reals({0, 1, 0, 0, 0, 1, step, step, step});
    geometry.text("tria3");
    geometry.whole(1);
    geometry.whole({1, 2, 3});
    geometry.text("END TIME STEP");
    p.text("BEGIN TIME STEP");
    p.text("p");
    p.text("part");
    p.whole(1);
    p.text("coordinates");
    p.reals({1.0 + step, 2.0, 3.0});
    p.text("END TIME STEP");
  }
  const std::string name = (at / "steps.case").string();
  std::ofstream(name, std::ios::binary)
    << "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 1 steps.geo\nVARIABLE\nscalar per node: 1 1 "
       "p "
       "steps.p\nTIME\ntime set: 1\nnumber of steps: 2\ntime values: 0 0.5\nFILE\nfile set: 1\n"
       "number of steps: 2\n";
  return name;
}

} // namespace samples
