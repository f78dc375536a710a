// Triangles written to a .mote file, read back, and drawn from there.
#include "MeshTestSupport.h"

#include "filters/io/IOTestSupport.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMoteMeshFilePoints.h"
#include "vtkMoteMeshFileReader.h"
#include "vtkMoteMeshFileWriter.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// What is drawn of a mapper's input, and files.
struct MeshFiled : MeshStage
{
  struct Files : FileTest
  {
    using FileTest::path;
    void TestBody() override {}
  };
  Files files;
  std::string name = files.path("a.mote");
  vtkNew<vtkMoteMeshFileReader> reader;

  vtkPolyData* writeAndRead(vtkPointSet* data)
  {
    vtkNew<vtkMoteMeshFileWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(name.c_str());
    EXPECT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
    reader->SetFileName(name.c_str());
    reader->Modified();
    reader->Update();
    EXPECT_EQ(reader->GetLastErrorMessage(), "");
    return reader->GetOutput();
  }
};

vtkSmartPointer<vtkPolyData> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(64);
  source->SetPhiResolution(48);
  source->Update();
  vtkSmartPointer<vtkPolyData> data = source->GetOutput();
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    height->InsertNextValue(data->GetPoint(i)[2]);
  data->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    number->InsertNextValue(static_cast<int>(i % 5));
  data->GetCellData()->AddArray(number);
  return data;
}

} // namespace

TEST_F(MeshFiled, ReadsBackWhatWasWritten)
{
  const auto data = sphere();
  data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 3.5);
  vtkPolyData* read = this->writeAndRead(data);
  ASSERT_EQ(read->GetNumberOfPolys(), data->GetNumberOfPolys());
  ASSERT_EQ(read->GetNumberOfPoints(), data->GetNumberOfPoints());
  EXPECT_TRUE(vtkMoteMeshFilePoints::FileOf(read));
  vtkDataArray* points = read->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* cells = read->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_TRUE(points && cells);
  ASSERT_TRUE(read->GetPointData()->GetNormals());
  std::vector<int> met(static_cast<std::size_t>(data->GetNumberOfCells()));
  for (vtkIdType c = 0; c < read->GetNumberOfCells(); ++c)
  {
    const auto original = static_cast<vtkIdType>(cells->GetTuple1(c));
    ++met.at(static_cast<std::size_t>(original));
    EXPECT_EQ(read->GetCellData()->GetArray("number")->GetTuple1(c), original % 5);
    vtkNew<vtkIdList> a, b;
    read->GetCellPoints(c, a);
    data->GetCellPoints(original, b);
    ASSERT_EQ(a->GetNumberOfIds(), 3);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(points->GetTuple1(a->GetId(k)), b->GetId(k));
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(read->GetPoint(a->GetId(k))[axis], data->GetPoint(b->GetId(k))[axis]);
      ASSERT_EQ(read->GetPointData()->GetArray("height")->GetTuple1(a->GetId(k)),
        data->GetPoint(b->GetId(k))[2]);
    }
  }
  EXPECT_EQ(met, std::vector<int>(met.size(), 1));
  double wanted[2], range[2];
  data->GetPointData()->GetArray("height")->GetRange(wanted);
  read->GetPointData()->GetArray("height")->GetRange(range);
  EXPECT_EQ(range[0], wanted[0]);
  EXPECT_EQ(range[1], wanted[1]);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(read->GetBounds()[k], data->GetBounds()[k], 1e-6);
  EXPECT_EQ(read->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 3.5);
}

TEST_F(MeshFiled, IsDrawnFromTheFile)
{
  const auto data = sphere();
  mapper->SetInputData(data);
  for (const double error : {0.0, 4.0})
  {
    mapper->SetPixelsOfError(error);
    mapper->SetInputData(data);
    const Picture memory = this->trace();
    vtkPolyData* read = this->writeAndRead(data);
    mapper->SetInputData(read);
    const Picture file = this->trace();
    EXPECT_GT(memory.covered(), 100);
    EXPECT_EQ(file.covered(), memory.covered());
    for (int y = 0; y < size; y += 3)
      for (int x = 0; x < size; x += 3)
        for (int k = 0; k < 3; ++k)
          ASSERT_NEAR(file.color(y * size + x)[k], memory.color(y * size + x)[k], 1e-5);
    const double bytes = static_cast<double>(mapper->GetStructureBytes());
    EXPECT_LT(bytes, 60.0 * static_cast<double>(read->GetNumberOfPolys()));
  }
}

TEST_F(MeshFiled, WhatFiltersMakeOfItIsBuilt)
{
  vtkPolyData* read = this->writeAndRead(sphere());
  vtkNew<vtkPolyData> half; // the points, half of the triangles
  half->SetPoints(read->GetPoints());
  vtkNew<vtkCellArray> some;
  for (vtkIdType c = 0; c < read->GetNumberOfCells() / 2; ++c)
  {
    vtkNew<vtkIdList> corners;
    read->GetCellPoints(c, corners);
    some->InsertNextCell(corners);
  }
  half->SetPolys(some);
  EXPECT_FALSE(vtkMoteMeshFilePoints::FileOf(half));
  mapper->SetInputData(half);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), read->GetNumberOfCells() / 2);
  mapper->SetInputData(read);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), read->GetNumberOfCells());
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(read);
  EXPECT_FALSE(vtkMoteMeshFilePoints::FileOf(copy));
  copy->GetPoints()->SetPoint(0, 2.0, 0.0, 0.0); // its own
  mapper->SetInputData(copy);
  mapper->Update();
  EXPECT_NEAR(mapper->GetBounds()[1], 2.0, 1e-6);
}

TEST_F(MeshFiled, PolygonsAreCutAndKeepTheirValues)
{
  auto data = polygonAndStrip();
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int i = 0; i < data->GetNumberOfCells(); ++i)
    number->InsertNextValue(10 * i);
  data->GetCellData()->AddArray(number);
  vtkPolyData* read = this->writeAndRead(data);
  ASSERT_EQ(read->GetNumberOfCells(), 4);
  vtkDataArray* cells = read->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < 4; ++c)
    EXPECT_EQ(read->GetCellData()->GetArray("number")->GetTuple1(c), 10.0 * cells->GetTuple1(c));
}

TEST_F(MeshFiled, ErrorsAreSentences)
{
  vtkNew<vtkMoteMeshFileWriter> writer;
  const Complaints complaints(writer);
  vtkNew<vtkPolyData> nothing;
  writer->SetInputData(nothing);
  writer->SetFileName(name.c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorMessage().find("no triangles"), std::string::npos);
  writer->SetInputData(sphere());
  writer->SetFileName(files.path("none/a.mote").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorMessage().find("none"), std::string::npos);
  EXPECT_EQ(complaints.errors, 2);
  // From such a file to another.
  writer->SetInputData(this->writeAndRead(sphere()));
  writer->SetFileName(files.path("b.mote").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorMessage().find("can be copied"), std::string::npos);
}
