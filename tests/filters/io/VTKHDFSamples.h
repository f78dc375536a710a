#ifndef MoteVTKHDFSamples_h
#define MoteVTKHDFSamples_h

// Small VTKHDF files, as the format's description has them.

#include "HDF5Writer.h"

using Numbers = std::vector<std::int64_t>;

inline void beginVTKHDF(HDF5Writer& out, const std::string& type, double major)
{
  out.group("/VTKHDF");
  out.attribute("/VTKHDF", "Version", {major, 0});
  out.text("/VTKHDF", "Type", type);
  for (const char* group : {"/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData"})
    out.group(group);
}

/// A part of a hexahedron, and one of a wedge and a tetrahedron.
inline void writeGridHDF(const std::string& file)
{
  HDF5Writer out(file);
  beginVTKHDF(out, "UnstructuredGrid", 1);
  const std::string root = "/VTKHDF/";
  out.array<std::int64_t>(root + "NumberOfPoints", {8, 7});
  out.array<std::int64_t>(root + "NumberOfCells", {1, 2});
  out.array<std::int64_t>(root + "NumberOfConnectivityIds", {8, 10});
  out.array<double>(root + "Points",
    {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 2, 0, 0, 3, 0, 0, 2, 1,
      0, 2, 0, 1, 3, 0, 1, 2, 1, 1, 2.5, 0.5, 3},
    3);
  out.array<std::int64_t>(
    root + "Connectivity", {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 3, 4, 5, 6});
  out.array<std::int64_t>(root + "Offsets", {0, 8, 0, 6, 10});
  out.array<unsigned char>(root + "Types", {12, 13, 10});
  std::vector<float> values;
  for (int i = 0; i < 15; ++i)
    values.push_back(0.1F * static_cast<float>(i));
  out.array<float>(root + "PointData/p", values);
  out.array<double>(root + "CellData/U", {1, 2, 3, 4, 5, 6, 7, 8, 9}, 3);
  out.array<int>(root + "CellData/number", {10, 11, 12});
  out.array<double>(root + "FieldData/AxisDirection", {0, 1, 0});
}

/// Two vertices and two triangles in two parts, a vertex and a triangle each.
inline void writePolygonsHDF(const std::string& file)
{
  HDF5Writer out(file);
  beginVTKHDF(out, "PolyData", 2);
  const std::string root = "/VTKHDF/";
  out.array<std::int64_t>(root + "NumberOfPoints", {3, 3});
  out.array<float>(root + "Points", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 5, 1, 0, 5, 0, 1, 5}, 3);
  for (const std::string kind : {"Vertices/", "Lines/", "Polygons/", "Strips/"})
  {
    const bool isUsed = kind[0] == 'V' || kind[0] == 'P';
    const std::int64_t corners = kind[0] == 'V' ? 1 : 3;
    out.group(root + kind);
    out.array<std::int64_t>(root + kind + "NumberOfCells", isUsed ? Numbers{1, 1} : Numbers{0, 0});
    out.array<std::int64_t>(
      root + kind + "NumberOfConnectivityIds", isUsed ? Numbers{corners, corners} : Numbers{0, 0});
    out.array<std::int64_t>(
      root + kind + "Offsets", isUsed ? Numbers{0, corners, 0, corners} : Numbers{0, 0});
    out.array<std::int64_t>(root + kind + "Connectivity", kind[0] == 'V' ? Numbers{2, 1}
                                                          : isUsed       ? Numbers{0, 1, 2, 2, 1, 0}
                                                                         : Numbers{});
  }
  out.array<int>(
    root + "CellData/number", {100, 101, 200, 201}); // of the parts one after the other
  out.array<float>(root + "PointData/p", {0, 1, 2, 3, 4, 5});
}

/// Three particles at three times: the second has the first one's places, and there are two at the
/// third.
inline void writeStepsHDF(const std::string& file)
{
  HDF5Writer out(file);
  beginVTKHDF(out, "PolyData", 2);
  const std::string root = "/VTKHDF/";
  out.group(root + "Steps");
  out.attribute("/VTKHDF/Steps", "NSteps", {3});
  out.array<double>(root + "Steps/Values", {0.5, 1.5, 4});
  out.array<std::int64_t>(root + "Steps/PartOffsets", {0, 0, 1});
  out.array<std::int64_t>(root + "Steps/NumberOfParts", {1, 1, 1});
  out.array<std::int64_t>(root + "Steps/PointOffsets", {0, 0, 3});
  out.array<std::int64_t>(root + "Steps/CellOffsets", {0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0}, 4);
  out.array<std::int64_t>(
    root + "Steps/ConnectivityIdOffsets", {0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0}, 4);
  out.group(root + "Steps/PointDataOffsets");
  out.array<std::int64_t>(root + "Steps/PointDataOffsets/v", {0, 3, 6});
  out.array<std::int64_t>(root + "NumberOfPoints", {3, 2});
  out.array<double>(root + "Points", {0, 0, 0, 1, 0, 0, 2, 0, 0, 7, 7, 7, 8, 8, 8}, 3);
  out.group(root + "Vertices");
  out.array<std::int64_t>(root + "Vertices/NumberOfCells", {3, 2});
  out.array<std::int64_t>(root + "Vertices/NumberOfConnectivityIds", {3, 2});
  out.array<std::int64_t>(root + "Vertices/Connectivity", {0, 1, 2, 0, 1});
  out.array<std::int64_t>(root + "Vertices/Offsets", {0, 1, 2, 3, 0, 1, 2});
  out.array<double>(root + "PointData/v", {10, 11, 12, 20, 21, 22, 30, 31});
}

/// An image of 3 x 2 x 4 points.
inline void writeImageHDF(const std::string& file)
{
  HDF5Writer out(file);
  beginVTKHDF(out, "ImageData", 1);
  out.attribute("/VTKHDF", "WholeExtent", {0, 2, 0, 1, 0, 3});
  out.attribute("/VTKHDF", "Origin", {1, 2, 3});
  out.attribute("/VTKHDF", "Spacing", {0.5, 0.25, 2});
  out.attribute("/VTKHDF", "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  std::vector<float> values;
  std::vector<double> vectors;
  for (int i = 0; i < 24; ++i)
  {
    values.push_back(static_cast<float>(i));
    vectors.insert(vectors.end(), {1.0 * i, 2.0 * i, 3.0 * i});
  }
  out.block<float>("/VTKHDF/PointData/p", values, {4, 2, 3});
  out.block<double>("/VTKHDF/PointData/U", vectors, {4, 2, 3, 3});
}

#endif
