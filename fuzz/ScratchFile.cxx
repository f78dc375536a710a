#include "ScratchFile.h"

#include "vtkMoteLinearCells.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

ScratchFile::ScratchFile(const std::string& ending)
{
  char folder[] = "/dev/shm/mote-fuzz-XXXXXX";
  if (!mkdtemp(folder))
    std::abort();
  folder_ = folder;
  path_ = folder_ + "/input" + ending;
}

ScratchFile::~ScratchFile()
{
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
}

void ScratchFile::write(const std::uint8_t* bytes, std::size_t size)
{
  std::FILE* file = std::fopen(path_.c_str(), "wb");
  if (!file || std::fwrite(bytes, 1, size, file) != size || std::fclose(file) != 0)
    std::abort();
}

namespace
{

void check(bool isRead, const std::string& error)
{
  if (isRead == error.empty() && error.find('\n') == std::string::npos)
    return;
  std::fprintf(stderr, "%s, and the message is '%s'\n",
    isRead ? "data were read" : "nothing was read", error.c_str());
  std::abort();
}

/// As the program takes what it has read.
void takeCells(vtkDataObject* data)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
    vtkSmartPointer<vtkDataSet>::Take(vtkMoteLinearCells::Of(set, 1 << 26));
}

} // namespace

void readAsUsersDo(const std::string& path)
{
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(path, error);
  check(reader != nullptr, error);
  if (!reader)
    return;
  const auto steps = vtkMoteReaderTable::GetTimeSteps(reader, error);
  if (!error.empty())
    return check(false, error);
  // Damage of one step leaves the others.
  const auto data = vtkMoteReaderTable::Read(reader, error);
  check(data != nullptr, error);
  takeCells(data);
  if (steps.size() < 2)
    return;
  for (const double step : {steps.back(), steps.front()})
  {
    error.clear();
    const auto other = vtkMoteReaderTable::Read(reader, step, error);
    check(other != nullptr, error);
  }
}
