#include "StepSource.h"

#include "AtomEyeFile.h"
#include "BgeoFile.h"
#include "FileError.h"
#include "GadgetFile.h"
#include "GromacsFile.h"
#include "HDF5Particles.h"
#include "PolyDataParts.h"
#include "TextFile.h"
#include "UintahFile.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace mote
{

void RowLayout::addPositions()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    m_rows.coordinates[axis] = m_rows.columns.size();
    m_rows.columns.emplace_back(1, "xyz"[axis]);
    m_rows.types.push_back(ColumnType::Float64);
  }
}

std::size_t RowLayout::add(const std::string& name, ColumnType type, std::size_t components)
{
  const std::size_t first = m_rows.columns.size();
  ColumnGroup group = {name, {}};
  for (std::size_t i = 0; i < components; ++i)
  {
    group.columns.push_back(first + i);
    // vx, vy, vz of v, as dumps have them; but no velocityx.
    m_rows.columns.push_back(components == 1   ? name
                             : components != 3 ? name + "[" + std::to_string(i + 1) + "]"
                             : name.size() > 1 ? std::string(1, "xyz"[i])
                                               : name + "xyz"[i]);
    m_rows.types.push_back(type);
  }
  m_rows.arrays.push_back(std::move(group));
  return first;
}

PointRows RowLayout::rowsFor(const SourceRequest& request) const
{
  PointRows rows = m_rows;
  rows.piece = request.piece;
  rows.space = request.space;
  return rows;
}

void storeText(const TextColumn& column, std::uint64_t row, std::string_view text)
{
  if (!column.data)
    return;
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row) * column.stride;
  if (column.type == ColumnType::String)
    static_cast<std::string*>(column.data)[at] = text;
  else if (column.type == ColumnType::Word)
    static_cast<std::int32_t*>(column.data)[at] = column.words->numberOf(std::string(text));
}

void addBox(const std::array<double, 9>& cell, const std::array<double, 3>& origin,
  const std::string& boundary, vtkPolyData* output)
{
  addNumbers(output->GetFieldData(), "box", cell.data(), 9);
  addNumbers(output->GetFieldData(), "box_origin", origin.data(), 3);
  addText(output->GetFieldData(), "boundary", boundary);
}

void addTypeNames(const std::map<int, std::string>& names, vtkPolyData* output)
{
  vtkNew<vtkStringArray> texts;
  texts->SetName("type_names");
  for (const auto& [type, name] : names)
    texts->InsertNextValue(std::to_string(type) + "=" + name);
  output->GetFieldData()->AddArray(texts);
}

std::unique_ptr<StepSource> openStepSource(const std::string& path, const Progress& progress)
{
  const std::string beginning = readBeginning(path, 4096);
  if (beginning.empty())
    throw FileError(FileError::Kind::Truncated, path, "the file is empty");
  if (looksLikeHDF5(beginning))
    return openHDF5Particles(path);
  if (looksLikeGadget(beginning))
    return openGadget(path);
  if (looksLikeUintah(beginning))
    return openUintah(path);
  if (looksLikeBgeo(beginning) || path.ends_with(".bgeo") || path.ends_with(".bhclassic"))
    return openBgeo(path);
  if (looksLikeAtomEye(beginning) || path.ends_with(".cfg"))
    return openAtomEye(path);
  return openGromacs(path, progress);
}

} // namespace mote
