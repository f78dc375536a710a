// Data in pieces: written, and put together again as they were.

#include "IOTestSupport.h"
#include "WrittenAgain.h"

#include "vtkMotePiecesWriter.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

namespace
{

namespace fs = std::filesystem;

class TestPiecesWriter : public FileTest
{
protected:
  /// Writes, and returns what went wrong.
  std::string written(vtkDataObject* data, const std::string& name, int pieces)
  {
    vtkNew<vtkMotePiecesWriter> writer;
    vtkNew<vtkCallbackCommand> quiet;
    writer->AddObserver(vtkCommand::ErrorEvent, quiet);
    if (data)
      writer->SetInputDataObject(data);
    writer->SetFileName(path(name).c_str());
    writer->SetNumberOfPieces(pieces);
    const int done = writer->Write();
    EXPECT_EQ(done == 1, writer->GetErrorMessage().empty());
    made = writer->GetNumberOfWrittenPieces();
    return writer->GetErrorMessage();
  }

  template <typename Data = vtkDataSet>
  vtkSmartPointer<Data> again(const std::string& name)
  {
    return readAgain<Data>(path(name));
  }

  int made = 0; ///< pieces that were written last
};

/// Boxes side by side, their points in common but for a thin wall: where x is `wall`, the boxes on
/// both sides have points of their own. 0: no wall.
vtkSmartPointer<vtkUnstructuredGrid> boxes(int nx, int ny, int nz, int wall, bool arePolyhedra)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  std::map<std::array<int, 4>, vtkIdType> known; // x, y, z, and the side of the wall
  const auto pointAt = [&](int x, int y, int z, int side)
  {
    const auto [place, isNew] =
      known.try_emplace({x, y, z, x == wall ? side : 0}, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(0.1 * x, 0.3 * y, 0.7 * z);
      values->InsertNextValue(static_cast<float>(100 * x + 10 * y + z + (x == wall ? side : 0)));
    }
    return place->second;
  };
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
      {
        const int side = x < wall ? -1 : 1;
        vtkIdType corners[8];
        const int aside[8][3] = {
          {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        for (int i = 0; i < 8; ++i)
          corners[i] = pointAt(x + aside[i][0], y + aside[i][1], z + aside[i][2], wall ? side : 0);
        numbers->InsertNextValue(grid->GetNumberOfCells());
        if (!arePolyhedra)
        {
          grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
          continue;
        }
        const int faces[6][4] = {
          {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
        vtkNew<vtkIdList> stream;
        stream->InsertNextId(6);
        for (const auto& face : faces)
        {
          stream->InsertNextId(4);
          for (const int corner : face)
            stream->InsertNextId(corners[corner]);
        }
        grid->InsertNextCell(VTK_POLYHEDRON, stream);
      }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(values);
  grid->GetCellData()->AddArray(numbers);
  return grid;
}

/// The bounds and the corner values of each cell, by its number.
std::map<int, std::vector<double>> factsOf(vtkUnstructuredGrid* grid)
{
  std::map<int, std::vector<double>> facts;
  vtkDataArray* numbers = grid->GetCellData()->GetArray("number");
  vtkDataArray* values = grid->GetPointData()->GetArray("value");
  for (vtkIdType i = 0; numbers && values && i < grid->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = grid->GetCell(i);
    std::vector<double> own(6);
    cell->GetBounds(own.data());
    own.push_back(cell->GetNumberOfFaces());
    double sum = 0.0;
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
      sum +=
        values->GetTuple1(cell->GetPointId(k)) * (1.0 + grid->GetPoint(cell->GetPointId(k))[0]);
    own.push_back(std::round(sum * 1e6));
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      double bounds[6];
      cell->GetFace(face)->GetBounds(bounds);
      own.insert(own.end(), bounds, bounds + 6);
    }
    facts[static_cast<int>(numbers->GetTuple1(i))] = own;
  }
  return facts;
}

} // namespace

TEST_F(TestPiecesWriter, GridsAreWholeAgain)
{
  for (const bool arePolyhedra : {false, true})
  {
    const auto grid = boxes(7, 5, 3, 0, arePolyhedra);
    for (const int pieces : {1, 2, 5, 8})
    {
      ASSERT_EQ(written(grid, "a.pvtu", pieces), "");
      EXPECT_EQ(made, pieces);
      const auto whole = again<vtkUnstructuredGrid>("a.pvtu");
      ASSERT_TRUE(whole);
      EXPECT_EQ(whole->GetNumberOfPoints(), grid->GetNumberOfPoints()) << pieces;
      EXPECT_EQ(whole->GetPoints()->GetDataType(), VTK_DOUBLE);
      EXPECT_EQ(factsOf(whole), factsOf(grid)) << pieces;
      EXPECT_EQ(whole->GetCellData()->GetNumberOfArrays(), 1);
    }
  }
}

TEST_F(TestPiecesWriter, PiecesAreEvenAndCompact)
{
  const auto grid = boxes(16, 4, 4, 0, false);
  ASSERT_EQ(written(grid, "a.pvtu", 4), "");
  for (int i = 0; i < 4; ++i)
  {
    const auto piece = again<vtkUnstructuredGrid>("a/a_" + std::to_string(i) + ".vtu");
    ASSERT_TRUE(piece);
    EXPECT_EQ(piece->GetNumberOfCells(), 64);
    double bounds[6];
    piece->GetBounds(bounds);
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    EXPECT_NEAR(volume, 64 * 0.1 * 0.3 * 0.7, 1e-9) << "cells fill their box";
  }
  EXPECT_FALSE(fs::exists(path("a/a_4.vtu")));
}

TEST_F(TestPiecesWriter, ThinWallsStay)
{
  // The wall at x = 4 crosses all pieces, which are cut along y.
  const auto grid = boxes(8, 40, 2, 4, false);
  ASSERT_EQ(written(grid, "a.pvtu", 4), "");
  const auto whole = again<vtkUnstructuredGrid>("a.pvtu");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->GetNumberOfPoints(), grid->GetNumberOfPoints());
  EXPECT_EQ(factsOf(whole), factsOf(grid));
}

TEST_F(TestPiecesWriter, ParticlesKeepTheirArrays)
{
  vtkNew<vtkPolyData> particles;
  vtkNew<vtkPoints> points;
  vtkNew<vtkStringArray> names;
  names->SetName("element");
  vtkNew<vtkDoubleArray> values;
  values->SetName("a < \"b\" & c");
  values->SetNumberOfComponents(2);
  for (int i = 0; i < 100; ++i)
  {
    points->InsertNextPoint(i * 37 % 100, i * 11 % 100, i);
    names->InsertNextValue(i % 2 ? "Ar" : "Kr");
    values->InsertNextTuple2(i, -i);
  }
  particles->SetPoints(points);
  particles->GetPointData()->AddArray(names);
  particles->GetPointData()->AddArray(values);
  ASSERT_EQ(written(particles, "b.pvtp", 3), "");
  const auto whole = again("b.pvtp");
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole->GetNumberOfPoints(), 100);
  vtkDataArray* numbers = whole->GetPointData()->GetArray(values->GetName());
  auto* words = vtkStringArray::SafeDownCast(whole->GetPointData()->GetAbstractArray("element"));
  ASSERT_TRUE(numbers && words);
  std::array<bool, 100> seen{};
  for (int i = 0; i < 100; ++i)
  {
    const int id = static_cast<int>(numbers->GetComponent(i, 0));
    seen.at(static_cast<std::size_t>(id)) = true;
    EXPECT_EQ(numbers->GetComponent(i, 1), -id);
    EXPECT_EQ(words->GetValue(i), id % 2 ? "Ar" : "Kr");
    EXPECT_EQ(whole->GetPoint(i)[2], id);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 100);
}

TEST_F(TestPiecesWriter, SurfacesKeepTheirCells)
{
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons, lines;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i <= 20; ++i)
    for (int y = 0; y < 2; ++y)
      points->InsertNextPoint(i, y, 0);
  const vtkIdType line[] = {0, 2};
  lines->InsertNextCell(2, line); // lines count before polygons
  numbers->InsertNextValue(-1);
  for (vtkIdType i = 0; i < 20; ++i)
  {
    const vtkIdType corners[] = {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1};
    polygons->InsertNextCell(4, corners);
    numbers->InsertNextValue(static_cast<int>(i));
  }
  surface->SetPoints(points);
  surface->SetLines(lines);
  surface->SetPolys(polygons);
  surface->GetCellData()->AddArray(numbers);
  ASSERT_EQ(written(surface, "c.pvtp", 4), "");
  const auto whole = again<vtkPolyData>("c.pvtp");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->GetNumberOfLines(), 1);
  ASSERT_EQ(whole->GetNumberOfPolys(), 20);
  vtkDataArray* again = whole->GetCellData()->GetArray("number");
  for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    whole->GetCellBounds(i, bounds);
    const double number = again->GetTuple1(i);
    EXPECT_EQ(bounds[0], number < 0 ? 0.0 : number);
    EXPECT_EQ(bounds[3], number < 0 ? 0.0 : 1.0);
  }
}

TEST_F(TestPiecesWriter, PlacesThatAreNoNumbersAreKept)
{
  vtkNew<vtkPolyData> particles;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 50; ++i)
    points->InsertNextPoint(i % 3 ? i : std::nan(""), i, 0);
  particles->SetPoints(points);
  ASSERT_EQ(written(particles, "n.pvtp", 4), "");
  EXPECT_EQ(again("n.pvtp")->GetNumberOfPoints(), 50);
}

TEST_F(TestPiecesWriter, FewCellsMakeFewPieces)
{
  ASSERT_EQ(written(boxes(3, 1, 1, 0, false), "a.pvtu", 100), "");
  EXPECT_EQ(made, 3);
  EXPECT_EQ(again("a.pvtu")->GetNumberOfCells(), 3);
}

TEST_F(TestPiecesWriter, SaysWhatCannotBeWritten)
{
  const auto grid = boxes(2, 2, 2, 0, false);
  EXPECT_NE(written(grid, "a.vtu", 2).find("must end in .pvtp or .pvtu"), std::string::npos);
  EXPECT_NE(written(grid, "a.pvtp", 2).find("go into a .pvtu file"), std::string::npos);
  EXPECT_NE(written(nullptr, "a.pvtu", 2).find("no data to write"), std::string::npos);
  std::ofstream(path("d")) << "a file where the folder should be";
  EXPECT_NE(written(grid, "d.pvtu", 2).find("cannot be made"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("d.pvtu")));
  EXPECT_NE(written(grid, "none/a.pvtu", 2), "");
}

TEST_F(TestPiecesWriter, DamagedPiecesAreNoCrash)
{
  const auto grid = boxes(3, 3, 3, 0, true);
  ASSERT_EQ(written(grid, "a.pvtu", 3), "");
  fs::remove(path("a/a_1.vtu"));
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(path("a.pvtu"), error);
  if (reader)
  {
    EXPECT_FALSE(vtkMoteReaderTable::Read(reader, error));
  }
  EXPECT_NE(error, "");
}
