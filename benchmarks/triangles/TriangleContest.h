#pragma once

#include "../Options.h"
#include "../Report.h"
#include "../Timing.h"
#include "../particles/Views.h"
#include "SecondaryRays.h"
#include "TriangleMethod.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// Where the camera may stand.
const std::vector<View>& triangleViews();

/// All methods at all tasks in all views, each as often as it has pixels of error.
class TriangleContest
{
public:
  TriangleContest(const Options& options, const TriangleInput& input);

  Report race();

private:
  struct Built
  {
    std::string name;
    std::unique_ptr<TriangleMethod> method;
    double seconds;
    double lodSeconds; ///< for levels of detail; NaN where there are none
    double bytesPerTriangle;

    bool hasLods() const { return !std::isnan(lodSeconds); }
  };

  /// What one method does at one task in one view: the places of its modes in the race.
  struct Entry
  {
    std::size_t method, view, first;
    TriangleTask task;
    double poe = 0.0;
    std::size_t modes = 0;
  };

  struct Answers
  {
    TriangleImage image;
    OcclusionAnswers bits;
    std::vector<PacketHits> hits;
  };

  /// What is told of an entry, in its fastest mode.
  struct Result
  {
    std::string mode;
    double seconds = 0.0, rays = 0.0, timesEmbree = 0.0, timesExact = 0.0;
    TriangleVisits visits;
    LodErrors errors;
    std::size_t differing = 0;
  };

  struct Sections
  {
    Section speed, errors, frames;
  };

  void build(const TriangleMethodEntry& entry);
  void addView(const View& view);
  void enter(std::size_t method, std::size_t view, TriangleTask task, double poe);
  const SecondaryRays& raysOf(const Entry& entry) const;
  std::vector<std::string> modesOf(const Entry& entry) const;
  Answers answersFor(const Entry& entry) const;
  void work(const Entry& entry, std::size_t mode, Answers& answers);
  std::size_t best(const Entry& entry) const;
  const Entry* find(
    const std::string& method, const Entry& like, TriangleTask task, double poe) const;
  /// Median over the rounds of the seconds of a method's exact answer over these; NaN without it.
  double timesPeer(const Entry& entry, const std::string& peer) const;
  /// In how many pixels, or rays, the answers differ from those of the first method.
  std::size_t differing(const Entry& entry);
  LodErrors errorsOf(const Entry& entry) const;
  Result resultOf(const Entry& entry);
  void addRows(const Entry& entry, const Result& result, Sections& sections) const;
  void addFrames(const Entry& primary, Table& table) const;
  Record recordOf(const Entry& entry, const Result& result) const;
  Report report();

  const Options& options_;
  const TriangleInput& input_;
  int threads_;
  std::vector<Built> methods_;
  std::vector<View> views_;
  std::vector<CameraRays> cameras_;
  std::vector<std::vector<SecondaryRays>> rays_; ///< of each view, for each task
  std::vector<std::vector<Answers>> answers_;    ///< likewise
  std::vector<Entry> entries_;
  Race race_;
};

} // namespace mote::bench
