#include "GrowthSuite.h"

#include "Comparison.h"
#include "Contest.h"

#include <kernels/core/Error.h>

#include <algorithm>
#include <charconv>
#include <deque>

namespace mote::bench
{

namespace
{

constexpr std::size_t leastCount = 1'000'000;

/// The input's name with 1 M, 4 M, 16 M ... particles up to as many as it says itself.
std::vector<std::string> sizesOf(const std::string& input)
{
  const std::size_t colon = input.rfind(':');
  const char* const end = input.data() + input.size();
  std::size_t most = 0;
  if (!(input.starts_with("lattice:") || input.starts_with("varied:")) ||
      std::from_chars(input.data() + colon + 1, end, most).ptr != end || most == 0)
    throw Error("The input \"" + input + "\" is neither lattice:N nor varied:N.");
  std::vector<std::string> sizes;
  for (std::size_t count = std::min(most, leastCount); count <= most; count *= 4)
    sizes.push_back(input.substr(0, colon + 1) + std::to_string(count));
  return sizes;
}

/// Seconds that it takes to make all particles once: they are made again when they are looked at.
double makingSeconds(const ParticleInput& input, int threads)
{
  return timed(threads, [&] { examine(input.set); });
}

Report run(const Options& options)
{
  const int threads = threadCount(options.threads);
  std::deque<ParticleInput> inputs;
  std::vector<double> making;
  Contest contest(viewsNamed(options.views), options.width, options.height, options.repeat);
  for (const std::string& name : sizesOf(options.input))
  {
    progress("making %s", name.c_str());
    inputs.push_back(makeParticleInput(name, true));
    const double once = makingSeconds(inputs.back(), threads);
    for (const ParticleMethodEntry& entry : particleMethods())
      if (isWanted(options, entry.name))
        for (Contestant& contestant : contestantsOf(entry,
               {threads, options.lambda, options.packet}, inputs.back(), threads, options.poe))
        {
          contest.add(std::move(contestant));
          making.push_back(once);
        }
  }
  contest.race();

  Report report;
  Section section{"", Table(2)};
  section.table.add({"method", "view", "PoE", "particles", "ms", "(min - max)", "x first",
    "build s", "making s", "bytes/particle"});
  std::vector<Measurement> measurements;
  const std::size_t methods = contest.size() / inputs.size();
  for (std::size_t v = 0; v < contest.views().size(); ++v)
    for (std::size_t c = 0; c < contest.size(); ++c)
    {
      Measurement& m = contest.at(c, v);
      m.suite = "growth";
      m.more = {{"seconds", m.seconds}, {"making_s", making[c]}};
      const double first = contest.at(c % methods, v).seconds;
      measurements.push_back(m);
      section.table.add({m.method, m.view, format("%g", m.poe), format("%zu", m.particles),
        format("%.1f", 1e3 * m.seconds), format("%.1f - %.1f", 1e3 * m.least, 1e3 * m.most),
        format("%.2f", m.seconds / first), format("%.2f", m.buildSeconds),
        format("%.2f", making[c]), format("%.2f", m.bytesPerParticle)});
      report.records.push_back(toRecord(m));
    }
  section.notes = {
    format("%dx%d rays a view, %d threads, medians of %d rounds over all sizes; no reference.",
      options.width, options.height, threads, options.repeat),
    "Particles are made when they are looked at, which builds do twice or more; making s: once."};
  report.sections.push_back(std::move(section));
  if (options.poe != std::vector<double>{0.0})
    report.sections.push_back(lodErrors(measurements));
  return report;
}

} // namespace

Suite growthSuite()
{
  Suite suite;
  suite.name = "growth";
  suite.summary = "primary rays through ever more particles";
  suite.inputs = {{"lattice:N, varied:N", "1 M, 4 M, 16 M ... particles up to N, made on the fly"}};
  for (const ParticleMethodEntry& entry : particleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  suite.bundles = true;
  suite.lods = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
