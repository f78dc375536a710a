#include "Volume.h"

#include "settings/Colors.h"

#include <vtkCellTypes.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLookupTable.h>
#include <vtkPiecewiseFunction.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mote::app
{

namespace
{

/// Shows all of the range, and its ends the most.
const std::vector<OpacityPoint> usual = {
  {0, true, 0.5}, {25, true, 0.08}, {50, true, 0.02}, {75, true, 0.08}, {100, true, 0.5}};

bool isVolume(int type)
{
  return type == VTK_TETRA || type == VTK_VOXEL || type == VTK_HEXAHEDRON || type == VTK_WEDGE ||
         type == VTK_PYRAMID;
}

/// The value at a share of a table's range; between the ends by logarithm where the table is.
double valueAt(vtkLookupTable* table, double share)
{
  const double* range = table->GetRange();
  return table->UsingLogScale() ? range[0] * std::pow(range[1] / range[0], share)
                                : range[0] + share * (range[1] - range[0]);
}

vtkSmartPointer<vtkColorTransferFunction> colorsOf(vtkLookupTable* table)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  const auto entries = table->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < entries; ++i)
  {
    const double* c = table->GetTableValue(i);
    colors->AddRGBPoint(
      valueAt(table, (static_cast<double>(i) + 0.5) / static_cast<double>(entries)), c[0], c[1],
      c[2]);
  }
  return colors;
}

} // namespace

Volume::Volume(const VolumeSettings& settings)
  : settings_(settings)
{
  volume_->GetProperty()->SetSpecular(0.0);
  volume_->SetMapper(mapper_);
  this->update();
  this->showAll();
}

void Volume::update()
{
  mapper_->SetStructureName(settings_.structure.empty() ? nullptr : settings_.structure.c_str());
  mapper_->SetIntegratorName(settings_.integrator.c_str());
  mapper_->SetSampleDistance(settings_.sampleDistance.value_or(0.0));
  mapper_->SetTolerance(settings_.tolerance);
  mapper_->SetShowCloud(settings_.cloud);
  mapper_->SetShowIsoSurfaces(!settings_.isoValues.empty());
  Color nan = {0.0, 0.0, 0.0};
  const bool colored = parseColor(settings_.nanColor, nan);
  mapper_->SetNanColor(nan.data());
  mapper_->SetNanOpacity(colored ? 0.5 : 0.0);
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetShade(settings_.lit);
  vtkContourValues* values = look->GetIsoSurfaceValues();
  if (values->GetNumberOfContours() != static_cast<int>(settings_.isoValues.size()))
    values->SetNumberOfContours(static_cast<int>(settings_.isoValues.size()));
  for (std::size_t i = 0; i < settings_.isoValues.size(); ++i)
    values->SetValue(static_cast<int>(i), settings_.isoValues[i]);
}

bool Volume::canShow(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || rankedArrays(grid).empty())
    return false;
  vtkNew<vtkCellTypes> types;
  grid->GetCellTypes(types);
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i)
    if (isVolume(types->GetCellType(i)))
      return true;
  return false;
}

void Volume::setData(vtkUnstructuredGrid* data)
{
  mapper_->SetInputData(data);
  if (arrayOf(data, choice_))
    return this->select(choice_);
  if (table_ && !warned_)
    std::fprintf(stderr,
      "mote: warning: a time step has no array '%s', so its cells are not shown\n",
      choice_.name.c_str());
  warned_ = warned_ || table_;
  if (const auto arrays = rankedArrays(data); !arrays.empty())
    this->select(arrays.front()); // something to build with, until colours come
}

void Volume::select(const ArrayChoice& choice)
{
  if (choice.ofCells)
    mapper_->SetScalarModeToUseCellFieldData();
  else
    mapper_->SetScalarModeToUsePointFieldData();
  mapper_->SelectScalarArray(choice.name.c_str());
  mapper_->SetVectorMode(choice.component == ArrayChoice::magnitude
                           ? vtkMoteVolumeMapper::MAGNITUDE
                           : vtkMoteVolumeMapper::COMPONENT);
  mapper_->SetVectorComponent(std::max(0, choice.component));
}

void Volume::setColors(
  vtkDataSet* data, const ArrayChoice& choice, vtkLookupTable* table, double diagonal)
{
  const bool isColored = arrayOf(data, choice) != nullptr;
  volume_->SetVisibility(isColored);
  if (!isColored)
    return;
  choice_ = choice;
  this->select(choice);
  table_ = table;
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetColor(colorsOf(table));
  look->SetScalarOpacityUnitDistance(settings_.opacityUnit.value_or(0.1 * diagonal));
  this->setOpacity();
}

void Volume::limit(double low, double high)
{
  limits_[0] = std::max(limits_[0], low);
  limits_[1] = std::min(limits_[1], high);
  this->setOpacity();
}

void Volume::showAll()
{
  limits_[0] = -HUGE_VAL, limits_[1] = HUGE_VAL;
  this->setOpacity();
}

void Volume::setOpacity()
{
  if (!table_)
    return;
  vtkNew<vtkPiecewiseFunction> whole, part;
  whole->AllowDuplicateScalarsOn(); // two points of one value are a step
  for (const OpacityPoint& point : settings_.opacity.empty() ? usual : settings_.opacity)
    whole->AddPoint(
      point.isShare ? valueAt(table_, 0.01 * point.value) : point.value, point.opacity);
  vtkVolumeProperty* look = volume_->GetProperty();
  if (limits_[0] > limits_[1])
    part->AddPoint(0.0, 0.0);
  else if (std::isinf(limits_[0]) && std::isinf(limits_[1]))
  {
    look->SetScalarOpacity(whole);
    return;
  }
  else
  {
    // The next number outside is clear: what is hidden ends at once.
    const double below = std::nextafter(limits_[0], -HUGE_VAL);
    const double above = std::nextafter(limits_[1], HUGE_VAL);
    if (std::isfinite(limits_[0]))
    {
      part->AddPoint(below, 0.0);
      part->AddPoint(limits_[0], whole->GetValue(limits_[0]));
    }
    for (int i = 0; i < whole->GetSize(); ++i)
    {
      double node[4];
      whole->GetNodeValue(i, node);
      if (node[0] > limits_[0] && node[0] < limits_[1])
        part->AddPoint(node[0], node[1]);
    }
    if (std::isfinite(limits_[1]))
    {
      part->AddPoint(limits_[1], whole->GetValue(limits_[1]));
      part->AddPoint(above, 0.0);
    }
  }
  look->SetScalarOpacity(part);
}

void Volume::setAmbient(double ambient)
{
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetAmbient(std::max(0.25, ambient));
  look->SetDiffuse(0.75);
}

} // namespace mote::app
