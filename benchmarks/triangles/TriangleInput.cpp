#include "TriangleInput.h"

#include "../DataFile.h"

#include <kernels/core/Error.h>

#include <tbb/parallel_for.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <unordered_map>

namespace mote::bench
{

namespace
{

using Corners = TriangleMesh::Corners;

constexpr std::size_t mostTriangles = std::size_t{1} << 30;

std::size_t countIn(const std::string& text)
{
  std::size_t count = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc() || at != end || count < 100 || count > mostTriangles)
    throw Error("\"" + text + "\" is no number of triangles from 100 to 1073741824.");
  return count;
}

/// A sphere of about `count` triangles, two for each cell of longitude and latitude, displaced in
/// waves of a 40th and of a 500th of its size.
TriangleInput displacedSphere(std::size_t count)
{
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 4.0));
  const std::size_t columns = 2 * rows;
  TriangleInput input;
  input.points.resize((rows + 1) * columns + 1);
  input.triangles.resize(2 * rows * columns);
  tbb::parallel_for(std::size_t{0}, rows + 1,
    [&](std::size_t j)
    {
      const double theta = M_PI * static_cast<double>(j) / static_cast<double>(rows);
      for (std::size_t i = 0; i < columns; ++i)
      {
        const double phi = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(columns);
        const double r = 1.0 + 0.05 * std::sin(9.0 * theta) * std::cos(7.0 * phi) +
                         0.004 * std::sin(171.0 * theta) * std::sin(133.0 * phi);
        input.points[j * columns + i] = Vec3f(r * std::sin(theta) * std::cos(phi),
          r * std::sin(theta) * std::sin(phi), r * std::cos(theta));
      }
      if (j == rows)
        return;
      Corners* to = &input.triangles[2 * j * columns];
      for (std::size_t i = 0; i < columns; ++i)
      {
        const auto a = static_cast<std::uint32_t>(j * columns + i);
        const auto b = static_cast<std::uint32_t>(j * columns + (i + 1) % columns);
        const auto below = static_cast<std::uint32_t>(columns);
        *to++ = {a, a + below, b};
        *to++ = {b, a + below, b + below};
      }
    });
  return input;
}

TriangleInput readTriangles(const std::string& fileName)
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
  TriangleInput input;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    const double* p = result->GetPoint(i);
    input.points.push_back(Vec3f(Vec3d(p[0], p[1], p[2]) - box.center()));
  }
  input.points.push_back(Vec3f(0.0f));
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = result->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
    input.triangles.push_back(
      {static_cast<std::uint32_t>(corners->GetId(0)), static_cast<std::uint32_t>(corners->GetId(1)),
        static_cast<std::uint32_t>(corners->GetId(2))});
  if (input.triangles.empty())
    throw Error("The file \"" + fileName + "\" holds no mesh.");
  return input;
}

/// Cuts every triangle into four.
void cutInFour(TriangleInput& input)
{
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(2 * input.triangles.size());
  input.points.pop_back();
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b)
  {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, isNew] =
      middles.try_emplace(edge, static_cast<std::uint32_t>(input.points.size()));
    if (isNew)
      input.points.push_back(0.5f * (input.points[a] + input.points[b]));
    return at->second;
  };
  RawVector<Corners> parts;
  parts.reserve(4 * input.triangles.size());
  for (const auto& [a, b, c] : input.triangles)
  {
    const std::uint32_t ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    parts.push_back({a, ab, ca});
    parts.push_back({ab, b, bc});
    parts.push_back({ca, bc, c});
    parts.push_back({ab, bc, ca});
  }
  input.triangles.swap(parts);
  input.points.push_back(Vec3f(0.0f));
}

/// Moves the points along their normals, by waves of a few edges: what was flat is flat no more.
void displace(TriangleInput& input)
{
  std::vector<Vec3f> normals(input.points.size(), Vec3f(0.0f));
  double area = 0.0;
  for (const auto& [a, b, c] : input.triangles)
  {
    const Vec3f normal =
      glm::cross(input.points[b] - input.points[a], input.points[c] - input.points[a]);
    area += 0.5 * glm::length(normal);
    for (const std::uint32_t corner : {a, b, c})
      normals[corner] += normal;
  }
  const auto edge =
    static_cast<float>(std::sqrt(2.0 * area / static_cast<double>(input.triangles.size())));
  for (std::size_t i = 0; i < input.pointCount(); ++i)
  {
    const Vec3f at = input.points[i] / (1.5f * edge);
    const float wave = std::sin(at.x) * std::sin(at.y + 1.0f) * std::sin(at.z + 2.0f);
    if (const float length = glm::length(normals[i]); length > 0.0f)
      input.points[i] += 0.5f * edge * wave / length * normals[i];
  }
}

/// FILE:N: the model with about N triangles, its own number times a power of four.
TriangleInput subdivided(const std::string& specification)
{
  const std::size_t colon = specification.rfind(':');
  if (colon == std::string::npos)
    throw Error("The input subdivide:FILE:N needs a file and a number of triangles.");
  const std::size_t count = countIn(specification.substr(colon + 1));
  TriangleInput input = readTriangles(specification.substr(0, colon));
  while (2 * input.triangles.size() < count)
    cutInFour(input);
  displace(input);
  return input;
}

TriangleInput makeOrRead(const std::string& specification)
{
  const auto rest = [&](const char* prefix)
  { return specification.substr(std::string(prefix).size()); };
  if (specification.rfind("sphere:", 0) == 0)
    return displacedSphere(countIn(rest("sphere:")));
  if (specification.rfind("subdivide:", 0) == 0)
    return subdivided(rest("subdivide:"));
  return readTriangles(specification);
}

} // namespace

TriangleInput makeTriangleInput(const std::string& specification)
{
  TriangleInput input = makeOrRead(specification);
  input.name = specification;
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
