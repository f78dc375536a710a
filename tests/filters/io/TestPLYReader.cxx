// What PLY files hold, of which VTK's reader has triangles, normals and colours alone. What is
// refused stands in TestFormatChecks.
#include "TableTest.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace
{

class TestPLYReader : public TableTest
{
protected:
  vtkPolyData* readText(const std::string& text)
  {
    EXPECT_EQ(errorOf(write("a.ply", text)), "");
    return vtkPolyData::SafeDownCast(m_data);
  }
};

void expectArray(
  vtkDataSetAttributes* arrays, const char* name, int type, const std::vector<double>& values)
{
  SCOPED_TRACE(name);
  vtkDataArray* array = arrays->GetArray(name);
  ASSERT_TRUE(array);
  EXPECT_EQ(array->GetDataType(), type);
  ASSERT_EQ(array->GetNumberOfValues(), static_cast<vtkIdType>(values.size()));
  const int components = array->GetNumberOfComponents();
  for (int i = 0; i < static_cast<int>(values.size()); ++i)
    EXPECT_EQ(array->GetComponent(i / components, i % components), values[i]) << i;
}

/// A triangle's header but for "format".
const std::string header =
  "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
  "property float quality\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
  "property short class\nproperty uint stamp\nproperty double scalar_Depth\n"
  "element face 1\nproperty list uchar int vertex_indices\nproperty char flags\n"
  "property ushort patch\nend_header\n";

void expectTriangle(vtkPolyData* data)
{
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPolys(), 1);
  vtkPointData* arrays = data->GetPointData();
  expectArray(arrays, "quality", VTK_FLOAT, {0.5, 0.25, -1});
  expectArray(arrays, "class", VTK_SHORT, {-2, 3, 300});
  expectArray(arrays, "stamp", VTK_UNSIGNED_INT, {4000000000.0, 1, 2});
  expectArray(arrays, "scalar_Depth", VTK_DOUBLE, {0.125, 1e-300, 7});
  EXPECT_TRUE(arrays->GetArray("RGB"));
  EXPECT_EQ(arrays->GetNumberOfArrays(), 5);
  expectArray(data->GetCellData(), "flags", VTK_SIGNED_CHAR, {-7});
  expectArray(data->GetCellData(), "patch", VTK_UNSIGNED_SHORT, {65535});
}

TEST_F(TestPLYReader, ValuesOfVerticesAndFacesAreArrays)
{
  expectTriangle(readText("ply\nformat ascii 1.0\n" + header +
                          "0 0 0 0.5 9 9 9 -2 4000000000 0.125\n1 0 0 0.25 9 9 9 3 1 1e-300\n"
                          "0 1 0 -1 9 9 9 300 2 7\n3 0 1 2 -7 65535\n"));
  for (const bool isBig : {false, true})
  {
    SCOPED_TRACE(isBig);
    std::string bytes;
    const auto put = [&](auto value)
    {
      char one[sizeof value];
      std::memcpy(one, &value, sizeof value);
      bytes += isBig ? std::string(std::rbegin(one), std::rend(one)) : std::string(one, sizeof one);
    };
    const auto vertex = [&](
                          float x, float y, float quality, short kind, unsigned stamp, double depth)
    {
      for (const float value : {x, y, 0.0f, quality})
        put(value);
      bytes += "\x09\x09\x09";
      put(kind);
      put(stamp);
      put(depth);
    };
    vertex(0, 0, 0.5f, -2, 4000000000U, 0.125);
    vertex(1, 0, 0.25f, 3, 1, 1e-300);
    vertex(0, 1, -1, 300, 2, 7);
    bytes += "\x03";
    for (const int corner : {0, 1, 2})
      put(corner);
    bytes += "\xf9";
    put(static_cast<unsigned short>(65535));
    expectTriangle(readText("ply\nformat binary_" + std::string(isBig ? "big" : "little") +
                            "_endian 1.0\n" + header + bytes));
  }
}

TEST_F(TestPLYReader, FacesMayHaveManyCorners)
{
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 300\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 1\n"
                           "property list int int vertex_indices\nend_header\n";
  std::ostringstream points, face;
  for (int i = 0; i < 300; ++i)
  {
    points << std::cos(i * 0.02) << ' ' << std::sin(i * 0.02) << " 0\n";
    face << ' ' << i;
  }
  vtkPolyData* data = readText(text + points.str() + "300" + face.str() + "\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetCell(0)->GetNumberOfPoints(), 300);
}

TEST_F(TestPLYReader, TheLastLineNeedsNoEnd)
{
  // VTK's reader frees what it never had then.
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  for (const char* end : {"", " ", "\n", "\r\n"})
  {
    vtkPolyData* data = readText(text + end);
    ASSERT_TRUE(data);
    EXPECT_EQ(data->GetNumberOfPolys(), 1);
  }
}

TEST_F(TestPLYReader, ColorsAndNormalsOfSeveralForms)
{
  const auto read = [&](const std::string& properties, const std::string& values)
  {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\n";
    std::istringstream names(properties);
    for (std::string type, name; names >> type >> name;)
      text += "property " + type + " " + name + "\n";
    return readText(text + "end_header\n1 2 3 " + values + "\n")->GetPointData();
  };
  expectArray(
    read("float diffuse_red float diffuse_green float diffuse_blue float alpha", "0 0.5 2 1"),
    "RGBA", VTK_UNSIGNED_CHAR, {0, 128, 255, 255});
  expectArray(read("ushort red ushort green ushort blue", "0 32896 65535"), "RGB",
    VTK_UNSIGNED_CHAR, {0, 128, 255});
  expectArray(read("uchar red", "7"), "red", VTK_UNSIGNED_CHAR, {7});
  expectArray(read("float nx double ny float nz", "0 0.5 1"), "Normals", VTK_FLOAT, {0, 0.5, 1});
  expectArray(read("float s float t", "0.25 1"), "TCoords", VTK_FLOAT, {0.25, 1});
}

TEST_F(TestPLYReader, CoordinatesFarFromTheOriginKeepTheirDigits)
{
  const auto at = [](const char* type, const char* place)
  {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 2\n";
    for (const char* axis : {"x", "y", "z"})
      text += "property " + std::string(type) + " " + axis + "\n";
    return text + "end_header\n" + place + " 0 0\n" + place + " 1 0\n";
  };
  vtkPolyData* data = readText(at("double", "500000.0123"));
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetPoint(1)[0], 500000.0123);
  EXPECT_EQ(data->GetPoint(1)[1], 1.0);
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 0);
  data = readText(at("double", "0.5"));
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_FLOAT);
  data = readText(at("float", "500000.0123"));
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetPoint(1)[0], 500000.0f);
}

} // namespace
