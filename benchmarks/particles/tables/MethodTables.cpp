// Methods beside one another: speed, memory, time to build.

#include "Tables.h"

#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

namespace
{

/// The thread counts to compare: one and as many as may be used.
std::vector<int> threadCounts(const TableRun& run)
{
  return run.threads > 1 ? std::vector<int>{1, run.threads} : std::vector<int>{1};
}

std::string threadsText(int threads)
{
  return format("%d thread%s", threads, threads == 1 ? "" : "s");
}

/// Builds a new object of the method over the input; the object is made and let go of outside the
/// time.
double timedBuild(const std::string& method, const TableRun& run, int threads)
{
  MethodOptions options = run.methodOptions();
  options.threads = threads;
  const std::unique_ptr<ParticleMethod> made = methodNamed(method).make(options);
  return timed(threads, [&] { made->build(run.input); });
}

} // namespace

Section referenceGridTable(TableRun& run)
{
  const std::vector<std::string> names = {"cgt", "cgt-reference"};
  Race builds;
  for (const std::string& name : names)
    builds.addTimed([&run, name] { return timedBuild(name, run, run.threads); });
  builds.run(run.options.repeat);
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
      contest.at(c, v).buildSeconds = builds.seconds(c);
      row.push_back(format("%.1f", 1e3 * contest.at(c, v).seconds));
    }
    row.push_back(format("%.1f", 1e3 * builds.seconds(c)));
    row.push_back(format("%.1f", contest.at(c, 0).bytesPerParticle));
    section.table.add(row);
  }
  run.record(contest);
  return section;
}

Section methodTable(TableRun& run)
{
  Contest contest = run.contest();
  const std::vector<int> counts = threadCounts(run);
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
  const std::vector<int> counts = threadCounts(run);
  std::vector<std::string> names = {"cgt again"};
  for (const ParticleMethodEntry& entry : particleMethods())
    names.push_back(entry.name);
  Race race;
  for (const int threads : counts)
  {
    // The object that is built into again and again lives as long as the race.
    const auto grid = std::make_shared<CoherentGrid>();
    race.add(threads,
      [&run, grid]
      {
        CoherentGridOptions options;
        options.keepIndices = false;
        options.cellsPerParticle = run.options.lambda;
        grid->build(run.input.set, options);
      });
    for (std::size_t k = 1; k < names.size(); ++k)
      race.addTimed([&run, name = names[k], threads] { return timedBuild(name, run, threads); });
  }
  race.run(run.options.repeat);

  Section section;
  std::vector<std::string> titles = {"method"};
  for (const int threads : counts)
  {
    titles.push_back(threadsText(threads) + ", ms");
    titles.push_back("embree / this");
  }
  section.table.add(titles);
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    std::vector<std::string> row = {names[k]};
    for (std::size_t t = 0; t < counts.size(); ++t)
    {
      const double own = race.seconds(t * names.size() + k);
      const double peer = race.seconds(t * names.size() + names.size() - 1);
      row.push_back(format("%.1f", 1e3 * own));
      row.push_back(format("%.2f", peer / own));
      Measurement m = run.measurement(k == 0 ? "cgt" : names[k], k == 0 ? "again" : "first");
      m.threads = counts[t];
      m.buildSeconds = own;
      run.record(m);
    }
    section.table.add(row);
  }
  section.notes.push_back(
    "First build of a new object; cgt again: into an object that was built before.");
  return section;
}

} // namespace mote::bench
