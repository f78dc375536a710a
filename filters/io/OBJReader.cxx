#include "OBJReader.h"

#include "ColorByte.h"
#include "FileError.h"
#include "FloatPlaces.h"
#include "OBJFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace
{

using mote::OBJFile;

/// Without vtkTypeMacro on purpose: in the eyes of others, Python among them, it is a vtkOBJReader.
class OBJReader : public vtkOBJReader
{
public:
  static OBJReader* New();

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
};

vtkStandardNewMacro(OBJReader);

/// The points of a mesh: its vertices, and those once more that have several normals.
class Points
{
public:
  explicit Points(const OBJFile& file)
    : file_(file)
    , normals_(file.places.size() / 3, -1)
  {
    const auto hasNormal = [](const OBJFile::Corner& corner) { return corner.normal >= 0; };
    hasNormals_ = !file.faces.corners.empty() &&
                  std::all_of(file.faces.corners.begin(), file.faces.corners.end(), hasNormal);
    if (!hasNormals_)
      return;
    // Files name a normal of the same value many times.
    std::map<std::array<float, 3>, std::int64_t> known;
    for (std::int64_t i = 0; 3 * i < static_cast<std::int64_t>(file.normals.size()); ++i)
    {
      const float* const n = &file.normals[static_cast<std::size_t>(3 * i)];
      same_.push_back(known.try_emplace({n[0], n[1], n[2]}, i).first->second);
    }
  }

  vtkIdType of(const OBJFile::Corner& corner)
  {
    if (!hasNormals_ || corner.normal < 0)
      return corner.vertex;
    const std::int64_t normal = same_[static_cast<std::size_t>(corner.normal)];
    std::int64_t& first = normals_[static_cast<std::size_t>(corner.vertex)];
    if (first < 0)
      first = normal;
    if (first == normal)
      return corner.vertex;
    const auto [entry, isNew] = others_[corner.vertex].try_emplace(
      normal, static_cast<vtkIdType>(normals_.size() + more_.size()));
    if (isNew)
      more_.emplace_back(corner.vertex, normal);
    return entry->second;
  }

  void addTo(vtkPolyData* output) const
  {
    const auto count = static_cast<vtkIdType>(normals_.size());
    const vtkIdType all = count + static_cast<vtkIdType>(more_.size());
    vtkNew<vtkPoints> points;
    points->SetDataType(mote::needDouble(file_.places) ? VTK_DOUBLE : VTK_FLOAT);
    points->SetNumberOfPoints(all);
    for (vtkIdType i = 0; i < all; ++i)
      points->SetPoint(i, &file_.places[3 * vertexOf(i)]);
    output->SetPoints(points);
    if (!file_.colors.empty())
      output->GetPointData()->AddArray(colors(all));
    if (!hasNormals_)
      return;
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(all);
    const float up[3] = {0.0f, 0.0f, 1.0f}; // of vertices that no face has
    for (vtkIdType i = 0; i < all; ++i)
    {
      const std::int64_t normal = i < count ? normals_[static_cast<std::size_t>(i)]
                                            : more_[static_cast<std::size_t>(i - count)].second;
      normals->SetTypedTuple(
        i, normal < 0 ? up : &file_.normals[static_cast<std::size_t>(3 * normal)]);
    }
    output->GetPointData()->SetNormals(normals);
  }

private:
  std::size_t vertexOf(vtkIdType point) const
  {
    const auto i = static_cast<std::size_t>(point);
    return i < normals_.size() ? i : static_cast<std::size_t>(more_[i - normals_.size()].first);
  }

  vtkSmartPointer<vtkUnsignedCharArray> colors(vtkIdType all) const
  {
    const float most = *std::max_element(file_.colors.begin(), file_.colors.end());
    const double unit = most > 1.0f ? 1.0 : 255.0; // MeshLab goes to 1, others to 255
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetName("RGB");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(all);
    for (vtkIdType i = 0; i < all; ++i)
      for (int c = 0; c < 3; ++c)
        colors->SetTypedComponent(i, c,
          mote::colorByte(unit * file_.colors[3 * vertexOf(i) + static_cast<std::size_t>(c)]));
    return colors;
  }

  const OBJFile& file_;
  bool hasNormals_ = false;
  std::vector<std::int64_t> same_;    ///< for each normal the first one of its value
  std::vector<std::int64_t> normals_; ///< of each vertex; -1: none so far
  std::unordered_map<std::int64_t, std::map<std::int64_t, vtkIdType>> others_; ///< of vertices
  std::vector<std::pair<std::int64_t, std::int64_t>> more_; ///< vertices and their normals
};

vtkSmartPointer<vtkCellArray> cellsOf(const OBJFile::Cells& cells, Points& points)
{
  vtkNew<vtkIdTypeArray> offsets, corners;
  offsets->InsertNextValue(0);
  for (const std::int64_t end : cells.ends)
    offsets->InsertNextValue(static_cast<vtkIdType>(end));
  for (const OBJFile::Corner& corner : cells.corners)
    corners->InsertNextValue(points.of(corner));
  auto made = vtkSmartPointer<vtkCellArray>::New();
  made->SetData(offsets, corners);
  return made;
}

/// Which group each cell is in, where cells are in several, and the names of these.
void addGroups(const OBJFile& file, const OBJFile::Groups& groups,
  std::vector<std::int32_t> OBJFile::Cells::*member, const std::string& kind, vtkPolyData* output)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName((kind + "Ids").c_str());
  std::vector<int> numbers(groups.names.size(), -1); // of those that cells are in
  vtkNew<vtkStringArray> names;
  names->SetName((kind + "Names").c_str());
  for (const OBJFile::Cells* cells : {&file.points, &file.lines, &file.faces})
    for (const std::int32_t group : cells->*member)
    {
      int& number = numbers[static_cast<std::size_t>(group)];
      if (number < 0)
        number =
          static_cast<int>(names->InsertNextValue(groups.names[static_cast<std::size_t>(group)]));
      ids->InsertNextValue(number);
    }
  if (names->GetNumberOfValues() < 2)
    return;
  output->GetCellData()->AddArray(ids);
  output->GetFieldData()->AddArray(names);
}

int OBJReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const OBJFile file = mote::readOBJ(this->FileName ? this->FileName : "",
      [this](double done)
      {
        this->UpdateProgress(done);
        return this->GetAbortExecute() == 0;
      });
    Points points(file);
    output->SetVerts(cellsOf(file.points, points));
    output->SetLines(cellsOf(file.lines, points));
    output->SetPolys(cellsOf(file.faces, points));
    points.addTo(output);
    addGroups(file, file.materials, &OBJFile::Cells::materials, "Material", output);
    addGroups(file, file.groups, &OBJFile::Cells::groups, "Group", output);
    addGroups(file, file.objects, &OBJFile::Cells::objects, "Object", output);
  }
  catch (const mote::FileError& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
  }
  return 1; // a failed request would leave old data downstream
}

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeOBJReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<OBJReader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

} // namespace mote
