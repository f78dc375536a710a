#pragma once

#include "ViewOptions.h"

namespace mote::app
{

/// What `mote render` may be told besides the view.
struct RenderOptions
{
  ViewOptions view;
  std::string output;
  bool allSteps = false;
};

/// Declares the options of `mote render`.
void addRenderOptions(CLI::App& app, RenderOptions& options);

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const RenderOptions& options);

} // namespace mote::app
