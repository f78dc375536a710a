#pragma once

#include "PickedPanel.h"
#include "stage/Plot.h"
#include "stage/Stage.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <utility>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// The part of the panel that plots how values are distributed: a histogram of one, or of two as an
/// image; a range that is dragged in it is shown.
class PlotPanel
{
public:
  PlotPanel();
  ~PlotPanel();

  /// Changes `next`, the settings to be, where the user chose arrays or ranges.
  /// What the user asked for, or None.
  Action draw(const Stage& stage, const PickedSet& picked, Settings& next);
  /// Plots what the settings ask for, though it is not drawn.
  void update(const Stage& stage, const PickedSet& picked);

  /// What was plotted by these.
  const Plot& plot() const { return plot_; }
  const PlotChoice& plotted() const { return plotted_; }

private:
  void choose(const Stage& stage, const PlotSettings& wanted);
  void drawChoices(PlotSettings& next) const;
  void follow(const Stage& stage, const PickedSet& picked);
  void drawPlot(Settings& next);
  void drag(const std::array<double, 2>& at, const float* size, Settings& next);
  void drawCounts(const float* from, const float* size) const;
  void drawLimits(Settings& settings, const float* from, const float* size) const;
  void drawFields(Settings& next) const;

  PlotChoice choice_;
  bool isLogarithmic_ = false; ///< while drawing
  std::vector<std::string> names_;
  std::vector<std::pair<vtkDataSet*, unsigned long>> data_; ///< of names_ and plot_
  Plot plot_;
  PlotChoice plotted_;
  unsigned long chosenTime_ = 0; ///< of what is visible, or picked, in plot_
  double seconds_ = 0.0;         ///< that plot_ took
  /// Where a range begins that is dragged.
  struct Pressed
  {
    std::array<double, 2> at;      ///< shares of the plot
    std::vector<ShowRange> ranges; ///< that were shown then
    bool isMoved = false;
  };
  std::optional<Pressed> pressed_;
  float heldTop_ = 0.0f; ///< of the plot on the screen, when it was pressed
  vtkSmartPointer<vtkLookupTable> colors_;
};

} // namespace mote::app
