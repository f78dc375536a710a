// What the settings of a vtkMoteVolumeMapper choose: structure and integrator, and what these need;
// the array.
#include "vtkMoteVolumeMapper.h"

#include "Names.h"

#include "kernels/core/Error.h"
#include "kernels/hexahedra/HexStructure.h"
#include "kernels/scene/Cloud.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

std::vector<std::string> vtkMoteVolumeMapper::GetStructureNames()
{
  return mote::hexStructureNames();
}

std::vector<std::string> vtkMoteVolumeMapper::GetIntegratorNames()
{
  return {"inverse-distance", "trilinear", "cell-by-cell"}; // as VolumeIntegrator counts them
}

mote::HexStructureOptions vtkMoteVolumeMapper::StructureOptions()
{
  mote::HexStructureOptions options;
  const std::vector<std::string>& names = mote::hexStructureNames();
  const char* name =
    this->StructureName && *this->StructureName ? this->StructureName : names.back().c_str();
  options.kind = static_cast<mote::HexStructureKind>(mote::findName(names, name, "structure"));
  const double* d = this->AxisDirection;
  const double* o = this->AxisOrigin;
  if (d[0] != 0.0 || d[1] != 0.0 || d[2] != 0.0)
    options.axis = mote::CylinderAxis{{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
  return options;
}

/// Whether the camera's rays go through the cloud from cell to cell.
bool vtkMoteVolumeMapper::Walks()
{
  mote::VolumeSampling sampling;
  sampling.integrator = mote::VolumeIntegrator::CellByCell;
  sampling.tolerance = this->Tolerance;
  return this->IntegratorName && this->IntegratorName == GetIntegratorNames().back() &&
         mote::walkServes(sampling);
}

bool vtkMoteVolumeMapper::NeedsStructure()
{
  return this->ShowIsoSurfaces || this->GetNumberOfSlices() > 0 ||
         (this->ShowCloud && !this->Walks());
}

void vtkMoteVolumeMapper::SetIsoArray(const char* name, bool ofCells, int component)
{
  const std::string wanted = name ? name : "";
  if (wanted == this->IsoArrayName && ofCells == this->IsoArrayOfCells &&
      component == this->IsoArrayComponent)
    return;
  this->IsoArrayName = wanted;
  this->IsoArrayOfCells = ofCells;
  this->IsoArrayComponent = component;
  this->Modified();
}

vtkDataArray* vtkMoteVolumeMapper::FindArray(vtkUnstructuredGrid* grid, bool& ofCells)
{
  int cellFlag = 0;
  vtkDataArray* array = vtkAbstractMapper::GetScalars(
    grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  ofCells = cellFlag == 1;
  if (array && cellFlag <= 1)
    return array;
  const std::string points = mote::arrayNames(grid->GetPointData());
  const std::string cells = mote::arrayNames(grid->GetCellData());
  const bool wantsPoints = this->ScalarMode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  if (!wantsPoints && this->ScalarMode != VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)
    throw mote::Error("There are no active scalars to draw; there are point arrays: " + points +
                      ", and cell arrays: " + cells + ".");
  std::string name = "\"";
  if (this->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
    name = "number " + std::to_string(this->ArrayId);
  else
    name.append(this->ArrayName ? this->ArrayName : "").append("\"");
  throw mote::Error(std::string("There is no ") + (wantsPoints ? "point" : "cell") + " array " +
                    name + " to draw; there are: " + (wantsPoints ? points : cells) + ".");
}
