// The model but for previews, which stand in ParticleModelPreview.cxx, and ranges, which stand in
// ParticleModelRanges.cxx.

#include "ParticleModel.h"

#include "BuildEvents.h"
#include "OcclusionArrays.h"
#include "StructureBuild.h"

#include "kernels/core/Error.h"
#include "kernels/particles/ParticleHash.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <cmath>
#include <sstream>
#include <thread>

namespace mote
{

ParticleModel::ParticleModel(vtkAlgorithm* owner, bool tellsOfBuilds)
  : owner_(owner)
  , tellsOfBuilds_(tellsOfBuilds)
{
}

ParticleModel::~ParticleModel() = default;

void ParticleModel::update(vtkPointSet* input)
{
  input_ = input;
  try
  {
    if (!input)
      throw Error("The input is not a data set of points.");
    InputKey key = keyOf(input, radii);
    const StructureChoice choice = structureOf(structureName, structureForm);
    key.insert(key.end(),
      {double(choice.kind), choice.form ? double(*choice.form) : -1.0, double(keepPointIds)});
    const bool failed = preview_ && !build_;
    if (structure_ && key == key_ && (!failed || this->wantsPreview()))
    {
      this->continueBuild();
      return;
    }
    this->stopBuild();
    key_.clear();
    if (drawsFile(input, radii, choice))
      this->takeFile();
    else if (!this->takeOffer(key))
    {
      if (this->wantsPreview())
        this->beginPreview();
      else
        this->buildAtOnce();
    }
    if (structure_)
      key_ = key;
  }
  catch (const std::exception&)
  {
    this->clear();
    throw;
  }
}

void ParticleModel::clear()
{
  this->stopBuild();
  structure_ = nullptr;
  key_.clear();
}

/// The structure is another one.
void ParticleModel::noteChange()
{
  selection_.forget();
  content_.reset();
  structureChanged_.Modified();
  changed_.Modified();
}

ParticleStructureOptions ParticleModel::buildOptions() const
{
  const StructureChoice choice = structureOf(structureName, structureForm);
  ParticleStructureOptions options;
  options.kind = choice.kind;
  options.pkdTree.form = choice.form.value_or(PkdTreeOptions::Form::Exact);
  options.pkdTree.keepIndices = keepPointIds;
  options.pkdTree.space = space;
  return options;
}

std::shared_ptr<const BuiltParticles> ParticleModel::built() const
{
  if (!structure_ || preview_ || !input_ || fileOf(input_))
    return nullptr;
  return std::make_shared<BuiltParticles>(
    BuiltParticles{structure_, key_, commonRadius_, buildTime_});
}

/// False where nothing was offered, or what was built from something else.
bool ParticleModel::takeOffer(const InputKey& key)
{
  const std::shared_ptr<const BuiltParticles> offered = std::move(offered_);
  offered_ = nullptr;
  if (!offered || offered->key != key)
    return false;
  structure_ = offered->structure;
  commonRadius_ = offered->commonRadius;
  buildTime_ = offered->buildTime;
  std::visit(
    [](auto& structure)
    {
      structure.setVisibility({});
      structure.setRanges({});
      structure.setAttributes({});
    },
    *structure_);
  this->noteChange();
  this->warnOfLeftOut();
  return true;
}

void ParticleModel::takeFile()
{
  const auto file = fileOf(input_);
  // A tree of its own, for ranges of its own.
  structure_ = std::make_shared<ParticleStructure>(file->tree());
  buildTime_ = 0.0;
  const ParticleStatistics& s = file->statistics();
  commonRadius_ = s.smallestRadius == s.largestRadius ? s.largestRadius : 0.0;
  this->noteChange();
}

void ParticleModel::buildAtOnce()
{
  const auto start = Clock::now();
  std::optional<BuildEvents> events;
  if (tellsOfBuilds_)
    events.emplace(owner_);
  const ParticleInput input = makeParticleInput(input_, radii, space.get());
  const auto caller = std::this_thread::get_id();
  buildStructure(structure_, input.set, this->buildOptions(),
    [&](double done)
    {
      if (std::this_thread::get_id() == caller)
        owner_->UpdateProgress(done);
      return owner_->GetAbortExecute() == 0;
    });
  buildTime_ = std::chrono::duration<double>(Clock::now() - start).count();
  commonRadius_ = input.commonRadius;
  this->noteChange();
  ++builds_;
  if (structure_)
    this->warnOfLeftOut();
}

void ParticleModel::warnOfLeftOut() const
{
  const ParticleStatistics s = this->statistics();
  if (!tellsOfBuilds_ || s.badPositions + s.badRadii == 0)
    return;
  std::string text;
  if (s.badPositions > 0)
    text += std::to_string(s.badPositions) + " with a position that is not finite";
  if (s.badRadii > 0)
    text += (text.empty() ? "" : " and ") + std::to_string(s.badRadii) +
            " with a radius that is not a finite number above zero";
  vtkWarningWithObjectMacro(owner_, << "Particles left out: " << text << ".");
}

std::shared_ptr<const PkdTree> ParticleModel::tree() const
{
  const auto* tree = structure_ ? std::get_if<PkdTree>(structure_.get()) : nullptr;
  return tree ? std::shared_ptr<const PkdTree>(structure_, tree) : nullptr;
}

bool ParticleModel::makeLods()
{
  auto* const tree = structure_ && !preview_ ? std::get_if<PkdTree>(structure_.get()) : nullptr;
  if (tree)
    tree->makeLods(space);
  return tree != nullptr;
}

ParticleStatistics ParticleModel::statistics() const
{
  if (preview_)
    return preview_->whole;
  return structure_ ? withStructure(*structure_, [](const auto& s) { return s.statistics(); })
                    : ParticleStatistics();
}

std::size_t ParticleModel::bytes() const
{
  return structure_ ? withStructure(*structure_, [](const auto& s) { return s.bytes(); }) : 0;
}

ParticleInput ParticleModel::particles() const
{
  RadiusChoice choice = radii;
  if (commonRadius_ > 0.0)
  {
    // As it was built; the spacing need not be estimated again.
    choice.mode = RadiusMode::Constant;
    choice.radius = commonRadius_;
    choice.scale = 1.0;
  }
  ParticleInput input = makeParticleInput(input_, choice);
  input.enlargement = preview_ ? preview_->enlargement : 1.0;
  return input;
}

const ContentHash& ParticleModel::content()
{
  if (!content_)
    content_ = hashOf(this->particles().set);
  return *content_;
}

void ParticleModel::updateOcclusion(
  const OcclusionBakeOptions& options, const InputKey& key, const FindMaps& find)
{
  const std::string problem =
    occlusion_.update(*structure_, key_, this->time(), options, key, find);
  if (!problem.empty())
    vtkWarningWithObjectMacro(owner_, << problem);
}

MapperOcclusion* ParticleModel::occlusion(const OcclusionRequest* request)
{
  if (!structure_ || preview_ || this->statistics().valid == 0)
    return nullptr;
  const auto mapsTime = request && input_ ? occlusionArraysTime(input_->GetFieldData()) : 0;
  if (request && (!request->isMoving || (mapsTime > 0 && !occlusion_.isOf(key_))))
  {
    this->updateOcclusion(request->options, {double(request->reachChosen), double(mapsTime)},
      [&] { return this->findMaps(*request); });
  }
  return occlusion_.isOf(key_) ? &occlusion_ : nullptr;
}

/// Those in the input's field data.
std::optional<StoredOcclusion> ParticleModel::findMaps(const OcclusionRequest& request)
{
  std::optional<StoredOcclusion> stored;
  if (input_)
    stored = findOcclusionArrays(input_->GetFieldData());
  if (!stored)
    return stored;
  if (stored->maps.size() != static_cast<std::size_t>(input_->GetNumberOfPoints()) ||
      stored->content != this->content())
    throw Error("The occlusion maps of the input belong to other particles or other radii, and "
                "are not used.");
  const double wanted = request.options.reach;
  if (request.reachChosen && stored->reach != wanted &&
      !(std::abs(stored->reach - wanted) <= 1e-6 * wanted))
  {
    std::ostringstream text;
    text << "The occlusion maps of the input have a reach of " << stored->reach << " and not of "
         << wanted << ", and are not used.";
    throw Error(text.str());
  }
  return stored;
}

} // namespace mote
