#include "BoxParts.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

namespace samples
{

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
    this->writeMesh("constant", 0.0);
    if (how_.isMoving)
      this->writeMesh("0.5", 1.0);
    if (how_.hasCloud)
      this->writeCloud();
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
    const bool isText =
      kind == "polyBoundaryMesh" || kind == "dictionary" || name.find("lagrangian") != name.npos;
    const bool isBinary = how_.isBinary && !isText;
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

  void writeFaces(const std::string& folder, const std::vector<Quad>& faces) const
  {
    auto file =
      this->begin(folder + "/polyMesh/faces", how_.isBinary ? "faceCompactList" : "faceList");
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

  /// The mesh as it is from a time on, so far along x.
  void writeMesh(const std::string& folder, double shift) const
  {
    this->begin("system/controlDict", "dictionary")
      << "startFrom startTime;\nstartTime 0;\nendTime 0.5;\ndeltaT 0.5;\nwriteControl timeStep;\n"
         "writeInterval 1;\n";
    std::vector<double> points;
    for (const Place& place : places((how_.processor == 1 ? nx : 0.0) + shift))
      points.insert(points.end(), place.begin(), place.end());
    auto file = this->begin(folder + "/polyMesh/points", "vectorField");
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
    auto boundary = this->begin(folder + "/polyMesh/boundary", "polyBoundaryMesh");
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
    this->writeFaces(folder, faces);
    file = this->begin(folder + "/polyMesh/owner", "labelList");
    this->writeList(file, owners);
    file = this->begin(folder + "/polyMesh/neighbour", "labelList");
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

  /// In text, whatever the fields are in.
  void writeCloud() const
  {
    const std::string cloud = "0.5/lagrangian/spray/";
    this->begin(cloud + "positions", "Cloud<basicKinematicCloud>")
      << "3\n(\n(0.5 0.5 0.5) 0\n(1.5 0.5 0.5) 1\n(2.5 1.5 1.5) 11\n)\n";
    this->begin(cloud + "d", "scalarField") << "3\n(\n0.1\n0.2\n0.3\n)\n";
    this->begin(cloud + "rho", "scalarField") << "3{1000}\n";
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

} // namespace samples
