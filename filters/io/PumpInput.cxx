#include "PumpInput.h"

#include "FileError.h"
#include "vtkMotePumpSource.h"

#include <charconv>

#include <vtksys/SystemTools.hxx>

namespace mote
{
namespace
{

constexpr std::string_view prefix = "pump:";

/// Throws FileError for what is no pump:SCALE[:PART].
vtkSmartPointer<vtkAlgorithm> makePump(const std::vector<std::string>& names)
{
  const std::string& name = names.front();
  const auto fail = [&](const std::string& sentence)
  { throw FileError(FileError::Kind::Malformed, name, sentence); };
  const std::size_t colon = name.find(':', prefix.size());
  const std::string number = name.substr(prefix.size(), colon - prefix.size());
  double scale = 0.0;
  const char* const end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, scale);
  if (error != std::errc() || stop != end)
    fail("a pump is named pump:SCALE or pump:SCALE:PART, and '" + number + "' is no number");
  auto source = vtkSmartPointer<vtkMotePumpSource>::New();
  source->SetScale(scale);
  if (source->GetScale() != scale)
    fail("the scale of a pump lies between 0.0005 (3,200 cells) and 10; at 1 it has 6.45 million");
  const std::string part = colon == name.npos ? "all" : name.substr(colon + 1);
  if (part == "inlet")
    source->SetPartToInlet();
  else if (part == "rotor")
    source->SetPartToRotor();
  else if (part == "diffuser")
    source->SetPartToDiffuser();
  else if (part != "all")
    fail("a pump has the parts inlet, rotor, diffuser and all, not '" + part + "'");
  return source;
}

} // namespace

const ReaderFormat* pumpFormat(const std::string& name)
{
  static const ReaderFormat format = {{}, "pump that is made", makePump};
  if (!name.starts_with(prefix) || vtksys::SystemTools::PathExists(name))
    return nullptr;
  makePump({name}); // for what it throws
  return &format;
}

} // namespace mote
