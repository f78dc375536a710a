#include "BoxParts.h"

#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <numeric>

namespace samples
{

namespace
{

void writeField(int file, int zone, const char* name, double time)
{
  int solution = 0, field = 0;
  std::vector<double> q(count);
  std::iota(q.begin(), q.end(), time);
  cg_sol_write(file, 1, zone, name, CGNS_ENUMV(CellCenter), &solution);
  cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble), "q", q.data(), &field);
}

void writeTimes(int file, int zone)
{
  char names[2][32];
  for (int step = 0; step < 2; ++step)
  {
    std::fill(names[step], names[step] + 32, ' ');
    const std::string name = step == 0 ? "first" : "second";
    std::copy(name.begin(), name.end(), names[step]);
    writeField(file, zone, name.c_str(), 0.5 * step);
  }
  cg_ziter_write(file, 1, zone, "ZoneIterativeData");
  cg_goto(file, 1, "Zone_t", zone, "ZoneIterativeData_t", 1, "end");
  const cgsize_t shape[2] = {32, 2};
  cg_array_write("FlowSolutionPointers", CGNS_ENUMV(Character), 2, shape, names);
}

void writeCoordinates(int file, int zone)
{
  const char* const names[3] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> values;
    for (const Place& place : places(zone == 1 ? 0.0 : nx))
      values.push_back(place[axis]);
    int coordinate = 0;
    cg_coord_write(file, 1, zone, CGNS_ENUMV(RealDouble), names[axis], values.data(), &coordinate);
  }
}

} // namespace

void writeCGNS(const std::string& name)
{
  int file = 0, base = 0, zone = 0, section = 0, condition = 0, family = 0;
  cg_open(name.c_str(), CG_MODE_WRITE, &file);
  cg_base_write(file, "Base", 3, 3, &base);
  const cgsize_t size[3] = {pointCount, count, 0};
  cg_zone_write(file, base, "fluid", size, CGNS_ENUMV(Unstructured), &zone);
  writeCoordinates(file, zone);
  std::vector<cgsize_t> corners;
  forCells(
    [&](int i, int j, int k)
    {
      for (const int corner : hexahedron(i, j, k))
        corners.push_back(corner + 1);
    });
  cgsize_t last = count;
  cg_section_write(
    file, base, zone, "cells", CGNS_ENUMV(HEXA_8), 1, last, 0, corners.data(), &section);
  const std::pair<const char*, std::vector<Face>> patches[] = {
    {"inlet", facesAt(0, false)}, {"walls", wallFaces()}};
  for (const auto& [patch, faces] : patches)
  {
    corners.clear();
    for (const Face& face : faces)
      for (const int point : face.points)
        corners.push_back(point + 1);
    const cgsize_t range[2] = {last + 1, last + static_cast<cgsize_t>(faces.size())};
    cg_section_write(
      file, base, zone, patch, CGNS_ENUMV(QUAD_4), range[0], range[1], 0, corners.data(), &section);
    cg_boco_write(
      file, base, zone, patch, CGNS_ENUMV(BCWall), CGNS_ENUMV(PointRange), 2, range, &condition);
    cg_boco_gridlocation_write(file, base, zone, condition, CGNS_ENUMV(FaceCenter));
    cg_goto(file, base, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", condition, "end");
    cg_famname_write(patch);
    cg_family_write(file, base, patch, &family);
    last = range[1];
  }
  writeTimes(file, zone);
  const cgsize_t shape[9] = {nx + 1, ny + 1, nz + 1, nx, ny, nz, 0, 0, 0};
  cg_zone_write(file, base, "rotor", shape, CGNS_ENUMV(Structured), &zone);
  writeCoordinates(file, zone);
  writeTimes(file, zone);
  cg_biter_write(file, base, "TimeIterValues", 2);
  cg_goto(file, base, "BaseIterativeData_t", 1, "end");
  const cgsize_t steps = 2;
  const double times[2] = {0.0, 0.5};
  cg_array_write("TimeValues", CGNS_ENUMV(RealDouble), 1, &steps, times);
  cg_close(file);
}

} // namespace samples
