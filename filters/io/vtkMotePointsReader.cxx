#include "vtkMotePointsReader.h"

#include "FileError.h"
#include "PointRows.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMotePointsReader);

vtkMotePointsReader::vtkMotePointsReader() = default;
vtkMotePointsReader::~vtkMotePointsReader() = default;

int vtkMotePointsReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  mote::offerPieces(outputVector->GetInformationObject(0));
  return 1;
}

int vtkMotePointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  vtkNew<vtkPolyData> result;
  const bool good = this->Attempt(
    [&](const ProgressFunction& progress)
    {
      this->RequireFileName();
      mote::TextCursor cursor(this->GetFileName(), mote::TextCursor::OpenEnd::Accept);
      mote::PointRows rows;
      rows.place = cursor.place();
      rows.space = this->GetScratchSpace();
      rows.columns = {"x", "y", "z"};
      rows.coordinates = {0, 1, 2};
      rows.types.assign(3, mote::ColumnType::Float64);
      rows.rows = mote::countRows(cursor);
      rows.piece = mote::requestedPiece(outputVector->GetInformationObject(0));
      if (rows.rows == 0)
        throw mote::FileError(
          mote::FileError::Kind::Truncated, this->GetFileName(), "the file is empty");
      mote::readPointRows(cursor, std::move(rows), progress, result);
    });
  if (good)
    output->ShallowCopy(result);
  return 1;
}

void vtkMotePointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
