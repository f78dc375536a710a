#include "XMLReaders.h"

#include "MessageCatcher.h"

#include "vtkXMLUtilities.h"

#include <filesystem>

namespace mote
{

namespace
{

namespace fs = std::filesystem;

/// The first file that an element, or one below it, names.
std::string firstFileIn(vtkXMLDataElement* element)
{
  for (const char* attribute : {"file", "Source"})
    if (const char* name = element->GetAttribute(attribute))
      return name;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    if (std::string name = firstFileIn(element->GetNestedElement(i)); !name.empty())
      return name;
  return {};
}

template <class Reader>
std::optional<double> timeBy(const std::string& file)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<Reader> reader;
  const MessageCatcher messages(reader); // who reads the whole tells them
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  if (!information->Has(Pipeline::TIME_STEPS()) || information->Length(Pipeline::TIME_STEPS()) != 1)
    return {};
  return information->Get(Pipeline::TIME_STEPS(), 0);
}

/// Of an index, or of one of the files that such name; `depth` of them may name one another.
std::optional<double> timeOf(const fs::path& file, int depth)
{
  const std::string ending = file.extension().string(), name = file.string();
  if (ending == ".vtp")
    return timeBy<vtkXMLPolyDataReader>(name);
  if (ending == ".vtu")
    return timeBy<vtkXMLUnstructuredGridReader>(name);
  if (ending == ".vti")
    return timeBy<vtkXMLImageDataReader>(name);
  if (ending == ".vts")
    return timeBy<vtkXMLStructuredGridReader>(name);
  if (ending == ".vtr")
    return timeBy<vtkXMLRectilinearGridReader>(name);
  if (depth == 0)
    return {};
  vtkSmartPointer<vtkXMLDataElement> index;
  index.TakeReference(vtkXMLUtilities::ReadElementFromFile(name.c_str()));
  const std::string first = index ? firstFileIn(index) : std::string();
  return first.empty() ? std::nullopt : timeOf(file.parent_path() / first, depth - 1);
}

} // namespace

std::optional<double> timeOfFiles(const std::string& index)
{
  return timeOf(index, 2);
}

} // namespace mote
