#include "KeptData.h"

#include "Blocks.h"

#include <vtkDataObject.h>
#include <vtkTrivialProducer.h>

#include <map>
#include <mutex>

namespace mote::app
{

namespace
{

const std::string prefix = "memory:";

std::mutex guard; ///< of both, which threads that read ahead ask, too
std::map<std::string, vtkSmartPointer<vtkDataObject>> kept;
int count = 0;

} // namespace

KeptData::~KeptData()
{
  const std::lock_guard lock(guard);
  for (const std::string& file : files_)
    kept.erase(file);
}

std::string KeptData::keep(const std::string& name, vtkDataObject* data)
{
  const std::lock_guard lock(guard);
  files_.push_back(prefix + std::to_string(++count) + ":" + name);
  kept[files_.back()] = data;
  return files_.back();
}

bool isKeptData(const std::string& file)
{
  const std::lock_guard lock(guard);
  return kept.count(file) > 0;
}

std::string nameOfKept(const std::string& file)
{
  return file.substr(file.find(':', prefix.size()) + 1);
}

vtkSmartPointer<vtkAlgorithm> producerOfKept(const std::string& file)
{
  const std::lock_guard lock(guard);
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(sharingCopy(kept.at(file)));
  return producer;
}

} // namespace mote::app
