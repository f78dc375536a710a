#pragma once

// What tests of files of triangles share.

#include "FileParts.h"
#include "MeshParts.h"

#include <kernels/meshes/RlodTreeFile.h>
#include <kernels/meshes/detail/RlodTreeFileHeader.h>

#include <stdexcept>

namespace mote::testing
{

/// A bumpy sphere, with a point that no triangle uses, and arrays: of points `h` (float) and
/// `Normals` (three float), of cells, each of two triangles, `part` (bytes), and a fact, `box`.
struct MeshExample
{
  Triangles triangles;
  TriangleMesh mesh;
  RlodTree tree;
  std::vector<float> height, normals;
  std::vector<std::int64_t> cellOf;
  std::vector<std::uint8_t> part;
  std::vector<double> box = {-1.0, 1.0};

  explicit MeshExample(int rings = 40)
    : triangles(bumpySphere(rings))
  {
    triangles.addPoint({50.0, 0.0, 0.0});
    mesh = triangles.mesh();
    tree.build(mesh);
    tree.makeLods();
    for (std::size_t i = 0; i < mesh.pointCount(); ++i)
    {
      height.push_back(static_cast<float>(triangles.point(i).z));
      for (int k = 0; k < 3; ++k)
        normals.push_back(static_cast<float>(triangles.point(i)[k]));
    }
    for (std::size_t t = 0; t < mesh.size(); ++t)
      cellOf.push_back(static_cast<std::int64_t>(t / 2));
    for (std::size_t c = 0; c < (mesh.size() + 1) / 2; ++c)
      part.push_back(static_cast<std::uint8_t>(c % 7));
  }

  RlodTreeFileContents contents() const
  {
    RlodTreeFileContents c;
    c.places = triangles.pointView();
    c.points = {{"h", ArrayView(height.data(), height.size(), 1), {}},
      {"Normals", ArrayView(normals.data(), height.size(), 3), {"x", "y", "z"}}};
    c.cells = {{"part", ArrayView(part.data(), ArrayView::Type::UInt8, part.size(), 1), {}}};
    c.cellOf = ArrayView(cellOf.data(), ArrayView::Type::Int64, cellOf.size(), 1);
    c.facts = {{"box", ArrayView(box.data(), 1, 2), {}}};
    c.time = 2.5;
    c.pointIndices = "point";
    c.cellIndices = "cell";
    c.normals = "Normals";
    return c;
  }
};

inline const FileArray& named(const std::vector<FileArray>& arrays, const std::string& name)
{
  for (const FileArray& array : arrays)
    if (array.name == name)
      return array;
  throw std::runtime_error("no array " + name);
}

/// A file of triangles.
struct Patient : FilePatient<RlodTreeFile, RlodTreeFileHeader>
{
  MeshExample example;

  explicit Patient(int rings = 40, bool arrays = true)
    : example(rings)
  {
    RlodTreeFileContents contents;
    contents.places = example.triangles.pointView();
    writeRlodTreeFile(
      folder.file(), example.tree, example.mesh, arrays ? example.contents() : contents);
    this->take();
  }

  std::vector<FileSection> sections() const
  {
    return {header.nodes, header.words, header.planes, header.clusters, header.corners,
      header.offsets, header.places};
  }
};

} // namespace mote::testing
