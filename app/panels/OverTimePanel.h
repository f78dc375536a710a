#pragma once

#include "settings/Settings.h"
#include "stage/ValuesOverTime.h"
#include "table/Keys.h"

#include <string>
#include <vector>

namespace mote::app
{

/// The part of the panel that plots the values of some particles over time.
class OverTimePanel
{
public:
  /// Returns what the user asked for; changes `next`, the settings to be, where that is another
  /// step. `usual` is the array to begin with.
  Action draw(const ValuesOverTime& values, const std::vector<double>& times, int step,
    const std::string& usual, Settings& next);

private:
  void choose(const std::vector<std::string>& names, const std::string& usual, PlotSettings& next);
  void follow(const ValuesOverTime& values, const std::string& name);
  void drawCurves(const float* from, const float* size, int step) const;
  void explain(bool isRead, int step) const;
  void drawIds() const;
  /// From 0 to 1 along the plot.
  float shareOf(int step) const;

  std::string name_, followed_; ///< that is plotted, and that the curves are of
  bool isMakeshift_ = false;    ///< name_ is, as what colours was not there
  std::uint64_t number_ = 0;    ///< of what they were taken from
  int read_ = 0;                ///< steps that the curves have
  std::vector<ValuesOverTime::Curve> curves_;
  std::vector<double> times_; ///< or numbers of steps, where there are no times
  double least_ = 0.0, most_ = 0.0;
};

} // namespace mote::app
