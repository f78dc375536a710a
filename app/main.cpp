// The program: chooses between window, render, convert and info, and turns what goes wrong into a
// sentence and an exit code.

#include "Convert.h"
#include "Failure.h"
#include "Info.h"
#include "Messages.h"
#include "Render.h"
#include "ViewOptions.h"
#include "Window.h"

#include <vtkMoteReaderTable.h>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <cstdio>
#include <memory>
#include <new>

namespace
{

using namespace mote::app;

constexpr int failed = 1, misused = 2, interrupted = 130;

/// Keeps every part of the program, the readers too, to so many threads; 0 for all.
std::unique_ptr<tbb::global_control> limitThreads(int threads)
{
  if (threads < 1)
    return nullptr;
  return std::make_unique<tbb::global_control>(
    tbb::global_control::max_allowed_parallelism, threads);
}

int run(CLI::App& app, const WindowOptions& window, const RenderOptions& rendering,
  const InfoOptions& info, const ConvertOptions& converting)
{
  const bool toRender = app.got_subcommand("render"), toInform = app.got_subcommand("info"),
             toConvert = app.got_subcommand("convert");
  const ViewOptions& view = toRender    ? rendering.view
                            : toInform  ? info.read
                            : toConvert ? converting.view
                                        : window.view;
  if (view.files.empty())
  {
    std::fprintf(stderr, "mote: no file given. Try: mote --help\n");
    return misused;
  }
  const auto limit = limitThreads(view.threads);
  if (toRender)
    render(rendering);
  else if (toInform)
    printInfo(info);
  else if (toConvert)
    convert(converting);
  else
    showWindow(window);
  // What stdout could not take, such as on a full disk, is only seen here.
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw Failure("the standard output could not be written");
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app(
    "Mote shows what particle simulations write: every particle a sphere, ray cast.", "mote");
  app.set_version_flag("--version", "mote " MOTE_VERSION);
  app.require_subcommand(0, 1);
  app.footer(
    "Files:\n" + vtkMoteReaderTable::GetFormatsHelp() +
    "\nWithout a command a window opens; press h in it for its keys. Exit codes: 0 done, 1 failed\n"
    "with a sentence on standard error, 2 a wrong command line, 130 interrupted.");
  WindowOptions window;
  RenderOptions rendering;
  InfoOptions info;
  ConvertOptions converting;
  addWindowOptions(app, window);
  addRenderOptions(*app.add_subcommand("render", "Write a picture; needs no display"), rendering);
  addConvertOptions(
    *app.add_subcommand("convert", "Write particles as a .mote file, which opens at once"),
    converting);
  addInfoOptions(*app.add_subcommand("info", "List arrays, ranges, types and time steps"), info);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& asked)
  {
    return app.exit(asked);
  }
  catch (const CLI::ParseError& error)
  {
    std::fprintf(stderr, "mote: %s. Try: mote --help\n", error.what());
    return misused;
  }

  Messages::install();
  try
  {
    return run(app, window, rendering, info, converting);
  }
  catch (const Interrupted&)
  {
    std::fprintf(stderr, "mote: interrupted\n");
    return interrupted;
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "mote: there is not enough memory for this\n");
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "mote: %s\n", error.what());
  }
  return failed;
}
