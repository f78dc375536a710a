// CGNS files whose elements have several sizes: lists of mixed cells, polygons and polyhedra; and
// those that do not fit together.
#include "CGNSCubes.h"
#include "TableTest.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace samples;

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
  const Section cubes = {CGNS_ENUMV(HEXA_8), 1, 1, firstCube, {}};
  expectRefusal(
    {cubes, {CGNS_ENUMV(HEXA_8), 5, 5, secondCube, {}}}, "numbers up to 5, and there are 2");
  expectRefusal(
    {cubes, {CGNS_ENUMV(HEXA_8), 2, 2, secondCube, {}}}, "there is no place 40", 2, {1, 40});
}

} // namespace
