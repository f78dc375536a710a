#include "StructureBuild.h"

#include <chrono>
#include <utility>

namespace mote
{

StructureBuild::StructureBuild(ParticleInput input, const ParticleStructureOptions& options,
  std::shared_ptr<ParticleStructure> used)
  : input_(std::move(input))
  , options_(options)
  , structure_(std::move(used))
  , thread_([this] { run(); })
{
}

StructureBuild::~StructureBuild()
{
  stop_ = true;
  thread_.join();
}

void StructureBuild::run() noexcept
{
  try
  {
    buildStructure(structure_, input_.set, options_,
      [this](double done)
      {
        progress_ = done;
        return !stop_;
      });
  }
  catch (...)
  {
    structure_ = nullptr;
    error_ = std::current_exception();
  }
  finished_ = true;
}

void StructureBuild::wait(double seconds) const
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!finished_ && Clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

std::shared_ptr<ParticleStructure> StructureBuild::take()
{
  if (error_)
    std::rethrow_exception(std::exchange(error_, nullptr));
  return std::move(structure_);
}

} // namespace mote
