// CGNS files whose elements have several sizes: lists of mixed cells, polygons and polyhedra; and
// those that do not fit together.
#include "TableTest.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

namespace
{

using Numbers = std::vector<cgsize_t>;

struct Section
{
  CGNS_ENUMT(ElementType_t) type;
  cgsize_t first, last;
  Numbers corners, offsets;
};

/// Two cubes side by side, 12 points, with the sections of elements that are asked for.
void writeCubes(const std::string& name, const std::vector<Section>& sections, cgsize_t cells = 2,
  const Numbers& patch = {})
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

const Numbers first = {1, 2, 5, 4, 7, 8, 11, 10}, second = {2, 3, 6, 5, 8, 9, 12, 11};

Section mixed()
{
  Section section = {CGNS_ENUMV(MIXED), 1, 2, {}, {0, 9, 18}};
  for (const Numbers& cube : {first, second})
  {
    section.corners.push_back(CGNS_ENUMV(HEXA_8));
    section.corners.insert(section.corners.end(), cube.begin(), cube.end());
  }
  return section;
}

/// The eleven faces of the cubes; the sixth lies between them.
Section polygons()
{
  return {CGNS_ENUMV(NGON_n), 1, 11,
    {1, 4, 5, 2, 1, 2, 8, 7, 4, 10, 11, 5, 7, 8, 11, 10, 1, 7, 10, 4, 2, 5, 11, 8, 2, 5, 6, 3, 2, 3,
      9, 8, 5, 11, 12, 6, 8, 9, 12, 11, 3, 6, 12, 9},
    {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44}};
}

Section polyhedra()
{
  return {CGNS_ENUMV(NFACE_n), 12, 13, {1, 2, 3, 4, 5, 6, -6, 7, 8, 9, 10, 11}, {0, 6, 12}};
}

class TestCGNSElements : public TableTest
{
protected:
  /// The one part of a file that has cells of volume.
  vtkSmartPointer<vtkUnstructuredGrid> read(const std::vector<Section>& sections)
  {
    writeCubes(path("a.cgns"), sections);
    EXPECT_EQ(errorOf(path("a.cgns")), "");
    auto* blocks = vtkCompositeDataSet::SafeDownCast(m_data);
    if (!blocks)
      return vtkUnstructuredGrid::SafeDownCast(m_data);
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    return vtkUnstructuredGrid::SafeDownCast(it->GetCurrentDataObject());
  }

  void expectRefusal(const std::vector<Section>& sections, const std::string& words,
    cgsize_t cells = 2, const Numbers& patch = {})
  {
    SCOPED_TRACE(words);
    writeCubes(path("a.cgns"), sections, cells, patch);
    expectError(path("a.cgns"), words);
  }

  /// Two cubes of volume 1, with their values.
  static void expectCubes(vtkUnstructuredGrid* grid)
  {
    ASSERT_TRUE(grid);
    ASSERT_EQ(grid->GetNumberOfCells(), 2);
    for (vtkIdType cell = 0; cell < 2; ++cell)
    {
      double bounds[6];
      grid->GetCellBounds(cell, bounds);
      EXPECT_EQ(bounds[0], cell);
      EXPECT_EQ(bounds[1], cell + 1);
      EXPECT_EQ(bounds[3], 1);
      EXPECT_EQ(bounds[5], 1);
    }
    vtkDataArray* values = grid->GetCellData()->GetArray("p");
    ASSERT_TRUE(values);
    EXPECT_EQ(values->GetTuple1(0), 3.5);
    EXPECT_EQ(values->GetTuple1(1), 4.5);
  }
};

TEST_F(TestCGNSElements, MixedCells)
{
  const auto grid = read({mixed()});
  expectCubes(grid);
  EXPECT_EQ(grid->GetCellType(0), VTK_HEXAHEDRON);
}

TEST_F(TestCGNSElements, Polyhedra)
{
  const auto grid = read({polygons(), polyhedra()});
  expectCubes(grid);
  EXPECT_EQ(grid->GetCellType(0), VTK_POLYHEDRON);
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(1, cell);
  EXPECT_EQ(cell->GetNumberOfFaces(), 6);
}

TEST_F(TestCGNSElements, ListsThatDoNotFit)
{
  const auto changed = [](Section section, auto change)
  {
    change(section);
    return section;
  };
  expectRefusal({changed(mixed(), [](Section& s) { s.corners[3] = 13; })}, "names the number 13");
  expectRefusal({changed(mixed(), [](Section& s) { s.corners[3] = 0; })}, "names the number 0");
  expectRefusal({changed(mixed(), [](Section& s) { s.corners[9] = CGNS_ENUMV(QUAD_4); })},
    "more corners than elements have");
  expectRefusal({changed(mixed(), [](Section& s) { s.offsets[1] = 8; })},
    "the places where elements begin do not fit");
  expectRefusal({changed(polygons(), [](Section& s) { s.offsets[3] = 16; }), polyhedra()},
    "the sizes of elements do not fit");
  expectRefusal({polygons(), changed(polyhedra(), [](Section& s) { s.corners[5] = 12; })},
    "names the number 12");
  expectRefusal({polygons(), changed(polyhedra(), [](Section& s) { s.offsets[1] = 0; })},
    "the sizes of elements do not fit");
  const Section cubes = {CGNS_ENUMV(HEXA_8), 1, 1, first, {}};
  expectRefusal(
    {cubes, {CGNS_ENUMV(HEXA_8), 5, 5, second, {}}}, "numbers up to 5, and there are 2");
  expectRefusal(
    {cubes, {CGNS_ENUMV(HEXA_8), 2, 2, second, {}}}, "there is no place 40", 2, {1, 40});
}

} // namespace
