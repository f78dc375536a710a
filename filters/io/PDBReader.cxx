#include "PDBReader.h"

#include "FileError.h"
#include "PDBCheck.h"
#include "StepSource.h"
#include "TextFile.h"
#include "WholeFile.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDBReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Models are time steps. Without vtkTypeMacro on purpose: in the eyes of others, Python among
/// them, it is a vtkPDBReader.
class CheckedPDBReader : public vtkPDBReader
{
public:
  static CheckedPDBReader* New();

protected:
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /// Looks through the file where it is another one now. Throws FileError.
  const mote::WholeFile& Look();
  std::size_t ModelOf(vtkInformation* information) const;

  mote::PDBModels Models;
  std::vector<double> Times;           ///< of several models
  std::optional<mote::WholeFile> File; ///< that has been looked through
  mote::FileStamp Stamp;
};

vtkStandardNewMacro(CheckedPDBReader);

/// The times of models: as all of them tell it, or else their numbers from 0.
std::vector<double> timesOf(const std::vector<mote::PDBModel>& models)
{
  std::vector<double> times;
  for (const mote::PDBModel& model : models)
    if (model.time && (times.empty() || *model.time > times.back()))
      times.push_back(*model.time);
  if (times.size() < models.size())
  {
    times.resize(models.size());
    std::iota(times.begin(), times.end(), 0.0);
  }
  return times;
}

const mote::WholeFile& CheckedPDBReader::Look()
{
  const std::string path = this->FileName ? this->FileName : "";
  const mote::FileStamp stamp = mote::stampOf(path);
  if (File && File->path() == path && Stamp == stamp)
    return *File;
  File.reset();
  File.emplace(path);
  try
  {
    Models = mote::checkPDB(File->bytes(), path);
  }
  catch (...)
  {
    File.reset();
    throw;
  }
  Times.clear();
  if (Models.models.size() > 1)
    Times = timesOf(Models.models);
  Stamp = stamp;
  return *File;
}

int CheckedPDBReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Remove(Pipeline::TIME_STEPS());
  information->Remove(Pipeline::TIME_RANGE());
  try
  {
    this->Look();
  }
  catch (const mote::FileError&)
  {
    return 1; // RequestData says what is wrong
  }
  if (Times.empty())
    return 1;
  const double range[2] = {Times.front(), Times.back()};
  information->Set(Pipeline::TIME_STEPS(), Times.data(), static_cast<int>(Times.size()));
  information->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

/// The one whose time is nearest to the one that is asked for.
std::size_t CheckedPDBReader::ModelOf(vtkInformation* information) const
{
  if (Times.empty() || !information->Has(Pipeline::UPDATE_TIME_STEP()))
    return 0;
  const double time = information->Get(Pipeline::UPDATE_TIME_STEP());
  const auto above = std::lower_bound(Times.begin(), Times.end(), time);
  if (above == Times.begin())
    return 0;
  const bool isAbove = above != Times.end() && *above - time < time - above[-1];
  return static_cast<std::size_t>(above - Times.begin()) - (isAbove ? 0 : 1);
}

void makeRadiusScalar(vtkPointData* arrays)
{
  vtkDataArray* triple = arrays->GetArray("radius");
  if (!triple || triple->GetNumberOfComponents() == 1)
    return;
  vtkNew<vtkFloatArray> radius;
  radius->SetName("radius");
  radius->SetNumberOfTuples(triple->GetNumberOfTuples());
  radius->CopyComponent(0, triple, 0);
  arrays->RemoveArray("radius"); // it was the active vector as well
  arrays->AddArray(radius);
}

int CheckedPDBReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkInformation* information = outputVector->GetInformationObject(0);
  try
  {
    const mote::WholeFile& file = this->Look();
    const std::size_t model = this->ModelOf(information);
    std::string text =
      model < Models.models.size() ? Models.textOf(file.bytes(), model) : std::string("END\n");
    mote::requireFewBonds(text, file.path());
    FILE* const stream = fmemopen(text.data(), text.size(), "r");
    if (!stream)
      throw mote::FileError(
        mote::FileError::Kind::CannotOpen, file.path(), "there is not enough memory for it");
    this->ReadMolecule(stream, output);
    std::fclose(stream);
    if (model < Models.models.size() && Models.models[model].box)
      mote::addBox(*Models.models[model].box, {0, 0, 0}, "pp pp pp", output);
    if (model < Times.size())
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), Times[model]);
  }
  catch (const mote::FileError& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 1; // a failed request would leave old data downstream
  }
  makeRadiusScalar(output->GetPointData());
  return 1;
}

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makePDBReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<CheckedPDBReader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

} // namespace mote
