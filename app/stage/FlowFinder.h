#pragma once

#include "Part.h"
#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkMoteStreamlines.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

namespace mote::app
{

/// Of what lines and arrows are found, and how: equal ones give the same.
struct FlowKey
{
  /// A volume: its points and arrays with their times of change, what hides its cells, how it
  /// stands.
  struct Volume
  {
    std::vector<std::pair<const void*, vtkMTimeType>> objects;
    std::vector<CellLimit> limits;
    Turn turn;
    bool operator==(const Volume&) const = default;
  };
  FlowSettings flow;
  std::vector<ShowRange> slices; ///< that arrows lie on
  std::vector<double> axis;
  int repetitions = 1; ///< that are gone through
  std::vector<Volume> volumes;
  bool operator==(const FlowKey&) const = default;

  /// What the settings ask for of the parts that are not hidden.
  static FlowKey of(const std::vector<std::unique_ptr<Part>>& parts, const Settings& settings);
  bool isEmpty() const { return volumes.empty() || (flow.lines == 0 && flow.arrows == 0); }
};

/// Triangles of lines and arrows; null where there are none. They may be shared by threads.
struct BuiltFlow
{
  FlowKey key;
  vtkSmartPointer<vtkPolyData> lines, arrows;
  vtkSmartPointer<vtkPolyData> places; ///< of the arrows, with the vectors "arrow"
  vtkIdType numberOfLines = 0;
  double tubeRadius = 0.0, arrowFactor = 0.0;
};

/// Hides parts and cells of volumes as the settings say, of whatever data is shown; `colored` is
/// the array that colours. What is wrong with the settings others tell.
void prepareFlow(const std::vector<std::unique_ptr<Part>>& parts,
  const std::vector<NamedData>& data, const Settings& settings, const ArrayChoice& colored);

/// Finds streamlines and arrows. What is built of cells lives from one time to the next.
class FlowFinder
{
public:
  /// Throws Failure and Interrupted.
  BuiltFlow find(const std::vector<std::unique_ptr<Part>>& parts, const Settings& settings,
    const Runner& runner);

private:
  struct Volumes;
  void run(const Runner& runner);
  void findLines(BuiltFlow& found, const Volumes& volumes, const Runner& runner);
  void findArrows(
    BuiltFlow& found, const Volumes& volumes, const Settings& settings, const Runner& runner);
  vtkSmartPointer<vtkPolyData> placesOnSlices(const FlowKey& key, const Volumes& volumes,
    const Settings& settings, const Runner& runner, double& apart);

  vtkNew<vtkMoteStreamlines> streamlines_;
};

} // namespace mote::app
