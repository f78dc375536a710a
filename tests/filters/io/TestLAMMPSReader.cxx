// What vtkMoteLAMMPSDumpReader makes of small files: arrays, time, selection, progress, abort.
#include "IOTestSupport.h"
#include "vtkMoteLAMMPSDumpReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>
#include <vector>

namespace
{

class TestLAMMPSReader : public FileTest
{
protected:
  vtkPolyData* read(const std::string& file)
  {
    m_reader->SetFileName(file.c_str());
    m_reader->Update();
    EXPECT_EQ(m_reader->GetLastErrorMessage(), "");
    return m_reader->GetOutput();
  }

  std::vector<double> times()
  {
    m_reader->UpdateInformation();
    vtkInformation* information = m_reader->GetOutputInformation(0);
    const auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
    const double* values = information->Get(const_cast<vtkInformationDoubleVectorKey*>(key));
    return {values, values + information->Length(const_cast<vtkInformationDoubleVectorKey*>(key))};
  }

  double dataTime() const
  {
    return m_reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  }

  vtkNew<vtkMoteLAMMPSDumpReader> m_reader;
};

TEST_F(TestLAMMPSReader, PointsArraysAndTheirTypes)
{
  vtkPolyData* data =
    read(write("a.dump", dumpFrame(42, 2, "id type element x y z vx vy vz c_s[1] c_s[2] ix q mol",
                           "7 1 Si 1.5 2.5 -3.5 1 2 3 4 5 -1 0.5 12\n"
                           "3 2 O 1e3 nan inf 6 7 8 9 10 2 -0.5 13\n")));
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  ASSERT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_EQ(data->GetCellType(1), VTK_VERTEX);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetPoint(0)[2], -3.5);
  EXPECT_EQ(data->GetPoint(1)[0], 1000.0);
  EXPECT_TRUE(std::isnan(data->GetPoint(1)[1]));
  vtkPointData* arrays = data->GetPointData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 8);
  EXPECT_EQ(arrays->GetArray("id")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(arrays->GetArray("id")->GetTuple1(0), 7);
  EXPECT_EQ(arrays->GetArray("type")->GetDataType(), VTK_INT);
  EXPECT_EQ(arrays->GetArray("ix")->GetTuple1(0), -1);
  EXPECT_EQ(arrays->GetArray("mol")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(arrays->GetArray("q")->GetDataType(), VTK_DOUBLE);
  vtkDataArray* velocity = arrays->GetArray("v");
  ASSERT_EQ(velocity->GetNumberOfComponents(), 3);
  EXPECT_STREQ(velocity->GetComponentName(2), "vz");
  EXPECT_EQ(velocity->GetComponent(1, 0), 6);
  EXPECT_STREQ(arrays->GetArray("c_s")->GetComponentName(1), "c_s[2]");
  auto* elements = vtkStringArray::SafeDownCast(arrays->GetAbstractArray("element"));
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->GetValue(1), "O");
}

TEST_F(TestLAMMPSReader, AColumnThatIsNamedTwiceIsReadOnce)
{
  // As in dumps of LIGGGHTS, whose examples write the type twice.
  vtkPolyData* data =
    read(write("a.dump", dumpFrame(0, 2, "id type type x y z x vx vx vy vz radius",
                           "7 1 1 1 2 3 1 4 4 5 6 0.5\n"
                           "8 2 2 7 8 9 7 4 4 5 6 0.25\n")));
  EXPECT_EQ(data->GetPoint(1)[0], 7);
  EXPECT_EQ(data->GetPoint(1)[2], 9);
  vtkPointData* arrays = data->GetPointData();
  std::vector<std::string> names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    names.emplace_back(arrays->GetArrayName(i));
  EXPECT_EQ(names, (std::vector<std::string>{"id", "type", "vx", "vy", "vz", "radius"}));
  EXPECT_EQ(arrays->GetArray("type")->GetTuple1(1), 2);
  EXPECT_EQ(arrays->GetArray("vz")->GetTuple1(1), 6);
  EXPECT_EQ(arrays->GetArray("radius")->GetTuple1(1), 0.25);
}

TEST_F(TestLAMMPSReader, WordsBecomeTypesWhereThereIsNoTypeColumn)
{
  vtkPolyData* data = read(write("a.dump",
    dumpFrame(0, 4, "id element x y z", "1 Si 0 0 0\n2 C 0 0 0\n3 O 0 0 0\n4 Si 0 0 0\n")));
  vtkDataArray* types = data->GetPointData()->GetArray("type");
  ASSERT_TRUE(types);
  EXPECT_EQ(types->GetDataType(), VTK_INT);
  const double expected[] = {3, 1, 2, 3};
  for (vtkIdType i = 0; i < 4; ++i)
    EXPECT_EQ(types->GetTuple1(i), expected[i]) << i;
  EXPECT_TRUE(data->GetPointData()->GetAbstractArray("element"));
  // Many rows, shared out among threads.
  std::string rows;
  for (int i = 0; i < 50000; ++i)
    rows += std::string(1, static_cast<char>('z' - i % 26)) + " 0 0 0\n";
  types = read(write("b.dump", dumpFrame(0, 50000, "word x y z", rows)))
            ->GetPointData()
            ->GetArray("type");
  ASSERT_TRUE(types);
  for (int i = 0; i < 50000; ++i)
    ASSERT_EQ(types->GetTuple1(i), 26 - i % 26);
  data = read(write("c.dump", dumpFrame(0, 0, "element x y z", "")));
  EXPECT_EQ(data->GetNumberOfPoints(), 0);
}

TEST_F(TestLAMMPSReader, FieldDataHoldTheHeader)
{
  vtkPolyData* data = read(write(
    "a.dump", "ITEM: UNITS\nmetal\nITEM: TIME\n0.5\n" + dumpFrame(42, 1, "x y z", "1 2 3\n")));
  vtkFieldData* fields = data->GetFieldData();
  EXPECT_EQ(fields->GetArray("TimeValue")->GetTuple1(0), 0.5);
  EXPECT_EQ(fields->GetArray("timestep")->GetTuple1(0), 42);
  ASSERT_EQ(fields->GetArray("box")->GetNumberOfComponents(), 9);
  EXPECT_EQ(fields->GetArray("box")->GetComponent(0, 4), 20);
  EXPECT_EQ(fields->GetArray("box_origin")->GetNumberOfComponents(), 3);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(fields->GetAbstractArray("boundary"))->GetValue(0), "pp pp pp");
  EXPECT_EQ(vtkStringArray::SafeDownCast(fields->GetAbstractArray("units"))->GetValue(0), "metal");
  EXPECT_EQ(dataTime(), 0.5);
}

TEST_F(TestLAMMPSReader, ScaledCoordinatesAndColumnsWithoutNames)
{
  const std::string box = "pp pp pp\n-1 9\n0 20\n5 45\n";
  vtkPolyData* data = read(write("old.dump", dumpFrame(0, 1, "", "1 1 0.5 0.25 0\n", box)));
  EXPECT_EQ(data->GetPoint(0)[0], 4);
  EXPECT_EQ(data->GetPoint(0)[1], 5);
  EXPECT_EQ(data->GetPoint(0)[2], 5);
  data = read(write("mixed.dump", dumpFrame(0, 1, "xsu yu zs", "1.5 7 0.5\n", box)));
  EXPECT_EQ(data->GetPoint(0)[0], 14);
  EXPECT_EQ(data->GetPoint(0)[1], 7);
  EXPECT_EQ(data->GetPoint(0)[2], 25);
}

TEST_F(TestLAMMPSReader, TriclinicCells)
{
  // Cell: origin (1, 2, 3), a = 10, b = (-2, 20, 0), c = (3, -4, 40).
  const std::string box = "xy xz yz pp pp pp\n-1 14 -2\n-2 22 3\n3 43 -4\n";
  vtkPolyData* data =
    read(write("a.dump", dumpFrame(0, 2, "xs ys zs", "1 1 1\n0.5 0.5 0.5\n", box)));
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[0], 12);
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[1], 18);
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[2], 43);
  EXPECT_DOUBLE_EQ(data->GetPoint(1)[0], 6.5);
  // The same atoms where z, and y and z, are lengths.
  data = read(write("b.dump", dumpFrame(0, 1, "xs ys z", "1 1 43\n", box)));
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[0], 12);
  data = read(write("c.dump", dumpFrame(0, 1, "xs y z", "0.5 10 23\n", box)));
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[0], 6.5);
  const std::string general = "abc origin pp pp pp\n0 10 0 1\n-20 0 0 2\n0 0 40 3\n";
  data = read(write("d.dump", dumpFrame(0, 1, "xs ys zs", "1 0.5 0.25\n", general)));
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[0], -9);
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[1], 12);
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[2], 13);
}

TEST_F(TestLAMMPSReader, TimeStepsAndTheNearestAtOrBefore)
{
  std::string text;
  for (const int step : {0, 100, 250})
  {
    const std::string at = std::to_string(step);
    text += dumpFrame(step, 1, "x y z", at + " 0 0\n");
  }
  read(write("a.dump", text));
  EXPECT_EQ(times(), (std::vector<double>{0, 100, 250}));
  EXPECT_EQ(dataTime(), 0);
  for (const auto& [asked, given] :
    {std::pair{100.0, 100.0}, {249.0, 100.0}, {1e9, 250.0}, {-5.0, 0.0}})
  {
    m_reader->UpdateTimeStep(asked);
    EXPECT_EQ(dataTime(), given);
    EXPECT_EQ(m_reader->GetOutput()->GetPoint(0)[0], given);
    EXPECT_EQ(m_reader->GetOutput()->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), given);
  }
}

TEST_F(TestLAMMPSReader, SeriesInAnyOrderAndRestarts)
{
  m_reader->AddFileName(
    write("b.dump", dumpFrame(20, 1, "x y z", "20 0 0\n") + dumpFrame(30, 1, "x y z", "30 0 0\n"))
      .c_str());
  m_reader->AddFileName(writeGzip("a.dump", dumpFrame(10, 1, "x y z", "10 0 0\n")).c_str());
  m_reader->AddFileName(write("c.dump", dumpFrame(30, 1, "x y z", "31 0 0\n")).c_str());
  EXPECT_EQ(m_reader->GetNumberOfFileNames(), 3);
  EXPECT_EQ(m_reader->GetFileName(3), nullptr);
  EXPECT_EQ(times(), (std::vector<double>{10, 20, 30}));
  m_reader->UpdateTimeStep(30);
  EXPECT_EQ(m_reader->GetOutput()->GetPoint(0)[0], 31);
  m_reader->UpdateTimeStep(10);
  EXPECT_EQ(m_reader->GetOutput()->GetPoint(0)[0], 10);
}

TEST_F(TestLAMMPSReader, EmptyFramesAreValid)
{
  vtkPolyData* data = read(write("a.dump", dumpFrame(0, 0, "id x y z c_ke", "")));
  EXPECT_EQ(data->GetNumberOfPoints(), 0);
  EXPECT_EQ(data->GetNumberOfCells(), 0);
  EXPECT_TRUE(data->GetPointData()->HasArray("c_ke"));
  EXPECT_EQ(data->GetFieldData()->GetArray("timestep")->GetTuple1(0), 0);
}

TEST_F(TestLAMMPSReader, DisabledArraysAreNotParsed)
{
  const std::string file =
    write("a.dump", dumpFrame(0, 1, "id x y z c_a c_b", "1 2 3 4 broken 6\n"));
  m_reader->SetFileName(file.c_str());
  m_reader->UpdateInformation();
  vtkDataArraySelection* selection = m_reader->GetPointDataArraySelection();
  EXPECT_EQ(selection->GetNumberOfArrays(), 3);
  EXPECT_TRUE(selection->ArrayIsEnabled("c_a"));
  selection->DisableArray("c_a");
  m_reader->Update();
  EXPECT_EQ(m_reader->GetLastErrorMessage(), "");
  vtkPointData* arrays = m_reader->GetOutput()->GetPointData();
  EXPECT_FALSE(arrays->HasArray("c_a"));
  EXPECT_EQ(arrays->GetArray("c_b")->GetTuple1(0), 6);
  EXPECT_EQ(arrays->GetArray("id")->GetTuple1(0), 1);
  // Another file offers its own arrays, and forgets these.
  m_reader->SetFileName(write("b.dump", dumpFrame(0, 1, "x y z q", "1 2 3 4\n")).c_str());
  m_reader->Update();
  EXPECT_EQ(m_reader->GetLastErrorMessage(), "");
  EXPECT_EQ(selection->GetNumberOfArrays(), 1);
}

TEST_F(TestLAMMPSReader, VectorsAndPrecisionAreOptions)
{
  m_reader->CombineVectorsOff();
  m_reader->SinglePrecisionOn();
  vtkPolyData* data =
    read(write("a.dump", dumpFrame(0, 1, "id x y z vx vy vz", "1 0.1 3 4 5 6 7\n")));
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 4);
  EXPECT_EQ(data->GetPointData()->GetArray("vy")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(data->GetPointData()->GetArray("vy")->GetTuple1(0), 6);
  EXPECT_EQ(data->GetPointData()->GetArray("id")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(data->GetPoint(0)[0], 0.1);
  m_reader->CombineVectorsOn();
  m_reader->Update();
  EXPECT_TRUE(data->GetPointData()->HasArray("v"));
  EXPECT_EQ(m_reader->GetPointDataArraySelection()->GetNumberOfArrays(), 2);
}

TEST_F(TestLAMMPSReader, IntegerColumnsWithOtherValuesBecomeWider)
{
  const std::string text = dumpFrame(0, 2, "type proc x y z", "1 3000000000 0 0 0\n1.5 2 0 0 0\n");
  for (const std::string& file : {write("a.dump", text), writeGzip("b.dump", text)})
  {
    vtkPointData* arrays = read(file)->GetPointData();
    EXPECT_EQ(arrays->GetArray("type")->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(arrays->GetArray("type")->GetTuple1(1), 1.5);
    EXPECT_EQ(arrays->GetArray("proc")->GetDataType(), VTK_ID_TYPE);
    EXPECT_EQ(arrays->GetArray("proc")->GetTuple1(0), 3e9);
  }
}

TEST_F(TestLAMMPSReader, ReadsAgainOnlyWhatHasChanged)
{
  const std::string first = dumpFrame(0, 1, "x y z", "1 0 0\n");
  const std::string file = write("a.dump", first);
  read(file);
  const vtkMTimeType time = m_reader->GetOutput()->GetMTime();
  m_reader->Update();
  EXPECT_EQ(m_reader->GetOutput()->GetMTime(), time);
  write("a.dump", first + dumpFrame(5, 1, "x y z", "2 0 0\n"));
  m_reader->Modified();
  EXPECT_EQ(times(), (std::vector<double>{0, 5}));
  m_reader->UpdateTimeStep(5);
  EXPECT_EQ(m_reader->GetOutput()->GetPoint(0)[0], 2);
}

/// A file of several batches, whose reading takes several progress events.
std::string largeDump(int atoms)
{
  std::string rows;
  for (int i = 0; i < atoms; ++i)
  {
    rows +=
      std::to_string(i) + " 1 0.123456789 0.987654321 5.5555555555 -1.234567e-05 123.456789\n";
  }
  return dumpFrame(0, atoms, "id type x y z c_a c_b", rows);
}

struct Watch
{
  int events = 0;
  double last = 0;
  bool ascending = true;
  int abortAt = -1;
};

void onProgress(vtkObject* caller, unsigned long, void* data, void* fraction)
{
  auto* watch = static_cast<Watch*>(data);
  const double now = *static_cast<double*>(fraction);
  watch->ascending = watch->ascending && (now >= watch->last || watch->last == 1.0);
  watch->last = now;
  if (watch->events++ == watch->abortAt)
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
}

TEST_F(TestLAMMPSReader, ProgressRisesAndAbortLeavesNothing)
{
  const std::string text = largeDump(600000);
  for (const std::string& file : {write("a.dump", text), writeGzip("b.dump", text)})
  {
    m_reader->SetFileName(file.c_str());
    m_reader->UpdateInformation();
    Watch watch;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&watch);
    command->SetCallback(onProgress);
    const auto tag = m_reader->AddObserver(vtkCommand::ProgressEvent, command);
    m_reader->Update();
    EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 600000);
    EXPECT_GE(watch.events, 4);
    EXPECT_TRUE(watch.ascending);
    EXPECT_EQ(watch.last, 1.0);

    watch = {0, 0, true, 2};
    m_reader->Modified();
    m_reader->Update();
    EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(m_reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_NE(m_reader->GetLastErrorMessage().find("aborted"), std::string::npos);

    watch.abortAt = -1;
    m_reader->Modified();
    m_reader->Update();
    EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 600000);
    EXPECT_EQ(m_reader->GetLastErrorMessage(), "");
    m_reader->RemoveObserver(tag);
  }
}

TEST_F(TestLAMMPSReader, AbortWhileIndexing)
{
  Watch watch;
  watch.abortAt = 1;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(onProgress);
  m_reader->AddObserver(vtkCommand::ProgressEvent, command);
  m_reader->SetFileName(write("a.dump", largeDump(100000)).c_str());
  m_reader->Update();
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
  watch.abortAt = -1;
  m_reader->Modified();
  m_reader->Update();
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 100000);
}

TEST_F(TestLAMMPSReader, CanReadFile)
{
  const std::string frame = dumpFrame(0, 0, "x y z", "");
  EXPECT_EQ(vtkMoteLAMMPSDumpReader::CanReadFile(write("a", frame).c_str()), 1);
  EXPECT_EQ(
    vtkMoteLAMMPSDumpReader::CanReadFile(writeGzip("b", "ITEM: UNITS\nlj\n" + frame).c_str()), 1);
  EXPECT_EQ(vtkMoteLAMMPSDumpReader::CanReadFile(write("c", "something").c_str()), 0);
  EXPECT_EQ(vtkMoteLAMMPSDumpReader::CanReadFile(write("d", "").c_str()), 0);
  EXPECT_EQ(vtkMoteLAMMPSDumpReader::CanReadFile(path("missing").c_str()), 0);
  EXPECT_EQ(vtkMoteLAMMPSDumpReader::CanReadFile(nullptr), 0);
}

TEST_F(TestLAMMPSReader, PrintSelfTellsTheState)
{
  read(write("a.dump", dumpFrame(0, 0, "x y z", "")));
  std::ostringstream text;
  m_reader->Print(text);
  for (const char* part : {"a.dump", "TimeSteps: 1", "CombineVectors: 1", "SinglePrecision: 0"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}

} // namespace
