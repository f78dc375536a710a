#include "ParticlesSuite.h"

#include "ImageCheck.h"
#include "ParticleMethod.h"

#include <kernels/core/Error.h>

#include <tbb/task_arena.h>

#include <chrono>
#include <functional>
#include <optional>
#include <thread>

namespace mote::bench
{

namespace
{

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

struct View
{
  std::string name;
  std::string summary;
  Vec3d eye; ///< from the middle, in lengths of the longest side of the bounds
};

const std::vector<View>& views()
{
  static const std::vector<View> all = {
    {"far", "eye at (1.1, 0.7, 1.5) sides from the middle: all of the data in sight",
      {1.1, 0.7, 1.5}},
    {"near", "eye at (0.65, 0.3, 0.7) sides from the middle", {0.65, 0.3, 0.7}}};
  return all;
}

Camera cameraOf(const View& view, const Box& bounds)
{
  const Vec3d size = bounds.size();
  Camera camera;
  camera.position = bounds.center() + view.eye * std::max({size.x, size.y, size.z});
  camera.forward = bounds.center() - camera.position;
  camera.up = Vec3d(0.0, 1.0, 0.0);
  camera.viewAngle = 35.0;
  return camera;
}

/// What is measured of one method in one view.
struct Timing
{
  std::vector<std::vector<double>> seconds; ///< by mode and repeat
  std::size_t best = 0;                     ///< the mode with the least median
  HitImage image{0, 0};                     ///< of that mode
  ImageErrors errors;
};

struct Entrant
{
  const ParticleMethodEntry& entry;
  std::unique_ptr<ParticleMethod> method;
  std::vector<std::string> modes;
  double buildSeconds = 0.0;
  double bytesPerParticle = 0.0;
  std::vector<Timing> timings; ///< by view
};

bool isWanted(const std::vector<std::string>& wanted, const std::string& name)
{
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

/// One run of the suite, step by step.
class Run
{
public:
  Run(const Options& options, int threads)
    : options_(options)
    , threads_(threads)
    , arena_(threads)
  {
  }

  Report operator()()
  {
    load();
    for (const ParticleMethodEntry& entry : particleMethods())
      if (isWanted(options_.methods, entry.name))
        build(entry);
    for (int k = 0; k < options_.repeat; ++k)
      castAll(k);
    finishMethods();
    check();
    return report();
  }

private:
  void load()
  {
    progress("making or reading %s", options_.input.c_str());
    input_ = makeParticleInput(options_.input);
    progress("%zu particles, radius %g to %g", input_.statistics.valid,
      input_.statistics.smallestRadius, input_.statistics.largestRadius);
    for (const View& view : views())
      if (isWanted(options_.views, view.name))
      {
        views_.push_back(view);
        rays_.emplace_back(
          cameraOf(view, input_.statistics.bounds), options_.width, options_.height);
      }
  }

  void build(const ParticleMethodEntry& entry)
  {
    Entrant entrant{entry, entry.make(threads_), {}, 0.0, 0.0, {}};
    entrant.buildSeconds = timed([&] { entrant.method->build(input_); });
    entrant.bytesPerParticle =
      static_cast<double>(entrant.method->bytes()) / static_cast<double>(input_.statistics.valid);
    entrant.modes = entrant.method->modes();
    entrant.timings.resize(views_.size());
    for (Timing& timing : entrant.timings)
      timing.seconds.resize(entrant.modes.size());
    progress("built %s in %.2f s, %.1f bytes a particle", entry.name.c_str(), entrant.buildSeconds,
      entrant.bytesPerParticle);
    entrants_.push_back(std::move(entrant));
  }

  /// Seconds that the work takes on the threads asked for; everything else may use them all.
  double timed(const std::function<void()>& work)
  {
    return arena_.execute(
      [&]
      {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      });
  }

  /// One round: every view, method and mode once, so that whatever else the machine does meanwhile
  /// falls on all of them.
  void castAll(int round)
  {
    HitImage image(options_.width, options_.height);
    if (round == 0) // the image's pages, the processor's clock, the threads
      timed([&] { entrants_.front().method->cast(0, rays_.front(), image); });
    for (std::size_t v = 0; v < views_.size(); ++v)
      for (Entrant& entrant : entrants_)
        for (std::size_t m = 0; m < entrant.modes.size(); ++m)
          entrant.timings[v].seconds[m].push_back(
            timed([&] { entrant.method->cast(m, rays_[v], image); }));
    progress("round %d of %d cast", round + 1, options_.repeat);
  }

  /// Keeps the images of the fastest modes. The structures then make room for the reference, and
  /// Embree for the threads that it holds back from the whole process.
  void finishMethods()
  {
    for (Entrant& entrant : entrants_)
    {
      for (std::size_t v = 0; v < views_.size(); ++v)
      {
        Timing& timing = entrant.timings[v];
        for (std::size_t m = 0; m < entrant.modes.size(); ++m)
        {
          if (median(timing.seconds[m]) < median(timing.seconds[timing.best]))
            timing.best = m;
          progress("view %s, %s %s: %.2f Mrays/s", views_[v].name.c_str(),
            entrant.entry.name.c_str(), entrant.modes[m].c_str(), mrays(median(timing.seconds[m])));
        }
        timing.image = HitImage(options_.width, options_.height);
        entrant.method->cast(timing.best, rays_[v], timing.image);
      }
      entrant.method.reset();
    }
  }

  void check()
  {
    progress("building the reference");
    const reference::SphereTree tree(input_.set);
    for (std::size_t v = 0; v < views_.size(); ++v)
    {
      progress("casting the reference, view %s", views_[v].name.c_str());
      const std::vector<double> depths =
        referenceDepths(tree, rays_[v], options_.width, options_.height);
      for (Entrant& entrant : entrants_)
        entrant.timings[v].errors = compare(entrant.timings[v].image, depths);
    }
  }

  double mrays(double seconds) const
  {
    return 1e-6 * options_.width * static_cast<double>(options_.height) / seconds;
  }

  /// Speed of the peer in a view, if it took part.
  std::optional<double> peerSpeed(std::size_t view) const
  {
    for (const Entrant& entrant : entrants_)
      if (entrant.entry.name == "embree")
        return mrays(median(bestSeconds(entrant, view)));
    return std::nullopt;
  }
  static const std::vector<double>& bestSeconds(const Entrant& entrant, std::size_t view)
  {
    return entrant.timings[view].seconds[entrant.timings[view].best];
  }

  Report report() const
  {
    Report report;
    report.table.add({"method", "mode", "view", "Mrays/s", "(min - max)", "x embree", "build s",
      "bytes/particle", "wrong/checked", "depth error", "of right pixels"});
    for (std::size_t v = 0; v < views_.size(); ++v)
      for (const Entrant& entrant : entrants_)
        addRow(entrant, v, report);
    report.notes.push_back(
      format("%zu particles (%s), %dx%d rays a view, %d threads, medians of %d "
             "rounds. Depth errors are relative, the largest.",
        input_.statistics.valid, options_.input.c_str(), options_.width, options_.height, threads_,
        options_.repeat));
    return report;
  }

  void addRow(const Entrant& entrant, std::size_t v, Report& report) const
  {
    const Timing& timing = entrant.timings[v];
    const std::vector<double>& seconds = bestSeconds(entrant, v);
    const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
    const double speed = mrays(median(seconds));
    const std::optional<double> peer = peerSpeed(v);
    const ImageErrors& errors = timing.errors;
    report.table.add({entrant.entry.name, entrant.modes[timing.best], views_[v].name,
      format("%.2f", speed), format("%.2f - %.2f", mrays(*most), mrays(*least)),
      peer ? format("%.2f", speed / *peer) : "-", format("%.2f", entrant.buildSeconds),
      format("%.1f", entrant.bytesPerParticle), format("%zu/%zu", errors.wrong, errors.checked),
      format("%.1e", errors.maxDepthError), format("%.1e", errors.maxRightDepthError)});
    report.records.push_back({{"suite", "particles"}, {"method", entrant.entry.name},
      {"mode", entrant.modes[timing.best]}, {"input", options_.input},
      {"particles", static_cast<std::int64_t>(input_.statistics.valid)}, {"view", views_[v].name},
      {"width", std::int64_t{options_.width}}, {"height", std::int64_t{options_.height}},
      {"threads", std::int64_t{threads_}}, {"repeat", std::int64_t{options_.repeat}},
      {"mrays_per_s", speed}, {"mrays_per_s_min", mrays(*most)}, {"mrays_per_s_max", mrays(*least)},
      {"build_s", entrant.buildSeconds}, {"bytes_per_particle", entrant.bytesPerParticle},
      {"checked_pixels", static_cast<std::int64_t>(errors.checked)},
      {"wrong_pixels", static_cast<std::int64_t>(errors.wrong)},
      {"max_depth_error", errors.maxDepthError},
      {"max_depth_error_of_right", errors.maxRightDepthError}});
  }

  const Options& options_;
  int threads_;
  tbb::task_arena arena_;
  ParticleInput input_;
  std::vector<View> views_;
  std::vector<CameraRays> rays_; ///< by view
  std::vector<Entrant> entrants_;
};

Report run(const Options& options)
{
  const int threads = options.threads > 0
                        ? options.threads
                        : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return Run(options, threads)();
}

} // namespace

Suite particlesSuite()
{
  Suite suite;
  suite.name = "particles";
  suite.summary = "primary rays through particles as spheres";
  suite.inputs = particleInputs();
  for (const ParticleMethodEntry& entry : particleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  suite.run = run;
  return suite;
}

} // namespace mote::bench
