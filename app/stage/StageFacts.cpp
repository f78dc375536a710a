// How much there is on the stage, in numbers and words.

#include "Stage.h"

#include "base/Text.h"

#include <vtkMoteParticleMapper.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

std::string Stage::preview() const
{
  vtkIdType shown = 0;
  bool any = false;
  double built = 0.0;
  for (const auto& part : parts_)
    if (vtkMoteParticleMapper* mapper = part->particles())
    {
      any = any || mapper->IsPreview();
      shown += mapper->IsPreview() ? mapper->GetNumberOfPreviewParticles()
                                   : mapper->GetNumberOfParticles();
      built += mapper->GetBuildProgress() * static_cast<double>(mapper->GetNumberOfParticles());
    }
  if (!any)
    return {};
  const vtkIdType all = this->numberOfParticles();
  std::string text =
    "Preview: " + withThousands(shown) + " of " + counted(all, "particle") + ", enlarged";
  if (this->isBuilding())
    text += "; " + asNumber(std::floor(100.0 * built / static_cast<double>(all))) + " % built";
  return text;
}

vtkIdType Stage::numberOfParticles() const
{
  vtkIdType count = 0;
  for (const auto& part : parts_)
    if (part->particles())
      count += part->particles()->GetNumberOfParticles();
  return count;
}

vtkIdType Stage::numberShown() const
{
  vtkIdType count = 0;
  for (const auto& part : parts_)
    count += part->numberShown();
  return count;
}

namespace
{

bool isOfTubes(const Part& part)
{
  return part.surface() && part.surface()->tubes();
}

/// Whether cells are told of: those of surfaces where some are hidden, else triangles say enough.
bool isCounted(const Part& part)
{
  return part.kind() == Part::Kind::Volume || (part.cells().mask() && !isOfTubes(part));
}

} // namespace

vtkIdType Stage::numberOfCells() const
{
  vtkIdType count = 0;
  for (const auto& part : parts_)
    count += isCounted(*part) ? part->data()->GetNumberOfCells() : 0;
  return count;
}

vtkIdType Stage::numberOfCellsShown() const
{
  vtkIdType count = 0;
  for (const auto& part : parts_)
    count += isCounted(*part) ? part->numberOfCellsShown() : 0;
  return count;
}

vtkIdType Stage::numberOfTriangles(bool shownOnly) const
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i)
  {
    // Patches that are not asked for are not missed.
    const bool isLeftOut = shownOnly || (i < data_.size() && data_[i].isBoundary);
    if (parts_[i]->surface() && !isOfTubes(*parts_[i]) && !(isLeftOut && parts_[i]->isHidden()))
      count += parts_[i]->surface()->mapper()->GetNumberOfTriangles();
  }
  return count;
}

vtkIdType Stage::numberOfLines(bool shownOnly) const
{
  vtkIdType count = 0;
  for (const auto& part : parts_)
    if (isOfTubes(*part))
      count += shownOnly ? part->numberOfCellsShown() : part->data()->GetNumberOfCells();
  return count;
}

vtkTypeInt64 Stage::structureBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& part : parts_)
    bytes += part->structureBytes();
  return bytes;
}

double Stage::buildTime() const
{
  double seconds = 0.0;
  for (const auto& part : parts_)
    seconds += part->buildTime();
  return seconds;
}

std::string Stage::contents() const
{
  std::string text;
  const bool particles = std::any_of(
    parts_.begin(), parts_.end(), [](const auto& part) { return part->particles() != nullptr; });
  if (particles || parts_.empty())
  {
    text = counted(this->numberOfParticles(), "particle");
    // How many of all are shown a preview does not know.
    if (this->preview().empty() && this->numberShown() != this->numberOfParticles())
      text = withThousands(this->numberShown()) + " of " + text + " shown";
  }
  int images = 1;
  for (const auto& part : parts_)
    images = std::max(images, part->images());
  if (images > 1)
    text += ", " + std::to_string(images) + " images";
  const auto tell = [&](vtkIdType all, vtkIdType shown, const char* what)
  {
    if (all > 0)
      text += (text.empty() ? "" : ", ") +
              (shown == all ? counted(all, what)
                            : withThousands(shown) + " of " + counted(all, what) + " shown");
  };
  tell(this->numberOfCells(), this->numberOfCellsShown(), "cell");
  tell(this->numberOfTriangles(false), this->numberOfTriangles(true), "triangle");
  tell(this->numberOfLines(false), this->numberOfLines(true), "line");
  if (flow_.numberOfLines() > 0)
    text += ", " + counted(flow_.numberOfLines(), "streamline");
  vtkIdType leftOut = 0;
  for (const auto& part : parts_)
    leftOut += part->isHidden() ? 0 : part->numberLeftOut();
  return leftOut > 0 ? text + " (" + withThousands(leftOut) + " cannot be drawn)" : text;
}

} // namespace mote::app
