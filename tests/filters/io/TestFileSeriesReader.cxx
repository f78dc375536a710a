// vtkMoteFileSeriesReader: the files of VTK, one time step each.
#include "IOTestSupport.h"
#include "vtkMoteFileSeriesReader.h"
#include "vtkMoteReaderTable.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetWriter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericDataObjectWriter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <array>
#include <limits>
#include <sstream>

namespace
{

constexpr double noTime = std::numeric_limits<double>::quiet_NaN();
using Times = std::vector<double>;
using Names = std::vector<std::string>;

std::string numbered(const std::string& name, int number, const std::string& extension)
{
  return name + std::to_string(number) + extension;
}

std::string swirl(int step)
{
  return numbered(MOTE_SOURCE_DIR "/data/swirl.", step, ".vtu");
}

template <class Data>
vtkSmartPointer<Data> at(double time, vtkSmartPointer<Data> data)
{
  if (time == time)
  {
    vtkNew<vtkDoubleArray> value;
    value->SetName("TimeValue");
    value->InsertNextValue(time);
    data->GetFieldData()->AddArray(value);
  }
  return data;
}

/// A sphere of that radius.
vtkSmartPointer<vtkPolyData> sphere(double radius, double time = noTime)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->Update();
  return at(time, vtkSmartPointer<vtkPolyData>(source->GetOutput()));
}

/// An image of n x 3 x 3 points that all have a value.
vtkSmartPointer<vtkImageData> image(int n, double value = 0)
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(n, 3, 3);
  data->AllocateScalars(VTK_DOUBLE, 1);
  data->GetPointData()->GetScalars()->Fill(value);
  return data;
}

class FileSeries : public FileTest
{
protected:
  /// Spheres of radius 1, 2, 3 and so on in sphere.0.vtp and on.
  Names spheres(const Times& times) const
  {
    Names names;
    for (const double time : times)
    {
      const int i = static_cast<int>(names.size());
      names.push_back(
        writeWith<vtkXMLPolyDataWriter>(numbered("sphere.", i, ".vtp"), sphere(i + 1, time)));
    }
    return names;
  }

  vtkSmartPointer<vtkMoteFileSeriesReader> open(const Names& names)
  {
    auto reader = vtkMoteReaderTable::MakeReader(names, m_error);
    EXPECT_EQ(m_error, "");
    auto* series = vtkMoteFileSeriesReader::SafeDownCast(reader);
    EXPECT_TRUE(series);
    return series;
  }

  Times timesOf(const Names& names)
  {
    auto times = vtkMoteReaderTable::GetTimeSteps(open(names), m_error);
    EXPECT_EQ(m_error, "");
    return times;
  }

  vtkSmartPointer<vtkDataObject> read(vtkAlgorithm* reader, double time)
  {
    auto data = vtkMoteReaderTable::Read(reader, time, m_error);
    EXPECT_EQ(m_error, "");
    return data;
  }

  /// Reading must fail with one sentence that names the file once.
  void expectFailure(vtkMoteFileSeriesReader* reader, double time, const std::string& file,
    const std::string& sentence)
  {
    EXPECT_FALSE(vtkMoteReaderTable::Read(reader, time, m_error));
    EXPECT_EQ(m_error, reader->GetLastErrorMessage());
    EXPECT_NE(m_error.find(file), std::string::npos) << m_error;
    EXPECT_EQ(m_error.find(file), m_error.rfind(file)) << m_error;
    EXPECT_EQ(m_error.find('\n'), std::string::npos) << m_error;
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
    EXPECT_FALSE(vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0))->GetNumberOfPoints());
    std::cout << "  " << m_error << "\n";
  }

  std::string m_error;
};

double radiusOf(vtkDataObject* data)
{
  return data ? vtkDataSet::SafeDownCast(data)->GetPoint(0)[2] : 0.0; // the pole
}

double timeOf(vtkDataObject* data)
{
  return data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
}

TEST_F(FileSeries, StepsAreTheFilesData)
{
  auto reader = open({swirl(0), swirl(1)});
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, m_error), (Times{7.5, 8}));
  for (const int step : {1, 0, 1})
  {
    auto data = read(reader, 7.5 + 0.5 * step);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    ASSERT_TRUE(grid);
    vtkNew<vtkXMLUnstructuredGridReader> single;
    single->SetFileName(swirl(step).c_str());
    single->Update();
    EXPECT_EQ(timeOf(grid), 7.5 + 0.5 * step);
    EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), timeOf(grid));
    ASSERT_EQ(grid->GetNumberOfCells(), single->GetOutput()->GetNumberOfCells());
    vtkDataArray* mine = grid->GetPointData()->GetArray("p");
    vtkDataArray* theirs = single->GetOutput()->GetPointData()->GetArray("p");
    for (vtkIdType i = 0; i < theirs->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(mine->GetTuple1(i), theirs->GetTuple1(i)) << i;
      std::array<double, 3> a{}, b{};
      grid->GetPoint(i, a.data());
      single->GetOutput()->GetPoint(i, b.data());
      ASSERT_EQ(a, b) << i;
    }
  }
}

TEST_F(FileSeries, ATimeIsTheStepAtOrBeforeIt)
{
  auto reader = open(spheres({10, 20, 40}));
  const std::pair<double, double> cases[] = {
    {0, 10}, {10, 10}, {19.9, 10}, {20, 20}, {39, 20}, {1e9, 40}};
  for (const auto& [asked, given] : cases)
  {
    auto data = read(reader, asked);
    ASSERT_TRUE(data);
    EXPECT_EQ(timeOf(data), given) << asked;
    EXPECT_EQ(radiusOf(data), given == 10 ? 1 : given == 20 ? 2 : 3) << asked;
  }
  auto first = vtkMoteReaderTable::Read(open(spheres({10, 20, 40})), m_error);
  EXPECT_EQ(timeOf(first), 10);
}

TEST_F(FileSeries, TimesOfTheFilesOrNumbers)
{
  EXPECT_EQ(timesOf(spheres({0.5, 0.75, 3})), (Times{0.5, 0.75, 3}));
  EXPECT_EQ(timesOf(spheres({noTime, noTime, noTime})), (Times{0, 1, 2}));
  EXPECT_EQ(timesOf(spheres({0.5, 0.75, noTime})), (Times{0, 1, 2}));
  EXPECT_EQ(timesOf(spheres({noTime, 0.75, 3})), (Times{0, 1, 2}));
  EXPECT_EQ(timesOf(spheres({3, 2, 1})), (Times{0, 1, 2}));
  EXPECT_EQ(timesOf(spheres({3, 3})), (Times{0, 1}));
  auto reader = open(spheres({3, 2, 1}));
  EXPECT_EQ(radiusOf(read(reader, 2)), 3);
  EXPECT_EQ(timeOf(reader->GetOutputDataObject(0)), 2);
}

TEST_F(FileSeries, OneFileHasItsOwnReader)
{
  auto reader = vtkMoteReaderTable::MakeReader(swirl(0), m_error);
  EXPECT_TRUE(vtkXMLUnstructuredGridReader::SafeDownCast(reader));
}

TEST_F(FileSeries, OneLegacyFileHasItsTimeOrNone)
{
  for (const double time : {2.5, noTime})
  {
    const std::string name = writeWith<vtkDataSetWriter>("one.vtk", sphere(1, time));
    const auto reader = vtkMoteReaderTable::MakeReader(name, m_error);
    EXPECT_EQ(
      vtkMoteReaderTable::GetTimeSteps(reader, m_error), std::isnan(time) ? Times() : Times{time});
    EXPECT_GT(vtkPolyData::SafeDownCast(read(reader, 0))->GetNumberOfPoints(), 0);
  }
}

TEST_F(FileSeries, TheLastStepIsKept)
{
  const Names names = spheres({10, 20});
  auto reader = open(names);
  const auto pointsAt = [&](double time)
  { return vtkPolyData::SafeDownCast(read(reader, time))->GetPoints(); };
  const vtkSmartPointer<vtkPoints> points = pointsAt(10);
  EXPECT_EQ(pointsAt(15), points) << "the same step";
  reader->Modified();
  EXPECT_EQ(pointsAt(10), points);
  EXPECT_NE(pointsAt(20), points);
  EXPECT_NE(pointsAt(10), points) << "only the last one is kept";
  EXPECT_EQ(radiusOf(reader->GetOutputDataObject(0)), 1);
  std::filesystem::copy_file(names[1], names[0], std::filesystem::copy_options::overwrite_existing);
  std::filesystem::last_write_time(
    names[0], std::filesystem::last_write_time(names[0]) + std::chrono::seconds(1));
  pointsAt(12);
  EXPECT_EQ(radiusOf(reader->GetOutputDataObject(0)), 2) << "a file that has changed is read again";
}

TEST_F(FileSeries, ImagesOfOneExtent)
{
  const Names names = {writeWith<vtkXMLImageDataWriter>("a0.vti", image(3, 5)),
    writeWith<vtkXMLImageDataWriter>("a1.vti", image(3, 6)),
    writeWith<vtkXMLImageDataWriter>("a2.vti", image(7, 7)),
    writeWith<vtkXMLImageDataWriter>("a3.vti", image(2, 8))};
  auto reader = open(names);
  for (const int step : {0, 1, 0})
  {
    auto data = read(reader, step);
    auto* set = vtkImageData::SafeDownCast(data);
    ASSERT_TRUE(set);
    EXPECT_EQ(set->GetNumberOfPoints(), 27);
    EXPECT_EQ(set->GetPointData()->GetScalars()->GetTuple1(0), 5 + step);
  }
  const std::string first = ", and the first one of the series 0 2 0 2 0 2";
  expectFailure(reader, 2, names[2], "this file has the extent 0 6 0 2 0 2" + first);
  expectFailure(reader, 3, names[3], "this file has the extent 0 1 0 2 0 2" + first);
  EXPECT_TRUE(read(reader, 1));
}

TEST_F(FileSeries, LegacyFiles)
{
  for (const bool binary : {false, true})
  {
    Names names;
    for (const int i : {0, 1})
    {
      vtkNew<vtkDataSetWriter> writer;
      writer->SetInputData(sphere(i + 1, 2.5 * i + 1));
      writer->SetFileName(path(numbered("s", i, ".vtk")).c_str());
      writer->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
      writer->Write();
      names.push_back(writer->GetFileName());
    }
    auto reader = open(names);
    EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, m_error), (Times{1, 3.5}));
    EXPECT_EQ(radiusOf(read(reader, 3.5)), 2);
    EXPECT_EQ(radiusOf(read(reader, 1)), 1);
  }
}

TEST_F(FileSeries, CompositeData)
{
  Names names;
  for (const int i : {1, 2})
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, sphere(i));
    blocks->SetBlock(1, image(i + 1));
    names.push_back(writeWith<vtkGenericDataObjectWriter>(numbered("m", i, ".vtk"), blocks));
  }
  auto reader = open(names);
  for (const int i : {1, 2, 1})
  {
    auto data = read(reader, i - 1);
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
    ASSERT_TRUE(blocks);
    EXPECT_EQ(timeOf(blocks), i - 1);
    ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
    EXPECT_EQ(radiusOf(blocks->GetBlock(0)), i);
    EXPECT_EQ(vtkDataSet::SafeDownCast(blocks->GetBlock(1))->GetNumberOfPoints(), 9 * (i + 1));
  }
}

TEST_F(FileSeries, AFileThatIsCutIsNamed)
{
  testing::internal::CaptureStderr();
  for (const int i : {0, 1, 2})
    std::filesystem::copy_file(swirl(0), path(numbered("s", i, ".vtu")));
  truncate("s1.vtu", 60000); // the header is whole
  auto reader = open({path("s0.vtu"), path("s1.vtu"), path("s2.vtu")});
  for (int round = 0; round < 2; ++round)
  {
    EXPECT_TRUE(read(reader, 0));
    expectFailure(reader, 1, path("s1.vtu"), "");
    expectFailure(reader, 1.5, path("s1.vtu"), "");
    EXPECT_TRUE(read(reader, 2));
  }
  const Names names = spheres({1, 2, 3});
  truncate("sphere.1.vtp", 300); // in the header
  expectFailure(open(names), 1, names[1], "");
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(open(names), m_error), Times());
  EXPECT_EQ(m_error.find(names[1] + ": "), 0u) << m_error;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(FileSeries, AFileThatIsMissingIsNamed)
{
  Names names = spheres({1, 2, 3});
  auto reader = open(names);
  EXPECT_TRUE(read(reader, 1));
  std::filesystem::remove(names[1]);
  expectFailure(reader, 2, names[1], "there is no such file");
  EXPECT_TRUE(read(reader, 3));
  reader->Modified();
  expectFailure(reader, 3, names[1], "there is no such file");
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader(names, m_error));
  EXPECT_EQ(m_error, names[1] + ": there is no such file");
  reader->RemoveAllFileNames();
  expectFailure(reader, 1, "vtkMoteFileSeriesReader", "no file name has been set");
  reader->AddFileName(names[2].c_str());
  EXPECT_EQ(radiusOf(read(reader, 0)), 3) << "as soon as there is one";
}

TEST_F(FileSeries, OneTypeOfData)
{
  const Names names = {writeWith<vtkDataSetWriter>("d0.vtk", sphere(1)),
    writeWith<vtkDataSetWriter>("d1.vtk", image(3))};
  auto reader = open(names);
  EXPECT_TRUE(read(reader, 0));
  expectFailure(reader, 1, names[1],
    "this file holds a vtkStructuredPoints, and the first one of the series a vtkPolyData");
  EXPECT_EQ(radiusOf(read(reader, 0)), 1);
}

TEST_F(FileSeries, OneStepAFile)
{
  const std::string several = path("e0.vtu");
  vtkNew<vtkUnstructuredGrid> point;
  point->SetPoints(sphere(1)->GetPoints());
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(point);
  writer->SetFileName(several.c_str());
  writer->SetNumberOfTimeSteps(2);
  writer->Start();
  writer->WriteNextTime(1);
  writer->WriteNextTime(2);
  writer->Stop();
  auto reader = open({several, swirl(1)});
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, m_error), Times());
  EXPECT_EQ(m_error,
    several + ": this file has 2 time steps, and the files of a series have one each; read it by "
              "itself");
}

TEST_F(FileSeries, ProgressAndAbort)
{
  auto reader = open(spheres({1, 2}));
  std::vector<double> shares;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&shares);
  watch->SetCallback([](vtkObject* object, unsigned long, void* list, void*)
    { static_cast<Times*>(list)->push_back(vtkAlgorithm::SafeDownCast(object)->GetProgress()); });
  reader->AddObserver(vtkCommand::ProgressEvent, watch);
  reader->UpdateInformation();
  EXPECT_EQ(shares, (Times{0.5, 1}));
  reader->UpdateTimeStep(2);
  EXPECT_GT(shares.size(), 4u) << "the file's reader has some to tell";
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* object, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(object)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_FALSE(vtkMoteReaderTable::Read(reader, 1.0, m_error));
  EXPECT_NE(m_error.find("reading was aborted"), std::string::npos) << m_error;
  reader->RemoveObserver(tag);
  reader->Modified();
  EXPECT_EQ(radiusOf(read(reader, 1)), 1) << "nothing is kept of a step that was not finished";
}

TEST_F(FileSeries, PointsAndMeshes)
{
  const Names tables = {
    write("t.1.csv", "x,y,z,v\n1,2,3,4\n"), write("t.2.csv", "x,y,z,v\n1,2,3,4\n5,6,7,8\n")};
  EXPECT_EQ(timesOf(tables), (Times{0, 1}));
  EXPECT_EQ(vtkPolyData::SafeDownCast(read(open(tables), 1))->GetNumberOfPoints(), 2);
  Names meshes;
  for (int i = 1; i < 4; ++i)
    meshes.push_back(writeWith<vtkPLYWriter>(numbered("m_", i, ".ply"), sphere(i)));
  EXPECT_EQ(timesOf(meshes), (Times{0, 1, 2}));
  EXPECT_NEAR(radiusOf(read(open(meshes), 2)), 3, 1e-6);
  truncate("m_2.ply", 300);
  EXPECT_FALSE(vtkMoteReaderTable::Read(open(meshes), 1.0, m_error));
  EXPECT_NE(m_error.find(meshes[1]), std::string::npos) << m_error;
}

TEST_F(FileSeries, FramesOfXYZ)
{
  const std::string one = "1\n\nA 1 0 0\n", two = "2\n\nA 2 0 0\nA 3 0 0\n";
  const Names single = {write("s1.xyz", one), write("s2.xyz", two)};
  EXPECT_EQ(timesOf(single), (Times{0, 1}));
  EXPECT_EQ(vtkPolyData::SafeDownCast(read(open(single), 1))->GetNumberOfPoints(), 2);
  const Names several = {
    write("r1.xyz", one + two), write("r2.xyz", one), write("r3.xyz", two + one)};
  const auto reader = open(several);
  EXPECT_EQ(timesOf(several), (Times{0, 1, 2, 3, 4}));
  const std::array<int, 5> wanted = {1, 2, 1, 2, 1};
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(vtkPolyData::SafeDownCast(read(reader, i))->GetNumberOfPoints(), wanted[i]) << i;
  const auto timed = [](const char* time)
  { return std::string("1\nTimestep: ") + time + "\nA 1 0 0\n"; };
  const Names times = {write("t1.xyz", timed("0.5") + timed("1")), write("t2.xyz", timed("2.5"))};
  EXPECT_EQ(timesOf(times), (Times{0.5, 1, 2.5}));
  // Nobody has looked into the third file before its step is asked for.
  const auto late = open({single[0], single[1], several[0]});
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(late, m_error), (Times{0, 1, 2}));
  EXPECT_FALSE(vtkMoteReaderTable::Read(late, 2.0, m_error));
  EXPECT_NE(m_error.find("this file has 2 time steps"), std::string::npos) << m_error;
}

TEST_F(FileSeries, WhichNamesMakeSeries)
{
  const Names names = {"s.10.vtu", "s.9.vtu", "a1.vtp", "a2.vtp", "s.9.vtp", "i1.vti", "i2.vti",
    "l1.vtk", "l2.vtk", "part1.stl", "part2.stl", "f_01.ply", "f_02.ply", "p1.csv", "p2.csv",
    "p1.xyz", "p2.xyz", "p1.pts", "p2.pts"};
  const auto groups = vtkMoteReaderTable::GroupSeries(names);
  ASSERT_EQ(groups.size(), 11u);
  EXPECT_EQ(groups[0], (Names{"s.9.vtu", "s.10.vtu"}));
  EXPECT_EQ(groups[1], (Names{"a1.vtp", "a2.vtp"}));
  EXPECT_EQ(groups[5], (Names{"part1.stl"})) << "meshes are parts more often than steps";
}

TEST_F(FileSeries, NamesAndPrint)
{
  vtkNew<vtkMoteFileSeriesReader> reader;
  reader->AddFileName("a.vtu");
  reader->AddFileName(nullptr);
  reader->AddFileName("");
  EXPECT_EQ(reader->GetNumberOfFileNames(), 1);
  EXPECT_STREQ(reader->GetFileName(0), "a.vtu");
  EXPECT_EQ(reader->GetFileName(1), nullptr);
  EXPECT_EQ(reader->GetFileName(-1), nullptr);
  std::ostringstream text;
  reader->Print(text);
  EXPECT_NE(text.str().find("a.vtu"), std::string::npos);
}

} // namespace
