#include "FileSuite.h"

#include "../PageCache.h"
#include "../PeakMemory.h"
#include "../Timing.h"
#include "StructureMethod.h"
#include "Views.h"

#include <kernels/particles/PkdTreeFile.h>

#include <chrono>
#include <cmath>
#include <functional>

namespace mote::bench
{

namespace
{

constexpr int orbitViews = 24;

/// What has been measured at one stage.
struct Moment
{
  std::string what, view;
  double poe;
  std::vector<double> seconds{};
  double anonymous = 0.0, mapped = 0.0; ///< resident bytes: memory proper, and pages of files
  double read = 0.0;                    ///< bytes from the disk, the last time

  void add(double time, double readBefore)
  {
    seconds.push_back(time);
    anonymous = statusBytes("RssAnon");
    mapped = statusBytes("RssFile");
    read = bytesReadFromDisk() - readBefore;
  }
};

double secondsOf(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The view from so many steps of a full circle farther around the vertical axis.
View turned(View view, int step, int steps)
{
  const double angle = 2.0 * 3.14159265358979323846 * step / steps;
  const Vec3d eye = view.eye;
  view.eye = {std::cos(angle) * eye.x + std::sin(angle) * eye.z, eye.y,
    std::cos(angle) * eye.z - std::sin(angle) * eye.x};
  return view;
}

/// All measurements on one file.
class FileRun
{
public:
  explicit FileRun(const Options& options)
    : options_(options)
    , threads_(threadCount(options.threads))
    , image_(options.width, options.height)
  {
  }

  void run()
  {
    for (const View& view : viewsNamed(options_.views))
    {
      for (const double poe : options_.poe)
        for (const bool cold : {true, false})
          this->openAndLook(view, cold, poe);
    }
    const PkdTreeFile file(options_.input);
    for (const View& view : viewsNamed(options_.views))
      for (const double poe : options_.poe)
        this->frames(file, view, poe);
    for (const double poe : options_.poe)
      this->orbit(file, views().front(), poe);
  }

  const std::vector<Moment>& moments() const { return moments_; }
  int threads() const { return threads_; }
  const std::string& forgetting() const { return forgetting_; }
  double residentWhenCold() const { return residentWhenCold_; }

private:
  /// Casts a picture of a view; returns seconds.
  double look(const PkdTreeFile& file, const View& view, double poe)
  {
    PkdTree tree = file.tree();
    const CameraRays rays(
      cameraOf(view, file.statistics().bounds), options_.width, options_.height);
    return timed(threads_,
      [&]
      {
        if (poe > 0.0)
          tree.makeLods(); // where the file holds none
        castBundles(tree, 0, rays, image_, poe);
      });
  }

  /// Opens the file and casts its first picture, with nothing of it in memory or all that it takes.
  void openAndLook(const View& view, bool cold, double poe)
  {
    const std::string state = cold ? "cold" : "warm";
    Moment open{"open " + state, view.name, poe}, first{"first picture " + state, view.name, poe};
    for (int k = 0; k < options_.repeat; ++k)
    {
      if (cold)
      {
        forgetting_ = forgetPages(options_.input);
        residentWhenCold_ = std::max(residentWhenCold_, residentShare(options_.input));
      }
      const double before = bytesReadFromDisk();
      std::unique_ptr<const PkdTreeFile> file;
      const double opened =
        secondsOf([&] { file = std::make_unique<const PkdTreeFile>(options_.input); });
      open.add(opened, before);
      const double looked = this->look(*file, view, poe);
      first.add(opened + looked, before);
      progress("%s, view %s, %g pixels of error: opened in %.3f ms, first picture after %.3f s",
        state.c_str(), view.name.c_str(), poe, 1e3 * opened, opened + looked);
    }
    moments_.push_back(open);
    moments_.push_back(first);
  }

  void frames(const PkdTreeFile& file, const View& view, double poe)
  {
    Moment frame{"frame", view.name, poe};
    this->look(file, view, poe); // pages
    for (int k = 0; k < 5 * options_.repeat; ++k)
    {
      const double before = bytesReadFromDisk();
      frame.add(this->look(file, view, poe), before);
    }
    moments_.push_back(frame);
  }

  /// Around the data at the distance of a view.
  void orbit(const PkdTreeFile& file, const View& view, double poe)
  {
    Moment first{"first orbit", "around", poe}, orbit{"orbit", "around", poe};
    for (int round = 0; round < 2; ++round)
      for (int k = 0; k < orbitViews; ++k)
      {
        const double before = bytesReadFromDisk();
        const double seconds = this->look(file, turned(view, k, orbitViews), poe);
        (round == 0 ? first : orbit).add(seconds, before);
      }
    moments_.push_back(first);
    moments_.push_back(orbit);
  }

  const Options& options_;
  int threads_;
  HitImage image_;
  std::vector<Moment> moments_;
  std::string forgetting_;
  double residentWhenCold_ = 0.0;
};

Record toRecord(
  const Moment& moment, const FileRun& run, const PkdTreeFile& file, const Options& options)
{
  const auto [least, most] = std::minmax_element(moment.seconds.begin(), moment.seconds.end());
  return {{"suite", std::string("file")}, {"what", moment.what}, {"input", options.input},
    {"particles", static_cast<std::int64_t>(file.size())},
    {"file_bytes", static_cast<std::int64_t>(file.bytes())}, {"view", moment.view},
    {"poe", moment.poe}, {"width", std::int64_t{options.width}},
    {"height", std::int64_t{options.height}}, {"threads", std::int64_t{run.threads()}},
    {"repeat", static_cast<std::int64_t>(moment.seconds.size())},
    {"seconds", median(moment.seconds)}, {"seconds_min", *least}, {"seconds_max", *most},
    {"rss_anon_bytes", moment.anonymous}, {"rss_file_bytes", moment.mapped},
    {"read_bytes", moment.read}, {"forgetting", run.forgetting()}};
}

std::vector<std::string> rowOf(const Moment& moment)
{
  const double seconds = median(moment.seconds);
  const auto [least, most] = std::minmax_element(moment.seconds.begin(), moment.seconds.end());
  const bool isFrame = moment.what == "frame" || moment.what.ends_with("orbit");
  return {moment.what, moment.view, format("%g", moment.poe), format("%.3f", 1e3 * seconds),
    format("%.3f - %.3f", 1e3 * *least, 1e3 * *most), isFrame ? format("%.2f", 1.0 / seconds) : "",
    format("%.1f", 1e-6 * moment.anonymous), format("%.1f", 1e-6 * moment.mapped),
    format("%.1f", 1e-6 * moment.read)};
}

Report run(const Options& options)
{
  FileRun run(options);
  run.run();
  const PkdTreeFile file(options.input);
  Report report;
  Section section{"", Table(2)};
  section.table.add({"what", "view", "PoE", "ms", "(min - max)", "frames/s", "RssAnon MB",
    "RssFile MB", "read MB"});
  for (const Moment& moment : run.moments())
  {
    section.table.add(rowOf(moment));
    report.records.push_back(toRecord(moment, run, file, options));
  }
  section.notes = {
    format("%zu particles in %.3f GB (%s), %dx%d rays a picture, %d threads, medians.", file.size(),
      1e-9 * static_cast<double>(file.bytes()), options.input.c_str(), options.width,
      options.height, run.threads()),
    format("First pictures: from before the file is opened. Cold: after %s, with %.2f %% of the "
           "file in memory. Orbit: %d views around, the first time and again.",
      run.forgetting().c_str(), 100.0 * run.residentWhenCold(), orbitViews),
    "Resident memory and bytes read stand after the last time."};
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite fileSuite()
{
  Suite suite;
  suite.name = "file";
  suite.summary = "opening and drawing a .mote file of any size, with and without it in memory";
  suite.inputs = {{"FILE", "a .mote file; mote convert writes them"}};
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  suite.lods = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
