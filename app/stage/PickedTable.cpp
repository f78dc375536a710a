#include "PickedTable.h"

#include "Calculated.h"
#include "PlacedCell.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "settings/Values.h"

#include <kernels/core/AtomicFile.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVariant.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace mote::app
{

namespace
{

const char* nameOf(Picked::Kind kind)
{
  return kind == Picked::Kind::Particle ? "particle" : "cell";
}

std::string numberText(double value, int digits)
{
  return digits > 0 ? asNumber(value, digits) : exactText(value);
}

} // namespace

std::string valueText(vtkAbstractArray* array, int component, vtkIdType tuple, int digits)
{
  const vtkIdType i = tuple * array->GetNumberOfComponents() + component;
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers && array->GetDataType() == VTK_FLOAT && digits == 0)
  {
    // The shortest text of the float, not of the double that it becomes.
    char text[32];
    const auto value = static_cast<float>(numbers->GetComponent(tuple, component));
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
  }
  if (numbers && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    return numberText(numbers->GetComponent(tuple, component), digits);
  // Whole numbers have all of their digits, beyond those of doubles too.
  return numbers && array->GetDataTypeSize() == 1
           ? std::to_string(static_cast<int>(numbers->GetComponent(tuple, component)))
           : std::string(array->GetVariantValue(i).ToString());
}

PickedTable::PickedTable(const PickedSet::Parts& parts, const PickedSet& picked)
  : parts_(&parts)
  , picked_(&picked)
{
  std::vector<bool> isUsed(parts.size());
  for (const Picked& one : picked.items())
    isUsed[static_cast<std::size_t>(one.part)] = true;
  const Picked::Kind first = picked.empty() ? Picked::Kind::Particle : picked.items().front().kind;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    hasKinds_ = hasKinds_ || (isUsed[k] && kindOfPicks(*parts[k]) != first);
    hasParts_ = hasParts_ || parts.size() > 1;
    hasCells_ = hasCells_ || (isUsed[k] && kindOfPicks(*parts[k]) == Picked::Kind::Cell);
    if (!isUsed[k])
      continue;
    this->addArrays(*parts[k], k, false);
    if (kindOfPicks(*parts[k]) == Picked::Kind::Cell)
      this->addArrays(*parts[k], k, true);
  }
  this->tellApart();
  names_ = {hasKinds_ || first == Picked::Kind::Particle ? "index" : nameOf(first)};
  if (hasKinds_)
    names_.emplace_back("what");
  if (hasParts_)
    names_.emplace_back("of");
  names_.insert(names_.end(), {"x", "y", "z"});
  if (hasCells_)
    names_.emplace_back("nearest point");
  for (const Column& column : columns_)
    names_.push_back(column.name);
  if (hasCells_)
    names_.emplace_back("points");
}

void PickedTable::addArrays(const Part& part, std::size_t k, bool ofCells)
{
  vtkDataSetAttributes* arrays =
    ofCells ? static_cast<vtkDataSetAttributes*>(part.data()->GetCellData())
            : static_cast<vtkDataSetAttributes*>(part.data()->GetPointData());
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    const std::string name = mote::app::nameOf(array);
    if (name.empty() || name == whereArray)
      continue;
    const int components = array->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
    {
      const char* own = array->GetComponentName(c);
      const std::string text = name + (components == 1 ? ""
                                        : own          ? ":" + std::string(own)
                                                       : ":" + std::to_string(c));
      auto column = std::find_if(columns_.begin(), columns_.end(),
        [&](const Column& one) { return one.name == text && one.ofCells == ofCells; });
      if (column == columns_.end())
        column = columns_.insert(
          columns_.end(), {text, c, ofCells, std::vector<vtkAbstractArray*>(parts_->size())});
      column->arrays[k] = array;
    }
  }
}

/// Names of arrays that points and cells both have become those that --color-by takes.
void PickedTable::tellApart()
{
  for (Column& ofPoints : columns_)
    for (Column& ofCells : columns_)
      if (!ofPoints.ofCells && ofCells.ofCells && ofPoints.name == ofCells.name)
      {
        ofPoints.name = "point:" + ofPoints.name;
        ofCells.name = "cell:" + ofCells.name;
      }
}

std::string PickedTable::cell(std::size_t row, std::size_t column, int digits) const
{
  const Picked& picked = picked_->items()[row];
  if (column == 0)
    return std::to_string(picked.id);
  const Part& part = *(*parts_)[static_cast<std::size_t>(picked.part)];
  std::size_t at = 1;
  if (hasKinds_ && column == at++)
    return nameOf(picked.kind);
  if (hasParts_ && column == at++)
    return part.name();
  if (column < at + 3)
    return numberText(picked_->placeOf(*parts_, picked)[column - at], digits);
  at += 3;
  if (hasCells_ && column == at++)
    return picked.kind == Picked::Kind::Cell
             ? std::to_string(nearestCorner(part.data(), picked.id,
                 placedCell(part, picked.id, picked_->placeOf(*parts_, picked)).place))
             : std::string();
  if (column - at < columns_.size())
    return this->valueOf(picked, columns_[column - at], digits);
  std::string text;
  for (const auto& [point, place] : this->corners(row))
    text += (text.empty() ? "" : "; ") + std::to_string(point) + " (" +
            numberText(place[0], digits) + " " + numberText(place[1], digits) + " " +
            numberText(place[2], digits) + ")";
  return text;
}

std::vector<PickedTable::Corner> PickedTable::corners(std::size_t row) const
{
  std::vector<Corner> corners;
  const Picked& picked = picked_->items()[row];
  if (picked.kind != Picked::Kind::Cell)
    return corners;
  const Part& part = *(*parts_)[static_cast<std::size_t>(picked.part)];
  const auto placed = placedCell(part, picked.id, picked_->placeOf(*parts_, picked)).placed;
  vtkNew<vtkIdList> points;
  part.data()->GetCellPoints(picked.id, points);
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    Corner& corner = corners.emplace_back(Corner{points->GetId(i), {}});
    part.data()->GetPoint(corner.point, corner.place.data());
    placed->TransformPoint(corner.place.data(), corner.place.data());
  }
  return corners;
}

std::string PickedTable::valueOf(const Picked& picked, const Column& column, int digits) const
{
  const auto part = static_cast<std::size_t>(picked.part);
  vtkAbstractArray* array = column.arrays[part];
  const bool isCell = picked.kind == Picked::Kind::Cell;
  if (!array)
    return {};
  if (isCell == column.ofCells)
    return picked.id < array->GetNumberOfTuples()
             ? valueText(array, column.component, picked.id, digits)
             : std::string();
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
    return {};
  return numberText(
    valueBetween(picked_->weightsOf(*parts_, picked), numbers, column.component), digits);
}

void PickedTable::appendLine(std::string& text, std::size_t row, char separator) const
{
  for (std::size_t column = 0; column < names_.size(); ++column)
    (text += inQuotes(this->cell(row, column, 0), separator)) += separator;
  text.back() = '\n';
}

void PickedTable::appendNames(std::string& text, char separator) const
{
  for (const std::string& name : names_)
    (text += inQuotes(name, separator)) += separator;
  text.back() = '\n';
}

std::string asJson(const PickedTable& table)
{
  auto rows = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < table.rows(); ++row)
  {
    nlohmann::ordered_json one;
    for (std::size_t column = 0; column < table.columns().size(); ++column)
    {
      const std::string text = table.cell(row, column, 0);
      auto& entry = one[table.columns()[column]]; // null where there is nothing
      if (const auto number = nlohmann::json::parse(text, nullptr, false); number.is_number())
        entry = number;
      else if (!text.empty())
        entry = text;
    }
    if (const auto corners = table.corners(row); !corners.empty())
    {
      auto& points = one["points"] = nlohmann::ordered_json::array();
      for (const auto& [point, place] : corners)
        points.push_back({{"point", point}, {"place", place}});
    }
    rows.push_back(std::move(one));
  }
  return rows.dump(2) + "\n";
}

void writePicked(const PickedTable& table, const std::string& file)
{
  constexpr std::size_t atOnce = 1 << 20;
  try
  {
    AtomicFile out(file);
    std::string text;
    if (lowerCase(file).ends_with(".json"))
    {
      text = asJson(table);
      out.write(text.data(), text.size());
      return out.commit();
    }
    table.appendNames(text, ',');
    for (std::size_t row = 0; row < table.rows(); ++row)
    {
      table.appendLine(text, row, ',');
      if (text.size() < atOnce)
        continue;
      out.write(text.data(), text.size());
      text.clear();
    }
    out.write(text.data(), text.size());
    out.commit();
  }
  catch (const WriteError& error)
  {
    throw Failure(error.what());
  }
}

} // namespace mote::app
