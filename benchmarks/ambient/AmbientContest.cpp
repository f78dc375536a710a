#include "AmbientContest.h"

#include "../particles/Comparison.h"

#include <kernels/core/Error.h>
#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/SeenParticles.h>

#include <algorithm>
#include <cmath>

namespace mote::bench
{

namespace
{

constexpr std::size_t smallInput = 10'000;    ///< particles; all are baked up to here
constexpr std::size_t racedParticles = 2'000; ///< baked by both sides in turns
constexpr int mostRacedRays = 16;             ///< a hit; pictures of more are made once

std::string nameOf(const ParticleStructure& structure)
{
  return particleStructureNames()[1 + structure.index()];
}

double reachOf(const Options& options, const ParticleInput& input)
{
  const Vec3d size = input.statistics.bounds.size();
  return options.reach > 0.0 ? options.reach : 0.1 * std::max({size.x, size.y, size.z});
}

void draw(const Scene& scene, const Camera& camera, const PictureSize& size, Film& film)
{
  film.resize(size.width, size.height);
  RayCaster(scene).addSample(camera, film);
}

std::string text(const char* pattern, double value)
{
  return std::isnan(value) ? "-" : format(pattern, value);
}

} // namespace

AmbientContest::AmbientContest(const Options& options, const ParticleInput& input)
  : options_(options)
  , input_(input)
  , threads_(threadCount(options.threads))
  , reach_(reachOf(options, input))
  , views_(viewsNamed(options.views))
  , size_{options.width, options.height}
  , frameSize_{options.frameWidth, options.frameHeight}
{
  const auto& names = particleStructureNames();
  const auto kind = std::find(names.begin(), names.end(), options.structure) - names.begin();
  structure_ = build(static_cast<ParticleStructureKind>(kind));
  tree_ = std::holds_alternative<PkdTree>(*structure_) ? structure_
                                                       : build(ParticleStructureKind::PkdTree);
  for (const View& view : views_)
    timed(threads_,
      [&]
      {
        references_.push_back(makeReference(
          tree_, view, input.statistics.bounds, size_, options.referenceRays, reach_));
      });
  chooseLiveStructure();
  chooseParticles();
  baker_ = std::make_unique<AmbientBaker>(options, input, *structure_, reach_);
}

AmbientContest::Structure AmbientContest::build(ParticleStructureKind kind) const
{
  ParticleStructureOptions building;
  building.kind = kind;
  building.coherentGrid.cellsPerParticle = options_.lambda;
  Structure structure = makeParticleStructure(input_.set, building);
  progress("built the %s", nameOf(*structure).c_str());
  return structure;
}

void AmbientContest::chooseLiveStructure()
{
  live_ = tree_;
  if (tree_ == structure_)
    return;
  Race race;
  Film film;
  const Camera& camera = references_.front().camera;
  const Scene inTree = ambientScene(tree_, 4, reach_), other = ambientScene(structure_, 4, reach_);
  race.add(threads_, [&] { draw(inTree, camera, size_, film); });
  race.add(threads_, [&] { draw(other, camera, size_, film); });
  race.run(1);
  if (race.seconds(1) < race.seconds(0))
    live_ = structure_;
  progress("rays of hits are cast in the %s", nameOf(*live_).c_str());
}

SlotBits AmbientContest::seen(const PictureSize& size) const
{
  SlotBits all;
  for (const ReferencePicture& reference : references_)
  {
    SeenView view;
    view.width = size.width;
    view.height = size.height;
    SeenParticles found;
    findSeenParticles(ambientScene(structure_, 0, reach_), reference.camera, view, found);
    all.resize(found.front().size(), 0);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] |= found.front()[k];
  }
  return all;
}

void AmbientContest::chooseParticles()
{
  const bool all =
    options_.baked == "all" || (options_.baked == "auto" && input_.statistics.valid <= smallInput);
  if (!all)
    slots_ = seen(size_);
}

std::vector<const AmbientMethod*> AmbientContest::wanted(
  const std::function<bool(const AmbientMethod&)>& is) const
{
  std::vector<const AmbientMethod*> found;
  for (const AmbientMethod& method : ambientMethods())
    if (isWanted(options_, method.name) && is(method))
      found.push_back(&method);
  return found;
}

double AmbientContest::Entry::mrays() const
{
  if (baked.maps)
    return 1e-6 * baked.statistics.raysPerSecond();
  const double rays = static_cast<double>(reference->hits) * method->rays;
  return frame > plain ? 1e-6 * rays / (frame - plain) : unknown;
}

/// Bakes, where that is the method: one bake serves all views.
void AmbientContest::addEntry(const AmbientMethod& method, std::vector<Entry>& entries)
{
  Entry entry;
  entry.method = &method;
  entry.scene = ambientScene(method.isLive() ? live_ : structure_, method.rays, reach_);
  entry.mode = nameOf(*live_);
  if (!method.isLive())
  {
    entry.baked = baker_->bake(method, slots_, threads_);
    progress("%s: %zu particles in %.2f s, %.1f Mrays/s, %.2f bytes a particle",
      method.name.c_str(), entry.baked.statistics.particles, entry.seconds(), entry.mrays(),
      entry.baked.bytesPerParticle());
    entry.mode = entry.baked.mode;
    entry.scene.surfaces[0].occlusion = entry.baked.maps;
  }
  for (const ReferencePicture& reference : references_)
  {
    entry.reference = &reference;
    entries.push_back(entry);
  }
}

void AmbientContest::timeFrames(std::vector<Entry>& entries) const
{
  progress("%d rounds of pictures", options_.repeat);
  Film film;
  Race race;
  // Without occlusion, in the structure that lookups are made in and in that of live rays.
  const Scene plain[2] = {ambientScene(structure_, 0, reach_), ambientScene(live_, 0, reach_)};
  std::vector<std::size_t> places;
  for (Entry& entry : entries)
  {
    const auto frame = [&, this](const Scene& scene)
    { return [&, this] { draw(scene, entry.reference->camera, size_, film); }; };
    if (entry.method->rays > mostRacedRays)
    {
      entry.frame = timed(threads_, frame(entry.scene));
      places.push_back(race.add(threads_, frame(plain[1])));
      continue;
    }
    places.push_back(race.add(threads_, frame(plain[entry.method->isLive()])));
    race.add(threads_, frame(entry.scene));
  }
  race.run(options_.repeat);
  for (std::size_t k = 0; k < entries.size(); ++k)
  {
    entries[k].plain = race.seconds(places[k]);
    if (entries[k].method->rays <= mostRacedRays)
      entries[k].frame = race.seconds(places[k] + 1);
  }
}

Record AmbientContest::recordOf(const std::string& table, const std::string& method,
  const std::string& view, const PictureSize& size) const
{
  return {{"suite", "ambient"}, {"table", table}, {"method", method}, {"input", input_.name},
    {"particles", static_cast<std::int64_t>(input_.statistics.valid)}, {"view", view},
    {"width", std::int64_t{size.width}}, {"height", std::int64_t{size.height}},
    {"threads", std::int64_t{threads_}}, {"repeat", std::int64_t{options_.repeat}},
    {"reach", reach_}, {"baked", bakedName()}};
}

Record AmbientContest::recordOf(const std::string& table, const Entry& e) const
{
  Record record = recordOf(table, e.method->name, e.reference->view.name, size_);
  const bool maps = e.baked.maps != nullptr;
  const Record rest = {{"mode", e.mode},
    {"samples", std::int64_t{e.method->samples > 0 ? e.method->samples : options_.samples}},
    {"seconds", e.seconds()}, {"mrays_per_s", e.mrays()},
    {"bytes_per_particle", maps ? e.baked.bytesPerParticle() : 0.0},
    {"bytes_per_baked_particle", maps ? e.baked.bytesPerBaked() : unknown},
    {"baked_particles", static_cast<std::int64_t>(e.baked.statistics.particles)},
    {"rays", static_cast<std::int64_t>(
               maps ? e.baked.statistics.rays
                    : e.reference->hits * static_cast<std::size_t>(e.method->rays))},
    {"frame_s", e.frame}, {"frame_without_s", e.plain}, {"rms_error", e.errors.rms},
    {"max_error", e.errors.greatest},
    {"checked_pixels", static_cast<std::int64_t>(e.errors.checked)},
    {"reference_error", e.reference->standardError}};
  record.insert(record.end(), rest.begin(), rest.end());
  return record;
}

void AmbientContest::compareErrors(Report& report)
{
  compareErrors(
    "errors", "Error against time", wanted([](const AmbientMethod&) { return true; }), report);
}

void AmbientContest::compareErrors(const AmbientTable& table, Report& report)
{
  std::vector<const AmbientMethod*> methods;
  for (const AmbientMethod& method : table.methods)
    methods.push_back(&method);
  compareErrors(table.name, table.title, methods, report);
}

void AmbientContest::compareErrors(const std::string& table, const std::string& title,
  const std::vector<const AmbientMethod*>& methods, Report& report)
{
  std::vector<Entry> entries;
  for (const AmbientMethod* method : methods)
    addEntry(*method, entries);
  timeFrames(entries);
  Section section{title, Table(3)};
  section.table.add({"method", "mode", "view", "seconds", "Mrays/s", "bytes/particle",
    "of the baked", "frame ms", "without ms", "RMS error", "greatest"});
  for (Entry& e : entries)
  {
    e.errors = compare(openShares(e.scene, e.reference->camera, size_), *e.reference);
    const bool maps = e.baked.maps != nullptr;
    section.table.add({e.method->name, e.mode, e.reference->view.name, format("%.3g", e.seconds()),
      text("%.1f", e.mrays()), maps ? format("%.2f", e.baked.bytesPerParticle()) : "-",
      maps ? format("%.1f", e.baked.bytesPerBaked()) : "-", format("%.2f", 1e3 * e.frame),
      format("%.2f", 1e3 * e.plain), format("%.5f", e.errors.rms),
      format("%.3f", e.errors.greatest)});
    report.records.push_back(recordOf(table, e));
  }
  for (const ReferencePicture& reference : references_)
    section.notes.push_back(
      format("%s: %zu pixels of %dx%d, the reference's own standard error %.5f.",
        reference.view.name.c_str(), reference.hits, size_.width, size_.height,
        reference.standardError));
  section.notes.push_back(
    "seconds: of the whole picture where rays are live, of the bake where maps are baked. frame: "
    "a picture with, without: one without occlusion. RMS error: of the open share, in [0, 1].");
  section.notes.push_back(format(
    "%zu particles (%s), %s of them baked (%zu), reach %g, %d rays a texel; reference by %d rays a "
    "hit; %d threads, medians of %d rounds of pictures.",
    input_.statistics.valid, options_.input.c_str(), bakedName().c_str(), baker_->count(slots_),
    reach_, options_.samples, options_.referenceRays, threads_, options_.repeat));
  report.sections.push_back(std::move(section));
}

/// The bake of some particles by one method and by Embree in its place, in turns.
void AmbientContest::raceEmbree(
  const AmbientMethod& method, const SlotBits& some, int threads, Table& table, Report& report)
{
  progress("%d rounds of %s and Embree's, %zu particles", options_.repeat,
    method.adaptive ? "adaptive bakes" : "bakes", baker_->count(some));
  AmbientMethod own = method;
  own.embree = false;
  const SlotBits none(some.size(), 0);
  Race race;
  BakedMaps baked[3];
  const auto add = [&](const AmbientMethod& who, const SlotBits& slots, BakedMaps& to)
  {
    race.addTimed(
      [&]
      {
        to = baker_->bake(who, slots, threads);
        return to.statistics.seconds;
      });
  };
  add(own, none, baked[0]);
  add(own, some, baked[1]);
  add(method, some, baked[2]);
  race.run(options_.repeat);
  // To look through all slots for those to bake is no part of the contest.
  const double idle = race.seconds(0), mote = race.seconds(1) - idle;
  const double embree = race.seconds(2) - idle;
  const double rays = 1e-6 * static_cast<double>(baked[1].statistics.rays);
  table.add({method.adaptive ? "adaptive" : "16x16", baked[1].mode, baked[2].mode,
    format("%.1f", rays / mote), format("%.1f", rays / embree), format("%.2f", embree / mote)});
  Record record = recordOf("embree", method.name, "", {});
  const Record rest = {{"mode", baked[2].mode}, {"seconds", embree}, {"mrays_per_s", rays / embree},
    {"mote_seconds", mote}, {"mote_mrays_per_s", rays / mote}, {"times_embree", embree / mote},
    {"race_threads", std::int64_t{threads}},
    {"baked_particles", static_cast<std::int64_t>(baked[1].statistics.particles)}};
  record.insert(record.end(), rest.begin(), rest.end());
  report.records.push_back(std::move(record));
}

void AmbientContest::raceEmbree(Report& report)
{
  const auto methods = wanted([](const AmbientMethod& method) { return method.embree; });
  if (methods.empty())
    return;
  const SlotBits some = baker_->thinned(slots_, racedParticles);
  const int threads = options_.threads > 0 ? options_.threads : 1;
  Section section{"The same bakes by Mote and by Embree", Table(3)};
  section.table.add(
    {"bake", "structure", "Embree's way", "Mote Mrays/s", "Embree Mrays/s", "x Embree"});
  for (const AmbientMethod* method : methods)
    raceEmbree(*method, some, threads, section.table, report);
  section.notes = {
    format("%zu of the particles, %d threads, medians of %d rounds in which both take turns; what "
           "a bake of no particle takes is taken off.",
      baker_->count(some), threads, options_.repeat)};
  report.sections.push_back(std::move(section));
}

/// Frames of one view with all maps and with none, in turns.
void AmbientContest::timeLookUps(
  const std::vector<LookUp>& all, const ReferencePicture& reference, Table& table, Report& report)
{
  progress("%d rounds of frames of %dx%d", options_.repeat, frameSize_.width, frameSize_.height);
  Film film;
  Race race;
  Scene plain = all.front().scene;
  plain.surfaces[0].occlusion = nullptr;
  const auto add = [&](const Scene& scene)
  { race.add(threads_, [&] { draw(scene, reference.camera, frameSize_, film); }); };
  add(plain);
  for (const LookUp& one : all)
    add(one.scene);
  race.run(options_.repeat);
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    const double with = race.seconds(k + 1), without = race.seconds(0);
    const double cost = race.ratio(k + 1, 0) - 1.0, bytes = all[k].baked.bytesPerParticle();
    table.add({all[k].method->name, reference.view.name, format("%.2f", bytes),
      format("%.2f", 1e3 * with), format("%.2f", 1e3 * without), format("%.1f %%", 100.0 * cost)});
    Record record = recordOf("look-up", all[k].method->name, reference.view.name, frameSize_);
    const Record rest = {{"mode", all[k].baked.mode}, {"bytes_per_particle", bytes},
      {"frame_s", with}, {"frame_without_s", without}, {"frame_cost", cost}};
    record.insert(record.end(), rest.begin(), rest.end());
    report.records.push_back(std::move(record));
  }
}

void AmbientContest::timeLookUps(Report& report)
{
  const SlotBits slots = slots_.empty() ? SlotBits() : seen(frameSize_);
  // As a program draws: a headlight, and a third of the light from the sky.
  Scene scene = ambientScene(structure_, 0, reach_);
  scene.surfaces[0].material.ambient = 0.3f;
  scene.surfaces[0].material.diffuse = 0.7f;
  scene.lights.resize(1);
  std::vector<LookUp> all;
  for (const AmbientMethod* method :
    wanted([](const AmbientMethod& m) { return !m.isLive() && m.dilate && !m.embree; }))
  {
    progress("look-ups: %s of %zu particles", method->name.c_str(), baker_->count(slots));
    all.push_back({method, baker_->bakeQuickly(*method, slots, threads_), scene});
    all.back().scene.surfaces[0].occlusion = all.back().baked.maps;
  }
  if (all.empty())
    return;
  Section section{"Looking up", Table(2)};
  section.table.add({"method", "view", "bytes/particle", "frame ms", "without ms", "cost"});
  for (const ReferencePicture& reference : references_)
    timeLookUps(all, reference, section.table, report);
  section.notes = {
    format("Frames of %dx%d with a headlight and ambient light, medians of %d rounds in which all "
           "take turns; cost: in time, of the frame without occlusion. Maps of one size are baked "
           "with one ray a texel here.",
      frameSize_.width, frameSize_.height, options_.repeat)};
  report.sections.push_back(std::move(section));
}

} // namespace mote::bench
