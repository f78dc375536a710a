// What is written is read again as the same, by Mote's readers and by VTK's.

#include "IOTestSupport.h"
#include "WrittenAgain.h"

#include "vtkMoteDataWriter.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace
{

class TestDataWriter : public FileTest
{
protected:
  /// Writes, and returns what went wrong.
  std::string written(vtkDataObject* data, const std::string& name)
  {
    vtkNew<vtkMoteDataWriter> writer;
    vtkNew<vtkCallbackCommand> quiet;
    writer->AddObserver(vtkCommand::ErrorEvent, quiet);
    writer->SetInputDataObject(data);
    writer->SetFileName(path(name).c_str());
    const int done = writer->Write();
    EXPECT_EQ(done == 1, writer->GetErrorMessage().empty());
    return writer->GetErrorMessage();
  }

  vtkSmartPointer<vtkDataSet> again(const std::string& name)
  {
    return readAgain<vtkDataSet>(path(name));
  }
};

template <class Array, class Value>
void add(vtkFieldData* fields, const char* name, const std::vector<Value>& values, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const Value& value : values)
    array->InsertNextValue(value);
  fields->AddArray(array);
}

constexpr double third = 1.0 / 3.0;

/// Three points with numbers of all kinds that are hard to write.
vtkSmartPointer<vtkPolyData> particles()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(third, -0.0, 1e300);
  points->InsertNextPoint(std::nextafter(1.0, 2.0), 1e-310, 12345678.9);
  points->InsertNextPoint(0.0, 7.0, -5e-324);
  data->SetPoints(points);
  vtkPointData* arrays = data->GetPointData();
  add<vtkStringArray>(arrays, "element", std::vector<std::string>{"Cu", "Zr", "Cu"}, 1);
  add<vtkIntArray>(arrays, "type", std::vector<int>{29, 40, 29}, 1);
  add<vtkFloatArray>(arrays, "v", std::vector<float>{0.1f, 1e-40f, 3e38f, 1, 2, 3, 4, 5, 6}, 3);
  add<vtkIdTypeArray>(arrays, "id",
    std::vector<vtkIdType>{(vtkIdType{1} << 60) + 1, 2, std::numeric_limits<vtkIdType>::min()}, 1);
  add<vtkUnsignedCharArray>(arrays, "flag", std::vector<unsigned char>{0, 65, 255}, 1);
  add<vtkDoubleArray>(arrays, "odd", std::vector<double>{std::nan(""), HUGE_VAL, -HUGE_VAL}, 1);
  add<vtkDoubleArray>(
    data->GetFieldData(), "box", std::vector<double>{2, 0, 0, 0.5, 3, 0, 0, third, 4}, 9);
  add<vtkDoubleArray>(data->GetFieldData(), "box_origin", std::vector<double>{-1, 0, third}, 3);
  add<vtkStringArray>(data->GetFieldData(), "boundary", std::vector<std::string>{"pp ff pp"}, 1);
  data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 2.5);
  return data;
}

/// Whether two numbers are the same, nan and -0 included.
bool isSame(double a, double b)
{
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

void expectSame(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
      EXPECT_TRUE(isSame(a->GetComponent(i, c), b->GetComponent(i, c)))
        << (a->GetName() ? a->GetName() : "points") << ' ' << i << ' ' << a->GetComponent(i, c)
        << ' ' << b->GetComponent(i, c);
}

TEST_F(TestDataWriter, Particles)
{
  const auto data = particles();
  for (const char* name : {"a.vtp", "a.VTU", "a.xyz", "a.xyz.gz"})
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(written(data, name), "");
    const auto read = again(name);
    ASSERT_TRUE(read);
    expectSame(
      data->GetPoints()->GetData(), vtkPointSet::SafeDownCast(read)->GetPoints()->GetData());
    for (const char* array : {"type", "flag"})
      expectSame(data->GetPointData()->GetArray(array), read->GetPointData()->GetArray(array));
    for (const char* array : {"box", "box_origin"})
      expectSame(data->GetFieldData()->GetArray(array), read->GetFieldData()->GetArray(array));
    expectSame(data->GetPointData()->GetArray("odd"), read->GetPointData()->GetArray("odd"));
    for (vtkIdType i = 0; i < 9; ++i) // XYZ reads as double what is float
      EXPECT_EQ(static_cast<float>(read->GetPointData()->GetArray("v")->GetComponent(
                  i / 3, static_cast<int>(i % 3))),
        static_cast<float>(
          data->GetPointData()->GetArray("v")->GetComponent(i / 3, static_cast<int>(i % 3))));
    auto* ids = vtkIdTypeArray::SafeDownCast(read->GetPointData()->GetArray("id"));
    ASSERT_TRUE(ids);
    EXPECT_EQ(ids->GetValue(0), (vtkIdType{1} << 60) + 1);
    EXPECT_EQ(ids->GetValue(2), std::numeric_limits<vtkIdType>::min());
    const bool isXYZ = std::strstr(name, "xyz");
    auto* elements = vtkStringArray::SafeDownCast(
      read->GetPointData()->GetAbstractArray(isXYZ ? "species" : "element"));
    ASSERT_TRUE(elements);
    EXPECT_EQ(elements->GetValue(1), "Zr");
    auto* boundary =
      vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("boundary"));
    ASSERT_TRUE(boundary);
    EXPECT_EQ(boundary->GetValue(0), "pp ff pp");
    std::string error;
    const auto reader = vtkMoteReaderTable::MakeReader(path(name), error);
    EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, error), std::vector<double>{2.5});
  }
}

TEST_F(TestDataWriter, TextOfXYZ)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points; // float
  points->InsertNextPoint(0.1, 2, 3);
  points->InsertNextPoint(-4.5, 1e10, 0);
  data->SetPoints(points);
  add<vtkIntArray>(data->GetPointData(), "type", std::vector<int>{1, 2}, 1);
  add<vtkDoubleArray>(data->GetPointData(), "a : \"b\"=c", std::vector<double>{1, 2, 3, 4}, 2);
  add<vtkStringArray>(data->GetPointData(), "words", std::vector<std::string>{"two words", ""}, 1);
  add<vtkStringArray>(
    data->GetFieldData(), "type_names", std::vector<std::string>{"1=Cu", "2=Zr"}, 1);
  EXPECT_EQ(written(data, "a.xyz"), "");
  std::ifstream file(path("a.xyz"));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text, "2\n"
                  "Properties=species:S:1:pos:R:3:type:I:1:a____b__c:R:2:words:S:1\n"
                  "Cu 0.1 2 3 1 1 2 two_words\n"
                  "Zr -4.5 1e+10 0 2 3 4 X\n");
  EXPECT_EQ(again("a.xyz")->GetNumberOfPoints(), 2);
}

TEST_F(TestDataWriter, NoPoints)
{
  vtkNew<vtkPolyData> data;
  for (const char* name : {"a.vtp", "a.vtu", "a.xyz", "a.xyz.gz"})
  {
    EXPECT_EQ(written(data, name), "") << name;
    EXPECT_GT(std::filesystem::file_size(path(name)), 10U) << name;
    if (std::strstr(name, "xyz")) // files of VTK without points are said to be damaged
      EXPECT_EQ(again(name)->GetNumberOfPoints(), 0) << name;
  }
}

TEST_F(TestDataWriter, ManyPoints)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  constexpr int count = 300'001; // several blocks, the last one not full
  for (int i = 0; i < count; ++i)
    points->InsertNextPoint(i, 0.1 * i, -i);
  data->SetPoints(points);
  for (const char* name : {"a.xyz", "a.xyz.gz"})
  {
    EXPECT_EQ(written(data, name), "");
    const auto read = again(name);
    ASSERT_EQ(read->GetNumberOfPoints(), count);
    for (vtkIdType i = 0; i < count; ++i)
      ASSERT_EQ(
        static_cast<float>(read->GetPoint(i)[1]), static_cast<float>(points->GetPoint(i)[1]))
        << i;
  }
}

TEST_F(TestDataWriter, Cells)
{
  vtkNew<vtkImageData> image; // of 4 x 3 x 2 cells
  image->SetDimensions(5, 4, 3);
  image->SetSpacing(0.5, 1, third);
  std::vector<double> values;
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
    values.push_back(third * static_cast<double>(i));
  add<vtkDoubleArray>(image->GetCellData(), "c", values, 1);
  EXPECT_EQ(written(image, "a.vtu"), "");
  const auto read = again("a.vtu");
  ASSERT_EQ(read->GetNumberOfCells(), image->GetNumberOfCells());
  ASSERT_EQ(read->GetNumberOfPoints(), image->GetNumberOfPoints());
  expectSame(read->GetCellData()->GetArray("c"), image->GetCellData()->GetArray("c"));
  double own[6], others[6];
  read->GetCell(7)->GetBounds(own);
  image->GetCell(7)->GetBounds(others);
  for (int i = 0; i < 6; ++i)
    EXPECT_DOUBLE_EQ(own[i], others[i]);
}

TEST_F(TestDataWriter, Errors)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  const auto data = particles();
  EXPECT_NE(
    written(data, "a.txt").find("must end in .vtp, .vtu, .xyz or .xyz.gz"), std::string::npos);
  EXPECT_NE(written(image, "a.vtp").find("go into a .vtu file"), std::string::npos);
  EXPECT_NE(written(image, "a.xyz").find("an XYZ file holds points"), std::string::npos);
  EXPECT_NE(written(data, "none/a.xyz").find("folder does not exist"), std::string::npos);
  EXPECT_NE(written(data, "none/a.vtp").find("folder does not exist"), std::string::npos);
  vtkNew<vtkMoteDataWriter> empty;
  vtkNew<vtkCallbackCommand> quiet;
  empty->AddObserver(vtkCommand::ErrorEvent, quiet);
  empty->SetFileName(path("a.vtp").c_str());
  EXPECT_EQ(empty->Write(), 0);
  EXPECT_NE(empty->GetErrorMessage().find("no data"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(path("")));
}

TEST_F(TestDataWriter, StoppedWritingLeavesTheOldFile)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 300'000; ++i)
    points->InsertNextPoint(i, 0, 0);
  data->SetPoints(points);
  for (const char* name : {"a.vtp", "a.xyz"})
  {
    write(name, "old");
    vtkNew<vtkMoteDataWriter> writer;
    vtkNew<vtkCallbackCommand> stop;
    stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
    writer->AddObserver(vtkCommand::ProgressEvent, stop);
    writer->SetInputData(data);
    writer->SetFileName(path(name).c_str());
    EXPECT_EQ(writer->Write(), 0) << name;
    std::ifstream file(path(name));
    std::string text;
    file >> text;
    EXPECT_EQ(text, "old") << name;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), {}), 2);
}

} // namespace
