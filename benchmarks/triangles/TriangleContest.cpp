#include "TriangleContest.h"

#include "../Display.h"
#include "../particles/Comparison.h"

#include <kernels/core/Error.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mote::bench
{

const std::vector<View>& triangleViews()
{
  static const std::vector<View> all = {
    {"far", "eye at (1.6, 1, 2.15) sides from the middle: triangles are smaller than pixels",
      {1.6, 1.0, 2.15}},
    {"near", "eye at (0.65, 0.3, 0.7) sides from the middle", {0.65, 0.3, 0.7}}};
  return all;
}

namespace
{

/// Pixels that one of two images hits and the other does not, or that differ by more than a
/// 10,000th of the depth.
std::size_t differingPixels(const TriangleImage& a, const TriangleImage& b)
{
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
    {
      const float s = a.t(x, y), t = b.t(x, y);
      count += std::isfinite(s) != std::isfinite(t) ||
               (std::isfinite(s) && std::abs(s - t) > 1e-4f * std::min(s, t));
    }
  return count;
}

std::size_t differingRays(const OcclusionAnswers& a, const OcclusionAnswers& b)
{
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    count += static_cast<std::size_t>(std::popcount(a[k] ^ b[k]));
  return count;
}

std::size_t differingHits(const std::vector<PacketHits>& a, const std::vector<PacketHits>& b)
{
  std::size_t count = 0;
  for (std::size_t p = 0; p < a.size(); ++p)
    for (int i = 0; i < OcclusionRays::packetRays; ++i)
    {
      const float s = a[p].t[i], t = b[p].t[i];
      count += std::isfinite(s) != std::isfinite(t) ||
               (std::isfinite(s) && std::abs(s - t) > 1e-4f * std::min(s, t));
    }
  return count;
}

std::string number(double v, const char* pattern)
{
  char text[32];
  std::snprintf(text, sizeof text, pattern, v);
  return std::isnan(v) ? "-" : text;
}

/// Median seconds of building it anew a few times: the first time memory is the system's to clear.
double secondsToBuild(TriangleMethod& method, const TriangleInput& input, int threads, int repeat)
{
  constexpr double longTime = 15.0;
  std::vector<double> seconds;
  do
    seconds.push_back(timed(threads, [&] { method.build(input); }));
  while (static_cast<int>(seconds.size()) < std::min(repeat, 3) && seconds.back() < longTime);
  return median(seconds);
}

} // namespace

TriangleContest::TriangleContest(const Options& options, const TriangleInput& input)
  : options_(options)
  , input_(input)
  , threads_(threadCount(options.threads))
{
  for (const TriangleMethodEntry& entry : triangleMethods())
    if (isWanted(options, entry.name) && !(entry.draws && options.methods.empty() && !hasDisplay()))
      build(entry);
  for (const View& view : triangleViews())
    if (options.views.empty() ||
        std::find(options.views.begin(), options.views.end(), view.name) != options.views.end())
      addView(view);
}

void TriangleContest::build(const TriangleMethodEntry& entry)
{
  Built built{entry.name, entry.make(threads_), 0.0, std::nan(""), 0.0};
  built.seconds = secondsToBuild(*built.method, input_, threads_, options_.repeat);
  bool made = false;
  if (*std::max_element(options_.poe.begin(), options_.poe.end()) > 0.0)
    if (const double seconds = timed(threads_, [&] { made = built.method->makeLods(); }); made)
      built.lodSeconds = seconds;
  built.bytesPerTriangle =
    static_cast<double>(built.method->bytes()) / static_cast<double>(input_.triangles.size());
  progress("built %s in %.3f s, R-LODs in %.3f s, %.1f bytes a triangle", built.name.c_str(),
    built.seconds, built.lodSeconds, built.bytesPerTriangle);
  methods_.push_back(std::move(built));
}

void TriangleContest::addView(const View& view)
{
  views_.push_back(view);
  cameras_.emplace_back(cameraOf(view, input_.bounds), options_.width, options_.height);
  TriangleImage image(options_.width, options_.height);
  methods_.front().method->cast(0, cameras_.back(), image);
  std::vector<SecondaryRays>& rays = rays_.emplace_back();
  for (const TriangleTask task : triangleTasks)
  {
    rays.push_back(secondaryRays(task, image, cameras_.back(), input_.bounds));
    if (task == TriangleTask::Occlusion && rays.back().rays.count == 0)
      throw Error("View " + view.name + " shows no triangle at this size.");
  }
  std::vector<Answers>& answers = answers_.emplace_back();
  for (const TriangleTask task : triangleTasks)
    answers.push_back(answersFor({0, views_.size() - 1, 0, task}));
}

const SecondaryRays& TriangleContest::raysOf(const Entry& entry) const
{
  return rays_[entry.view][static_cast<std::size_t>(entry.task)];
}

std::vector<std::string> TriangleContest::modesOf(const Entry& entry) const
{
  return methods_[entry.method].method->modes(entry.task);
}

void TriangleContest::work(const Entry& entry, std::size_t mode, Answers& answers)
{
  TriangleMethod& method = *methods_[entry.method].method;
  method.setPoe(entry.poe);
  if (entry.task == TriangleTask::Primary)
    method.cast(mode, cameras_[entry.view], answers.image);
  else if (entry.task == TriangleTask::Reflection)
    method.castRays(mode, raysOf(entry), answers.hits);
  else
    method.occlude(entry.task, mode, raysOf(entry), answers.bits);
}

TriangleContest::Answers TriangleContest::answersFor(const Entry& entry) const
{
  const std::size_t packets = raysOf(entry).rays.packets.size();
  const bool isPicture = entry.task == TriangleTask::Primary;
  return {TriangleImage(isPicture ? options_.width : 1, isPicture ? options_.height : 1),
    OcclusionAnswers(packets),
    std::vector<PacketHits>(entry.task == TriangleTask::Reflection ? packets : 0)};
}

void TriangleContest::enter(std::size_t method, std::size_t view, TriangleTask task, double poe)
{
  Entry entry{method, view, 0, task, poe};
  const std::size_t modes = modesOf(entry).size();
  if (modes == 0 || (task != TriangleTask::Primary && raysOf(entry).rays.count == 0))
    return; // nothing that is seen faces the light, for one
  for (std::size_t mode = 0; mode < modes; ++mode)
  {
    const std::size_t place = race_.add(threads_, [this, entry, mode]
      { work(entry, mode, answers_[entry.view][static_cast<std::size_t>(entry.task)]); });
    if (mode == 0)
      entry.first = place;
  }
  entry.modes = modes;
  entries_.push_back(entry);
}

Report TriangleContest::race()
{
  for (std::size_t v = 0; v < views_.size(); ++v)
    for (const TriangleTask task : triangleTasks)
      for (std::size_t m = 0; m < methods_.size(); ++m)
        for (const double poe : methods_[m].hasLods() ? options_.poe : std::vector<double>{0.0})
          enter(m, v, task, poe);
  progress("casting %d rounds of %zu methods", options_.repeat, methods_.size());
  race_.run(options_.repeat);
  return report();
}

std::size_t TriangleContest::best(const Entry& entry) const
{
  return entry.first + race_.fastest(entry.first, entry.modes);
}

const TriangleContest::Entry* TriangleContest::find(
  const std::string& method, const Entry& like, TriangleTask task, double poe) const
{
  for (const Entry& entry : entries_)
    if (methods_[entry.method].name == method && entry.view == like.view && entry.task == task &&
        entry.poe == poe)
      return &entry;
  return nullptr;
}

double TriangleContest::timesPeer(const Entry& entry, const std::string& peer) const
{
  const Entry* other = find(peer, entry, entry.task, 0.0);
  return other != nullptr ? 1.0 / race_.ratio(best(entry), best(*other)) : std::nan("");
}

std::size_t TriangleContest::differing(const Entry& entry)
{
  Entry first = entry;
  first.method = 0;
  first.poe = 0.0;
  if (modesOf(first).empty())
    return 0;
  Answers exact = answersFor(entry), found = answersFor(entry);
  work(first, 0, exact);
  work(entry, best(entry) - entry.first, found);
  return entry.task == TriangleTask::Primary      ? differingPixels(exact.image, found.image)
         : entry.task == TriangleTask::Reflection ? differingHits(exact.hits, found.hits)
                                                  : differingRays(exact.bits, found.bits);
}

/// What a picture with levels of detail makes wrong.
LodErrors TriangleContest::errorsOf(const Entry& entry) const
{
  if (entry.task != TriangleTask::Primary || entry.poe == 0.0)
    return {0.0, 0.0, 0.0, 0.0, 0, 0};
  const Built& built = methods_[entry.method];
  built.method->setPoe(entry.poe);
  return built.method->lodErrors(cameras_[entry.view], options_.width, options_.height);
}

TriangleContest::Result TriangleContest::resultOf(const Entry& entry)
{
  const Built& built = methods_[entry.method];
  const std::vector<std::string> modes = modesOf(entry);
  Result result;
  result.mode = modes[best(entry) - entry.first];
  result.seconds = race_.seconds(best(entry));
  result.rays = static_cast<double>(entry.task == TriangleTask::Primary
                                      ? std::size_t(options_.width) * options_.height
                                      : raysOf(entry).rays.count);
  built.method->setPoe(entry.poe);
  if (entry.task == TriangleTask::Primary)
    result.visits = built.method->visits(
      best(entry) - entry.first, cameras_[entry.view], options_.width, options_.height);
  result.timesEmbree = timesPeer(entry, "embree");
  result.timesExact = timesPeer(entry, built.name);
  result.differing = differing(entry);
  result.errors = errorsOf(entry);
  for (std::size_t mode = 0; mode < modes.size(); ++mode)
    progress("%s, view %s, PoE %g, %s %s: %.2f Mrays/s", nameOf(entry.task),
      views_[entry.view].name.c_str(), entry.poe, built.name.c_str(), modes[mode].c_str(),
      1e-6 * result.rays / race_.seconds(entry.first + mode));
  return result;
}

void TriangleContest::addRows(const Entry& entry, const Result& r, Sections& sections) const
{
  const Built& built = methods_[entry.method];
  const std::string& view = views_[entry.view].name;
  const std::string poe = number(entry.poe, "%g");
  sections.speed.table.add({nameOf(entry.task), built.name, r.mode, view, poe,
    number(1e-6 * r.rays / r.seconds, "%.2f"), number(1.0 / r.seconds, "%.2f"),
    number(r.timesEmbree, "%.2f"), number(r.timesExact, "%.2f"), number(r.visits.nodes, "%.3f"),
    number(r.visits.clusters, "%.3f"), number(1e-6 * r.visits.bytes, "%.1f"),
    number(built.seconds, "%.3f"), number(built.lodSeconds, "%.3f"),
    number(built.bytesPerTriangle, "%.1f"), std::to_string(r.differing)});
  if (entry.task == TriangleTask::Primary && entry.poe > 0.0)
    sections.errors.table.add(
      {built.name, view, poe, number(1e3 * r.seconds, "%.2f"), number(r.timesExact, "%.2f"),
        number(r.errors.rms, "%.3f"), number(r.errors.mostOfMany, "%.2f"),
        number(r.errors.most, "%.2f"), number(r.errors.lods, "%.3f"),
        std::to_string(r.errors.holes), std::to_string(r.errors.extra)});
}

/// Frames that need primary rays alone, or others too: their times added up.
void TriangleContest::addFrames(const Entry& primary, Table& table) const
{
  const auto seconds = [&](const std::string& method, double poe, std::size_t tasks)
  {
    static constexpr TriangleTask needed[] = {
      TriangleTask::Primary, TriangleTask::Shadow, TriangleTask::Reflection};
    double sum = 0.0;
    for (std::size_t k = 0; k < tasks; ++k)
    {
      const Entry* entry = find(method, primary, needed[k], poe);
      sum += entry != nullptr ? race_.seconds(best(*entry)) : std::nan("");
    }
    return sum;
  };
  const std::string& name = methods_[primary.method].name;
  std::vector<std::string> row = {name, views_[primary.view].name, number(primary.poe, "%g")};
  for (std::size_t tasks = 1; tasks <= 3; ++tasks)
  {
    const double own = seconds(name, primary.poe, tasks);
    row.push_back(number(1.0 / own, "%.2f"));
    row.push_back(number(seconds("embree", 0.0, tasks) / own, "%.2f"));
    row.push_back(number(seconds(name, 0.0, tasks) / own, "%.2f"));
  }
  table.add(std::move(row));
}

Record TriangleContest::recordOf(const Entry& entry, const Result& r) const
{
  const Built& built = methods_[entry.method];
  return {{"suite", std::string("triangles")}, {"task", std::string(nameOf(entry.task))},
    {"method", built.name}, {"mode", r.mode}, {"input", input_.name}, {"poe", entry.poe},
    {"triangles", static_cast<std::int64_t>(input_.triangles.size())},
    {"view", views_[entry.view].name}, {"width", std::int64_t{options_.width}},
    {"height", std::int64_t{options_.height}}, {"threads", std::int64_t{threads_}},
    {"repeat", std::int64_t{options_.repeat}}, {"rays", static_cast<std::int64_t>(r.rays)},
    {"fps", 1.0 / r.seconds}, {"mrays_per_s", 1e-6 * r.rays / r.seconds},
    {"times_embree", r.timesEmbree}, {"times_exact", r.timesExact},
    {"nodes_per_ray", r.visits.nodes}, {"clusters_per_ray", r.visits.clusters},
    {"working_set_mb", 1e-6 * r.visits.bytes}, {"bytes_per_triangle", built.bytesPerTriangle},
    {"build_s", built.seconds}, {"lod_build_s", built.lodSeconds}, {"rms_error", r.errors.rms},
    {"displacement_999_pixels", r.errors.mostOfMany}, {"max_displacement_pixels", r.errors.most},
    {"holes", r.errors.holes}, {"extra", r.errors.extra},
    {"differing", static_cast<std::int64_t>(r.differing)}};
}

Report TriangleContest::report()
{
  Sections sections;
  sections.speed.table = Table(4);
  sections.speed.table.add(
    {"task", "method", "mode", "view", "PoE", "Mrays/s", "fps", "x embree", "x PoE 0", "nodes/ray",
      "clusters/ray", "MB seen", "build s", "LODs s", "bytes/triangle", "differing"});
  sections.speed.notes.push_back(
    format("%zu triangles (%s), %dx%d rays a view; occlusion rays from what is seen, %g of the "
           "longest side long; shadow rays to a light far away; reflection as of a mirror. %d "
           "threads, medians of %d rounds. Differing: from the first method's exact answer, of "
           "pixels or rays.",
      input_.triangles.size(), options_.input.c_str(), options_.width, options_.height,
      occlusionReach, threads_, options_.repeat));
  sections.errors.title = "Error against time";
  sections.errors.table = Table(2);
  sections.errors.table.add({"method", "view", "PoE", "ms", "x PoE 0", "rms", "99.9 %", "most",
    "on LODs", "holes", "extra"});
  sections.errors.notes.push_back(
    "Displacements in pixels: of hits on R-LODs from the triangles that these stand for. Holes "
    "miss where the exact picture hits; extra the other way round.");
  sections.frames.title = "Frames";
  sections.frames.table = Table(2);
  sections.frames.table.add({"method", "view", "PoE", "primary fps", "x embree", "x PoE 0",
    "with shadows", "x embree", "x PoE 0", "and reflection", "x embree", "x PoE 0"});
  Report report;
  for (const Entry& entry : entries_)
  {
    const Result result = resultOf(entry);
    addRows(entry, result, sections);
    if (entry.task == TriangleTask::Primary)
      addFrames(entry, sections.frames.table);
    report.records.push_back(recordOf(entry, result));
  }
  const auto add = [&](Section& section, const char* name, bool otherwise)
  {
    if (options_.wantsTables() ? options_.wantsTable(name) : otherwise)
      report.sections.push_back(std::move(section));
  };
  add(sections.speed, "speed", true);
  add(sections.errors, "errors", options_.poe != std::vector<double>{0.0});
  add(sections.frames, "frames", true);
  return report;
}

} // namespace mote::bench
