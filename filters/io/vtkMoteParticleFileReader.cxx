#include "vtkMoteParticleFileReader.h"

#include "OpenMoteFile.h"
#include "Piece.h"
#include "TimeSteps.h"

#include "kernels/core/Vec.h"
#include "kernels/particles/ParticleSource.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMoteParticleFilePoints.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{

using Array = vtkSmartPointer<vtkDataArray>;

/// Some tuples of an array of the file, in memory.
Array tuplesOf(vtkDataArray* all, vtkIdType first, vtkIdType count)
{
  const auto some = Array::Take(vtkDataArray::CreateDataArray(all->GetDataType()));
  some->SetName(all->GetName());
  some->SetNumberOfComponents(all->GetNumberOfComponents());
  some->CopyComponentNames(all);
  some->SetNumberOfTuples(count);
  some->InsertTuples(0, count, first, all);
  return some;
}

/// The radii of some particles; an array of one value each.
Array radiiOf(const mote::ParticleSource& particles, std::size_t first, std::size_t count)
{
  const auto radii = vtkSmartPointer<vtkDoubleArray>::New();
  radii->SetName("radius");
  radii->SetNumberOfValues(static_cast<vtkIdType>(count));
  double* const values = radii->GetPointer(0);
  particles.radii(first, first + count, values);
  std::for_each(values, values + count, [&](double& value) { value *= particles.radius(); });
  return radii;
}

/// What one of several processes gets: particles that stand beside one another in the file, and
/// about in space too, since the file has the order of its tree.
void readPiece(const mote::PkdTreeFile& file, const mote::Piece& piece, vtkPolyData* result)
{
  const auto particles = file.particles();
  const std::size_t first = piece.first(particles->count());
  const std::size_t count = piece.size(particles->count());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  static_assert(sizeof(mote::Vec3d) == 3 * sizeof(double));
  particles->positions(first, first + count, static_cast<mote::Vec3d*>(points->GetVoidPointer(0)));
  result->SetPoints(points);
  for (int i = 0; i < result->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* whole = result->GetPointData()->GetArray(i);
    result->GetPointData()->AddArray(
      tuplesOf(whole, static_cast<vtkIdType>(first), static_cast<vtkIdType>(count)));
  }
  if (!result->GetPointData()->HasArray("radius"))
    result->GetPointData()->AddArray(radiiOf(*particles, first, count));
}

} // namespace

vtkStandardNewMacro(vtkMoteParticleFileReader);

vtkMoteParticleFileReader::vtkMoteParticleFileReader() = default;
vtkMoteParticleFileReader::~vtkMoteParticleFileReader() = default;

bool vtkMoteParticleFileReader::Open()
{
  this->File = nullptr;
  return this->Attempt(
    [this](const ProgressFunction&)
    {
      this->RequireFileName();
      this->File = mote::openMoteFile<mote::PkdTreeFile>(this->GetFileName());
    });
}

int vtkMoteParticleFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  mote::offerPieces(information);
  if (this->Open() && this->File->time())
    mote::offerTimeSteps(information, {*this->File->time()});
  return 1;
}

int vtkMoteParticleFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  if (!this->File)
    return 1; // the error has been reported
  vtkNew<vtkPolyData> result;
  vtkNew<vtkMoteParticleFilePoints> points;
  points->SetFile(this->File);
  result->SetPoints(points);
  const auto add = [this](vtkFieldData* to, std::size_t count, bool ofWhole)
  {
    for (std::size_t i = 0; i < count; ++i)
      to->AddArray(vtkSmartPointer<vtkDataArray>::Take(
        vtkMoteParticleFilePoints::NewArray(this->File, i, ofWhole)));
  };
  add(result->GetPointData(), this->File->arrays().size(), false);
  add(result->GetFieldData(), this->File->facts().size(), true);
  const mote::Piece piece = mote::requestedPiece(outputVector->GetInformationObject(0));
  if (!piece.isAll())
    readPiece(*this->File, piece, result);
  if (this->File->time())
    DeliverStep(result, *this->File->time(), output);
  else
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteParticleFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Particles: " << (this->File ? this->File->size() : 0) << "\n";
}
