#include "vtkMoteGeneratedMeshReader.h"

#include "FileError.h"
#include "ReaderFormats.h"
#include "vtkMoteReaderTable.h"

#include "kernels/core/Error.h"
#include "kernels/meshes/GeneratedMeshes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>

vtkStandardNewMacro(vtkMoteGeneratedMeshReader);

namespace
{

constexpr std::string_view spherePrefix = "sphere:", subdividePrefix = "subdivide:";

[[noreturn]] void fail(const std::string& name, const std::string& sentence)
{
  throw mote::FileError(mote::FileError::Kind::Malformed, name, sentence);
}

/// Parts of subdivide:FILE:N. The file's name may have colons.
struct Subdivision
{
  std::string file;
  std::size_t count;

  explicit Subdivision(const std::string& name)
  {
    const std::size_t colon = name.rfind(':');
    if (colon < subdividePrefix.size())
      fail(name, "a model is cut finer by subdivide:FILE:N");
    file = name.substr(subdividePrefix.size(), colon - subdividePrefix.size());
    count = mote::triangleCountIn(std::string_view(name).substr(colon + 1));
  }
};

/// The polygons of a file as triangles.
mote::GeneratedMesh meshIn(const std::string& name, const std::string& file)
{
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(file, error);
  const vtkSmartPointer<vtkDataObject> data =
    reader ? vtkMoteReaderTable::Read(reader, error) : nullptr;
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!data)
    fail(name, error);
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputDataObject(surface);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  if (surface)
    triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();
  if (triangles->GetNumberOfPolys() == 0)
    fail(name, "the file has no polygons to cut finer");
  mote::GeneratedMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(triangles->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    double p[3];
    triangles->GetPoint(static_cast<vtkIdType>(i), p);
    mesh.points[i] = mote::Vec3f(mote::Vec3d(p[0], p[1], p[2]));
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = triangles->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
  {
    auto& triangle = mesh.triangles.emplace_back();
    for (int k = 0; k < 3; ++k)
      triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(corners->GetId(k));
  }
  return mesh;
}

mote::GeneratedMesh meshNamed(const std::string& name)
{
  if (!name.starts_with(subdividePrefix))
    return mote::displacedSphere(
      mote::triangleCountIn(std::string_view(name).substr(spherePrefix.size())));
  const Subdivision wanted(name);
  return mote::subdivided(meshIn(name, wanted.file), wanted.count);
}

void deliver(const mote::GeneratedMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.points.size()));
  std::copy_n(&mesh.points[0].x, 3 * mesh.points.size(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  const auto count = static_cast<vtkIdType>(mesh.triangles.size());
  const auto numbers = [](vtkIdType size)
  {
    vtkNew<vtkTypeInt32Array> array;
    array->SetNumberOfValues(size);
    return vtkSmartPointer<vtkTypeInt32Array>(array);
  };
  const auto corners = numbers(3 * count), offsets = numbers(count + 1);
  std::copy_n(mesh.triangles[0].data(), 3 * mesh.triangles.size(), corners->GetPointer(0));
  for (vtkIdType i = 0; i <= count; ++i)
    offsets->SetValue(i, static_cast<std::int32_t>(3 * i));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetPolys(cells);
}

} // namespace

vtkMoteGeneratedMeshReader::vtkMoteGeneratedMeshReader() = default;
vtkMoteGeneratedMeshReader::~vtkMoteGeneratedMeshReader() = default;

int vtkMoteGeneratedMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return this->RequestMade(outputVector,
    [](const std::string& name, vtkPolyData* output) { deliver(meshNamed(name), output); });
}

void vtkMoteGeneratedMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

namespace mote
{

bool namesGeneratedMesh(const std::string& name)
{
  return name.starts_with(spherePrefix) || name.starts_with(subdividePrefix);
}

} // namespace mote
