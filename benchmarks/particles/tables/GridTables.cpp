// How Mote's grid is used: size of bundles, size of the image, cells a particle.

#include "../StructureMethod.h"
#include "Tables.h"

#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

namespace
{

/// A grid built as `options` say, and how long that took.
struct TimedGrid
{
  std::shared_ptr<CoherentGrid> grid = std::make_shared<CoherentGrid>();
  double seconds = 0.0;
  double bytesPerParticle = 0.0;
};

TimedGrid buildGrid(const TableRun& run, double lambda)
{
  TimedGrid built;
  CoherentGridOptions options;
  options.keepIndices = false;
  options.cellsPerParticle = lambda;
  built.seconds = timed(run.threads, [&] { built.grid->build(run.input.set, options); });
  built.bytesPerParticle =
    static_cast<double>(built.grid->bytes()) / static_cast<double>(run.input.statistics.valid);
  return built;
}

Contestant bundles(const TableRun& run, const TimedGrid& built, int side, const std::string& mode)
{
  return {"cgt", {mode},
    [grid = built.grid, side](std::size_t, const CameraRays& rays, HitImage& image)
    { castBundles(*grid, side, rays, image); },
    &run.input, run.threads, built.seconds, built.bytesPerParticle};
}

/// "first" and then a column a view.
std::vector<std::string> head(const TableRun& run, std::vector<std::string> row, const char* what)
{
  for (const View& view : run.views)
    row.push_back(view.name + ' ' + what);
  return row;
}

} // namespace

Section packetTable(TableRun& run)
{
  const TimedGrid built = buildGrid(run, run.options.lambda);
  Contest contest = run.contest();
  for (const int side : {2, 4, 8, 16})
    contest.add(bundles(run, built, side, format("packet %dx%d", side, side)));
  contest.add(bundles(run, built, 0, "auto"));
  contest.race();
  contest.check(run.references);
  run.record(contest);

  Section section;
  section.table.add(head(run, {"bundle"}, "Mrays/s"));
  for (std::size_t c = 0; c < contest.size(); ++c)
  {
    std::vector<std::string> row = {contest.at(c, 0).mode};
    for (std::size_t v = 0; v < run.views.size(); ++v)
      row.push_back(format("%.2f", contest.at(c, v).mrays()));
    section.table.add(row);
  }
  return section;
}

Section resolutionTable(TableRun& run)
{
  Section section;
  std::vector<std::string> titles = {"image"};
  for (const View& view : run.views)
    for (const char* what : {" cgt Mrays/s", " embree", " ratio"})
      titles.push_back(view.name + what);
  section.table.add(titles);
  for (const int side : {256, 512, 1024, 2048})
  {
    Contest contest = run.contest(side, side);
    for (const char* method : {"cgt", "embree"})
      contest.add(contestantOf(methodNamed(method), run.methodOptions(), run.input, run.threads));
    contest.race();
    contest.check(run.references);
    run.record(contest);
    std::vector<std::string> row = {format("%dx%d", side, side)};
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      const double own = contest.at(0, v).mrays(), peer = contest.at(1, v).mrays();
      row.push_back(format("%.2f", own));
      row.push_back(format("%.2f", peer));
      row.push_back(format("%.2f", own / peer));
    }
    section.table.add(row);
  }
  return section;
}

Section lambdaTable(TableRun& run)
{
  Contest contest = run.contest();
  const double lambdas[] = {0.2, 0.5, 1.0, 2.0, 5.0};
  for (const double lambda : lambdas)
    contest.add(
      bundles(run, buildGrid(run, lambda), run.options.packet, format("lambda %g", lambda)));
  contest.race();
  contest.check(run.references);

  Section section;
  std::vector<std::string> titles = head(run, {"lambda"}, "Mrays/s");
  titles.insert(titles.end(), {"build s", "bytes/particle"});
  section.table.add(titles);
  for (std::size_t c = 0; c < contest.size(); ++c)
  {
    std::vector<std::string> row = {format("%g", lambdas[c])};
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      contest.at(c, v).more = {{"lambda", lambdas[c]}};
      row.push_back(format("%.2f", contest.at(c, v).mrays()));
    }
    row.push_back(format("%.3f", contest.at(c, 0).buildSeconds));
    row.push_back(format("%.1f", contest.at(c, 0).bytesPerParticle));
    section.table.add(row);
  }
  run.record(contest);
  return section;
}

} // namespace mote::bench
