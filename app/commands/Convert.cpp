#include "Convert.h"

#include "AllSteps.h"
#include "base/Failure.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "settings/Values.h"
#include "stage/Calculated.h"
#include "stage/HiddenParts.h"
#include "stage/Input.h"
#include "stage/Part.h"
#include "stage/Selection.h"
#include "stage/ShownData.h"
#include "stage/Surface.h"
#include "table/Row.h"

#include <kernels/core/MemoryLimit.h>
#include <kernels/core/ScratchSpace.h>

#include <vtkActor.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMoteBlocksWriter.h>
#include <vtkMoteDataWriter.h>
#include <vtkMoteMeshFileWriter.h>
#include <vtkMoteParticleFileWriter.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMotePiecesWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace mote::app
{

namespace
{

/// What a file may be made of.
struct Found
{
  std::vector<NamedData> particles, surfaces, volumes;
};

Found find(Input& input, const Settings& settings, ProgressRelay& progress)
{
  Found found;
  for (const NamedData& one : shownParts(
         readAsAsked(input, input.chosenStep(settings), settings, progress), settings.selection))
    switch (Part::kindOf(one.data, settings))
    {
    case Part::Kind::Particles:
      found.particles.push_back(one);
      break;
    case Part::Kind::Surface:
      found.surfaces.push_back(one);
      break;
    case Part::Kind::Volume:
      found.volumes.push_back(one);
    }
  return found;
}

/// The endings of files that are written.
std::string endingOf(const std::string& file)
{
  if (lowerCase(std::filesystem::path(file).extension().string()) == ".mote")
    return ".mote";
  for (const std::string& ending :
    {vtkMotePiecesWriter::EndingOf(file), vtkMoteBlocksWriter::EndingOf(file)})
    if (!ending.empty())
      return ending;
  return vtkMoteDataWriter::EndingOf(file);
}

bool isOfPieces(const std::string& ending)
{
  return ending == ".pvtp" || ending == ".pvtu";
}

/// Throws Failure where what is read lies in the folder of the pieces that are written.
void checkFolder(const std::string& output, const std::vector<std::string>& inputs)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::path(output).replace_extension(), ignored);
  for (const std::string& input : inputs)
    if (fs::exists(input, ignored) && fs::weakly_canonical(input, ignored).parent_path() == folder)
      throw Failure(input + " lies in the folder of what " + output + " names, which is written");
}

/// The ending of one piece, or of a file that has none.
std::string withoutPieces(const std::string& ending)
{
  return isOfPieces(ending) ? '.' + ending.substr(2) : ending;
}

/// What a file with an ending can hold, for messages.
std::string holdingOf(const std::string& ending)
{
  const std::string kind = withoutPieces(ending);
  return "a " + ending + " file holds one set of particles" +
         (kind == ".mote"   ? ", or without particles one surface"
           : kind == ".vtp" ? " or one surface"
           : kind == ".vtu" ? ", one surface or one volume"
                            : "");
}

/// The one data set that a file with this ending can hold.
NamedData convertible(
  Input& input, const Settings& settings, const std::string& ending, ProgressRelay& progress)
{
  const Found found = find(input, settings, progress);
  const std::string kind = withoutPieces(ending);
  std::vector<NamedData> all = found.particles;
  const bool withSurfaces = kind == ".vtp" || kind == ".vtu" || (kind == ".mote" && all.empty());
  if (withSurfaces)
    all.insert(all.end(), found.surfaces.begin(), found.surfaces.end());
  if (kind == ".vtu")
    all.insert(all.end(), found.volumes.begin(), found.volumes.end());
  if (all.size() == 1)
    return all.front();
  const auto many = [](const std::vector<NamedData>& them, const char* what)
  { return std::to_string(them.size()) + ' ' + what + (them.size() == 1 ? "" : "s"); };
  throw Failure(
    input.name() + " holds " + many(found.particles, "set") + " of particles, " +
    many(found.surfaces, "surface") + " and " + many(found.volumes, "volume") + "; " +
    holdingOf(ending) +
    (all.empty()                  ? ""
      : all.front().block.empty() ? "; choose one with --hide-data"
                                  : "; choose one: --hide-part '*' --show-part NAME, or "
                                    "write a .vtm file, which holds all"));
}

double secondsSince(double start)
{
  return vtkTimerLog::GetUniversalTime() - start;
}

void convertParticles(
  Part& part, const std::string& output, ProgressRelay& progress, const std::string& which)
{
  vtkNew<vtkMoteParticleFileWriter> writer;
  writer->SetMapper(part.particles());
  writer->SetWriteOriginalIds(part.particles()->GetKeepPointIds());
  writeFile(writer, output, progress, which);
}

void convertSurface(
  const Part& part, const std::string& output, ProgressRelay& progress, const std::string& which)
{
  part.surface()->nameCellsForFile();
  vtkNew<vtkMoteMeshFileWriter> writer;
  writer->SetMapper(part.surface()->mapper());
  writeFile(writer, output, progress, which);
}

/// A part of these data, with what the settings hide hidden.
std::unique_ptr<Part> hiding(
  const NamedData& data, const Settings& settings, ProgressRelay& progress)
{
  Settings own = settings; // whole data sets are chosen already
  own.selection.hiddenData.clear();
  own.selection.hiddenParts.clear();
  own.selection.shownParts.clear();
  std::vector<std::unique_ptr<Part>> parts;
  parts.push_back(std::make_unique<Part>(data.name, data.data, settings, 0.0));
  const bool hides = hidesAny(settings);
  if (parts.front()->particles() && (hides || givesRadii(settings.particles)))
    parts.front()->build(progress); // by which ranges are looked at
  if (hides)
    Selection(own).apply(parts, {}, {data});
  return std::move(parts.front());
}

/// What is shown of the data, and the settings with the radius that they have. Radii that these say
/// become an array where the file has no other place for them.
NamedData shownOf(const NamedData& data, Settings& settings, bool isMote, ProgressRelay& progress)
{
  const std::unique_ptr<Part> part = hiding(data, settings, progress);
  NamedData shown = data;
  shown.data =
    markedData(*part, shownMarks(*part, settings), !isMote && givesRadii(settings.particles));
  if (part->keptRadius() > 0.0) // of all, which those that are left may not tell
    settings.particles.radius = exactText(part->keptRadius());
  return shown;
}

Failure nothingShown(const Input& input, const std::string& output)
{
  return Failure("nothing of " + input.name() + " is shown, so that " + output + " would be empty");
}

/// The lines that tell what was written end alike.
void tell(const std::string& output, const std::string& what)
{
  std::printf("%s: %s\n", output.c_str(), what.c_str());
}

std::string sizeOf(const std::string& file)
{
  return asBytes(static_cast<double>(std::filesystem::file_size(file)));
}

/// How many particles, or cells, data have.
std::string countOf(vtkDataSet* data)
{
  return Part::isMesh(data) ? counted(data->GetNumberOfCells(), "cell")
                            : counted(data->GetNumberOfPoints(), "particle");
}

/// Builds what the data are drawn by, and writes that as a .mote file.
void convertToMote(const NamedData& data, const Settings& settings, const std::string& output,
  const std::shared_ptr<ScratchSpace>& space, ProgressRelay& progress, const std::string& which,
  double readTime)
{
  Part part(data.name, data.data, settings, 0.0);
  if (vtkMoteParticleMapper* particles = part.particles())
  {
    particles->SetStructureName("pkd-tree");
    particles->SetScratchSpace(space);
    const bool ofSource = Part::isOfSource(data.data); // whose order says nothing
    particles->SetKeepPointIds(!ofSource || data.data->GetPointData()->GetNumberOfArrays() > 0);
  }
  part.build(progress);
  const double built = vtkTimerLog::GetUniversalTime();
  if (part.particles())
    convertParticles(part, output, progress, which);
  else
    convertSurface(part, output, progress, which);
  const std::string count =
    part.particles() ? counted(part.particles()->GetNumberOfParticles(), "particle")
                     : counted(part.surface()->mapper()->GetNumberOfTriangles(), "triangle");
  tell(output, count + ", " + sizeOf(output) + "; read in " + asDuration(readTime) + ", built in " +
                 asDuration(part.buildTime()) + ", written in " + asDuration(secondsSince(built)));
}

/// Answers how many pieces were written.
int writePieces(vtkDataSet* data, const Settings& settings, const std::string& output,
  ProgressRelay& progress, const std::string& which)
{
  vtkNew<vtkMotePiecesWriter> writer;
  writer->SetInputData(data);
  if (settings.output.pieces > 0)
    writer->SetNumberOfPieces(settings.output.pieces);
  writeFile(writer, output, progress, which);
  return writer->GetNumberOfWrittenPieces();
}

/// What is shown of each part, as blocks of its name, and what that is, for messages.
std::string takeShown(
  Input& input, const Settings& settings, vtkMultiBlockDataSet* blocks, ProgressRelay& progress)
{
  const auto parts = shownParts(
    readAsAsked(input, input.chosenStep(settings), settings, progress), settings.selection);
  vtkIdType particles = 0, cells = 0;
  for (const NamedData& part : parts)
  {
    Settings own = settings; // which get the part's radius
    if (part.data->GetNumberOfPoints() == 0)
      continue;
    const vtkSmartPointer<vtkDataSet> data = shownOf(part, own, false, progress).data;
    if (data->GetNumberOfPoints() == 0)
      continue;
    (Part::isMesh(data) ? cells : particles) +=
      Part::isMesh(data) ? data->GetNumberOfCells() : data->GetNumberOfPoints();
    const unsigned index = blocks->GetNumberOfBlocks();
    blocks->SetBlock(index, data);
    blocks->GetMetaData(index)->Set(
      vtkCompositeDataSet::NAME(), (part.block.empty() ? part.name : part.block).c_str());
  }
  return (particles > 0 ? counted(particles, "particle") + ", " : "") +
         (cells > 0 ? counted(cells, "cell") + ", " : "") +
         counted(blocks->GetNumberOfBlocks(), "block");
}

/// A file of all that is shown, each part as a block.
void convertToBlocks(Input& input, const Settings& settings, const std::string& output,
  ProgressRelay& progress, const std::string& which)
{
  const double start = vtkTimerLog::GetUniversalTime();
  vtkNew<vtkMultiBlockDataSet> blocks;
  const std::string made = takeShown(input, settings, blocks, progress);
  if (blocks->GetNumberOfBlocks() == 0)
  {
    if (!settings.output.allSteps)
      throw nothingShown(input, output);
    return tell(output, "nothing is shown, not written");
  }
  const double ready = vtkTimerLog::GetUniversalTime();
  vtkNew<vtkMoteBlocksWriter> writer;
  writer->SetInputData(blocks);
  writeFile(writer, output, progress, which);
  tell(output, made + "; read in " + asDuration(ready - start) + ", written in " +
                 asDuration(secondsSince(ready)));
}

/// The file of a step, in which what stood there is replaced.
void convertStep(Input& input, const Settings& given, const std::string& output,
  const std::shared_ptr<ScratchSpace>& space, ProgressRelay& progress, const std::string& which)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const std::string ending = endingOf(output);
  if (ending == ".vtm")
    return convertToBlocks(input, given, output, progress, which);
  Settings settings = given;
  NamedData data = convertible(input, settings, ending, progress);
  const bool isWhole = ending == ".mote" && !hidesAny(settings);
  if (!isWhole && data.data->GetNumberOfPoints() > 0)
    data = shownOf(data, settings, ending == ".mote", progress);
  if (data.data->GetNumberOfPoints() == 0 && (settings.output.allSteps || !isWhole))
  {
    if (!settings.output.allSteps)
      throw nothingShown(input, output);
    return tell(output, "no particle, not written");
  }
  const double readTime = secondsSince(start);
  if (ending == ".mote")
    return convertToMote(data, settings, output, space, progress, which, readTime);
  const double ready = vtkTimerLog::GetUniversalTime();
  std::string made = countOf(data.data) + ", ";
  if (isOfPieces(ending))
    made += counted(writePieces(data.data, settings, output, progress, which), "piece");
  else
  {
    writeData(data.data, output, progress, which);
    made += sizeOf(output);
  }
  tell(output,
    made + "; read in " + asDuration(readTime) + ", written in " + asDuration(secondsSince(ready)));
}

} // namespace

std::optional<NamedData> onlyParticlesOf(
  Input& input, const Settings& settings, ProgressRelay& progress)
{
  const Found found = find(input, settings, progress);
  return found.particles.size() == 1 ? std::optional(found.particles.front()) : std::nullopt;
}

void convert(const Settings& given)
{
  Settings settings = given;
  const std::string output = settings.data.files.back();
  settings.data.files.pop_back();
  const std::string ending = endingOf(output);
  if (ending.empty())
    throw Failure("the last file is the one to write, and must end in .mote, .vtp, .vtu, .vtm, "
                  ".pvtp, .pvtu, .xyz or .xyz.gz, not " +
                  output);
  if (settings.output.pieces > 0 && !isOfPieces(ending))
    throw Failure("--pieces is for .pvtp and .pvtu files, not for " + output +
                  (ending == ".mote" ? ", which ranks read in parts as it is" : ""));
  if (settings.data.files.empty())
    throw Failure("no file to read is given, only " + output + " to write");

  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  checkOutput(output, settings.data.files); // before hours of reading
  if (isOfPieces(ending) || ending == ".vtm")
    checkFolder(output, settings.data.files);
  const std::uint64_t memory =
    settings.output.memory.empty() ? physicalMemory() / 2 : bytesOf(settings.output.memory);
  // The rest is for putting arrays in order.
  const auto space = std::make_shared<ScratchSpace>(output, memory / 4 * 3);
  Input input(settings.data.files);
  if (ending == ".mote" && !hidesAny(settings)) // others keep words, and what is read in memory
    input.setSpace(space);
  input.open(progress);
  forSteps(input, settings, progress,
    [&](const Settings& ofStep, const std::string& which)
    {
      const int step = input.chosenStep(ofStep) + 1, steps = input.numberOfSteps();
      const std::string file = settings.output.allSteps ? numbered(output, step, steps) : output;
      checkOutput(file, settings.data.files);
      convertStep(input, ofStep, file, space, progress, which);
    });
}

} // namespace mote::app
