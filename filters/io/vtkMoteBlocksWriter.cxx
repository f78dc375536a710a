#include "vtkMoteBlocksWriter.h"

#include "FileEnding.h"
#include "PieceFiles.h"
#include "XMLNames.h"

#include "kernels/core/AtomicFile.h"
#include "kernels/core/Error.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

namespace
{

using Block = std::pair<std::string, vtkDataSet*>;

std::vector<Block> blocksOf(vtkMultiBlockDataSet* data)
{
  std::vector<Block> blocks;
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(data->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* set = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    if (!set || set->GetNumberOfPoints() == 0)
      continue;
    const char* name = it->HasCurrentMetaData()
                         ? it->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
                         : nullptr;
    blocks.emplace_back(name ? name : "", set);
  }
  return blocks;
}

std::string indexOf(const std::vector<Block>& blocks, const std::vector<std::string>& files)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" "
                     "version=\"1.0\" header_type=\"UInt64\">\n  <vtkMultiBlockDataSet>\n";
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    text += "    <DataSet index=\"" + std::to_string(i) + '"';
    if (!blocks[i].first.empty())
      text += " name=\"" + mote::xmlEncoded(blocks[i].first) + '"';
    text += " file=\"" + mote::xmlEncoded(files[i]) + "\"/>\n";
  }
  return text + "  </vtkMultiBlockDataSet>\n</VTKFile>\n";
}

} // namespace

vtkStandardNewMacro(vtkMoteBlocksWriter);

vtkMoteBlocksWriter::vtkMoteBlocksWriter() = default;

vtkMoteBlocksWriter::~vtkMoteBlocksWriter() = default;

std::string vtkMoteBlocksWriter::EndingOf(const std::string& fileName)
{
  return mote::endingAmong(fileName, {".vtm"});
}

int vtkMoteBlocksWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  return 1;
}

bool vtkMoteBlocksWriter::WriteFile()
{
  if (vtkMoteBlocksWriter::EndingOf(this->FileName).empty())
    throw mote::Error("the name must end in .vtm.");
  if (this->GetNumberOfInputConnections(0) == 0)
    throw mote::Error("there are no data to write.");
  this->GetInputAlgorithm()->Update();
  auto* data = vtkMultiBlockDataSet::SafeDownCast(this->GetInput());
  const std::vector<Block> blocks = data ? blocksOf(data) : std::vector<Block>();
  if (blocks.empty())
    throw mote::Error("there are no data to write.");
  mote::PieceFiles files(this->FileName);
  mote::AtomicFile index(this->FileName);
  const double share = 1.0 / static_cast<double>(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (!files.write(this, blocks[i].second, blocks[i].second->IsA("vtkPolyData") ? ".vtp" : ".vtu",
          static_cast<double>(i) * share, share))
      return false;
  const std::string text = indexOf(blocks, files.names());
  files.commit();
  index.write(text.data(), text.size());
  index.commit();
  return true;
}

void vtkMoteBlocksWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
