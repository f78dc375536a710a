// The program: chooses between the window and the commands, and turns what goes wrong into a
// sentence and an exit code.

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/ProgressRelay.h"
#include "commands/Average.h"
#include "commands/Bake.h"
#include "commands/Convert.h"
#include "commands/ImageSilhouettes.h"
#include "commands/Info.h"
#include "commands/Probe.h"
#include "commands/Render.h"
#include "table/Help.h"
#include "window/Window.h"

#include <vtkMoteReaderTable.h>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <cstdio>
#include <cstring>
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

/// The options of the window and of every command.
struct AllOptions
{
  WindowOptions window;
  RenderOptions rendering;
  InfoOptions info;
  ConvertOptions converting;
  AverageOptions averaging;
  BakeOptions baking;
  ImageSilhouetteOptions drawing;
  ProbeOptions probing;
  HelpOptions help;
};

/// Values with commas, and ranges, end with themselves: what follows is a file.
void takeNoMore(CLI::App& app)
{
  for (CLI::Option* option :
    app.get_options([](const CLI::Option* o) { return !o->get_positional(); }))
    option->allow_extra_args(false);
  for (CLI::App* command : app.get_subcommands({}))
    takeNoMore(*command);
}

void addCommands(CLI::App& app, AllOptions& all)
{
  addWindowOptions(app, all.window);
  const auto command = [&app](const char* name, const char* help) -> CLI::App&
  { return *app.add_subcommand(name, help); };
  addRenderOptions(command("render", "Write a picture; needs no display"), all.rendering);
  addConvertOptions(
    command("convert", "Write particles as a .mote file, which opens at once"), all.converting);
  addInfoOptions(
    command("info", "List arrays, ranges, types and time steps; cells, volumes and quality"),
    all.info);
  addAverageOptions(
    command("average", "Average an array over circles about an axis: a table or a picture"),
    all.averaging);
  addImageSilhouetteOptions(
    command("silhouettes", "Draw the silhouettes of a depth image, of any program's"), all.drawing);
  addBakeOptions(command("bake", "Write the ambient occlusion of particles as maps, which "
                                 "--ambient-occlusion baked looks up"),
    all.baking);
  addProbeOptions(command("probe", "List the values along a line"), all.probing);
  addHelpOptions(command("help", "Tell more about a topic, an option or the keys"), all.help);
}

/// Help without the marks of lists, whose commas the values' names show.
class HelpFormatter : public CLI::Formatter
{
public:
  std::string make_option_opts(const CLI::Option* option) const override
  {
    std::string text = CLI::Formatter::make_option_opts(option);
    for (const char* mark : {" ...", " x 2"})
      if (const std::size_t at = text.find(mark); at != std::string::npos)
        text.erase(at, std::strlen(mark));
    return text;
  }
};

int run(CLI::App& app, const AllOptions& all)
{
  const bool toRender = app.got_subcommand("render"), toInform = app.got_subcommand("info"),
             toConvert = app.got_subcommand("convert"), toAverage = app.got_subcommand("average"),
             toBake = app.got_subcommand("bake"), toProbe = app.got_subcommand("probe"),
             toDraw = app.got_subcommand("silhouettes");
  const DataSettings& data = (toRender    ? all.rendering.given
                              : toInform  ? all.info.given
                              : toConvert ? all.converting.given
                              : toAverage ? all.averaging.given
                              : toBake    ? all.baking.given
                              : toProbe   ? all.probing.given
                                          : all.window.given)
                               .settings.data;
  if (app.got_subcommand("help"))
  {
    printHelp(app, all.help);
    return 0;
  }
  if (data.files.empty() && !toDraw)
  {
    std::fprintf(stderr, "mote: no file given. Try: mote --help\n");
    return misused;
  }
  const auto limit = limitThreads(toDraw ? all.drawing.given.settings.data.threads : data.threads);
  if (toRender)
    render(all.rendering);
  else if (toInform)
    printInfo(all.info);
  else if (toConvert)
    convert(all.converting);
  else if (toAverage)
    average(all.averaging);
  else if (toBake)
    bake(all.baking);
  else if (toProbe)
    probe(all.probing);
  else if (toDraw)
    drawImageSilhouettes(all.drawing);
  else
    showWindow(all.window);
  // What stdout could not take, such as on a full disk, is only seen here.
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    throw Failure("the standard output could not be written");
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app(
    "Mote shows what simulations write: particles as spheres, hexahedra as volumes, ray cast.",
    "mote");
  app.set_version_flag("--version", "mote " MOTE_VERSION);
  app.require_subcommand(0, 1);
  app.footer(
    "Files:\n" + vtkMoteReaderTable::GetFormatsHelp() +
    "\nWithout a command a window opens; press h in it for its keys. Exit codes: 0 done, 1 failed\n"
    "with a sentence on standard error, 2 a wrong command line, 130 interrupted.");
  app.formatter(std::make_shared<HelpFormatter>());
  AllOptions all;
  addCommands(app, all);
  takeNoMore(app);
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
  endOnInterrupt();
  try
  {
    return run(app, all);
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
