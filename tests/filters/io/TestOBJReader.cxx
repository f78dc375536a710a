// Wavefront OBJ files as programs write them. What is refused stands in TestFormatChecks.
#include "TableTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace
{

class TestOBJReader : public TableTest
{
protected:
  vtkPolyData* readText(const std::string& text)
  {
    EXPECT_EQ(errorOf(write("a.obj", text)), "");
    return vtkPolyData::SafeDownCast(m_data);
  }
};

std::vector<double> valuesOf(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      values.push_back(array->GetComponent(i, c));
  return values;
}

std::vector<std::vector<vtkIdType>> polygonsOf(vtkPolyData* data)
{
  std::vector<std::vector<vtkIdType>> all;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetPolys()->GetNumberOfCells(); ++i)
  {
    data->GetPolys()->GetCellAtId(i, corners);
    all.emplace_back(corners->begin(), corners->end());
  }
  return all;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(TestOBJReader, FacesThatAreWrittenInSeveralWaysAreAllThere)
{
  // VTK's reader keeps those of one way alone, or nothing.
  vtkPolyData* data =
    readText("mtllib a.mtl\n" + square +
             "vt 0 0\nvt 1 0\nvn 0 0 1\nusemtl m\nf 1/1 2/2 3/1\nf 1//1 3//1 4//1\n"
             "f 1 2 3 \\\n4\nf -4/1/1 -3/2/1 -2/1/1\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 4);
  EXPECT_EQ(polygonsOf(data),
    (std::vector<std::vector<vtkIdType>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2, 3}, {0, 1, 2}}));
  EXPECT_FALSE(data->GetPointData()->GetNormals()) << "some faces have none";
  EXPECT_EQ(data->GetCellData()->GetNumberOfArrays(), 0) << "there is one material";
}

TEST_F(TestOBJReader, VerticesWithSeveralNormalsAreThereOnceForEach)
{
  vtkPolyData* data = readText(square + "v 0 0 1\nvn 0 0 1\nvn 1 0 0\nvn 0 0 1\n"
                                        "f 1//1 2//1 3//1\nf 1//3 3//3 4//3\nf 1//2 4//2 5//2\n");
  ASSERT_TRUE(data);
  // The third normal has the value of the first: no vertex is split for it.
  EXPECT_EQ(data->GetNumberOfPoints(), 7);
  EXPECT_EQ(
    polygonsOf(data), (std::vector<std::vector<vtkIdType>>{{0, 1, 2}, {0, 2, 3}, {5, 6, 4}}));
  ASSERT_TRUE(data->GetPointData()->GetNormals());
  EXPECT_EQ(valuesOf(data->GetPointData()->GetNormals()),
    (std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(data->GetPoint(6)[1], 1.0);
}

TEST_F(TestOBJReader, VerticesMayHaveColors)
{
  vtkPolyData* data =
    readText("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 1\nv 0 1 0\nv 0 0 1 0.2\nf 1 2 3\nf 1 2 4\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(valuesOf(data->GetPointData()->GetArray("RGB")),
    (std::vector<double>{255, 0, 0, 0, 128, 255, 255, 255, 255, 255, 255, 255}));
  data = readText("v 0 0 0 255 0 7\nv 1 0 0 0 128 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(valuesOf(data->GetPointData()->GetArray("RGB")),
    (std::vector<double>{255, 0, 7, 0, 128, 1, 0, 0, 0}));
}

TEST_F(TestOBJReader, GroupsAreNumberedWhereThereAreSeveral)
{
  vtkPolyData* data = readText(square + "p 1\nl 1 2\no box\nusemtl wood oak\ng left side\nf 1 2 3\n"
                                        "usemtl steel\nf 1 3 4\nusemtl wood oak\nf 2 3 4\n");
  ASSERT_TRUE(data);
  const auto names = [&](const char* name)
  {
    std::vector<std::string> all;
    auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
      all.push_back(array->GetValue(i));
    return all;
  };
  EXPECT_EQ(valuesOf(data->GetCellData()->GetArray("MaterialIds")),
    (std::vector<double>{0, 0, 1, 2, 1})); // points, lines, polygons
  EXPECT_EQ(names("MaterialNames"), (std::vector<std::string>{"", "wood oak", "steel"}));
  EXPECT_EQ(
    valuesOf(data->GetCellData()->GetArray("GroupIds")), (std::vector<double>{0, 0, 1, 1, 1}));
  EXPECT_EQ(names("GroupNames"), (std::vector<std::string>{"", "left side"}));
  EXPECT_EQ(names("ObjectNames"), (std::vector<std::string>{"", "box"}));
}

TEST_F(TestOBJReader, CoordinatesFarFromTheOriginKeepTheirDigits)
{
  vtkPolyData* data = readText("v 500000.0123 4000000.5 10\nv 500001 4000000.75 10\n"
                               "v 500000 4000001.25 11\nf 1 2 3\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetPoint(0)[0], 500000.0123);
  data = readText(square + "f 1 2 3\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_FLOAT);
}

TEST_F(TestOBJReader, GzipAndPointsAlone)
{
  EXPECT_EQ(errorOf(writeGzip("a.obj.gz", square + "f 1 2 3\n")), "");
  EXPECT_EQ(vtkPolyData::SafeDownCast(m_data)->GetNumberOfPolys(), 1);
  vtkPolyData* data = readText(square);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 4);
  EXPECT_EQ(data->GetNumberOfCells(), 0);
}

} // namespace
