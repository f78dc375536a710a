#include "vtkMoteDelimitedPointsReader.h"

#include "FileError.h"
#include "PointTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

namespace
{

using mote::FileError;

void requireText(const std::string& path)
{
  if (mote::readBeginning(path, 4096).find('\0') != std::string::npos)
    throw FileError(
      FileError::Kind::OtherFormat, path, "this is a binary file, not a table of text");
}

} // namespace

vtkStandardNewMacro(vtkMoteDelimitedPointsReader);

vtkMoteDelimitedPointsReader::vtkMoteDelimitedPointsReader() = default;
vtkMoteDelimitedPointsReader::~vtkMoteDelimitedPointsReader() = default;

int vtkMoteDelimitedPointsReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  mote::offerPieces(outputVector->GetInformationObject(0));
  return 1;
}

int vtkMoteDelimitedPointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  vtkNew<vtkPolyData> result;
  const bool good = this->Attempt(
    [&](const ProgressFunction& progress)
    {
      this->RequireFileName();
      requireText(this->GetFileName());
      mote::TextCursor cursor(this->GetFileName(), mote::TextCursor::OpenEnd::Accept);
      mote::PointRows rows = mote::readTableHead(cursor);
      rows.space = this->GetScratchSpace();
      rows.rows = mote::countRows(cursor, rows.format);
      rows.piece = mote::requestedPiece(outputVector->GetInformationObject(0));
      mote::readPointRows(cursor, std::move(rows), progress, result);
    });
  if (good)
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteDelimitedPointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
