#include "FileCollection.h"

#include "FileError.h"
#include "TextFile.h"
#include "XMLCheck.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <vtksys/SystemTools.hxx>

namespace mote
{

namespace
{

/// A file with its time, as the collection says it.
struct Entry
{
  double time = 0.0;
  CollectedFile file;
};

[[noreturn]] void failAs(const std::string& path, const std::string& sentence)
{
  throw FileError(FileError::Kind::Malformed, path, sentence);
}

std::string besideOf(const std::string& collection, std::string name)
{
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path file(name);
  return file.is_absolute()
           ? name
           : (std::filesystem::path(collection).parent_path() / file).lexically_normal().string();
}

void add(const std::string& collection, double time, const std::string& file,
  const std::string& name, std::vector<Entry>& entries)
{
  if (file.empty())
    failAs(collection, "an entry of this collection names no file");
  if (!std::isfinite(time))
    failAs(collection, "the time of '" + file + "' is no number");
  const std::string ending = vtksys::SystemTools::LowerCase(file);
  if (ending.ends_with(".pvd") || ending.ends_with(".series"))
    failAs(collection, "'" + file + "' is a collection within a collection, which is not read");
  entries.push_back({time, {besideOf(collection, file), name}});
}

std::string attributeOf(vtkXMLDataElement* element, const char* name)
{
  const char* value = element->GetAttribute(name);
  return value ? value : "";
}

/// The entries of <VTKFile type="Collection"><Collection><DataSet .../>.
std::vector<Entry> entriesOfXML(const std::string& path)
{
  checkXMLDepth(path);
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
    failAs(path, "this is no whole collection of VTK files");
  std::vector<Entry> entries;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* one = collection->GetNestedElement(i);
    if (attributeOf(one, "file").empty() && std::string(one->GetName()) != "DataSet")
      continue;
    double time = 0.0;
    const std::string text = attributeOf(one, "timestep");
    if (!text.empty() && !one->GetScalarAttribute("timestep", time))
      failAs(path, "the time '" + text + "' is no number");
    const std::string part = attributeOf(one, "part");
    const std::string name = attributeOf(one, "name");
    add(path, time, attributeOf(one, "file"),
      !name.empty()  ? name
      : part.empty() ? ""
                     : "part " + part,
      entries);
  }
  return entries;
}

/// The entries of {"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]}.
std::vector<Entry> entriesOfJSON(const std::string& path)
{
  using Json = nlohmann::json;
  std::ifstream file(path, std::ios::binary);
  const Json json = Json::parse(
    std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array())
    failAs(path, "this is no whole list of a series of files");
  std::vector<Entry> entries;
  for (const Json& one : json["files"])
  {
    const bool isWhole = one.is_object() && one.contains("name") && one["name"].is_string() &&
                         (!one.contains("time") || one["time"].is_number());
    if (!isWhole)
      failAs(path, "an entry of this list has no name, or a time that is no number");
    add(path, one.value("time", 0.0), one["name"].get<std::string>(), "", entries);
  }
  return entries;
}

} // namespace

std::vector<CollectedStep> stepsOfCollection(const std::string& path)
{
  const std::string beginning = readBeginning(path, 256);
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  const bool isJSON = first != std::string::npos && beginning[first] == '{';
  std::map<double, CollectedStep> steps;
  for (const Entry& entry : isJSON ? entriesOfJSON(path) : entriesOfXML(path))
  {
    CollectedStep& step = steps[entry.time];
    step.time = entry.time;
    step.files.push_back(entry.file);
  }
  if (steps.empty())
    failAs(path, "this collection names no file");
  std::vector<CollectedStep> all;
  for (auto& [time, step] : steps)
  {
    // One alone needs no name that only counts.
    if (step.files.size() == 1 && step.files.front().name.starts_with("part "))
      step.files.front().name.clear();
    all.push_back(std::move(step));
  }
  return all;
}

} // namespace mote
