#include "Contest.h"

#include <algorithm>
#include <cmath>

namespace mote::bench
{

Record toRecord(const Measurement& m)
{
  Record record = {{"suite", m.suite}};
  if (!m.table.empty())
    record.emplace_back("table", m.table);
  const Record rest = {{"method", m.method}, {"mode", m.mode}, {"input", m.input},
    {"particles", static_cast<std::int64_t>(m.particles)}, {"view", m.view},
    {"width", std::int64_t{m.width}}, {"height", std::int64_t{m.height}},
    {"threads", std::int64_t{m.threads}}, {"repeat", std::int64_t{m.repeat}},
    {"mrays_per_s", m.mrays()}, {"mrays_per_s_min", m.mrays(m.most)},
    {"mrays_per_s_max", m.mrays(m.least)}, {"build_s", m.buildSeconds},
    {"bytes_per_particle", m.bytesPerParticle},
    {"checked_pixels", static_cast<std::int64_t>(m.errors.checked)},
    {"wrong_pixels", static_cast<std::int64_t>(m.errors.wrong)},
    {"max_depth_error", m.errors.checked > 0 ? m.errors.maxDepthError : unknown},
    {"max_depth_error_of_right", m.errors.checked > 0 ? m.errors.maxRightDepthError : unknown}};
  record.insert(record.end(), rest.begin(), rest.end());
  if (!std::isnan(m.lodSeconds))
  {
    const ParticleLodErrors& e = m.lodErrors;
    const Record lods = {{"poe", m.poe}, {"lod_build_s", m.lodSeconds}, {"rms_error", e.rms},
      {"displacement_999_pixels", e.mostOfMany}, {"max_displacement_pixels", e.most},
      {"on_lods", e.lods}, {"holes", e.holes}, {"extra", e.extra}, {"coverage", e.coverage},
      {"brightness", e.brightness}, {"exact_color_error", e.exactColor}, {"color_error", e.color},
      {"exact_flicker", e.exactFlicker}, {"flicker", e.flicker}};
    record.insert(record.end(), lods.begin(), lods.end());
  }
  record.insert(record.end(), m.more.begin(), m.more.end());
  return record;
}

const std::vector<double>& ReferenceImages::depths(
  const ParticleInput& input, const View& view, int width, int height)
{
  std::vector<double>& depths =
    images_[format("%s|%s|%dx%d", input.name.c_str(), view.name.c_str(), width, height)];
  if (depths.empty())
  {
    if (!tree_ || treeOf_ != input.name)
    {
      progress("building the reference of %s", input.name.c_str());
      tree_ = std::make_unique<reference::SphereTree>(input.set);
      treeOf_ = input.name;
    }
    progress("casting the reference, view %s, %dx%d", view.name.c_str(), width, height);
    const CameraRays rays(cameraOf(view, input.statistics.bounds), width, height);
    depths = referenceDepths(*tree_, rays, width, height);
  }
  return depths;
}

void Measurement::setTimes(const Race& race, std::size_t place)
{
  seconds = race.seconds(place);
  least = race.least(place);
  most = race.most(place);
}

Measurement measurementOf(
  const ParticleInput& input, int width, int height, int threads, int repeat)
{
  Measurement m;
  m.input = input.name;
  m.particles = input.statistics.valid;
  m.width = width;
  m.height = height;
  m.threads = threads;
  m.repeat = repeat;
  return m;
}

BuiltMethod buildMethod(const ParticleMethodEntry& entry, const MethodOptions& options,
  const ParticleInput& input, int threads)
{
  const std::shared_ptr<ParticleMethod> method = entry.make(options);
  BuiltMethod built{entry.name, method};
  built.seconds = timed(threads, [&] { method->build(input); });
  built.bytesPerParticle =
    static_cast<double>(method->bytes()) / static_cast<double>(input.statistics.valid);
  progress("built %s in %.3f s, %.1f bytes a particle", entry.name.c_str(), built.seconds,
    built.bytesPerParticle);
  return built;
}

Contestant contestantOf(const ParticleMethodEntry& entry, const MethodOptions& options,
  const ParticleInput& input, int threads)
{
  const BuiltMethod built = buildMethod(entry, options, input, threads);
  Contestant contestant;
  contestant.method = built.name;
  contestant.own = built.method;
  contestant.modes = built.method->modes();
  contestant.cast = [method = built.method](std::size_t mode, const CameraRays& rays,
                      HitImage& image) { method->cast(mode, rays, image); };
  contestant.input = &input;
  contestant.threads = threads;
  contestant.buildSeconds = built.seconds;
  contestant.bytesPerParticle = built.bytesPerParticle;
  return contestant;
}

std::vector<Contestant> contestantsOf(const ParticleMethodEntry& entry,
  const MethodOptions& options, const ParticleInput& input, int threads,
  const std::vector<double>& poe)
{
  Contestant built = contestantOf(entry, options, input, threads);
  if (*std::max_element(poe.begin(), poe.end()) <= 0.0)
    return {built};
  bool made = false;
  const double seconds = timed(threads, [&] { made = built.own->makeLods(); });
  if (!made)
    return {built};
  progress("levels of detail in %.3f s", seconds);
  built.lodSeconds = seconds;
  built.bytesPerParticle =
    static_cast<double>(built.own->bytes()) / static_cast<double>(input.statistics.valid);
  std::vector<Contestant> contestants;
  for (const double error : poe)
  {
    Contestant contestant = built;
    contestant.poe = error;
    contestant.cast = [method = built.own, error](
                        std::size_t mode, const CameraRays& rays, HitImage& image)
    {
      method->setPoe(error);
      method->cast(mode, rays, image);
    };
    if (error > 0.0)
      contestant.errors = [method = built.own, error](const Camera& camera, int width, int height)
      { return method->lodErrors(camera, width, height, error); };
    contestants.push_back(std::move(contestant));
  }
  return contestants;
}

Contest::Contest(std::vector<View> views, int width, int height, int repeat)
  : views_(std::move(views))
  , width_(width)
  , height_(height)
  , repeat_(repeat)
{
}

void Contest::enterAll(Race& race, HitImage& image)
{
  for (const Contestant& c : contestants_)
    for (const View& view : views_)
      rays_.emplace_back(cameraOf(view, c.input->statistics.bounds), width_, height_);
  // View by view: those who are compared directly stand side by side.
  places_.resize(rays_.size());
  for (std::size_t v = 0; v < views_.size(); ++v)
    for (std::size_t c = 0; c < contestants_.size(); ++c)
    {
      const Contestant* who = &contestants_[c];
      const CameraRays* rays = &rays_[c * views_.size() + v];
      for (std::size_t mode = 0; mode < who->modes.size(); ++mode)
      {
        const std::size_t place =
          race.add(who->threads, [who, rays, mode, &image] { who->cast(mode, *rays, image); });
        if (mode == 0)
          places_[c * views_.size() + v] = place;
      }
    }
}

void Contest::keep(const Race& race, std::size_t c, std::size_t v)
{
  const Contestant& who = contestants_[c];
  const std::size_t first = places_[c * views_.size() + v];
  const std::size_t best = race.fastest(first, who.modes.size());
  Measurement m = measurementOf(*who.input, width_, height_, who.threads, repeat_);
  m.method = who.method;
  m.mode = who.modes[best];
  m.view = views_[v].name;
  m.setTimes(race, first + best);
  m.buildSeconds = who.buildSeconds;
  m.bytesPerParticle = who.bytesPerParticle;
  m.poe = who.poe;
  m.lodSeconds = who.lodSeconds;
  if (who.errors)
    m.lodErrors = who.errors(cameraOf(views_[v], who.input->statistics.bounds), width_, height_);
  for (std::size_t mode = 0; mode < who.modes.size(); ++mode)
    progress("view %s, %s %s: %.2f Mrays/s", m.view.c_str(), m.method.c_str(),
      who.modes[mode].c_str(), m.mrays(race.seconds(first + mode)));
  images_.emplace_back(width_, height_);
  who.cast(best, rays_[c * views_.size() + v], images_.back());
  measurements_.push_back(std::move(m));
}

void Contest::race()
{
  HitImage image(width_, height_);
  Race race;
  enterAll(race, image);
  progress("casting %d rounds of %zu contestants", repeat_, contestants_.size());
  race.run(repeat_);
  for (std::size_t c = 0; c < contestants_.size(); ++c)
    for (std::size_t v = 0; v < views_.size(); ++v)
      keep(race, c, v);
  for (Contestant& contestant : contestants_)
  {
    contestant.cast = nullptr;
    contestant.errors = nullptr;
    contestant.own.reset();
  }
}

void Contest::check(ReferenceImages& references)
{
  for (std::size_t c = 0; c < contestants_.size(); ++c)
    for (std::size_t v = 0; v < views_.size(); ++v)
    {
      const std::size_t i = c * views_.size() + v;
      measurements_[i].errors =
        compare(images_[i], references.depths(*contestants_[c].input, views_[v], width_, height_));
    }
  images_.clear();
}

} // namespace mote::bench
