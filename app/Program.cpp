#include "Program.h"

#include "base/Failure.h"
#include "base/Memory.h"
#include "base/Messages.h"
#include "base/ProgressRelay.h"
#include "base/Text.h"
#include "commands/Animate.h"
#include "commands/Average.h"
#include "commands/Bake.h"
#include "commands/Convert.h"
#include "commands/ImageSilhouettes.h"
#include "commands/Info.h"
#include "commands/Integrate.h"
#include "commands/Probe.h"
#include "commands/Render.h"
#include "table/CommandOptions.h"
#include "table/Help.h"
#include "table/Recording.h"
#include "table/Session.h"
#include "window/Display.h"
#include "window/Window.h"

#include <kernels/core/CutFiles.h>

#include <vtkMoteReaderTable.h>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>

namespace mote::app
{

namespace
{

constexpr int failed = 1, misused = 2, interrupted = 130;

/// What the program does: the window, which needs no word, and the commands.
struct Command
{
  const char* name;
  const char* help;
  void (*declare)(CLI::App& app, GivenSettings& given);
  void (*run)(const Settings& settings);
};

constexpr Command commands[] = {
  {"", "", addWindowOptions, showWindow},
  {"render", "Write a picture; needs no display", addRenderOptions, render},
  {"animate", "Write a film: an orbit, time steps, key frames; needs no display", addAnimateOptions,
    animate},
  {"convert",
    "Write particles or triangles as a .mote file, which opens at once; or what is shown as .vtp, "
    ".vtu or .xyz",
    addConvertOptions, convert},
  {"info", "List arrays, ranges, types and time steps; cells, volumes and quality", addInfoOptions,
    printInfo},
  {"average", "Average an array over circles about an axis: a table or a picture",
    addAverageOptions, average},
  {"silhouettes", "Draw the silhouettes of a depth image, of any program's",
    addImageSilhouetteOptions, drawImageSilhouettes},
  {"bake",
    "Write the ambient occlusion of particles as maps, which --ambient-occlusion baked looks up",
    addBakeOptions, bake},
  {"integrate", "List areas, means, flow rates, torques and heads of sections and boundaries",
    addIntegrateOptions, integrate},
  {"probe", "List the values along a line", addProbeOptions, probe},
};

/// What the command line says to each of them.
struct CommandLine
{
  GivenSettings given[std::size(commands)];
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

void addCommands(CLI::App& app, CommandLine& line)
{
  for (std::size_t i = 0; i < std::size(commands); ++i)
  {
    const Command& command = commands[i];
    command.declare(
      *command.name ? *app.add_subcommand(command.name, command.help) : app, line.given[i]);
  }
  const std::string codes = "Exit codes: 0 success, 1 failure with a sentence on standard error, 2 "
                            "a wrong command line,\n130 interrupted.";
  const std::string formats = "Files:\n" + vtkMoteReaderTable::GetFormatsHelp() + "\n";
  for (CLI::App* command : app.get_subcommands({}))
    command->footer(formats + codes);
  app.get_subcommand("silhouettes")
    ->footer("Images: .exr with depths, or any image of one channel of numbers.\n\n" + codes);
  app.footer(formats + "Without a command a window opens; press h in it for its keys.\n" + codes);
  addHelpOptions(
    *app.add_subcommand("help", "Tell more about a topic, an option or the keys"), line.help);
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

/// What stdout could not take, such as on a full disk, is only seen at the end.
void requireWritten()
{
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) || !std::cout)
    throw Failure("the standard output could not be written");
}

/// "rendr" in place of "render" is taken for a file.
std::string wrongCommand(int argc, char** argv)
{
  const std::string word = argc > 1 ? argv[1] : "";
  std::error_code error;
  if (word.empty() || word.find_first_not_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos ||
      std::filesystem::exists(word, error))
    return {};
  std::string known;
  for (const Command& command : commands)
    known += *command.name ? std::string(command.name) + ", " : "";
  return "there is neither a file nor a command '" + word + "'; commands are " + known + "help. ";
}

void tell(const std::string& sentence)
{
  std::fprintf(stderr, "mote: %s\n", oneLine(sentence).c_str());
}

int run(CLI::App& app, const CommandLine& line)
{
  if (app.got_subcommand("help"))
  {
    printHelp(app, line.help);
    requireWritten();
    return 0;
  }
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < std::size(commands); ++i)
    if (app.got_subcommand(commands[i].name))
      chosen = i;
  const bool canOffer = chosen == 0 && displayAvailable();
  const Settings& given = line.given[chosen].settings;
  if (given.data.files.empty() && given.output.play.empty() && !canOffer)
  {
    tell("no file given. Try: mote --help");
    return misused;
  }
  const Settings settings = line.given[chosen].resolved();
  checkSessionOutput(settings);
  checkRecordingOutput(settings);
  const auto limit = limitThreads(settings.data.threads);
  commands[chosen].run(settings);
  requireWritten();
  return 0;
}

/// Runs what the command line says, and tells what goes wrong. Returns the exit code.
int runWhole(CLI::App& app, const CommandLine& line)
{
  Messages::install();
  endOnInterrupt();
  surviveCutFiles();
  try
  {
    const int code = run(app, line);
    if (!fileWasCut())
      return code;
  }
  catch (const Interrupted&)
  {
    tell("interrupted");
    return interrupted;
  }
  catch (const std::bad_alloc&)
  {
    tell("there is not enough memory for this");
  }
  catch (const std::exception& error)
  {
    if (!fileWasCut()) // what was found wrong with it says less
      tell(error.what());
  }
  if (fileWasCut())
    tell("a file was cut short by another program, or could not be read, while it was in use");
  return failed;
}

} // namespace

std::unique_ptr<tbb::global_control> limitThreads(int threads)
{
  if (threads < 1)
    return nullptr;
  return std::make_unique<tbb::global_control>(
    tbb::global_control::max_allowed_parallelism, threads);
}

int runProgram(int argc, char** argv)
{
  keepToMemoryOfGroup();
  CLI::App app(
    "Mote ray casts what simulations write: particles as spheres; hexahedra and other 3D cells as "
    "volumes.",
    "mote");
  app.set_version_flag("--version", "mote " MOTE_VERSION);
  app.require_subcommand(0, 1);
  app.formatter(std::make_shared<HelpFormatter>());
  CommandLine line;
  addCommands(app, line);
  takeNoMore(app);
  try
  {
    std::vector<std::string> words = wordsOf(app, argc, argv);
    std::reverse(words.begin(), words.end()); // as the library wants them
    app.parse(std::move(words));
  }
  catch (const CLI::Success& asked)
  {
    const int code = app.exit(asked);
    try
    {
      requireWritten();
    }
    catch (const Failure& failure)
    {
      tell(failure.what());
      return failed;
    }
    return code;
  }
  catch (const CLI::ParseError& error)
  {
    const std::string wrong =
      app.get_subcommands().empty() ? wrongCommand(argc, argv) : std::string();
    const std::vector<CLI::App*> commands = app.get_subcommands();
    const std::string command = commands.empty() ? "" : commands.front()->get_name() + " ";
    tell(wrong + error.what() + ". Try: mote " + command + "--help");
    return misused;
  }

  return runWhole(app, line);
}

} // namespace mote::app
