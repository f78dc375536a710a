#include "MeshSamples.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>

namespace samples
{

namespace
{

constexpr int nx = cells[0], ny = cells[1], nz = cells[2];
constexpr int count = nx * ny * nz;
constexpr int pointCount = (nx + 1) * (ny + 1) * (nz + 1);

int pointAt(int i, int j, int k)
{
  return i + (nx + 1) * (j + (ny + 1) * k);
}

int cellAt(int i, int j, int k)
{
  return i + nx * (j + ny * k);
}

using Place = std::array<double, 3>;

std::vector<Place> places(double firstX = 0.0)
{
  std::vector<Place> all;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        all.push_back({firstX + i, double(j), double(k)});
  return all;
}

std::array<int, 8> hexahedron(int i, int j, int k)
{
  return {pointAt(i, j, k), pointAt(i + 1, j, k), pointAt(i + 1, j + 1, k), pointAt(i, j + 1, k),
    pointAt(i, j, k + 1), pointAt(i + 1, j, k + 1), pointAt(i + 1, j + 1, k + 1),
    pointAt(i, j + 1, k + 1)};
}

void forCells(const std::function<void(int, int, int)>& visit)
{
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        visit(i, j, k);
}

using Quad = std::array<int, 4>;

/// The face of a cell that points along an axis, forwards or backwards; its normal points out.
Quad faceOf(int i, int j, int k, int axis, bool isForwards)
{
  const auto at = [&](int a, int b, int c) { return pointAt(i + a, j + b, k + c); };
  const int d = isForwards ? 1 : 0;
  Quad quad = axis == 0   ? Quad{at(d, 0, 0), at(d, 1, 0), at(d, 1, 1), at(d, 0, 1)}
              : axis == 1 ? Quad{at(0, d, 0), at(0, d, 1), at(1, d, 1), at(1, d, 0)}
                          : Quad{at(0, 0, d), at(1, 0, d), at(1, 1, d), at(0, 1, d)};
  if (!isForwards)
    std::swap(quad[1], quad[3]);
  return quad;
}

struct Face
{
  Quad points;
  int owner;
};

/// The faces of the box along an axis, at one of its ends.
std::vector<Face> facesAt(int axis, bool isLast)
{
  std::vector<Face> faces;
  forCells(
    [&](int i, int j, int k)
    {
      const int at[3] = {i, j, k};
      if (at[axis] == (isLast ? cells[axis] - 1 : 0))
        faces.push_back({faceOf(i, j, k, axis, isLast), cellAt(i, j, k)});
    });
  return faces;
}

std::vector<Face> wallFaces()
{
  std::vector<Face> walls;
  for (int axis : {1, 2})
    for (bool isLast : {false, true})
      for (const Face& face : facesAt(axis, isLast))
        walls.push_back(face);
  return walls;
}

void addArrays(vtkDataSet* data, double time)
{
  vtkNew<vtkDoubleArray> p;
  p->SetName("p");
  double at[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, at);
    p->InsertNextValue(at[0] + 10.0 * at[1] + 100.0 * at[2]);
  }
  vtkNew<vtkDoubleArray> q;
  q->SetName("q");
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("U");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    q->InsertNextValue(double(i));
    velocity->InsertNextTuple3(time, double(i), 0.0);
  }
  data->GetPointData()->AddArray(p);
  data->GetCellData()->AddArray(q);
  data->GetCellData()->AddArray(velocity);
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> box(double time)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (const Place& place : places())
    points->InsertNextPoint(place.data());
  grid->SetPoints(points);
  forCells(
    [&](int i, int j, int k)
    {
      const auto corners = hexahedron(i, j, k);
      const std::vector<vtkIdType> ids(corners.begin(), corners.end());
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
    });
  addArrays(grid, time);
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> structuredBox(bool isLeftHanded)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(nx + 1, ny + 1, nz + 1);
  vtkNew<vtkPoints> points;
  for (const Place& place : places())
    points->InsertNextPoint(isLeftHanded ? nx - place[0] : place[0], place[1], place[2]);
  grid->SetPoints(points);
  addArrays(grid, 0.0);
  return grid;
}

namespace
{

/// Writes the files of an OpenFOAM case.
class FoamWriter
{
public:
  FoamWriter(const std::string& folder, const Foam& how)
    : folder_(folder)
    , how_(how)
  {
  }

  void write()
  {
    this->writeMesh();
    for (const double time : {0.0, 0.5})
    {
      this->writePressure(time);
      this->writeVelocity(time);
    }
  }

private:
  struct Patch
  {
    std::string name, type;
    std::vector<Face> faces;
  };

  /// As decomposePar writes them: all patches for each processor, and then those between.
  std::vector<Patch> patches() const
  {
    const std::vector<Face> first = facesAt(0, false), last = facesAt(0, true), none;
    const int processor = how_.processor;
    std::vector<Patch> all = {{"inlet", "patch", processor == 1 ? none : first},
      {"outlet", "patch", processor == 0 ? none : last}, {"walls", "wall", wallFaces()}};
    if (processor == 0)
      all.push_back({"procBoundary0to1", "processor", last});
    if (processor == 1)
      all.push_back({"procBoundary1to0", "processor", first});
    return all;
  }

  std::ofstream begin(const std::string& name, const std::string& kind) const
  {
    const auto path = std::filesystem::path(folder_) / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    const bool isBinary = how_.isBinary && kind != "polyBoundaryMesh" && kind != "dictionary";
    file << "FoamFile\n{\n    version     2.0;\n    format      " << (isBinary ? "binary" : "ascii")
         << ";\n    arch        \"LSB;label=32;scalar=64\";\n    class       " << kind
         << ";\n    object      " << path.filename().string() << ";\n}\n\n";
    return file;
  }

  template <class T>
  void writeRaw(std::ostream& file, const std::vector<T>& values) const
  {
    file.write(reinterpret_cast<const char*>(values.data()),
      static_cast<std::streamsize>(values.size() * sizeof(T)));
  }

  /// A list of numbers, or of vectors of so many.
  template <class T>
  void writeList(std::ostream& file, const std::vector<T>& values, int components = 1) const
  {
    file << values.size() / components << "\n(";
    if (how_.isBinary)
      this->writeRaw(file, values);
    else
      for (std::size_t i = 0; i < values.size(); i += components)
      {
        file << "\n" << (components > 1 ? "(" : "");
        for (int k = 0; k < components; ++k)
          file << (k > 0 ? " " : "") << values[i + k];
        file << (components > 1 ? ")" : "");
      }
    file << (how_.isBinary ? ")\n" : "\n)\n");
  }

  void writeFaces(const std::vector<Quad>& faces) const
  {
    auto file =
      this->begin("constant/polyMesh/faces", how_.isBinary ? "faceCompactList" : "faceList");
    std::vector<std::int32_t> begins, corners;
    for (const Quad& quad : faces)
    {
      begins.push_back(static_cast<std::int32_t>(corners.size()));
      corners.insert(corners.end(), quad.begin(), quad.end());
    }
    begins.push_back(static_cast<std::int32_t>(corners.size()));
    if (how_.isBinary)
    {
      this->writeList(file, begins);
      file << "\n";
      this->writeList(file, corners);
      return;
    }
    file << faces.size() << "\n(\n";
    for (const Quad& quad : faces)
      file << "4(" << quad[0] << " " << quad[1] << " " << quad[2] << " " << quad[3] << ")\n";
    file << ")\n";
  }

  void writeMesh() const
  {
    this->begin("system/controlDict", "dictionary")
      << "startFrom startTime;\nstartTime 0;\nendTime 0.5;\ndeltaT 0.5;\nwriteControl timeStep;\n"
         "writeInterval 1;\n";
    std::vector<double> points;
    for (const Place& place : places(how_.processor == 1 ? nx : 0.0))
      points.insert(points.end(), place.begin(), place.end());
    auto file = this->begin("constant/polyMesh/points", "vectorField");
    this->writeList(file, points, 3);
    std::vector<Quad> faces;
    std::vector<std::int32_t> owners, neighbours;
    forCells(
      [&](int i, int j, int k)
      {
        const int at[3] = {i, j, k};
        for (int axis = 0; axis < 3; ++axis)
          if (at[axis] + 1 < cells[axis])
          {
            faces.push_back(faceOf(i, j, k, axis, true));
            owners.push_back(cellAt(i, j, k));
            neighbours.push_back(cellAt(i + (axis == 0), j + (axis == 1), k + (axis == 2)));
          }
      });
    auto boundary = this->begin("constant/polyMesh/boundary", "polyBoundaryMesh");
    boundary << this->patches().size() << "\n(\n";
    for (const Patch& patch : this->patches())
    {
      boundary << "    " << patch.name << "\n    {\n        type            " << patch.type
               << ";\n        nFaces          " << patch.faces.size()
               << ";\n        startFace       " << faces.size() << ";\n    }\n";
      for (const Face& face : patch.faces)
      {
        faces.push_back(face.points);
        owners.push_back(face.owner);
      }
    }
    boundary << ")\n";
    this->writeFaces(faces);
    file = this->begin("constant/polyMesh/owner", "labelList");
    this->writeList(file, owners);
    file = this->begin("constant/polyMesh/neighbour", "labelList");
    this->writeList(file, neighbours);
  }

  static std::string nameOf(double time)
  {
    std::ostringstream name;
    name << time;
    return name.str();
  }

  void writePressure(double time) const
  {
    auto file = this->begin(nameOf(time) + "/p", "volScalarField");
    std::vector<double> values(count);
    std::iota(values.begin(), values.end(), time);
    file << "dimensions      [0 2 -2 0 0 0 0];\n\ninternalField   nonuniform List<scalar>\n";
    this->writeList(file, values);
    file << ";\n\nboundaryField\n{\n";
    for (const Patch& patch : this->patches())
    {
      file << "    " << patch.name << "\n    {\n";
      if (patch.name == "inlet")
        file << "        type            fixedValue;\n        value           uniform 7;\n";
      else if (patch.name == "walls")
      {
        file << "        type            fixedValue;\n        value           nonuniform "
                "List<scalar>\n";
        this->writeList(file, std::vector<double>(patch.faces.size(), 3.0));
        file << ";\n";
      }
      else
        file << "        type            zeroGradient;\n";
      file << "    }\n";
    }
    file << "}\n";
  }

  void writeVelocity(double time) const
  {
    auto file = this->begin(nameOf(time) + "/U", "volVectorField");
    file << "dimensions      [0 1 -1 0 0 0 0];\n\n";
    if (time == 0.0)
      file << "internalField   uniform (0 2 0);\n\n";
    else
    {
      std::vector<double> values;
      for (int i = 0; i < count; ++i)
        values.insert(values.end(), {time, double(i), 0.0});
      file << "internalField   nonuniform List<vector>\n";
      this->writeList(file, values, 3);
      file << ";\n\n";
    }
    file << "boundaryField\n{\n";
    for (const Patch& patch : this->patches())
      file << "    " << patch.name << "\n    {\n        type            zeroGradient;\n    }\n";
    file << "}\n";
  }

  std::string folder_;
  Foam how_;
};

std::string touch(const std::filesystem::path& file)
{
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << "";
  return file.string();
}

} // namespace

std::string writeFoam(const std::string& folder, const Foam& how)
{
  FoamWriter(folder, how).write();
  return touch(std::filesystem::path(folder) / "case.foam");
}

std::string writeDecomposedFoam(const std::string& folder, bool isBinary)
{
  for (const int processor : {0, 1})
    FoamWriter(folder + "/processor" + std::to_string(processor), {isBinary, processor}).write();
  std::filesystem::create_directories(folder + "/system");
  std::filesystem::copy_file(folder + "/processor0/system/controlDict",
    folder + "/system/controlDict", std::filesystem::copy_options::overwrite_existing);
  return touch(std::filesystem::path(folder) / "case.foam");
}

namespace
{

/// Writes EnSight Gold as text or bytes.
class EnSightFile
{
public:
  EnSightFile(const std::filesystem::path& path, bool isBinary)
    : file_(path, std::ios::binary)
    , isBinary_(isBinary)
  {
  }

  void text(std::string line)
  {
    if (!isBinary_)
      file_ << line << "\n";
    else
    {
      line.resize(80, ' ');
      file_ << line;
    }
  }
  void whole(int value)
  {
    if (!isBinary_)
      file_ << "         " << value << "\n";
    else
      this->raw(static_cast<std::int32_t>(value));
  }
  void whole(const std::vector<int>& values)
  {
    for (const int value : values)
      if (isBinary_)
        this->raw(static_cast<std::int32_t>(value));
      else
        file_ << " " << value;
    if (!isBinary_)
      file_ << "\n";
  }
  void real(double value)
  {
    if (!isBinary_)
      file_ << " " << value << "\n";
    else
      this->raw(static_cast<float>(value));
  }

private:
  template <class T>
  void raw(T value)
  {
    file_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::ofstream file_;
  bool isBinary_;
};

void writeEnSightGeometry(EnSightFile file, bool isBinary)
{
  if (isBinary)
    file.text("C Binary");
  file.text("a box");
  file.text("of a test");
  file.text("node id off");
  file.text("element id off");
  const auto points = places();
  file.text("part");
  file.whole(1);
  file.text("fluid");
  file.text("coordinates");
  file.whole(pointCount);
  for (int axis = 0; axis < 3; ++axis)
    for (const Place& place : points)
      file.real(place[axis]);
  file.text("hexa8");
  file.whole(count);
  forCells(
    [&](int i, int j, int k)
    {
      std::vector<int> corners;
      for (const int corner : hexahedron(i, j, k))
        corners.push_back(corner + 1);
      file.whole(corners);
    });
  // A part has points of its own.
  const auto faces = facesAt(0, false);
  file.text("part");
  file.whole(2);
  file.text("inlet");
  file.text("coordinates");
  file.whole(static_cast<int>(4 * faces.size()));
  for (int axis = 0; axis < 3; ++axis)
    for (const Face& face : faces)
      for (const int point : face.points)
        file.real(points[point][axis]);
  file.text("quad4");
  file.whole(static_cast<int>(faces.size()));
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
    file.whole({4 * i + 1, 4 * i + 2, 4 * i + 3, 4 * i + 4});
}

} // namespace

std::string writeEnSight(const std::string& folder, bool isBinary)
{
  const std::filesystem::path at(folder);
  std::filesystem::create_directories(at);
  writeEnSightGeometry(EnSightFile(at / "box.geo", isBinary), isBinary);
  const auto faces = facesAt(0, false);
  for (int step = 0; step < 2; ++step)
  {
    EnSightFile p(at / ("box.p." + std::to_string(step)), isBinary);
    p.text("p");
    p.text("part");
    p.whole(1);
    p.text("coordinates");
    for (const Place& place : places())
      p.real(place[0] + 10.0 * place[1] + 100.0 * place[2]);
    p.text("part");
    p.whole(2);
    p.text("coordinates");
    for (std::size_t i = 0; i < 4 * faces.size(); ++i)
      p.real(0.0);
    EnSightFile velocity(at / ("box.U." + std::to_string(step)), isBinary);
    velocity.text("U");
    velocity.text("part");
    velocity.whole(1);
    velocity.text("hexa8");
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < count; ++i)
        velocity.real(axis == 0 ? 0.5 * step : axis == 1 ? double(i) : 0.0);
  }
  const std::string name = (at / "box.case").string();
  std::ofstream(name, std::ios::binary)
    << "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: box.geo\nVARIABLE\nscalar per node: 1 p "
       "box.p.*\nvector per element: 1 U box.U.*\nTIME\ntime set: 1\nnumber of steps: 2\n"
       "filename start number: 0\nfilename increment: 1\ntime values: 0 0.5\n";
  return name;
}

namespace
{

void writeField(int file, int zone, const char* name, double time)
{
  int solution = 0, field = 0;
  std::vector<double> q(count);
  std::iota(q.begin(), q.end(), time);
  cg_sol_write(file, 1, zone, name, CGNS_ENUMV(CellCenter), &solution);
  cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble), "q", q.data(), &field);
}

void writeTimes(int file, int zone)
{
  char names[2][32];
  for (int step = 0; step < 2; ++step)
  {
    std::fill(names[step], names[step] + 32, ' ');
    const std::string name = step == 0 ? "first" : "second";
    std::copy(name.begin(), name.end(), names[step]);
    writeField(file, zone, name.c_str(), 0.5 * step);
  }
  cg_ziter_write(file, 1, zone, "ZoneIterativeData");
  cg_goto(file, 1, "Zone_t", zone, "ZoneIterativeData_t", 1, "end");
  const cgsize_t shape[2] = {32, 2};
  cg_array_write("FlowSolutionPointers", CGNS_ENUMV(Character), 2, shape, names);
}

void writeCoordinates(int file, int zone)
{
  const char* const names[3] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> values;
    for (const Place& place : places(zone == 1 ? 0.0 : nx))
      values.push_back(place[axis]);
    int coordinate = 0;
    cg_coord_write(file, 1, zone, CGNS_ENUMV(RealDouble), names[axis], values.data(), &coordinate);
  }
}

} // namespace

void writeCGNS(const std::string& name)
{
  int file = 0, base = 0, zone = 0, section = 0, condition = 0, family = 0;
  cg_open(name.c_str(), CG_MODE_WRITE, &file);
  cg_base_write(file, "Base", 3, 3, &base);
  const cgsize_t size[3] = {pointCount, count, 0};
  cg_zone_write(file, base, "fluid", size, CGNS_ENUMV(Unstructured), &zone);
  writeCoordinates(file, zone);
  std::vector<cgsize_t> corners;
  forCells(
    [&](int i, int j, int k)
    {
      for (const int corner : hexahedron(i, j, k))
        corners.push_back(corner + 1);
    });
  cgsize_t last = count;
  cg_section_write(
    file, base, zone, "cells", CGNS_ENUMV(HEXA_8), 1, last, 0, corners.data(), &section);
  const std::pair<const char*, std::vector<Face>> patches[] = {
    {"inlet", facesAt(0, false)}, {"walls", wallFaces()}};
  for (const auto& [patch, faces] : patches)
  {
    corners.clear();
    for (const Face& face : faces)
      for (const int point : face.points)
        corners.push_back(point + 1);
    const cgsize_t range[2] = {last + 1, last + static_cast<cgsize_t>(faces.size())};
    cg_section_write(
      file, base, zone, patch, CGNS_ENUMV(QUAD_4), range[0], range[1], 0, corners.data(), &section);
    cg_boco_write(
      file, base, zone, patch, CGNS_ENUMV(BCWall), CGNS_ENUMV(PointRange), 2, range, &condition);
    cg_boco_gridlocation_write(file, base, zone, condition, CGNS_ENUMV(FaceCenter));
    cg_goto(file, base, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", condition, "end");
    cg_famname_write(patch);
    cg_family_write(file, base, patch, &family);
    last = range[1];
  }
  writeTimes(file, zone);
  const cgsize_t shape[9] = {nx + 1, ny + 1, nz + 1, nx, ny, nz, 0, 0, 0};
  cg_zone_write(file, base, "rotor", shape, CGNS_ENUMV(Structured), &zone);
  writeCoordinates(file, zone);
  writeTimes(file, zone);
  cg_biter_write(file, base, "TimeIterValues", 2);
  cg_goto(file, base, "BaseIterativeData_t", 1, "end");
  const cgsize_t steps = 2;
  const double times[2] = {0.0, 0.5};
  cg_array_write("TimeValues", CGNS_ENUMV(RealDouble), 1, &steps, times);
  cg_close(file);
}

} // namespace samples
