#pragma once

#include "DataArrayView.h"

#include "kernels/core/ContentHash.h"
#include "kernels/hexahedra/HexMesh.h"

#include <array>

class vtkUnstructuredGrid;

namespace mote
{

/// The arrays that make up the cells of an unstructured grid; null for those it has not.
struct GridArrays
{
  vtkDataArray* points = nullptr;
  vtkDataArray *types = nullptr, *offsets = nullptr, *connectivity = nullptr;
  vtkDataArray *faces = nullptr, *faceLocations = nullptr; ///< of polyhedra

  MOTERENDERINGDATA_EXPORT explicit GridArrays(vtkUnstructuredGrid* grid);
  std::array<vtkDataArray*, 6> all() const
  {
    return {points, types, offsets, connectivity, faces, faceLocations};
  }
};

/// The cells of an unstructured grid as the kernels see them, and what keeps their memory alive.
class GridCells
{
public:
  MOTERENDERINGDATA_EXPORT explicit GridCells(const GridArrays& arrays);
  MOTERENDERINGDATA_EXPORT HexMeshInput input() const;
  /// Of all numbers, which tells whether the cells of two grids are the same.
  MOTERENDERINGDATA_EXPORT ContentHash hash() const;

private:
  std::array<DataArrayView, 6> views_;
};

} // namespace mote
