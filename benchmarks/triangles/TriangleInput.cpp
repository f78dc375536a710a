#include "TriangleInput.h"

#include "../DataFile.h"

#include <kernels/core/Error.h>
#include <kernels/meshes/GeneratedMeshes.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <cstdint>
#include <filesystem>

namespace mote::bench
{

namespace
{

GeneratedMesh readTriangles(const std::string& fileName)
{
  if (!std::filesystem::exists(fileName))
    throw Error("The input \"" + fileName +
                "\" is neither sphere:N nor subdivide:FILE:N nor a file that exists.");
  const vtkSmartPointer<vtkDataObject> data = readLastStep(fileName);
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (surface == nullptr || surface->GetNumberOfPoints() == 0)
    throw Error("The file \"" + fileName + "\" holds no mesh.");
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(surface);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  vtkPolyData* result = triangulate->GetOutput();
  Box box;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    const double* p = result->GetPoint(i);
    box.add(Vec3d(p[0], p[1], p[2]));
  }
  GeneratedMesh mesh;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    const double* p = result->GetPoint(i);
    mesh.points.push_back(Vec3f(Vec3d(p[0], p[1], p[2]) - box.center()));
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = result->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
    mesh.triangles.push_back(
      {static_cast<std::uint32_t>(corners->GetId(0)), static_cast<std::uint32_t>(corners->GetId(1)),
        static_cast<std::uint32_t>(corners->GetId(2))});
  if (mesh.triangles.empty())
    throw Error("The file \"" + fileName + "\" holds no mesh.");
  return mesh;
}

/// FILE:N: the model with about N triangles.
GeneratedMesh subdividedModel(const std::string& specification)
{
  const std::size_t colon = specification.rfind(':');
  if (colon == std::string::npos)
    throw Error("The input subdivide:FILE:N needs a file and a number of triangles.");
  const std::size_t count = triangleCountIn(specification.substr(colon + 1));
  return subdivided(readTriangles(specification.substr(0, colon)), count);
}

GeneratedMesh makeOrRead(const std::string& specification)
{
  const auto rest = [&](const char* prefix)
  { return specification.substr(std::string(prefix).size()); };
  if (specification.rfind("sphere:", 0) == 0)
    return displacedSphere(triangleCountIn(rest("sphere:")));
  if (specification.rfind("subdivide:", 0) == 0)
    return subdividedModel(rest("subdivide:"));
  return readTriangles(specification);
}

} // namespace

TriangleInput makeTriangleInput(const std::string& specification)
{
  GeneratedMesh mesh = makeOrRead(specification);
  TriangleInput input;
  input.name = specification;
  input.points.swap(mesh.points);
  input.points.push_back(Vec3f(0.0f));
  input.triangles.swap(mesh.triangles);
  for (std::size_t i = 0; i < input.pointCount(); ++i)
    input.bounds.add(Vec3d(input.points[i]));
  return input;
}

std::vector<Named> triangleInputs()
{
  return {{"sphere:N", "a sphere of about N triangles, displaced in waves"},
    {"subdivide:FILE:N", "a model whose triangles are cut in four, again and again, to about N, "
                         "then displaced in waves of a few edges"},
    {"FILE", "a mesh that Mote's readers read"}};
}

} // namespace mote::bench
