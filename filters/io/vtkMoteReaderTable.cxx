#include "vtkMoteReaderTable.h"

#include "CaseFolder.h"
#include "DataSetMismatch.h"
#include "FileError.h"
#include "MessageCatcher.h"
#include "PumpInput.h"
#include "ReaderFormats.h"
#include "TextFile.h"
#include "vtkMoteCollectionReader.h"
#include "vtkMoteFileSeriesReader.h"
#include "vtkMotePolyDataReader.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <set>

vtkStandardNewMacro(vtkMoteReaderTable);
vtkInformationKeyMacro(vtkMoteReaderTable, FILE_NAME, String);

namespace
{

/// The format of a readable file. Throws FileError for others.
const mote::ReaderFormat& requireFormat(const std::string& path)
{
  if (path.empty())
    throw mote::FileError(mote::FileError::Kind::NotFound, "reader", "no file name was given");
  if (const mote::ReaderFormat* format = mote::pumpFormat(path))
    return *format;
  if (const mote::ReaderFormat* format = mote::generatedFormat(path))
    return *format;
  const std::string beginning = mote::readBeginning(mote::fileOfFolder(path), 4096);
  if (const mote::ReaderFormat* format = mote::formatOf(path, beginning))
    return *format;
  using Kind = mote::FileError::Kind;
  throw mote::FileError(Kind::OtherFormat, path,
    "no reader knows this file; known extensions are " + vtkMoteReaderTable::GetExtensions());
}

/// Where the last number in a file's own name is: [first, second).
std::pair<std::size_t, std::size_t> lastNumber(const std::string& path)
{
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const std::size_t slash = path.rfind('/');
  const std::size_t begin = slash == path.npos ? 0 : slash + 1;
  std::size_t last = path.size();
  while (last > begin && !isDigit(path[last - 1]))
    --last;
  std::size_t first = last;
  while (first > begin && isDigit(path[first - 1]))
    --first;
  return {first, last};
}

/// A number's digits in a form whose alphabetic order is that of the numbers.
std::pair<std::size_t, std::string> orderOf(const std::string& path)
{
  const auto [first, last] = lastNumber(path);
  std::string digits = path.substr(first, last - first);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  return {digits.size(), digits};
}

bool hasContent(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
    return composite->GetNumberOfPoints() > 0;
  if (auto* set = vtkDataSet::SafeDownCast(data))
    return set->GetNumberOfPoints() > 0;
  auto* table = vtkTable::SafeDownCast(data);
  return data && (!table || table->GetNumberOfRows() > 0);
}

std::string fileOf(vtkAlgorithm* reader)
{
  const char* name = reader->GetInformation()->Get(vtkMoteReaderTable::FILE_NAME());
  return name ? name : "";
}

/// Adds the file's name to what a reader of VTK said, unless that names it already.
std::string withFile(vtkAlgorithm* reader, const std::string& message)
{
  const std::string file = fileOf(reader);
  return message.find(file) != std::string::npos ? message : file + ": " + message;
}

/// Runs an update and gives what went wrong as one sentence, or nothing.
template <class Update>
std::string runQuietly(vtkAlgorithm* reader, const Update& update, std::string* warnings)
{
  mote::MessageCatcher catcher(reader);
  try
  {
    update();
  }
  catch (const std::bad_alloc&)
  {
    return withFile(reader, "there is not enough memory for it");
  }
  catch (const std::exception& error)
  {
    return withFile(reader, std::string("reading failed (") + error.what() + ")");
  }
  std::set<std::string> told; // readers repeat themselves
  for (const std::string& warning : catcher.warnings())
    if (warnings && told.insert(warning).second)
      *warnings += (warnings->empty() ? "" : "\n") + warning;
  if (auto* own = vtkMotePolyDataReader::SafeDownCast(reader))
    return own->GetLastErrorMessage();
  auto* series = vtkMoteFileSeriesReader::SafeDownCast(reader);
  if (series && !series->GetLastErrorMessage().empty())
    return series->GetLastErrorMessage();
  const std::string error = catcher.firstError();
  return error.empty() ? error : withFile(reader, error);
}

template <class Update>
vtkSmartPointer<vtkDataObject> readWith(
  vtkAlgorithm* reader, const Update& update, std::string& error, std::string* warnings)
{
  if (!reader)
  {
    error = "there is no reader to read with";
    return nullptr;
  }
  error = runQuietly(reader, update, warnings);
  vtkDataObject* data = error.empty() ? reader->GetOutputDataObject(0) : nullptr;
  // Readers of our own leave nothing to check, those of series have their files checked one by one.
  if (!data || vtkMotePolyDataReader::SafeDownCast(reader) ||
      vtkMoteFileSeriesReader::SafeDownCast(reader) ||
      vtkMoteCollectionReader::SafeDownCast(reader))
    return data;
  const std::string damage =
    hasContent(data) ? mote::mismatchOf(data) : "the file has no points, or is damaged";
  if (!damage.empty())
  {
    error = withFile(reader, damage);
    data = nullptr;
  }
  return data;
}

} // namespace

vtkSmartPointer<vtkAlgorithm> vtkMoteReaderTable::MakeReader(
  const std::vector<std::string>& fileNames, std::string& error)
{
  error.clear();
  try
  {
    if (fileNames.empty())
      requireFormat("");
    const mote::ReaderFormat& format = requireFormat(fileNames.front());
    for (const std::string& name : fileNames)
    {
      if (&requireFormat(name) != &format)
      {
        throw mote::FileError(mote::FileError::Kind::OtherFormat, name,
          "the files of a series must have one format, and this is no " +
            std::string(format.description));
      }
    }
    if (fileNames.size() > 1 && !format.series)
    {
      throw mote::FileError(mote::FileError::Kind::OtherFormat, fileNames[1],
        "several files of this format (" + std::string(format.description) +
          ") make no series; read them one by one");
    }
    vtkSmartPointer<vtkAlgorithm> reader = format.make(fileNames);
    reader->GetInformation()->Set(FILE_NAME(), fileNames.front());
    return reader;
  }
  catch (const mote::FileError& reason)
  {
    error = reason.what();
    return nullptr;
  }
}

vtkSmartPointer<vtkAlgorithm> vtkMoteReaderTable::MakeReader(
  const std::string& fileName, std::string& error)
{
  return MakeReader(std::vector<std::string>{fileName}, error);
}

vtkAlgorithm* vtkMoteReaderTable::NewReader(const std::string& fileName)
{
  std::string error;
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(fileName, error);
  if (!reader)
  {
    vtkErrorWithObjectMacro(nullptr, << error);
    return nullptr;
  }
  reader->Register(nullptr); // the caller's reference
  return reader;
}

std::string vtkMoteReaderTable::CheckFile(const std::string& fileName)
{
  try
  {
    if (const auto check = requireFormat(fileName).check)
      check(fileName);
    return {};
  }
  catch (const mote::FileError& reason)
  {
    return reason.what();
  }
}

bool vtkMoteReaderTable::NameTells(const std::string& fileName)
{
  const mote::ReaderFormat* format = mote::formatOf(fileName, "");
  return format && !format->check;
}

vtkSmartPointer<vtkDataObject> vtkMoteReaderTable::Read(
  vtkAlgorithm* reader, std::string& error, std::string* warnings)
{
  return readWith(
    reader, [&] { reader->Update(); }, error, warnings);
}

vtkSmartPointer<vtkDataObject> vtkMoteReaderTable::Read(
  vtkAlgorithm* reader, double time, std::string& error, std::string* warnings)
{
  const auto update = [&]
  {
    reader->UpdateInformation();
    reader->UpdateTimeStep(time);
  };
  return readWith(reader, update, error, warnings);
}

vtkDataObject* vtkMoteReaderTable::ReadFile(const std::string& fileName)
{
  std::string error;
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(fileName, error);
  vtkSmartPointer<vtkDataObject> data = reader ? Read(reader, error) : nullptr;
  if (!data)
  {
    vtkErrorWithObjectMacro(nullptr, << error);
    return nullptr;
  }
  data->Register(nullptr); // the caller's reference
  return data;
}

std::vector<double> vtkMoteReaderTable::GetTimeSteps(vtkAlgorithm* reader, std::string& error)
{
  if (!reader)
  {
    error = "there is no reader to ask for time steps";
    return {};
  }
  error = runQuietly(
    reader, [&] { reader->UpdateInformation(); }, nullptr);
  vtkInformation* information = reader->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!error.empty() || !information || !information->Has(key))
    return {};
  const double* times = information->Get(key);
  return std::vector<double>(times, times + information->Length(key));
}

std::vector<std::vector<std::string>> vtkMoteReaderTable::GroupSeries(
  const std::vector<std::string>& fileNames)
{
  std::vector<std::vector<std::string>> groups;
  std::vector<std::string> patterns; // of the groups; empty for those that take no more files
  for (const std::string& name : fileNames)
  {
    const auto [first, last] = lastNumber(name);
    std::string pattern;
    if (first < last && mote::isSeriesFile(name))
      pattern = name.substr(0, first) + '*' + name.substr(last);
    const auto known = std::find(patterns.begin(), patterns.end(), pattern);
    if (pattern.empty() || known == patterns.end())
    {
      patterns.push_back(pattern);
      groups.push_back({name});
    }
    else
    {
      groups[known - patterns.begin()].push_back(name);
    }
  }
  for (std::vector<std::string>& group : groups)
  {
    std::stable_sort(group.begin(), group.end(),
      [](const std::string& a, const std::string& b) { return orderOf(a) < orderOf(b); });
  }
  return groups;
}

std::string vtkMoteReaderTable::GetExtensions()
{
  std::string list;
  for (const mote::ReaderFormat& format : mote::readerFormats())
    for (const char* extension : format.extensions)
      list.append(list.empty() ? "" : " ").append(extension);
  return list;
}

std::string vtkMoteReaderTable::GetFormatsHelp()
{
  std::string text;
  for (const mote::ReaderFormat& format : mote::readerFormats())
  {
    std::string line = " ";
    for (const char* extension : format.extensions)
      line += ' ' + std::string(extension);
    const std::size_t width = 32;
    if (line.size() + 2 > width)
    {
      text += line + '\n'; // the description goes below
      line.clear();
    }
    line.resize(width, ' ');
    text += line + format.description + (format.series ? ", a file or a series\n" : "\n");
  }
  return text +
         "  pump:SCALE  pump:SCALE:PART     a synthetic pump of hexahedra, no file: 6.45 million "
         "at "
         "scale 1\n"
         "  lattice:N  random:N:R  varied:N\n" +
         std::string(32, ' ') + "synthetic particles, no file: N of them, of radius R\n" +
         "  sphere:N  subdivide:FILE:N      about N synthetic triangles, no file; FILE cut finer\n";
}

void vtkMoteReaderTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Formats:\n" << GetFormatsHelp();
}
