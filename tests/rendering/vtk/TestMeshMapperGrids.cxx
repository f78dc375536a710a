// vtkMoteMeshMapper on unstructured grids: it draws their outer faces, which look outwards. It
// needs no display.
#include "MeshTestSupport.h"
#include "SurfaceTriangles.h"
#include "VolumeTestSupport.h"

#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

using namespace mote::testing;

namespace
{

/// The same cells with their corners in the other order that files have them in, inside out.
vtkSmartPointer<vtkUnstructuredGrid> turnedRound(vtkUnstructuredGrid* grid)
{
  const auto orderOf = [](int type) -> std::vector<vtkIdType>
  {
    switch (type)
    {
    case VTK_TETRA:
      return {0, 2, 1, 3};
    case VTK_PYRAMID:
      return {0, 3, 2, 1, 4};
    case VTK_WEDGE:
      return {3, 4, 5, 0, 1, 2};
    default:
      return {4, 5, 6, 7, 0, 1, 2, 3};
    }
  };
  auto turned = vtkSmartPointer<vtkUnstructuredGrid>::New();
  turned->SetPoints(grid->GetPoints());
  turned->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, corners);
    std::vector<vtkIdType> ids;
    for (const vtkIdType corner : orderOf(grid->GetCellType(i)))
      ids.push_back(corners->GetId(corner));
    turned->InsertNextCell(grid->GetCellType(i), static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return turned;
}

/// Cells about an axis, on which those next to it have their corners: hexahedra whose sides there
/// are lines, every other one a wedge where `withWedges`.
vtkSmartPointer<vtkUnstructuredGrid> cylinder(int radial, int around, int high, bool withWedges)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto id = [&](int r, int a, int h)
  {
    a = r == 0 ? 0 : a % around;
    const auto [it, isNew] = ids.emplace(std::array{r, a, h}, points->GetNumberOfPoints());
    const double angle = 2.0 * M_PI * a / around;
    if (isNew)
      points->InsertNextPoint(r * std::cos(angle), r * std::sin(angle), h);
    return it->second;
  };
  grid->Allocate(1);
  for (int h = 0; h < high; ++h)
    for (int r = 0; r < radial; ++r)
      for (int a = 0; a < around; ++a)
      {
        std::vector<vtkIdType> of;
        const bool isWedge = withWedges && r == 0 && a % 2 == 1;
        for (const int k : {h, h + 1})
        {
          of.insert(of.end(), {id(r, a, k), id(r + 1, a, k), id(r + 1, a + 1, k)});
          if (!isWedge)
            of.push_back(id(r, a + 1, k));
        }
        grid->InsertNextCell(
          isWedge ? VTK_WEDGE : VTK_HEXAHEDRON, static_cast<vtkIdType>(of.size()), of.data());
      }
  grid->SetPoints(points);
  return grid;
}

/// The volume within triangles that look outwards.
double volumeWithin(const mote::SurfaceTriangles& found, vtkPointSet* data)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < found.cells.size(); ++t)
  {
    mote::Vec3d p[3];
    for (int k = 0; k < 3; ++k)
      data->GetPoint(static_cast<vtkIdType>(found.view().value(t, k)), &p[k].x);
    sum += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.0;
  }
  return sum;
}

} // namespace

TEST_F(MeshStage, CellsAboutAnAxisShowTheirTriangles)
{
  const int radial = 3, around = 8, high = 2;
  const double area = around * 0.5 * radial * radial * std::sin(2.0 * M_PI / around);
  const int ends = 2 * around * (1 + 2 * (radial - 1)), side = 2 * around * high;
  for (const bool withWedges : {false, true})
    for (const bool isTurned : {false, true})
    {
      auto grid = cylinder(radial, around, high, withWedges);
      if (isTurned)
        grid = turnedRound(grid);
      const mote::SurfaceTriangles found = mote::surfaceTrianglesOf(grid);
      EXPECT_EQ(static_cast<int>(found.cells.size()), ends + side);
      EXPECT_NEAR(volumeWithin(found, grid), area * high, 1e-12);
      mapper->SetInputData(grid);
      // Without two cells at the axis, one on the other, the three sides of each show.
      vtkNew<vtkUnsignedCharArray> shown;
      for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
        shown->InsertNextValue(i % (radial * around) == 2 ? 0 : 1);
      mapper->SetVisibleCells(shown);
      mapper->Update();
      EXPECT_EQ(mapper->GetNumberOfTriangles(), ends - 2 + side + 2 * 3 * 2);
      const mote::SurfaceTriangles rest = mote::surfaceTrianglesOf(grid, shown);
      for (const vtkIdType cell : rest.cells)
        EXPECT_NE(shown->GetValue(cell), 0);
      const double wedge = area / around / (radial * radial);
      EXPECT_NEAR(volumeWithin(rest, grid), (area - wedge) * high, 1e-12);
    }
}

TEST_F(MeshStage, ShellsAreClosedAtThePoles)
{
  // Beside the axis faces have two corners at one place, but for rounding, of which VTK's filter
  // may keep a triangle without an area alone; on it they have no area at all.
  const int around = 24, high = 12, deep = 3;
  for (const int type : {VTK_FLOAT, VTK_DOUBLE})
    for (const int turns : {0, 1, 2, 3})
    {
      SCOPED_TRACE(type);
      SCOPED_TRACE(turns);
      vtkNew<vtkPoints> points;
      points->SetDataType(type);
      const auto place = [&](int i, int j, double radius)
      {
        const double longitude = 2.0 * M_PI * i / around,
                     latitude = M_PI * (j / double(high) - 0.5);
        const double x = radius * std::cos(latitude) * std::cos(longitude);
        const double y = radius * std::cos(latitude) * std::sin(longitude);
        const double z = radius * std::sin(latitude);
        return mote::Vec3d(turns & 1 ? -x : x, y, turns & 2 ? -z : z);
      };
      double volume = 0.0; // between the outer and the inner quadrilaterals
      for (int k = 0; k <= deep; ++k)
        for (int j = 0; j <= high; ++j)
          for (int i = 0; i <= around; ++i)
          {
            const double radius = 3480.0 + 963.0 * k;
            points->InsertNextPoint(&place(i, j, radius)[0]);
            if ((k > 0 && k < deep) || i == 0 || j == 0)
              continue;
            const mote::Vec3d a = place(i - 1, j - 1, radius), b = place(i, j - 1, radius),
                              c = place(i, j, radius), d = place(i - 1, j, radius);
            volume += (k == 0 ? -1.0 : 1.0) *
                      (glm::dot(a, glm::cross(b, c)) + glm::dot(a, glm::cross(c, d))) / 6.0;
          }
      vtkNew<vtkStructuredGrid> grid;
      grid->SetDimensions(around + 1, high + 1, deep + 1);
      grid->SetPoints(points);
      const mote::SurfaceTriangles found = mote::surfaceTrianglesOf(grid);
      EXPECT_EQ(found.flat, 0);
      EXPECT_NEAR(volumeWithin(found, grid), volume, 1e-5 * std::abs(volume));
    }
}

TEST_F(MeshStage, GridsShowTheirFacesAndNameTheirCells)
{
  for (const int type : {VTK_HEXAHEDRON, VTK_TETRA, VTK_WEDGE, VTK_PYRAMID, VTK_QUAD, VTK_TRIANGLE,
         VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_TRIANGLE})
  {
    SCOPED_TRACE(type);
    const auto grid = gridOf(type);
    double box[6];
    grid->GetBounds(box);
    const double diagonal = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
    mapper->SetInputData(grid);
    renderer->GetActiveCamera()->SetFocalPoint(grid->GetCenter());
    for (const double away : {-1.0, 1.0})
    {
      const double* middle = grid->GetCenter();
      renderer->GetActiveCamera()->SetPosition(
        middle[0] + 2.0 * away, middle[1] + 3.0 * away, middle[2] + 5.0 * away);
      renderer->GetActiveCamera()->SetParallelScale(0.5 * diagonal);
      renderer->ResetCameraClippingRange();
      int picked = 0;
      for (int p = 0; p < size * size; p += 7)
      {
        if (picker->Pick(p % size, p / size, 0, renderer) == 0)
          continue;
        ++picked;
        double cell[6];
        ASSERT_GE(picker->GetCellId(), 0);
        ASSERT_LT(picker->GetCellId(), grid->GetNumberOfCells());
        grid->GetCellBounds(picker->GetCellId(), cell);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_GT(picker->GetPickPosition()[axis], cell[2 * axis] - 1e-4);
          EXPECT_LT(picker->GetPickPosition()[axis], cell[2 * axis + 1] + 1e-4);
        }
      }
      EXPECT_GT(picked, 60);
    }
  }
}

TEST_F(MeshStage, LooksIntoWallsWhoseOuterSideIsClear)
{
  const auto grid = gridOf(VTK_HEXAHEDRON); // nine cells a layer, from z = 0 on
  mapper->SetInputData(grid);
  actor->SetPosition(-1.5, -1.5, -1.5);
  EXPECT_GE(cellAt(0.1, 0.1), 18);
  actor->GetProperty()->SetOpacity(0.0);
  EXPECT_EQ(cellAt(0.1, 0.1), -1);
  vtkNew<vtkProperty> inner;
  actor->SetBackfaceProperty(inner);
  EXPECT_EQ(cellAt(0.1, 0.1), 4); // of the farthest layer
  const auto alpha = [&] { return this->trace().color(pixel(0.1, 0.1))[3]; };
  EXPECT_EQ(alpha(), 1.0f);
  inner->SetOpacity(0.5);
  EXPECT_NEAR(alpha(), 0.5, 1e-6);
  actor->GetProperty()->SetOpacity(0.5);
  EXPECT_NEAR(alpha(), 0.75, 1e-6);
}

TEST_F(MeshStage, SheetsBesideCellsAreSeenFromBothSidesWhereThatIsAsked)
{
  actor->SetPosition(-1.5, -1.5, -1.5);
  vtkNew<vtkProperty> inner;
  const auto alpha = [&] { return this->trace().color(pixel(0.1, 0.1))[3]; };
  for (const bool looksAway : {false, true})
  {
    SCOPED_TRACE(looksAway);
    const auto grid = gridOf(VTK_HEXAHEDRON);
    const vtkIdType sheet = grid->GetNumberOfCells();
    vtkIdType corners[4];
    const double places[4][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
    for (const int k : {0, 1, 2, 3})
      corners[looksAway ? 3 - k : k] =
        grid->GetPoints()->InsertNextPoint(places[k][0], places[k][1], 3.5);
    grid->InsertNextCell(VTK_QUAD, 4, corners);
    mapper->SetInputData(grid);
    actor->SetBackfaceProperty(nullptr);
    actor->GetProperty()->SetOpacity(1.0);
    mapper->TwoSidedSheetsOff();
    mapper->Update();
    const vtkIdType triangles = mapper->GetNumberOfTriangles();
    for (const bool isTwoSided : {false, true})
    {
      SCOPED_TRACE(isTwoSided);
      mapper->SetTwoSidedSheets(isTwoSided);
      actor->GetProperty()->SetOpacity(0.0);
      actor->SetBackfaceProperty(inner);
      EXPECT_EQ(cellAt(0.1, 0.1), isTwoSided || looksAway ? sheet : 4);
      EXPECT_EQ(cellAt(-1.2, -1.2), 0);
      // It is there once where light goes through it: sheet, near wall, far wall.
      actor->SetBackfaceProperty(nullptr);
      actor->GetProperty()->SetOpacity(0.5);
      EXPECT_NEAR(alpha(), 1.0 - 0.5 * 0.5 * 0.5, 1e-6);
      EXPECT_EQ(mapper->GetNumberOfTriangles(), triangles);
    }
    // Points that move, which builds no tree.
    const int refits = mapper->GetNumberOfRefits();
    for (vtkIdType i = 0; i < 4; ++i)
      grid->GetPoints()->SetPoint(
        corners[i], grid->GetPoint(corners[i])[0] + 0.9, grid->GetPoint(corners[i])[1] + 0.9, 3.5);
    grid->GetPoints()->Modified();
    actor->GetProperty()->SetOpacity(0.0);
    actor->SetBackfaceProperty(inner);
    EXPECT_EQ(cellAt(0.9, 0.9), sheet);
    EXPECT_EQ(cellAt(0.1, 0.1), 4);
    EXPECT_EQ(mapper->GetNumberOfRefits(), refits + 1);
    EXPECT_EQ(mapper->GetNumberOfTriangles(), triangles);
  }
}

TEST_F(MeshStage, FacesLookOutwardsWhateverTheOrderOfCorners)
{
  actor->SetPosition(-1.5, -1.5, -1.5);
  vtkNew<vtkProperty> inner;
  for (const int type : {VTK_HEXAHEDRON, VTK_TETRA, VTK_WEDGE, VTK_PYRAMID})
  {
    SCOPED_TRACE(type);
    const auto grid = gridOf(type);
    for (const auto& data : {grid, turnedRound(grid)})
    {
      // With a clear outer side rays end at the farthest faces.
      mapper->SetInputData(data);
      actor->GetProperty()->SetOpacity(0.0);
      actor->SetBackfaceProperty(inner);
      for (int p = 0; p < size * size; p += 7)
      {
        ASSERT_EQ(picker->Pick(p % size, p / size, 0, renderer), 1) << p;
        EXPECT_NEAR(picker->GetPickPosition()[2], -1.5, 1e-5) << p;
      }
    }
  }
}

TEST_F(MeshStage, FacesOfPolyhedraLookOutwardsWhateverTheirOrder)
{
  const auto cells = gridOf(VTK_HEXAHEDRON);
  const int faces[6][4] = {
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const int inwards : {0, 63, 1, 37, 54}) // a bit for each face that looks inwards
  {
    SCOPED_TRACE(inwards);
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(cells->GetPoints());
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      cells->GetCellPoints(i, corners);
      vtkNew<vtkIdList> stream;
      stream->InsertNextId(6);
      for (int f = 0; f < 6; ++f)
      {
        stream->InsertNextId(4);
        for (int k = 0; k < 4; ++k)
          stream->InsertNextId(corners->GetId(faces[f][inwards >> f & 1 ? 3 - k : k]));
      }
      grid->InsertNextCell(VTK_POLYHEDRON, stream);
    }
    const mote::SurfaceTriangles found = mote::surfaceTrianglesOf(grid);
    EXPECT_EQ(found.cells.size(), 2U * 6 * 9);
    EXPECT_NEAR(volumeWithin(found, grid), 27.0, 1e-9);
  }
}

TEST_F(MeshStage, FacesAreInTheSameOrderEachTime)
{
  // VTK's filter gives them as its threads finish.
  for (const int type : {VTK_WEDGE, VTK_HEXAHEDRON, VTK_TETRA})
  {
    const auto grid = gridOf(type);
    const mote::SurfaceTriangles first = mote::surfaceTrianglesOf(grid);
    for (int round = 0; round < 300; ++round)
    {
      const mote::SurfaceTriangles again = mote::surfaceTrianglesOf(grid);
      ASSERT_EQ(again.cells, first.cells) << round;
      ASSERT_EQ(again.edges, first.edges) << round;
      for (std::size_t t = 0; t < first.cells.size(); ++t)
        for (int k = 0; k < 3; ++k)
          ASSERT_EQ(again.view().value(t, k), first.view().value(t, k)) << round;
    }
  }
}

TEST_F(MeshStage, LinesOnFacesAreTheSameWhateverTheOrderOfCorners)
{
  actor->SetPosition(-1.5, -1.5, -1.5);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(1, 0, 0);
  actor->GetProperty()->SetLineWidth(3);
  for (const int type : {VTK_HEXAHEDRON, VTK_WEDGE})
  {
    SCOPED_TRACE(type);
    const auto grid = gridOf(type);
    mapper->SetInputData(grid);
    const Picture as = this->trace();
    mapper->SetInputData(turnedRound(grid));
    const Picture turned = this->trace();
    int lines = 0;
    for (int p = 0; p < size * size; ++p)
    {
      lines += as.color(p)[0] > 0.5f && as.color(p)[1] < 0.1f;
      for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(as.color(p)[k], turned.color(p)[k], 1e-5) << p;
    }
    EXPECT_GT(lines, 100);
  }
}
