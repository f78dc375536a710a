// The part of vtkMoteParticleMapper that shows a preview while the structure is built on another
// thread.

#include "ParticleMapperInternals.h"

#include "kernels/particles/ParticleSample.h"

#include "vtkCommand.h"
#include "vtkPointSet.h"

#include <new>

namespace
{

constexpr double waitingStep = 0.05; // seconds between ProgressEvents while somebody waits

/// A smaller set is built about as fast as its preview.
constexpr vtkIdType worthwhile = 4;

} // namespace

bool vtkMoteParticleMapper::UsesPreview()
{
  vtkPointSet* input = this->GetInput();
  return this->Preview && !this->Impl->exactOnly && input &&
         input->GetNumberOfPoints() / worthwhile > this->PreviewSize;
}

bool vtkMoteParticleMapper::IsPreview()
{
  return this->Impl->preview != nullptr;
}

bool vtkMoteParticleMapper::IsBuilding()
{
  return this->Impl->build != nullptr;
}

vtkIdType vtkMoteParticleMapper::GetNumberOfPreviewParticles()
{
  const auto& preview = this->Impl->preview;
  return preview ? static_cast<vtkIdType>(preview->particles) : 0;
}

double vtkMoteParticleMapper::GetBuildProgress()
{
  const Internals& impl = *this->Impl;
  if (impl.build)
    return impl.build->progress();
  return impl.structure && !impl.preview ? 1.0 : 0.0;
}

bool vtkMoteParticleMapper::FinishBuild()
{
  Internals& impl = *this->Impl;
  impl.exactOnly = true;
  this->Update();
  impl.exactOnly = false;
  return impl.structure && !impl.preview;
}

void vtkMoteParticleMapper::StopBuild()
{
  Internals& impl = *this->Impl;
  const bool building = impl.build != nullptr;
  impl.build = nullptr;
  if (impl.preview)
  {
    impl.preview = nullptr;
    impl.structure = nullptr;
    impl.structureKey.clear();
    impl.selection.forget();
    impl.builtAt.Modified();
  }
  if (building)
    this->InvokeEvent(vtkCommand::EndEvent, nullptr);
}

void vtkMoteParticleMapper::BeginPreview(vtkPointSet* input)
{
  Internals& impl = *this->Impl;
  impl.buildStart = std::chrono::steady_clock::now();
  const mote::ParticleStructureOptions options =
    mote::structureOf(this->StructureName, this->StructureForm).options();
  mote::ParticleInput particles = mote::makeParticleInput(input, impl.choice);
  auto preview = std::make_unique<Internals::PreviewFacts>();
  preview->whole = mote::examine(particles.set);
  const mote::ParticleSample sample(particles.set, static_cast<std::size_t>(this->PreviewSize));
  auto structure = std::make_shared<mote::ParticleStructure>();
  auto& grid = structure->emplace<mote::CoherentGrid>();
  grid.build(sample.set(), sample.gridOptions());
  preview->enlargement = sample.enlargement();
  preview->particles = grid.size();
  impl.commonRadius = particles.commonRadius;
  impl.selection.forget();
  impl.structure.swap(structure);
  impl.preview = std::move(preview);
  impl.builtAt.Modified();
  this->WarnOfLeftOut(impl.preview->whole);

  this->SetAbortExecute(0);
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  // What was drawn until now lends its memory, where nobody else looks at it.
  if (structure.use_count() != 1)
    structure = nullptr;
  impl.build =
    std::make_unique<mote::StructureBuild>(std::move(particles), options, std::move(structure));
}

void vtkMoteParticleMapper::ContinueBuild()
{
  Internals& impl = *this->Impl;
  if (!impl.build || impl.continuing)
    return;
  impl.continuing = true; // who hears of progress may ask for an Update()
  do
  {
    if (!this->UsesPreview())
      impl.build->wait(waitingStep);
    this->UpdateProgress(impl.build->progress());
    if (impl.build && this->GetAbortExecute())
      this->StopBuild();
  } while (impl.build && !impl.build->finished() && !this->UsesPreview());
  impl.continuing = false;
  if (impl.build && impl.build->finished())
    this->TakeBuild();
}

void vtkMoteParticleMapper::TakeBuild()
{
  Internals& impl = *this->Impl;
  const std::unique_ptr<mote::StructureBuild> build = std::move(impl.build);
  std::string problem;
  try
  {
    impl.structure = build->take();
    impl.preview = nullptr;
    impl.selection.forget();
    impl.buildTime =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - impl.buildStart).count();
    impl.builtAt.Modified();
    ++impl.builds;
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
    vtkErrorMacro("The preview stays, as its exact structure could not be built: " << problem);
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
}
