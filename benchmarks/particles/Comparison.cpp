#include "Comparison.h"

#include <algorithm>
#include <cmath>

namespace mote::bench
{

namespace
{

/// Speed of the peer in a view, or 0 where it took no part.
double peerSpeed(const std::vector<Measurement>& measurements, const std::string& view)
{
  for (const Measurement& m : measurements)
    if (m.method == "embree" && m.view == view)
      return m.mrays();
  return 0.0;
}

std::vector<std::string> rowOf(const Measurement& m, double peer, bool depths)
{
  const ImageErrors& errors = m.errors;
  std::vector<std::string> row = {m.method, m.mode, m.view, format("%.2f", m.mrays()),
    format("%.2f - %.2f", m.mrays(m.most), m.mrays(m.least)),
    peer > 0.0 ? format("%.2f", m.mrays() / peer) : "-", format("%.3f", m.buildSeconds),
    format("%.1f", m.bytesPerParticle), format("%zu/%zu", errors.wrong, errors.checked)};
  if (depths)
  {
    row.push_back(format("%.1e", errors.maxDepthError));
    row.push_back(format("%.1e", errors.maxRightDepthError));
  }
  return row;
}

} // namespace

ParticleInput inputOf(const Options& options)
{
  progress("making or reading %s", options.input.c_str());
  ParticleInput input = makeParticleInput(options.input);
  const ParticleStatistics& statistics = input.statistics;
  progress("%zu particles, radius %g to %g", statistics.valid, statistics.smallestRadius,
    statistics.largestRadius);
  return input;
}

bool isWanted(const Options& options, const std::string& method)
{
  const std::vector<std::string>& wanted = options.methods;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), method) != wanted.end();
}

Section comparison(const std::vector<Measurement>& measurements)
{
  const bool depths = std::none_of(measurements.begin(), measurements.end(),
    [](const Measurement& m) { return std::isnan(m.errors.maxDepthError); });
  std::vector<std::string> titles = {"method", "mode", "view", "Mrays/s", "(min - max)", "x embree",
    "build s", "bytes/particle", "wrong/checked"};
  if (depths)
    titles.insert(titles.end(), {"depth error", "of right pixels"});
  Section section{"", Table(3)};
  section.table.add(titles);
  for (const Measurement& m : measurements)
    section.table.add(rowOf(m, peerSpeed(measurements, m.view), depths));
  return section;
}

} // namespace mote::bench
