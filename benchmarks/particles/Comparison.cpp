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

Section lodErrors(const std::vector<Measurement>& measurements)
{
  Section section{"Error against time", Table(2)};
  section.table.add({"method", "view", "PoE", "particles", "ms", "x PoE 0", "rms", "99.9 %", "most",
    "on boxes", "holes", "extra", "coverage", "brightness", "color", "exact", "flicker", "exact"});
  const auto number = [](const char* pattern, double v)
  { return std::isnan(v) ? std::string("-") : format(pattern, v); };
  for (const Measurement& m : measurements)
  {
    double exact = unknown;
    for (const Measurement& other : measurements)
      if (other.poe == 0.0 && other.method == m.method && other.view == m.view &&
          other.particles == m.particles)
        exact = other.seconds;
    const ParticleLodErrors& e = m.lodErrors;
    if (!std::isnan(m.lodSeconds))
      section.table.add({m.method, m.view, format("%g", m.poe), format("%zu", m.particles),
        format("%.2f", 1e3 * m.seconds), number("%.2f", exact / m.seconds), number("%.3f", e.rms),
        number("%.2f", e.mostOfMany), number("%.2f", e.most), number("%.3f", e.lods),
        format("%lld", static_cast<long long>(e.holes)),
        format("%lld", static_cast<long long>(e.extra)), number("%.3f", e.coverage),
        number("%.3f", e.brightness), number("%.3f", e.color), number("%.3f", e.exactColor),
        number("%.3f", e.flicker), number("%.3f", e.exactFlicker)});
  }
  section.notes = {
    "Displacements in pixels: of rays that hit boxes from the nearest sphere that these stand for.",
    "Coverage and brightness of 36 rays a pixel, times those of 36 exact ones; color: rms error of "
    "one ray a pixel",
    "against these; flicker: rms change of pixels when the camera moves by a quarter of one."};
  return section;
}

} // namespace mote::bench
