#include "FoamReader.h"

#include "FileError.h"
#include "FoamCase.h"
#include "FoamMesh.h"
#include "FoamUnits.h"
#include "MessageCatcher.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDummyController.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPOpenFOAMReader.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

namespace
{

/// Tells arrays what they are measured in, and points that they are metres.
void nameUnits(vtkDataSet* part, const std::map<std::string, std::string>& units)
{
  const auto name = [](vtkAbstractArray* array, const std::string& unit)
  {
    if (!unit.empty())
      array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit.c_str());
  };
  if (auto* points = vtkPointSet::SafeDownCast(part); points && points->GetPoints())
    name(points->GetPoints()->GetData(), "m");
  for (vtkFieldData* arrays : {static_cast<vtkFieldData*>(part->GetPointData()),
         static_cast<vtkFieldData*>(part->GetCellData())})
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      if (vtkAbstractArray* array = arrays->GetAbstractArray(i); array->GetName())
        if (const auto found = units.find(array->GetName()); found != units.end())
          name(array, found->second);
}

class vtkMoteFoamReader : public vtkPOpenFOAMReader
{
public:
  static vtkMoteFoamReader* New();
  vtkTypeMacro(vtkMoteFoamReader, vtkPOpenFOAMReader);

  mote::FoamCase Case;

  /// Throws FileError where a mesh of this time, or else of the first, is damaged. Looks at none
  /// twice.
  mote::FoamMeshFacts CheckMeshes(std::optional<double> time)
  {
    mote::FoamMeshFacts all;
    for (const mote::FoamMesh& mesh : mote::foamMeshesOf(this->Case, time))
    {
      auto known = this->Checked.find(mesh);
      if (known == this->Checked.end())
        known = this->Checked.emplace(mesh, mote::checkFoamMesh(mesh)).first;
      all.places = std::max(all.places, known->second.places);
      all.hasPlainPoints = all.hasPlainPoints && known->second.hasPlainPoints;
    }
    return all;
  }

protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    return this->Guarded(
      [&] { return this->Superclass::RequestInformation(request, inputs, outputs); });
  }

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    std::map<std::string, std::string> units;
    bool mayMove = false;
    auto* const key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    try
    {
      const double time = information->Has(key) ? information->Get(key) : 0.0;
      const mote::FoamMeshFacts facts = this->CheckMeshes(time);
      mayMove = facts.hasPlainPoints && this->HasMesh;
      for (const std::string& file : mote::foamFilesOf(this->Case, time))
        mote::checkFoamFile(file, facts.places);
      for (const std::string& field : mote::foamFieldsOf(this->Case, time))
      {
        std::filesystem::path name = std::filesystem::path(field).filename();
        if (name.extension() == ".gz") // packed: not of the field's name
          name = name.stem();
        units.emplace(name.string(), mote::foamUnitOf(field));
      }
    }
    catch (const mote::FileError& error)
    {
      vtkMultiBlockDataSet::GetData(information)->Initialize();
      vtkErrorMacro(<< error.what());
      return 1; // a failed request would leave old data downstream
    }
    const int done = this->Read(request, inputs, outputs, mayMove);
    for (vtkDataSet* part : vtkCompositeDataSet::GetDataSets(vtkDataObject::GetData(information)))
      nameUnits(part, units);
    return done;
  }

private:
  /// Some damage VTK 9.1's reader throws as a text, which it does not catch itself.
  template <class Request>
  int Guarded(const Request& request)
  {
    try
    {
      return request();
    }
    catch (const char* text)
    {
      vtkErrorMacro("the case is damaged (" << text << ")");
    }
    return 0;
  }

  /// VTK 9.1's reader keeps the mesh of the time before and moves its points. It does not look
  /// whether there is one, nor whether new points could be read: else it makes the mesh anew.
  int Read(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
    bool mayMove)
  {
    const vtkTypeBool isCached = this->CacheMesh;
    this->CacheMesh = isCached && mayMove;
    const int done =
      this->Guarded([&] { return this->Superclass::RequestData(request, inputs, outputs); });
    this->CacheMesh = isCached;
    this->HasMesh = done != 0 && vtkMultiBlockDataSet::GetData(outputs)->GetNumberOfCells() > 0;
    return done;
  }

  bool HasMesh = false;
  std::map<mote::FoamMesh, mote::FoamMeshFacts> Checked;
};

vtkStandardNewMacro(vtkMoteFoamReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeFoamReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<vtkMoteFoamReader>::New();
  reader->Case = foamCaseOf(fileName);
  reader->CheckMeshes({});
  for (const std::string& file : foamFilesOf(reader->Case, {})) // which fields there are
    checkFoamDepth(file);
  reader->SetController(vtkNew<vtkDummyController>()); // it does not look whether there is one
  reader->SetFileName(fileName.c_str());
  reader->SetCaseType(reader->Case.isDecomposed ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                                                : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
  reader->DecomposePolyhedraOff();
  const MessageCatcher catcher(reader);
  reader->UpdateInformation();
  if (const std::string error = catcher.firstError(); !error.empty())
    throw FileError(FileError::Kind::Malformed, fileName, error);
  reader->EnableAllPatchArrays();
  reader->EnableAllCellArrays();
  reader->EnableAllPointArrays();
  reader->EnableAllLagrangianArrays();
  reader->Modified();
  return reader;
}

} // namespace mote
