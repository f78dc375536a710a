#include "TrianglesSuite.h"

#include "../Display.h"
#include "../Timing.h"
#include "../particles/Comparison.h"
#include "../particles/Views.h"
#include "TriangleMethod.h"

#include <kernels/core/Error.h>
#include <kernels/particles/GeneratedParticles.h>

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

struct Built
{
  std::string name;
  std::unique_ptr<TriangleMethod> method;
  double seconds;
  double lodSeconds; ///< for levels of detail; NaN where there are none
  double bytesPerTriangle;

  bool hasLods() const { return !std::isnan(lodSeconds); }
};

/// What one method does in one view: the places of its modes in the race.
struct Entry
{
  std::size_t method, view, first;
  bool occlusion;
  double poe = 0.0;
};

/// Rays in all directions from what an image shows, a tenth of the longest side long.
OcclusionRays occlusionRaysOf(
  const TriangleImage& image, const CameraRays& camera, const Box& bounds)
{
  const Vec3d size = bounds.size();
  const double side = std::max({size.x, size.y, size.z});
  OcclusionRays rays;
  rays.reach = occlusionReach * side;
  std::uint64_t number = 0;
  for (int y0 = 0; y0 < image.height(); y0 += 8)
    for (int x0 = 0; x0 < image.width(); x0 += 8)
      for (int i = 0; i < 64; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(8, i, x, y);
        x += x0;
        y += y0;
        if (x >= image.width() || y >= image.height() || !std::isfinite(image.t(x, y)))
          continue;
        const TriangleImage::Block& block = image.blockAt(x, y);
        const int k = TriangleImage::place(x, y);
        const Vec3d way = camera.directionAt(x + 0.5, y + 0.5);
        Vec3d normal(block.normal[0][k], block.normal[1][k], block.normal[2][k]);
        if (!(glm::length(normal) > 0.0))
          continue;
        normal = glm::normalize(normal) * (glm::dot(normal, way) > 0.0 ? -1.0 : 1.0);
        const Vec3d at =
          camera.originAt(x + 0.5, y + 0.5) + double(block.t[k]) * way + 1e-5 * side * normal;
        const double a = uniformNumber(4, number), b = uniformNumber(4, number + 1);
        number += 2;
        addRay(rays, at, cosineWeighted(normal, a, b), at, Vec3d(0.0));
      }
  return rays;
}

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

/// All methods in all views.
class TriangleContest
{
public:
  TriangleContest(const Options& options, const TriangleInput& input)
    : options_(options)
    , input_(input)
    , threads_(threadCount(options.threads))
    , image_(options.width, options.height)
  {
    for (const TriangleMethodEntry& entry : triangleMethods())
      if (isWanted(options, entry.name) &&
          !(entry.draws && options.methods.empty() && !hasDisplay()))
        build(entry);
    for (const View& view : triangleViews())
      if (options.views.empty() ||
          std::find(options.views.begin(), options.views.end(), view.name) != options.views.end())
        addView(view);
  }

  Report race()
  {
    for (std::size_t v = 0; v < views_.size(); ++v)
      for (const bool occlusion : {false, true})
        for (std::size_t m = 0; m < methods_.size(); ++m)
          for (const double poe : poesOf(methods_[m], occlusion))
            enter(m, v, occlusion, poe);
    progress("casting %d rounds of %zu methods", options_.repeat, methods_.size());
    race_.run(options_.repeat);
    Report report;
    Section section, errors;
    section.table = Table(4);
    section.table.add({"task", "method", "mode", "view", "PoE", "Mrays/s", "fps", "x embree",
      "nodes/ray", "clusters/ray", "MB seen", "build s", "LODs s", "bytes/triangle", "differing"});
    errors.title = "Error against time";
    errors.table = Table(2);
    errors.table.add({"method", "view", "PoE", "ms", "x PoE 0", "rms", "99.9 %", "most", "on LODs",
      "holes", "extra"});
    for (const Entry& entry : entries_)
      report.records.push_back(recordOf(entry, section.table, errors.table));
    section.notes.push_back(
      format("%zu triangles (%s), %dx%d rays a view; occlusion rays from what "
             "is seen, %g of the longest side long; %d threads, medians of %d "
             "rounds. Differing: from the first method, of pixels or rays.",
        input_.triangles.size(), options_.input.c_str(), options_.width, options_.height,
        occlusionReach, threads_, options_.repeat));
    report.sections.push_back(std::move(section));
    errors.notes.push_back("Displacements in pixels: of hits on R-LODs from the triangles that "
                           "these stand for. Holes miss where the exact picture hits; extra the "
                           "other way round.");
    if (options_.poe != std::vector<double>{0.0})
      report.sections.push_back(std::move(errors));
    return report;
  }

private:
  void build(const TriangleMethodEntry& entry)
  {
    Built built{entry.name, entry.make(threads_), 0.0, std::nan(""), 0.0};
    built.seconds = timed(threads_, [&] { built.method->build(input_); });
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

  void addView(const View& view)
  {
    views_.push_back(view);
    cameras_.emplace_back(cameraOf(view, input_.bounds), options_.width, options_.height);
    TriangleImage image(options_.width, options_.height);
    methods_.front().method->cast(0, cameras_.back(), image);
    rays_.push_back(occlusionRaysOf(image, cameras_.back(), input_.bounds));
    if (rays_.back().count == 0)
      throw Error("View " + view.name + " shows no triangle at this size.");
    answers_.emplace_back(rays_.back().packets.size());
  }

  std::vector<std::string> modesOf(const Entry& entry) const
  {
    const TriangleMethod& method = *methods_[entry.method].method;
    return entry.occlusion ? method.occlusionModes() : method.modes();
  }

  void work(const Entry& entry, std::size_t mode, TriangleImage& image, OcclusionAnswers& answers)
  {
    TriangleMethod& method = *methods_[entry.method].method;
    method.setPoe(entry.poe);
    if (entry.occlusion)
      method.occlude(mode, rays_[entry.view], answers);
    else
      method.cast(mode, cameras_[entry.view], image);
  }

  std::vector<double> poesOf(const Built& built, bool occlusion) const
  {
    return built.hasLods() && !occlusion ? options_.poe : std::vector<double>{0.0};
  }

  void enter(std::size_t method, std::size_t view, bool occlusion, double poe)
  {
    Entry entry{method, view, 0, occlusion, poe};
    if (modesOf(entry).empty())
      return;
    for (std::size_t mode = 0; mode < modesOf(entry).size(); ++mode)
    {
      const std::size_t place = race_.add(
        threads_, [this, entry, mode] { work(entry, mode, image_, answers_[entry.view]); });
      if (mode == 0)
        entry.first = place;
    }
    entries_.push_back(entry);
  }

  /// Median over the rounds of Embree's best mode over this one, or NaN without Embree.
  double timesEmbree(const Entry& entry, std::size_t place) const
  {
    for (const Entry& peer : entries_)
      if (methods_[peer.method].name == "embree" && peer.view == entry.view &&
          peer.occlusion == entry.occlusion)
        return 1.0 /
               race_.ratio(place, peer.first + race_.fastest(peer.first, modesOf(peer).size()));
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// In how many pixels, or rays, the answers differ from those of the first method.
  std::size_t differing(const Entry& entry, std::size_t mode)
  {
    Entry first = entry;
    first.method = 0;
    first.poe = 0.0;
    TriangleImage image(options_.width, options_.height);
    OcclusionAnswers answers(rays_[entry.view].packets.size());
    work(first, 0, image_, answers_[entry.view]);
    work(entry, mode, image, answers);
    return entry.occlusion ? differingRays(answers, answers_[entry.view])
                           : differingPixels(image, image_);
  }

  /// Median over the rounds of the same method's exact picture over this one.
  double timesExact(const Entry& entry, std::size_t place) const
  {
    for (const Entry& exact : entries_)
      if (exact.method == entry.method && exact.view == entry.view && !exact.occlusion &&
          exact.poe == 0.0)
        return 1.0 /
               race_.ratio(place, exact.first + race_.fastest(exact.first, modesOf(exact).size()));
    return std::nan("");
  }

  static std::string number(double v, const char* pattern)
  {
    char text[32];
    std::snprintf(text, sizeof text, pattern, v);
    return std::isnan(v) ? "-" : text;
  }

  /// What a picture with levels of detail makes wrong, as a row.
  LodErrors errorsOf(const Entry& entry, std::size_t place, Table& table) const
  {
    if (entry.occlusion || entry.poe == 0.0)
      return {0.0, 0.0, 0.0, 0.0, 0, 0};
    const Built& built = methods_[entry.method];
    built.method->setPoe(entry.poe);
    const LodErrors errors =
      built.method->lodErrors(cameras_[entry.view], options_.width, options_.height);
    table.add({built.name, views_[entry.view].name, number(entry.poe, "%g"),
      number(1e3 * race_.seconds(place), "%.2f"), number(timesExact(entry, place), "%.2f"),
      number(errors.rms, "%.3f"), number(errors.mostOfMany, "%.2f"), number(errors.most, "%.2f"),
      number(errors.lods, "%.3f"), std::to_string(errors.holes), std::to_string(errors.extra)});
    return errors;
  }

  Record recordOf(const Entry& entry, Table& table, Table& errorTable)
  {
    const Built& built = methods_[entry.method];
    const std::vector<std::string> modes = modesOf(entry);
    const std::size_t best = race_.fastest(entry.first, modes.size());
    const double seconds = race_.seconds(entry.first + best);
    const auto rays = static_cast<double>(
      entry.occlusion ? rays_[entry.view].count : std::size_t(options_.width) * options_.height);
    const double times = timesEmbree(entry, entry.first + best);
    TriangleVisits visits;
    built.method->setPoe(entry.poe);
    if (!entry.occlusion)
      visits = built.method->visits(best, cameras_[entry.view], options_.width, options_.height);
    const std::size_t different = differing(entry, best);
    const std::string task = entry.occlusion ? "occlusion" : "primary";
    const std::string& view = views_[entry.view].name;
    for (std::size_t mode = 0; mode < modes.size(); ++mode)
      progress("%s, view %s, %s %s: %.2f Mrays/s", task.c_str(), view.c_str(), built.name.c_str(),
        modes[mode].c_str(), 1e-6 * rays / race_.seconds(entry.first + mode));
    const LodErrors errors = errorsOf(entry, entry.first + best, errorTable);
    table.add({task, built.name, modes[best], view, number(entry.poe, "%g"),
      number(1e-6 * rays / seconds, "%.2f"), number(1.0 / seconds, "%.2f"), number(times, "%.2f"),
      number(visits.nodes, "%.3f"), number(visits.clusters, "%.3f"),
      number(1e-6 * visits.bytes, "%.1f"), number(built.seconds, "%.3f"),
      number(built.lodSeconds, "%.3f"), number(built.bytesPerTriangle, "%.1f"),
      std::to_string(different)});
    return {{"suite", std::string("triangles")}, {"task", task}, {"method", built.name},
      {"mode", modes[best]}, {"input", input_.name}, {"poe", entry.poe},
      {"triangles", static_cast<std::int64_t>(input_.triangles.size())}, {"view", view},
      {"width", std::int64_t{options_.width}}, {"height", std::int64_t{options_.height}},
      {"threads", std::int64_t{threads_}}, {"repeat", std::int64_t{options_.repeat}},
      {"rays", static_cast<std::int64_t>(rays)}, {"fps", 1.0 / seconds},
      {"mrays_per_s", 1e-6 * rays / seconds}, {"times_embree", times},
      {"nodes_per_ray", visits.nodes}, {"clusters_per_ray", visits.clusters},
      {"working_set_mb", 1e-6 * visits.bytes}, {"bytes_per_triangle", built.bytesPerTriangle},
      {"build_s", built.seconds}, {"lod_build_s", built.lodSeconds}, {"rms_error", errors.rms},
      {"displacement_999_pixels", errors.mostOfMany}, {"max_displacement_pixels", errors.most},
      {"holes", errors.holes}, {"extra", errors.extra},
      {"differing", static_cast<std::int64_t>(different)}};
  }

  const Options& options_;
  const TriangleInput& input_;
  int threads_;
  TriangleImage image_;
  std::vector<Built> methods_;
  std::vector<View> views_;
  std::vector<CameraRays> cameras_;
  std::vector<OcclusionRays> rays_;
  std::vector<OcclusionAnswers> answers_;
  std::vector<Entry> entries_;
  Race race_;
};

Report run(const Options& options)
{
  progress("making or reading %s", options.input.c_str());
  const TriangleInput input = makeTriangleInput(options.input);
  return TriangleContest(options, input).race();
}

} // namespace

Suite trianglesSuite()
{
  Suite suite;
  suite.name = "triangles";
  suite.summary = "primary and occlusion rays through triangles";
  suite.inputs = triangleInputs();
  for (const TriangleMethodEntry& entry : triangleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : triangleViews())
    suite.views.emplace_back(view.name, view.summary);
  suite.cells = false;
  suite.lods = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
