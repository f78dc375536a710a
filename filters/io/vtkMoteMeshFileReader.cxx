#include "vtkMoteMeshFileReader.h"

#include "FileArrays.h"
#include "OpenMoteFile.h"
#include "TimeSteps.h"

#include "kernels/meshes/RlodTreeFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMoteMeshFilePoints.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkMoteMeshFileReader);

vtkMoteMeshFileReader::vtkMoteMeshFileReader() = default;
vtkMoteMeshFileReader::~vtkMoteMeshFileReader() = default;

int vtkMoteMeshFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  this->File = nullptr;
  const bool opened = this->Attempt(
    [this](const ProgressFunction&)
    {
      this->RequireFileName();
      this->File = mote::openMoteFile<mote::RlodTreeFile>(this->GetFileName());
    });
  if (opened && this->File->time())
    mote::offerTimeSteps(information, {*this->File->time()});
  return 1;
}

int vtkMoteMeshFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  const auto& file = this->File;
  if (!file)
    return 1; // the error has been reported
  vtkNew<vtkPolyData> result;
  vtkNew<vtkMoteMeshFilePoints> points;
  points->SetFile(file);
  result->SetPoints(points);
  const mote::ArrayView corners(
    file->corners()->data(), mote::ArrayView::Type::Int32, 3 * file->size(), 1);
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(vtkSmartPointer<vtkDataArray>::Take(mote::newArrayOf(file->offsets(), file)),
    vtkSmartPointer<vtkDataArray>::Take(mote::newArrayOf(corners, file)));
  result->SetPolys(triangles);
  const auto add = [&](vtkFieldData* to, const std::vector<mote::FileArray>& arrays)
  {
    for (const mote::FileArray& array : arrays)
      to->AddArray(vtkSmartPointer<vtkDataArray>::Take(mote::newArrayOf(array, file)));
  };
  add(result->GetPointData(), file->points());
  add(result->GetCellData(), file->cells());
  add(result->GetFieldData(), file->facts());
  if (!file->normals().empty())
    result->GetPointData()->SetActiveNormals(file->normals().c_str());
  if (file->time())
    DeliverStep(result, *file->time(), output);
  else
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteMeshFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Triangles: " << (this->File ? this->File->size() : 0) << "\n";
}
