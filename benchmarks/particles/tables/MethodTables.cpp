// Methods beside one another: speed, memory, time to build.

#include "../BuildCosts.h"
#include "Tables.h"

#include <kernels/particles/GeneratedParticles.h>

namespace mote::bench
{

namespace
{

std::string threadsText(int threads)
{
  return format("%d thread%s", threads, threads == 1 ? "" : "s");
}

} // namespace

Section referenceGridTable(TableRun& run)
{
  const std::vector<std::string> names = {"cgt", "cgt-reference"};
  const std::vector<BuildCost> builds =
    measureBuilds({&methodNamed(names[0]), &methodNamed(names[1])}, run.methodOptions(), run.input,
      {run.threads}, run.options.repeat);
  Contest contest = run.contest();
  for (const std::string& name : names)
    contest.add(contestantOf(methodNamed(name), run.methodOptions(), run.input, run.threads));
  contest.race();
  contest.check(run.references);

  Section section;
  std::vector<std::string> titles = {"method"};
  for (const View& view : run.views)
    titles.push_back(view.name + " ms");
  titles.insert(titles.end(), {"build ms", "bytes/particle"});
  section.table.add(titles);
  for (std::size_t c = 0; c < contest.size(); ++c)
  {
    std::vector<std::string> row = {names[c]};
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      contest.at(c, v).buildSeconds = builds[c].first;
      row.push_back(format("%.1f", 1e3 * contest.at(c, v).seconds));
    }
    row.push_back(format("%.1f", 1e3 * builds[c].first));
    row.push_back(format("%.1f", contest.at(c, 0).bytesPerParticle));
    section.table.add(row);
  }
  run.record(contest);
  return section;
}

Section methodTable(TableRun& run)
{
  Contest contest = run.contest();
  const std::vector<int> counts = threadCounts(run.threads);
  for (const ParticleMethodEntry& entry : particleMethods())
  {
    const Contestant contestant = contestantOf(entry, run.methodOptions(), run.input, run.threads);
    for (const int threads : counts)
    {
      contest.add(contestant);
      contest.last().threads = threads;
    }
  }
  contest.race();
  contest.check(run.references);
  run.record(contest);

  Section section{"", Table(3)};
  std::vector<std::string> titles = {"method", "mode", "view"};
  for (const int threads : counts)
    titles.push_back(threadsText(threads) + ", Mrays/s");
  titles.insert(titles.end(), {"speed-up", "x embree", "wrong/checked"});
  section.table.add(titles);
  const std::size_t n = counts.size(), last = contest.size() - n; // embree comes last
  for (std::size_t v = 0; v < run.views.size(); ++v)
    for (std::size_t c = 0; c < contest.size(); c += n)
    {
      const Measurement& one = contest.at(c, v);
      const Measurement& all = contest.at(c + n - 1, v);
      std::vector<std::string> row = {one.method, one.mode, one.view};
      for (std::size_t k = 0; k < n; ++k)
        row.push_back(format("%.2f", contest.at(c + k, v).mrays()));
      row.push_back(n > 1 ? format("%.2f", all.mrays() / one.mrays()) : "-");
      row.push_back(format("%.2f", one.mrays() / contest.at(last, v).mrays()));
      row.push_back(format("%zu/%zu", one.errors.wrong, one.errors.checked));
      section.table.add(row);
    }
  section.notes.push_back("x embree: on one thread.");
  return section;
}

Section radiiTable(TableRun& run)
{
  const std::size_t count = run.input.statistics.valid;
  const ParticleInput equal =
    makeParticleInput(format("random:%zu:%.9g", count, equalRadius(count)));
  const ParticleInput varied = makeParticleInput(format("varied:%zu", count));
  const std::vector<std::string> names = {"cgt", "embree"};
  Contest contest = run.contest();
  for (const std::string& name : names)
    for (const ParticleInput* input : {&equal, &varied})
      contest.add(contestantOf(methodNamed(name), run.methodOptions(), *input, run.threads));
  contest.race();
  contest.check(run.references);
  run.record(contest);

  Section section{"", Table(2)};
  section.table.add({"method", "view", equal.name + " ms", varied.name + " ms", "ratio",
    "wrong, one radius", "wrong, varied"});
  for (std::size_t k = 0; k < names.size(); ++k)
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      const Measurement &one = contest.at(2 * k, v), &many = contest.at(2 * k + 1, v);
      section.table.add({names[k], run.views[v].name, format("%.1f", 1e3 * one.seconds),
        format("%.1f", 1e3 * many.seconds), format("%.2f", many.seconds / one.seconds),
        format("%zu", one.errors.wrong), format("%zu", many.errors.wrong)});
    }
  section.notes.push_back("These inputs are made, as many particles each as the input has.");
  return section;
}

Section buildTable(TableRun& run)
{
  std::vector<const ParticleMethodEntry*> methods;
  for (const ParticleMethodEntry& entry : particleMethods())
    methods.push_back(&entry);
  const std::vector<BuildCost> costs = measureBuilds(
    methods, run.methodOptions(), run.input, threadCounts(run.threads), run.options.repeat);
  for (const BuildCost& cost : costs)
    run.record(toMeasurement(cost, run.input, run.options.repeat));
  return buildSection(costs);
}

} // namespace mote::bench
