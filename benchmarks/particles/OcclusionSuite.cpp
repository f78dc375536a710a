#include "OcclusionSuite.h"

#include "Comparison.h"

#include <kernels/core/Error.h>

#include <bit>

namespace mote::bench
{

namespace
{

/// The rays of a view and what the reference says of them.
struct Question
{
  std::string view;
  OcclusionRays rays;
  OcclusionAnswers right;
};

/// Asks the reference, and lets go of its tree: it shall not stand in the methods' way.
std::vector<Question> makeQuestions(const Options& options, const ParticleInput& input)
{
  progress("building the reference of %s", input.name.c_str());
  const reference::SphereTree tree(input.set);
  std::vector<Question> questions;
  for (const View& view : viewsNamed(options.views))
  {
    progress("making the rays of view %s and their answers", view.name.c_str());
    const CameraRays camera(cameraOf(view, input.statistics.bounds), options.width, options.height);
    Question question{view.name,
      makeOcclusionRays(tree, input, camera, options.width, options.height, options.rays), {}};
    if (question.rays.count == 0)
      throw Error("View " + view.name + " shows no particle at this size.");
    question.right = referenceAnswers(tree, question.rays);
    questions.push_back(std::move(question));
  }
  return questions;
}

std::size_t countBits(const OcclusionAnswers& answers)
{
  std::size_t count = 0;
  for (const std::uint64_t bits : answers)
    count += static_cast<std::size_t>(std::popcount(bits));
  return count;
}

ImageErrors compare(OcclusionAnswers answers, const Question& question)
{
  for (std::size_t p = 0; p < answers.size(); ++p)
    answers[p] ^= question.right[p];
  ImageErrors errors;
  errors.checked = question.rays.count;
  errors.wrong = countBits(answers);
  errors.maxDepthError = errors.maxRightDepthError = unknown; // nobody says how far
  return errors;
}

/// All methods that can, over one input.
class OcclusionContest
{
public:
  OcclusionContest(const Options& options, const ParticleInput& input)
    : options_(options)
    , input_(input)
    , threads_(threadCount(options.threads))
    , questions_(makeQuestions(options, input))
  {
    for (const ParticleMethodEntry& entry : particleMethods())
      if (entry.occludes && isWanted(options, entry.name))
        methods_.push_back(buildMethod(entry, {threads_, options.lambda}, input, threads_));
    for (const BuiltMethod& built : methods_)
      for (const Question& question : questions_)
        built.method->prepareOcclusion(question.rays);
  }

  std::vector<Measurement> race()
  {
    Race race;
    OcclusionAnswers answers;
    std::vector<std::size_t> places; // of everyone's first mode in each view
    for (const Question& question : questions_)
      for (const BuiltMethod& built : methods_)
        for (std::size_t mode = 0; mode < built.method->occlusionModes().size(); ++mode)
        {
          const std::size_t place =
            race.add(threads_, [&, mode] { answer(built, mode, question, answers); });
          if (mode == 0)
            places.push_back(place);
        }
    progress("casting %d rounds of %zu methods", options_.repeat, methods_.size());
    race.run(options_.repeat);
    std::vector<Measurement> measurements;
    for (const Question& question : questions_)
      for (const BuiltMethod& built : methods_)
        measurements.push_back(measure(race, places[measurements.size()], built, question));
    return measurements;
  }

private:
  static void answer(
    const BuiltMethod& built, std::size_t mode, const Question& question, OcclusionAnswers& answers)
  {
    answers.resize(question.rays.packets.size());
    built.method->occlude(mode, question.rays, answers);
  }

  Measurement measure(
    const Race& race, std::size_t first, const BuiltMethod& built, const Question& question) const
  {
    const std::vector<std::string> modes = built.method->occlusionModes();
    const std::size_t best = race.fastest(first, modes.size());
    Measurement m =
      measurementOf(input_, options_.width, options_.height, threads_, options_.repeat);
    m.suite = "occlusion";
    m.method = built.name;
    m.mode = modes[best];
    m.view = question.view;
    m.rays = question.rays.count;
    m.setTimes(race, first + best);
    m.buildSeconds = built.seconds;
    m.bytesPerParticle = built.bytesPerParticle;
    for (std::size_t mode = 0; mode < modes.size(); ++mode)
      progress("view %s, %s %s: %.2f Mrays/s", m.view.c_str(), m.method.c_str(),
        modes[mode].c_str(), m.mrays(race.seconds(first + mode)));
    OcclusionAnswers answers;
    answer(built, best, question, answers);
    m.errors = compare(answers, question);
    const auto rays = static_cast<double>(m.rays);
    m.more = {{"rays", static_cast<std::int64_t>(m.rays)},
      {"occluded_share", static_cast<double>(countBits(question.right)) / rays}};
    return m;
  }

  const Options& options_;
  const ParticleInput& input_;
  int threads_;
  std::vector<Question> questions_;
  std::vector<BuiltMethod> methods_;
};

Report run(const Options& options)
{
  const ParticleInput input = inputOf(options);
  const std::vector<Measurement> measurements = OcclusionContest(options, input).race();
  Report report;
  for (const Measurement& m : measurements)
    report.records.push_back(toRecord(m));
  Section section = comparison(measurements);
  section.notes.push_back(format("%zu particles (%s), rays from what %dx%d pixels show, %d from "
                                 "each, %g of the longest side long; %d threads, medians of %d "
                                 "rounds.",
    input.statistics.valid, options.input.c_str(), options.width, options.height, options.rays,
    occlusionReach, measurements.front().threads, options.repeat));
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite occlusionSuite()
{
  Suite suite;
  suite.name = "occlusion";
  suite.summary = "incoherent rays from visible particles that ask for anything in their way";
  suite.inputs = particleInputs();
  for (const ParticleMethodEntry& entry : particleMethods())
    if (entry.occludes)
      suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  suite.raysOfHits = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
