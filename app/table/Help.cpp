#include "Help.h"

#include "CommandLine.h"
#include "Keys.h"
#include "Row.h"
#include "base/Failure.h"
#include "base/Text.h"

#include <vtkMoteReaderTable.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace mote::app
{

namespace
{

/// A group of settingsTable(), or a command with what it alone takes.
struct Topic
{
  const char* name;
  const char* about;
  const char* example;
  const char* command = ""; ///< as Row::command; empty: a group

  bool has(const Row& row) const { return *command ? row.command == command : row.group == name; }
  bool isCalled(const std::string& word) const
  {
    return lowerCase(name) == word || (*command && word == command) ||
           (word == "color" && lowerCase(name) == "colour");
  }
  const std::vector<Row>& table() const { return *command ? commandTable() : settingsTable(); }
};

const std::vector<Topic>& topics()
{
  static const std::vector<Topic> all = {
    {"Data", "What is read, and when.", "mote render dump.*.lammpstrj -o last.png --step last"},
    {"Colour", "Which array colours, and how.",
      "mote render run.dump -o v.png --color-by v:magnitude --color-map plasma --range 0 5"},
    {"Selection", "What is shown; the rest is hidden, not only recoloured.",
      "mote render run.dump -o part.png --show c_pe=-3.2: --show z=0:10"},
    {"Cuts", "Planes and cylinders that cut everything open.",
      "mote render run.dump -o half.png --cut x=:0 --cut z=1:5"},
    {"Radius", "How large particles are.",
      "mote render run.dump -o r.png --type-radius 1=0.5,2=0.7"},
    {"Structure", "What rays are cast through; pictures stay the same, to rounding.",
      "mote render run.dump -o a.png --structure pkd-tree --form 8-byte"},
    {"Volume", "How cells with a volume look.",
      "mote render pump:0.02 -o pump.png --color-by pressure --opacity 0%=0.4,50%=0,100%=0.4"},
    {"Slices", "Volumes sliced by planes and cylinders; their boundary; edges of cells.",
      "mote render pump:0.02 -o slice.png --slice z=0.03 --walls 0.2 --edges 1"},
    {"Flow", "Streamlines and arrows of the vectors in volumes.",
      "mote render pump:0.02 -o flow.png --streamlines 200"},
    {"Camera", "Where the picture is taken from.",
      "mote render run.dump -o side.png --view +x --elevation 20 --zoom 2"},
    {"Light", "Lights, shadows and the sky.",
      "mote render run.dump -o soft.png --shadows soft --ambient-occlusion live"},
    {"Silhouettes", "Lines where depth jumps.",
      "mote render run.dump -o lines.png --silhouettes=4 --silhouette-color navy"},
    {"Picture", "Size, smoothness, and what lies over the picture.",
      "mote render run.dump -o big.png --size 3840x2160 --samples 64 --background white"},
    {"mote", "The window; it takes all of the above, too.",
      "mote run.dump --save-session view.json", "mote"},
    {"mote render", "A picture; it takes all of the above, too.",
      "mote render run.dump -o run.png --all-steps", "render"},
    {"mote animate", "A film; it takes all of the above, too.",
      "mote animate run.dump -o turn.ogv --orbit 360", "animate"},
    {"mote convert",
      "A .mote file of particles or triangles, or what is shown as .vtp, .vtu, these in pieces "
      "(.pvtp, .pvtu), as blocks (.vtm), or .xyz; it takes the groups Data and Radius, --form, and "
      "--show, --where, "
      "ids and cuts, too.",
      "mote convert run.dump run.mote --memory 8G", "convert"},
    {"mote info", "What files hold; it takes the group Data, too.", "mote info --json run.dump",
      "info"},
    {"mote average", "Averages over circles about an axis; it takes Data and Colour, too.",
      "mote average pump:0.02:rotor --array velocity -o rotor.png", "average"},
    {"mote silhouettes", "Silhouettes of a depth image; it takes those of Silhouettes, too.",
      "mote silhouettes run.exr -o lines.png --threshold 2%", "silhouettes"},
    {"mote bake", "Maps of ambient occlusion; it takes Data and Radius, too.",
      "mote bake run.dump --samples 196", "bake"},
    {"mote integrate", "Integrals over sections and boundaries; it takes Data, too.",
      "mote integrate pump:0.02:rotor --slice r=0.06,0.12 --array pressure", "integrate"},
    {"mote probe", "Values along a line; it takes Data, too.",
      "mote probe pump:0.02 --from 0,0.1,0.1 --to 0.3,0.1,0.1 -o line.csv", "probe"},
  };
  return all;
}

const char* invalidatesText(Invalidates invalidates)
{
  switch (invalidates)
  {
  case Invalidates::Nothing:
    return "nothing";
  case Invalidates::Picture:
    return "the picture";
  case Invalidates::Shading:
    return "the shading";
  case Invalidates::Structure:
    return "the structure";
  default:
    return "the data";
  }
}

/// "-c, --color-by NAME"
std::string optionText(const Row& row)
{
  std::string text = (row.alias.empty() ? "" : row.alias + ", ") + row.option();
  if (row.shape == Shape::OptionalOne)
    return text + "[=" + row.value + "]";
  return text + (row.value.empty() ? "" : " " + row.value);
}

std::string rowText(const Row& row)
{
  std::string text = "  " + optionText(row) + "\n      " + row.help + ".\n";
  if (const std::string values = row.values(); !values.empty())
    text += "      Values: " + values + ".\n";
  if (const std::string usual = row.usualText(); !usual.empty())
    text += "      Default: " + usual + ".\n";
  return text;
}

std::string groupText(const Topic& topic)
{
  std::string text =
    std::string(topic.name) + ": " + topic.about + "\n\n  " + topic.example + "\n\n";
  for (const Row& row : topic.table())
    if (topic.has(row))
      text += rowText(row);
  return text;
}

std::string topicText(const std::string& asked)
{
  const std::size_t dashes = asked.find_first_not_of('-');
  const std::string name = lowerCase(dashes == std::string::npos ? asked : asked.substr(dashes));
  if (name == "keys")
    return keysHelp() + "\n";
  if (name == "formats")
    return vtkMoteReaderTable::GetFormatsHelp();
  std::string text;
  for (const Topic& topic : topics())
    if (topic.isCalled(name) && name == asked)
      text += (text.empty() ? "" : "\n") + groupText(topic);
  if (!text.empty())
    return text;
  for (const auto* table : {&settingsTable(), &commandTable()})
    for (const Row& row : *table)
      if (row.name == name || row.option() == "--" + name || row.alias == "--" + name ||
          row.alias == asked)
        text += (row.command.empty() ? "" : "Of mote " + row.command + ":\n") + rowText(row);
  if (!text.empty())
    return text;
  std::vector<std::string> known = {"keys", "formats"};
  for (const Topic& topic : topics())
    known.push_back(*topic.command ? topic.command : lowerCase(topic.name));
  throw Failure("there is no help about '" + asked + "'; there is about " + joined(known, ", ") +
                " and every option");
}

std::string overview()
{
  std::string text =
    "mote help TOPIC tells more about a topic, or about an option, as in mote help "
    "shadows:\n\n";
  for (const Topic& topic : topics())
  {
    std::string name = lowerCase(topic.name);
    name.resize(18, ' ');
    text += "  " + name + topic.about + "\n";
  }
  return text + "  keys              What keys do in the window.\n"
                "  formats           What files are read.\n";
}

/// A cell of a table: a bar would end it.
std::string cell(std::string text)
{
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

std::string markdown()
{
  std::string text =
    "# Settings\n\nEvery choice that a user can make. The groups up to Picture are "
    "options of `mote` and `mote render`, and\nentries of sessions; what follows "
    "belongs to one command. Keys have [a page of their own](keys.md).\n`mote help --format "
    "markdown` writes this page.\n";
  for (const Topic& topic : topics())
  {
    text += "\n## " + std::string(topic.name) + "\n\n" + topic.about + "\n\n    " + topic.example +
            "\n\n| option | what | values | default |" +
            (*topic.command ? "\n|---|---|---|---|\n"
                            : " a change recomputes |\n|---|---|---|---|---|\n");
    for (const Row& row : topic.table())
      if (topic.has(row))
        text += "| `" + cell(optionText(row)) + "` | " + cell(row.help) + " | " +
                cell(row.values()) + " | " + cell(row.usualText()) + " |" +
                (*topic.command ? "" : std::string(" ") + invalidatesText(row.invalidates) + " |") +
                "\n";
  }
  return text;
}

/// Text for troff: a line must not begin with a dot or a quote, and dashes are no hyphens.
std::string troff(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
  return escaped.starts_with('.') || escaped.starts_with('\'') ? "\\&" + escaped : escaped;
}

std::string manPage(const CLI::App& app)
{
  std::string text = ".TH MOTE 1\n.SH NAME\nmote \\- ray casts what simulations write\n"
                     ".SH SYNOPSIS\n.B mote\n[COMMAND] [OPTIONS] FILE...\n.SH DESCRIPTION\n" +
                     troff(app.get_description()) + "\n.SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += ".TP\n.B " + command->get_name() + "\n" + troff(command->get_description()) + "\n";
  for (const Topic& topic : topics())
  {
    text += ".SH " + std::string(topic.name) + "\n" + troff(topic.about) + "\n";
    for (const Row& row : topic.table())
      if (topic.has(row))
      {
        const std::string usual = row.usualText();
        const std::string values = row.values();
        text += ".TP\n.B " + troff(optionText(row)) + "\n" + troff(row.help) + ".\n" +
                (values.empty() ? "" : "Values: " + troff(values) + ".\n") +
                (usual.empty() ? "" : "Default: " + troff(usual) + ".\n");
      }
  }
  return text + ".SH KEYS\n.nf\n" + troff(keysHelp()) + "\n.fi\n.SH FILES\n.nf\n" +
         troff(vtkMoteReaderTable::GetFormatsHelp()) +
         ".fi\n.SH EXIT STATUS\n0 success, 1 failure with a sentence on standard error, "
         "2 a wrong command line, 130 interrupted.\n";
}

/// The names of a command's options.
std::string optionNames(const CLI::App& app)
{
  std::string names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names += " --" + name;
  return names;
}

std::string bashCompletion(const CLI::App& app)
{
  std::string commands, cases;
  for (const CLI::App* command : app.get_subcommands({}))
  {
    commands += " " + command->get_name();
    cases += "    " + command->get_name() + ") options=\"" + optionNames(*command) + "\" ;;\n";
  }
  std::string words;
  for (const Row& row : settingsTable())
    if (const auto& values = row.words.empty() ? row.offers : row.words; !values.empty())
      words += "    --" + row.name + (row.alias.empty() ? "" : "|" + row.alias) +
               ") mapfile -t COMPREPLY < <(compgen " + (row.namesFile ? "-f " : "") + "-W \"" +
               joined(values, " ") + "\" -- \"$word\"); return ;;\n";
  return "# Completion of mote for bash.\n_mote() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} options\n"
         "  case ${COMP_WORDS[COMP_CWORD-1]} in\n" +
         words + "  esac\n  case ${COMP_WORDS[1]} in\n" + cases + "    *) options=\"" +
         optionNames(app) + "\" ;;\n  esac\n  if [[ $word == -* ]]; then\n" +
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n" +
         "  elif [ \"$COMP_CWORD\" = 1 ]; then\n    mapfile -t COMPREPLY < <(compgen -f -W \"" +
         commands +
         "\" -- \"$word\")\n  else\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n  fi\n}\n"
         "complete -o filenames -F _mote mote\n";
}

} // namespace

void addHelpOptions(CLI::App& app, HelpOptions& options)
{
  app
    .add_option("TOPIC", options.topic, "A group of options, a command, an option, keys or formats")
    ->type_name("");
  app.allow_extras(); // options, as they are written elsewhere
  app
    .add_option("--format", options.format,
      "Print all of it: markdown for the reference (of keys, where TOPIC is keys), man for a "
      "manual page, bash for a completion")
    ->check(CLI::IsMember({"text", "markdown", "man", "bash"}).description(""))
    ->type_name("text|markdown|man|bash");
}

void printHelp(const CLI::App& app, const HelpOptions& options)
{
  const std::vector<std::string> others = app.get_subcommand("help")->remaining();
  const std::string& topic =
    options.topic.empty() && !others.empty() ? others.front() : options.topic;
  const std::string text = options.format == "markdown"
                             ? topic == "keys" ? keysMarkdown() : markdown()
                           : options.format == "man"  ? manPage(app)
                           : options.format == "bash" ? bashCompletion(app)
                           : topic.empty()            ? overview()
                                                      : topicText(topic);
  std::fputs(text.c_str(), stdout);
}

} // namespace mote::app
