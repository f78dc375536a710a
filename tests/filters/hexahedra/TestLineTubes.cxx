// Tubes around lines: where their sides are, and that none is lost where a line stands still or
// turns back.
#include "vtkMoteLineTubes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using Lines = vtkSmartPointer<vtkPolyData>;
using Place = std::array<double, 3>;

/// A polyline through each of these, with the number of the line as an array of cells.
Lines through(const std::vector<std::vector<Place>>& lines)
{
  auto data = Lines::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("line");
  for (const auto& line : lines)
  {
    numbers->InsertNextValue(static_cast<int>(numbers->GetNumberOfValues()));
    std::vector<vtkIdType> ids;
    for (const Place& place : line)
      ids.push_back(points->InsertNextPoint(place.data()));
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->AddArray(numbers);
  return data;
}

std::vector<Place> helix(int count)
{
  std::vector<Place> places;
  for (int i = 0; i < count; ++i)
  {
    const double t = 0.05 * i;
    places.push_back({100.0 + std::cos(t), 5.0 + std::sin(t), 0.3 * t});
  }
  return places;
}

double areaOf(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(triangles->GetOutputPort());
  properties->Update();
  return properties->GetSurfaceArea();
}

/// Of a straight tube with eight sides and two ends.
double areaOfTube(double radius, double length)
{
  const double side = 2.0 * radius * std::sin(vtkMath::Pi() / 8.0);
  const double end = 4.0 * radius * radius * std::sin(vtkMath::Pi() / 4.0);
  return 8.0 * side * length + 2.0 * end;
}

/// How far a point is from the nearest point of the lines.
double distanceTo(vtkPolyData* lines, const double* point)
{
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    least = std::min(least, vtkMath::Distance2BetweenPoints(lines->GetPoint(i), point));
  return std::sqrt(least);
}

} // namespace

TEST(LineTubes, HaveTheirRadiusAroundEveryPoint)
{
  const Lines lines = through({helix(200)});
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(0.01);
  tubes->SetRadiusScale(2.0);
  tubes->Update();
  vtkPolyData* const made = tubes->GetOutput();
  ASSERT_GE(made->GetNumberOfPoints(), 200 * 8);
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
    EXPECT_NEAR(distanceTo(lines, made->GetPoint(i)), 0.02, 1e-9);
  EXPECT_EQ(tubes->GetNumberOfLinesLeftOut(), 0);
  ASSERT_TRUE(made->GetPointData()->GetNormals());
  EXPECT_FALSE(made->GetPointData()->HasArray("MoteTubeRadii"));
}

TEST(LineTubes, HaveTheAreaOfTheirLength)
{
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(through({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}));
  tubes->SetRadius(0.1);
  tubes->Update();
  EXPECT_NEAR(areaOf(tubes->GetOutput()), areaOfTube(0.1, 3.0), 1e-6);
}

TEST(LineTubes, HaveFewerSidesWhereThereAreMany)
{
  for (const auto& [count, sides] : {std::pair(1000, 8), std::pair(1'600'000, 5)})
  {
    std::vector<Place> places;
    for (int i = 0; i < count; ++i)
      places.push_back({1.0 * i, 0.0, 0.0});
    vtkNew<vtkMoteLineTubes> tubes;
    tubes->SetInputData(through({places}));
    tubes->SetRadius(0.1);
    tubes->Update();
    EXPECT_EQ(tubes->GetOutput()->GetNumberOfPoints(), (count + 2) * sides); // and two ends
  }
}

TEST(LineTubes, GoOnWhereALineStandsStill)
{
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(
    through({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 0, 0}}}));
  tubes->SetRadius(0.1);
  tubes->Update();
  EXPECT_NEAR(areaOf(tubes->GetOutput()), areaOfTube(0.1, 3.0), 1e-6);
}

TEST(LineTubes, BeginAnewWhereALineTurnsBackOrHasNoPlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetRadius(0.1);
  tubes->SetInputData(through({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}}));
  tubes->Update();
  EXPECT_NEAR(areaOf(tubes->GetOutput()), areaOfTube(0.1, 2.0) + areaOfTube(0.1, 1.0), 1e-6);
  tubes->SetInputData(through({{{0, 0, 0}, {2, 0, 0}, {nan, 0, 0}, {3, 0, 0}, {4, 0, 0}}}));
  tubes->Update();
  EXPECT_NEAR(areaOf(tubes->GetOutput()), areaOfTube(0.1, 2.0) + areaOfTube(0.1, 1.0), 1e-6);
}

TEST(LineTubes, HaveTheValuesOfTheirLines)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(through({{{0, 0, 0}, {1, 0, 0}}, {{2, 2, 2}, {2, 2, 2}}, {{5, 5, nan}},
    {{0, 3, 0}, {1, 3, 0}, {1, 4, 0}}}));
  tubes->Update();
  EXPECT_EQ(tubes->GetNumberOfLinesLeftOut(), 2);
  vtkPolyData* const made = tubes->GetOutput();
  vtkDataArray* const numbers = made->GetCellData()->GetArray("line");
  ASSERT_TRUE(numbers);
  ASSERT_EQ(numbers->GetNumberOfTuples(), made->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < made->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    made->GetCellBounds(cell, bounds);
    EXPECT_EQ(numbers->GetComponent(cell, 0), bounds[2] > 2.0 ? 3.0 : 0.0);
  }
}

TEST(LineTubes, TakeRadiiFromAnArray)
{
  const Lines lines = through({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}});
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("width");
  for (const double value : {0.1, 0.2, -1.0, std::numeric_limits<double>::infinity()})
    radius->InsertNextValue(value);
  lines->GetPointData()->AddArray(radius);
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadiusArrayName("width");
  tubes->SetRadiusScale(0.5);
  tubes->Update();
  const double expected[] = {0.05, 0.1, 1e-4, 1e-4};
  vtkPolyData* const made = tubes->GetOutput();
  ASSERT_GE(made->GetNumberOfPoints(), 4 * 8);
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    const double* const p = made->GetPoint(i);
    EXPECT_NEAR(std::hypot(p[1], p[2]), expected[static_cast<int>(std::lround(p[0]))], 1e-9);
  }
}

TEST(LineTubes, RefuseAnArrayThatIsNotThere)
{
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(through({helix(9)}));
  tubes->SetRadiusArrayName("width");
  vtkNew<vtkTest::ErrorObserver> errors, executive;
  tubes->AddObserver(vtkCommand::ErrorEvent, errors);
  tubes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
  tubes->Update();
  EXPECT_NE(errors->GetErrorMessage().find("The points have no array 'width'"), std::string::npos);
  EXPECT_EQ(tubes->GetOutput()->GetNumberOfCells(), 0);
}

TEST(LineTubes, AreTheSameForAGrid)
{
  const Lines lines = through({helix(50), {{0, 0, 0}, {1, 1, 1}}});
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(lines->GetPoints());
  grid->SetCells(VTK_POLY_LINE, lines->GetLines());
  vtkNew<vtkMoteLineTubes> ofLines, ofGrid;
  ofLines->SetInputData(lines);
  ofGrid->SetInputData(grid);
  ofLines->Update();
  ofGrid->Update();
  ASSERT_EQ(ofGrid->GetOutput()->GetNumberOfPoints(), ofLines->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ofGrid->GetOutput()->GetNumberOfPoints(); ++i)
    EXPECT_EQ(vtkMath::Distance2BetweenPoints(
                ofGrid->GetOutput()->GetPoint(i), ofLines->GetOutput()->GetPoint(i)),
      0.0);
}

TEST(LineTubes, KnowsDataOfLinesAlone)
{
  const Lines lines = through({helix(5)});
  EXPECT_TRUE(vtkMoteLineTubes::IsOfLines(lines));
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_FALSE(vtkMoteLineTubes::IsOfLines(grid));
  grid->SetPoints(lines->GetPoints());
  grid->SetCells(VTK_POLY_LINE, lines->GetLines());
  EXPECT_TRUE(vtkMoteLineTubes::IsOfLines(grid));
  const vtkIdType first = 0;
  grid->InsertNextCell(VTK_VERTEX, 1, &first);
  EXPECT_FALSE(vtkMoteLineTubes::IsOfLines(grid));
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, &first);
  lines->SetVerts(vertices);
  EXPECT_FALSE(vtkMoteLineTubes::IsOfLines(lines));
  EXPECT_FALSE(vtkMoteLineTubes::IsOfLines(vtkNew<vtkPolyData>()));
}
