#include "VTKHDFReader.h"

#include "FileError.h"
#include "TextFile.h"
#include "TimeSteps.h"
#include "VTKHDFFile.h"

#include "vtkDataObject.h"
#include "vtkDataObjectAlgorithm.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <memory>
#include <new>

namespace
{

class vtkMoteVTKHDFReader : public vtkDataObjectAlgorithm
{
public:
  static vtkMoteVTKHDFReader* New();
  vtkTypeMacro(vtkMoteVTKHDFReader, vtkDataObjectAlgorithm);

  std::string Path;

protected:
  vtkMoteVTKHDFReader() { this->SetNumberOfInputPorts(0); }

  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (!this->Attempt([this] { this->Open(); }))
      return 0;
    vtkInformation* information = outputs->GetInformationObject(0);
    vtkDataObject* output = vtkDataObject::GetData(information);
    if (!output || output->GetDataObjectType() != this->File->dataType())
    {
      vtkSmartPointer<vtkDataObject> made;
      made.TakeReference(vtkDataObjectTypes::NewDataObject(this->File->dataType()));
      information->Set(vtkDataObject::DATA_OBJECT(), made);
    }
    return 1;
  }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    mote::offerTimeSteps(information, {});
    const bool isOpen = this->Attempt(
      [&]
      {
        this->Open();
        if (this->File->dataType() != VTK_IMAGE_DATA)
          return mote::offerPieces(information);
        information->Set(
          vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->File->extent().data(), 6);
      });
    if (!isOpen)
      return 1;
    std::vector<double> times;
    for (const Step& step : this->Steps)
      times.push_back(step.time);
    mote::offerTimeSteps(information, times);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    vtkDataObject* output = vtkDataObject::GetData(information);
    output->Initialize();
    this->Attempt(
      [&]
      {
        this->Open();
        const Step step =
          this->Steps.empty() ? Step() : mote::requestedStep(information, this->Steps, &Step::time);
        const auto data = this->File->read(step.number, mote::requestedPiece(information),
          [this](double share)
          {
            this->UpdateProgress(share);
            return this->GetAbortExecute() == 0;
          });
        output->ShallowCopy(data);
        if (!this->Steps.empty())
          output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.time);
      });
    return 1;
  }

private:
  struct Step
  {
    double time = 0;
    std::size_t number = 0; ///< in the file
  };

  /// Opens the file where it is another one by now.
  void Open()
  {
    const mote::FileStamp stamp = mote::stampOf(this->Path);
    if (this->File && stamp == this->Stamp)
      return;
    this->File.reset();
    this->Steps.clear();
    this->File = std::make_unique<mote::VTKHDFFile>(this->Path);
    this->Stamp = stamp;
    for (const double time : this->File->times())
      this->Steps.push_back({time, this->Steps.size()});
    std::stable_sort(this->Steps.begin(), this->Steps.end(),
      [](const Step& a, const Step& b) { return a.time < b.time; });
  }

  template <typename Work>
  bool Attempt(const Work& work)
  {
    std::string problem;
    try
    {
      work();
      return true;
    }
    catch (const mote::FileError& error)
    {
      problem = error.what();
    }
    catch (const std::bad_alloc&)
    {
      problem = this->Path + ": there is not enough memory for it";
    }
    vtkErrorMacro(<< problem);
    return false;
  }

  std::unique_ptr<mote::VTKHDFFile> File;
  mote::FileStamp Stamp;
  std::vector<Step> Steps;
};

vtkStandardNewMacro(vtkMoteVTKHDFReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeVTKHDFReader(const std::string& fileName)
{
  VTKHDFFile check(fileName);
  auto reader = vtkSmartPointer<vtkMoteVTKHDFReader>::New();
  reader->Path = fileName;
  return reader;
}

} // namespace mote
