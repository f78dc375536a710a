// Data sets as blocks of one file: written, and read again as they were.

#include "IOTestSupport.h"
#include "WrittenAgain.h"

#include "vtkMoteBlocksWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellType.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

namespace fs = std::filesystem;

class TestBlocksWriter : public FileTest
{
protected:
  /// Writes, and returns what went wrong.
  std::string written(vtkDataObject* data, const std::string& name)
  {
    vtkNew<vtkMoteBlocksWriter> writer;
    vtkNew<vtkCallbackCommand> quiet;
    writer->AddObserver(vtkCommand::ErrorEvent, quiet);
    if (data)
      writer->SetInputDataObject(data);
    writer->SetFileName(path(name).c_str());
    const int done = writer->Write();
    EXPECT_EQ(done == 1, writer->GetErrorMessage().empty());
    return writer->GetErrorMessage();
  }
};

vtkSmartPointer<vtkPoints> pointsAt(double x, int count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int i = 0; i < count; ++i)
    points->InsertNextPoint(x, i % 2, i / 2);
  return points;
}

void name(vtkMultiBlockDataSet* blocks, unsigned index, const char* what)
{
  blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), what);
}

/// A tetrahedron, nothing, and within a block of their own three vertices and nothing again.
vtkSmartPointer<vtkMultiBlockDataSet> blocks()
{
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkUnstructuredGrid> grid, none;
  grid->SetPoints(pointsAt(1.0, 4));
  const vtkIdType corners[] = {0, 1, 2, 3};
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  all->SetBlock(0, grid);
  name(all, 0, "a <b> & \"c\"");
  all->SetBlock(1, none);
  vtkNew<vtkMultiBlockDataSet> within;
  vtkNew<vtkPolyData> vertices;
  vertices->SetPoints(pointsAt(2.0, 3));
  within->SetBlock(1, vertices);
  name(within, 1, "points");
  all->SetBlock(2, within);
  return all;
}

TEST_F(TestBlocksWriter, BlocksComeBackWithTheirNames)
{
  ASSERT_EQ(written(blocks(), "all of it.VTM"), "");
  EXPECT_TRUE(fs::exists(path("all of it/all of it_0.vtu")));
  EXPECT_TRUE(fs::exists(path("all of it/all of it_1.vtp")));
  fs::rename(path("all of it.VTM"), path("all of it.vtm"));
  const auto again = readAgain<vtkMultiBlockDataSet>(path("all of it.vtm"));
  ASSERT_TRUE(again);
  ASSERT_EQ(again->GetNumberOfBlocks(), 2u);
  const char* names[] = {"a <b> & \"c\"", "points"};
  const vtkIdType points[] = {4, 3};
  for (unsigned i = 0; i < 2; ++i)
  {
    auto* data = vtkDataSet::SafeDownCast(again->GetBlock(i));
    ASSERT_TRUE(data);
    EXPECT_EQ(data->GetNumberOfPoints(), points[i]);
    EXPECT_EQ(data->GetPoint(0)[0], 1.0 + i);
    EXPECT_STREQ(again->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()), names[i]);
  }
  EXPECT_EQ(vtkDataSet::SafeDownCast(again->GetBlock(0))->GetCellType(0), VTK_TETRA);
}

TEST_F(TestBlocksWriter, TheTimeOfTheBlocksIsThatOfTheFile)
{
  const auto data = blocks();
  data->GetBlock(0)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 2.5);
  ASSERT_EQ(written(data, "timed.vtm"), "");
  ASSERT_EQ(written(blocks(), "timeless.vtm"), "");
  for (const auto& [file, times] :
    {std::pair("timed.vtm", std::vector{2.5}), std::pair("timeless.vtm", std::vector<double>())})
  {
    std::string error;
    const auto reader = vtkMoteReaderTable::MakeReader(path(file), error);
    ASSERT_TRUE(reader) << error;
    EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, error), times) << file;
  }
  // An index that names itself has none, and does not hang.
  std::ofstream(path("round.vtm"))
    << "<VTKFile type=\"vtkMultiBlockDataSet\"><vtkMultiBlockDataSet>"
       "<DataSet index=\"0\" file=\"round.vtm\"/>"
       "</vtkMultiBlockDataSet></VTKFile>";
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(path("round.vtm"), error);
  EXPECT_TRUE(!reader || vtkMoteReaderTable::GetTimeSteps(reader, error).empty());
}

TEST_F(TestBlocksWriter, WhatCannotBeWrittenLeavesNoIndex)
{
  vtkNew<vtkMultiBlockDataSet> empty;
  EXPECT_NE(written(empty, "empty.vtm").find("no data"), std::string::npos);
  EXPECT_NE(written(nullptr, "none.vtm").find("no data"), std::string::npos);
  EXPECT_NE(written(blocks(), "a.vtu").find("must end in .vtm"), std::string::npos);
  EXPECT_NE(written(blocks(), "nowhere/a.vtm"), "");
  // A file stands where the folder of blocks would be; and the old index stays.
  std::ofstream(path("taken")) << "mine";
  std::ofstream(path("taken.vtm")) << "old";
  EXPECT_NE(written(blocks(), "taken.vtm").find("cannot be made"), std::string::npos);
  std::ofstream(path("mine.pvtu")) << "another's pieces";
  EXPECT_NE(written(blocks(), "mine.vtm").find("mine.pvtu"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("mine")));
  std::string old;
  std::ifstream(path("taken.vtm")) >> old;
  EXPECT_EQ(old, "old");
  for (const char* file : {"empty.vtm", "none.vtm", "a.vtu"})
    EXPECT_FALSE(fs::exists(path(file))) << file;
}

} // namespace
