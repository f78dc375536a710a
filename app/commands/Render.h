#pragma once

#include "table/CommandLine.h"

namespace mote::app
{

/// What `mote render` may be told besides the view.
struct RenderOptions
{
  GivenSettings given;
  std::string output;
  std::string session; ///< file to save the session in; empty: none
  bool allSteps = false;
};

/// Declares the options of `mote render`.
void addRenderOptions(CLI::App& app, RenderOptions& options);

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const RenderOptions& options);

} // namespace mote::app
