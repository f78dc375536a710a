#include "vtkMoteDataWriter.h"

#include "FileEnding.h"
#include "MessageCatcher.h"
#include "XMLNames.h"
#include "XYZText.h"

#include "kernels/core/AtomicFile.h"
#include "kernels/core/Error.h"

#include "vtkAppendFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <vector>
#include <zlib.h>

namespace
{

std::optional<double> timeOf(vtkDataObject* data)
{
  vtkInformation* information = data->GetInformation();
  if (information && information->Has(vtkDataObject::DATA_TIME_STEP()))
    return information->Get(vtkDataObject::DATA_TIME_STEP());
  return {};
}

/// The text as a member of a gzip file; those one after the other are one text.
std::string gzipped(const std::string& text)
{
  z_stream stream{};
  constexpr int gzip = 16; // in place of zlib's own header
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + gzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// Any cells as those of an unstructured grid.
vtkSmartPointer<vtkDataSet> asGrid(vtkDataSet* data)
{
  if (vtkUnstructuredGrid::SafeDownCast(data))
    return data;
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  if (!vtkPointSet::SafeDownCast(data)) // whose coordinates are computed in double
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  vtkSmartPointer<vtkDataSet> grid = append->GetOutput();
  grid->GetFieldData()->ShallowCopy(data->GetFieldData());
  return grid;
}

/// Gives arrays with <, & or quotes in their names copies with these encoded: VTK writes names as
/// they are, and decodes them when it reads.
void encodeNames(vtkFieldData* arrays)
{
  std::vector<vtkSmartPointer<vtkAbstractArray>> all;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    all.emplace_back(arrays->GetAbstractArray(i));
  for (const auto& array : all)
  {
    const std::string name = array->GetName() ? array->GetName() : "";
    const std::string encoded = mote::xmlEncoded(name);
    if (encoded == name)
      continue;
    vtkSmartPointer<vtkAbstractArray> copy;
    copy.TakeReference(array->NewInstance());
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
      vtkDataArray::SafeDownCast(copy)->ShallowCopy(numbers);
    else
      copy->DeepCopy(array);
    copy->SetName(encoded.c_str());
    arrays->RemoveArray(name.c_str());
    arrays->AddArray(copy);
  }
}

/// The data as VTK's XML files want them: with the time as an array of fields, and with points and
/// cells even if these are none.
vtkSmartPointer<vtkDataSet> completed(vtkDataSet* data, std::optional<double> time)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->ShallowCopy(data);
  if (time && !copy->GetFieldData()->HasArray("TimeValue"))
  {
    vtkNew<vtkDoubleArray> value;
    value->SetName("TimeValue");
    value->InsertNextValue(*time);
    copy->GetFieldData()->AddArray(value);
  }
  encodeNames(copy->GetFieldData());
  encodeNames(copy->GetPointData());
  encodeNames(copy->GetCellData());
  if (auto* set = vtkPointSet::SafeDownCast(copy); set && !set->GetPoints())
  {
    vtkNew<vtkPoints> none;
    set->SetPoints(none);
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(copy); grid && !grid->GetCells())
  {
    vtkNew<vtkCellArray> none;
    grid->SetCells(VTK_VERTEX, none);
  }
  return copy;
}

} // namespace

vtkStandardNewMacro(vtkMoteDataWriter);

vtkMoteDataWriter::vtkMoteDataWriter() = default;

vtkMoteDataWriter::~vtkMoteDataWriter() = default;

std::string vtkMoteDataWriter::EndingOf(const std::string& fileName)
{
  return mote::endingAmong(fileName, {".vtp", ".vtu", ".xyz", ".xyz.gz"});
}

int vtkMoteDataWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

bool vtkMoteDataWriter::WriteFile()
{
  const std::string name = this->FileName;
  const std::string ending = vtkMoteDataWriter::EndingOf(name);
  if (ending.empty())
    throw mote::Error("the name must end in .vtp, .vtu, .xyz or .xyz.gz.");
  if (this->GetNumberOfInputConnections(0) == 0)
    throw mote::Error("there are no data to write.");
  this->GetInputAlgorithm()->Update();
  auto* data = vtkDataSet::SafeDownCast(this->GetInput());
  if (!data)
    throw mote::Error("there are no data to write.");
  auto* points = vtkPointSet::SafeDownCast(data);
  const bool isXYZ = ending.compare(0, 4, ".xyz") == 0;
  if (isXYZ && !points)
    throw mote::Error("an XYZ file holds points, which a " + std::string(data->GetClassName()) +
                      " has not of its own.");
  if (ending == ".vtp" && !vtkPolyData::SafeDownCast(data))
    throw mote::Error(
      "a .vtp file holds points, lines and polygons; other cells go into a .vtu file.");
  mote::AtomicFile file(name);
  const bool isComplete =
    isXYZ ? this->WriteXYZ(points, ending == ".xyz.gz", file) : this->WriteXML(data, ending, file);
  if (isComplete)
    file.commit();
  return isComplete;
}

bool vtkMoteDataWriter::WriteXML(
  vtkDataSet* data, const std::string& ending, mote::AtomicFile& file)
{
  vtkSmartPointer<vtkXMLWriter> writer;
  if (ending == ".vtp")
    writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  else
    writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  writer->SetInputData(completed(ending == ".vtp" ? data : asGrid(data).Get(), timeOf(data)));
  writer->SetFileName(file.openName().c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  vtkNew<vtkCallbackCommand> relay;
  relay->SetClientData(this);
  relay->SetCallback(
    [](vtkObject* caller, unsigned long, void* self, void*)
    {
      auto* inner = vtkAlgorithm::SafeDownCast(caller);
      auto* outer = static_cast<vtkMoteDataWriter*>(self);
      outer->UpdateProgress(inner->GetProgress());
      inner->SetAbortExecute(outer->GetAbortExecute());
    });
  writer->AddObserver(vtkCommand::ProgressEvent, relay);
  std::string problem;
  bool isWritten = false;
  {
    const mote::MessageCatcher messages(writer); // which name the file by the name above
    isWritten = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
    problem = messages.firstError();
  }
  if (this->GetAbortExecute())
    return false;
  if (isWritten && problem.empty())
    return true;
  // What the system says to more at its end is why VTK could not write, mostly.
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(file.openName(), ignored);
  const std::array<char, 4096> more{};
  file.rewrite(ignored ? 0 : size, more.data(), more.size());
  if (writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError)
    throw mote::WriteError(mote::WriteError::Kind::NoSpace,
      "Cannot write \"" + std::string(this->FileName) + "\": there is no more space for it.");
  throw mote::Error(problem.empty() ? "VTK could not write it." : problem);
}

bool vtkMoteDataWriter::WriteXYZ(vtkPointSet* points, bool isCompressed, mote::AtomicFile& file)
{
  const mote::XYZText rows(points, timeOf(points));
  if (!rows.leftOut().empty())
    vtkWarningMacro(<< "\"" << this->FileName
                    << "\" is without the arrays that no column can hold: " << rows.leftOut()
                    << ".");
  const auto goesOn = this->ProgressOfWrite();
  const std::string head = isCompressed ? gzipped(rows.head()) : rows.head();
  file.write(head.data(), head.size());
  const vtkIdType count = points->GetNumberOfPoints(), perBlock = 16384;
  std::vector<std::string> blocks(
    static_cast<std::size_t>(4 * tbb::this_task_arena::max_concurrency()));
  const auto atOnce = static_cast<vtkIdType>(blocks.size()) * perBlock;
  for (vtkIdType begin = 0; begin < count; begin += atOnce)
  {
    tbb::parallel_for(std::size_t{0}, blocks.size(),
      [&](std::size_t i)
      {
        const vtkIdType from = begin + static_cast<vtkIdType>(i) * perBlock;
        blocks[i].clear();
        rows.append(blocks[i], std::min(from, count), std::min(from + perBlock, count));
        if (isCompressed && !blocks[i].empty())
          blocks[i] = gzipped(blocks[i]);
      });
    for (const std::string& block : blocks)
      file.write(block.data(), block.size());
    if (!goesOn(std::min(1.0, static_cast<double>(begin + atOnce) / static_cast<double>(count))))
      return false;
  }
  return true;
}

void vtkMoteDataWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
