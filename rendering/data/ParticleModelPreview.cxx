// The part of ParticleModel that shows a preview while the structure is built on another thread.

#include "ParticleModel.h"

#include "StructureBuild.h"

#include "kernels/particles/ParticleSample.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkPointSet.h"

namespace mote
{

namespace
{

constexpr double waitingStep = 0.05; // seconds between ProgressEvents while somebody waits

/// A smaller set is built about as fast as its preview.
constexpr vtkIdType worthwhile = 4;

} // namespace

bool ParticleModel::wantsPreview() const
{
  const vtkIdType size = previewSize ? previewSize() : 0;
  return size > 0 && input_ && input_->GetNumberOfPoints() / worthwhile > size;
}

double ParticleModel::buildProgress() const
{
  if (build_)
    return build_->progress();
  return structure_ && !preview_ ? 1.0 : 0.0;
}

void ParticleModel::stopBuild()
{
  const bool building = build_ != nullptr;
  build_ = nullptr;
  if (preview_)
  {
    preview_ = nullptr;
    structure_ = nullptr;
    key_.clear();
    this->noteChange();
  }
  if (building)
    owner_->InvokeEvent(vtkCommand::EndEvent, nullptr);
}

void ParticleModel::beginPreview()
{
  buildStart_ = Clock::now();
  ParticleInput particles = makeParticleInput(input_, radii, space.get());
  auto preview = std::make_unique<PreviewFacts>();
  preview->whole = examine(particles.set);
  const ParticleSample sample(particles.set, static_cast<std::size_t>(previewSize()));
  auto structure = std::make_shared<ParticleStructure>();
  auto& grid = structure->emplace<CoherentGrid>();
  grid.build(sample.set(), sample.gridOptions());
  preview->enlargement = sample.enlargement();
  preview->particles = grid.size();
  commonRadius_ = particles.commonRadius;
  structure_.swap(structure);
  preview_ = std::move(preview);
  this->noteChange();
  this->warnOfLeftOut();

  owner_->SetAbortExecute(0);
  owner_->InvokeEvent(vtkCommand::StartEvent, nullptr);
  // What was drawn until now lends its memory, where nobody else looks at it.
  if (structure.use_count() != 1)
    structure = nullptr;
  build_ = std::make_unique<StructureBuild>(
    std::move(particles), this->buildOptions(), std::move(structure));
}

void ParticleModel::continueBuild()
{
  if (!build_ || continuing_)
    return;
  continuing_ = true; // who hears of progress may ask for an update()
  do
  {
    if (!this->wantsPreview())
      build_->wait(waitingStep);
    owner_->UpdateProgress(build_->progress());
    if (build_ && owner_->GetAbortExecute())
      this->stopBuild();
  } while (build_ && !build_->wait(0.0) && !this->wantsPreview());
  continuing_ = false;
  if (build_ && build_->wait(0.0))
    this->takeBuild();
}

void ParticleModel::takeBuild()
{
  const std::unique_ptr<StructureBuild> build = std::move(build_);
  std::string problem;
  try
  {
    structure_ = build->take();
    preview_ = nullptr;
    buildTime_ = std::chrono::duration<double>(Clock::now() - buildStart_).count();
    ++builds_;
    this->noteChange();
  }
  catch (const std::bad_alloc&)
  {
    problem = "There is not enough memory";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  if (!problem.empty())
    vtkErrorWithObjectMacro(
      owner_, << "The preview stays, as its exact structure could not be built: " << problem);
  owner_->InvokeEvent(vtkCommand::EndEvent, nullptr);
}

} // namespace mote
