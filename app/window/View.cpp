#include "View.h"

namespace mote::app
{

void View::show(
  const Stage& stage, const std::vector<std::size_t>& parts, const ParticlePaths* paths)
{
  parts_ = parts;
  marks_.setParts(parts);
  box_.update(stage, parts);
  box_.setInk(inkOn(stage.renderer()), stage.renderer()->GetBackground());
  paths_.update(paths, parts);
  handles_.update(stage, parts);
}

void View::update(const Stage& stage, const PickedSet& picked)
{
  marks_.update(stage.parts(), picked);
  ruler_.update(stage.parts(), picked, parts_);
}

} // namespace mote::app
