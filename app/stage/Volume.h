#pragma once

#include "Arrays.h"
#include "settings/Settings.h"

#include <vtkMoteSlice.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

class vtkDataSet;
class vtkLookupTable;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace mote::app
{

/// Cells of a part, shown as a volume.
class Volume
{
public:
  /// The settings are those of the scene.
  Volume(const VolumeSettings& settings, double tolerance);

  /// Follows the settings, and another tolerance of integrals; colours and opacities are for
  /// setColors().
  void update(double tolerance);

  /// Whether a data set has cells with a volume and an array to look by.
  static bool canShow(vtkDataSet* data);

  void setSlices(const std::vector<vtkSmartPointer<vtkMoteSlice>>& slices);

  void setData(vtkUnstructuredGrid* data);
  /// Chooses the array that colours.
  void select(const ArrayChoice& choice);
  /// How volumes look: colours by an array through the table, and opacities. `diagonal` is the size
  /// of all that is shown.
  void setColors(vtkDataSet* data, const ArrayChoice& choice, vtkLookupTable* table,
    const std::vector<OpacityPoint>& opacity, double diagonal);
  /// Hides values of the array that colours outside of all these, which ascend, until showAll().
  /// Where called again what lies in one interval of each call is left.
  void limit(const std::vector<Interval>& intervals);
  void showAll();
  /// Whether the data have the array that colours; without it they cannot be shown.
  bool isColored() const { return isColored_; }
  void setAmbient(double ambient);
  /// Bounds of the cells that have a value that is shown; not initialized where there are none.
  /// `isVisible` is that of ShownCells.
  void shownBounds(
    vtkUnstructuredGrid* data, vtkUnsignedCharArray* isVisible, double bounds[6]) const;

  vtkVolume* volume() const { return volume_; }
  vtkMoteVolumeMapper* mapper() const { return mapper_; }

private:
  void setOpacity();
  void followIsoArray(vtkUnstructuredGrid* data);

  const VolumeSettings& settings_;
  vtkNew<vtkVolume> volume_;
  vtkNew<vtkMoteVolumeMapper> mapper_;
  vtkSmartPointer<vtkLookupTable> table_;
  ArrayChoice choice_;
  std::vector<OpacityPoint> opacity_;
  bool isColored_ = true;
  bool warned_ = false;         ///< of a time step without the array
  std::vector<Interval> shown_; ///< none: nothing
};

} // namespace mote::app
