#ifndef MoteCGNSCubes_h
#define MoteCGNSCubes_h

// Two cubes as CGNS files may have them: as mixed cells, or as polygons and polyhedra.

#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <string>
#include <vector>

namespace samples
{

using Numbers = std::vector<cgsize_t>;

struct Section
{
  CGNS_ENUMT(ElementType_t) type;
  cgsize_t first, last;
  Numbers corners, offsets;
};

/// Two cubes side by side, 12 points, with the sections of elements that are asked for.
inline void writeCubes(const std::string& name, const std::vector<Section>& sections,
  cgsize_t cells = 2, const Numbers& patch = {})
{
  int file = 0, base = 0, zone = 0, number = 0;
  cg_open(name.c_str(), CG_MODE_WRITE, &file);
  cg_base_write(file, "Base", 3, 3, &base);
  const cgsize_t size[3] = {12, cells, 0};
  cg_zone_write(file, base, "cubes", size, CGNS_ENUMV(Unstructured), &zone);
  const char* const axes[3] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
  const int counts[3] = {1, 3, 6}; // 3 along x, 2 along y, 2 along z
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> values;
    for (int i = 0; i < 12; ++i)
      values.push_back(i / counts[axis] % (axis == 0 ? 3 : 2));
    cg_coord_write(file, base, zone, CGNS_ENUMV(RealDouble), axes[axis], values.data(), &number);
  }
  int sectionNumber = 0;
  for (const Section& section : sections)
  {
    const std::string title = "elements " + std::to_string(++sectionNumber);
    if (section.offsets.empty())
      cg_section_write(file, base, zone, title.c_str(), section.type, section.first, section.last,
        0, section.corners.data(), &number);
    else
      cg_poly_section_write(file, base, zone, title.c_str(), section.type, section.first,
        section.last, 0, section.corners.data(), section.offsets.data(), &number);
  }
  if (!patch.empty())
    cg_boco_write(file, base, zone, "wall", CGNS_ENUMV(BCWall), CGNS_ENUMV(PointList),
      static_cast<cgsize_t>(patch.size()), patch.data(), &number);
  int solution = 0;
  std::vector<double> values = {3.5, 4.5};
  values.resize(static_cast<std::size_t>(cells));
  cg_sol_write(file, base, zone, "flow", CGNS_ENUMV(CellCenter), &solution);
  cg_field_write(file, base, zone, solution, CGNS_ENUMV(RealDouble), "p", values.data(), &number);
  cg_close(file);
}

const Numbers firstCube = {1, 2, 5, 4, 7, 8, 11, 10}, secondCube = {2, 3, 6, 5, 8, 9, 12, 11};

inline Section mixed()
{
  Section section = {CGNS_ENUMV(MIXED), 1, 2, {}, {0, 9, 18}};
  for (const Numbers& cube : {firstCube, secondCube})
  {
    section.corners.push_back(CGNS_ENUMV(HEXA_8));
    section.corners.insert(section.corners.end(), cube.begin(), cube.end());
  }
  return section;
}

/// The eleven faces of the cubes; the sixth lies between them.
inline Section polygons()
{
  return {CGNS_ENUMV(NGON_n), 1, 11,
    {1, 4, 5, 2, 1, 2, 8, 7, 4, 10, 11, 5, 7, 8, 11, 10, 1, 7, 10, 4, 2, 5, 11, 8, 2, 5, 6, 3, 2, 3,
      9, 8, 5, 11, 12, 6, 8, 9, 12, 11, 3, 6, 12, 9},
    {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44}};
}

inline Section polyhedra()
{
  return {CGNS_ENUMV(NFACE_n), 12, 13, {1, 2, 3, 4, 5, 6, -6, 7, 8, 9, 10, 11}, {0, 6, 12}};
}

} // namespace samples

#endif
