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

/// A group of settingsTable().
struct Topic
{
  const char* group;
  const char* about;
  const char* example;
};

const std::vector<Topic>& topics()
{
  static const std::vector<Topic> all = {
    {"Data", "What is read, and when.", "mote render dump.*.lammpstrj -o last.png --step last"},
    {"Colour", "Which array colours, and how.",
      "mote render run.dump -o v.png --color-by v:magnitude --color-map plasma --range 0 5"},
    {"Selection", "What is shown; the rest is hidden, not only recoloured.",
      "mote render run.dump -o part.png --show c_pe=-3.2: --show z=0:10"},
    {"Radius", "How large particles are.",
      "mote render run.dump -o r.png --type-radius 1=0.5,2=0.7"},
    {"Structure", "What rays are cast through; pictures stay the same.",
      "mote render run.dump -o a.png --structure pkd-tree --form 8-byte"},
    {"Volume", "How cells with a volume look.",
      "mote render pump:0.02 -o pump.png --color-by pressure --opacity 0%=0.4,50%=0,100%=0.4"},
    {"Camera", "Where the picture is taken from.",
      "mote render run.dump -o side.png --view +x --elevation 20 --zoom 2"},
    {"Light", "Lights, shadows and the sky.",
      "mote render run.dump -o soft.png --shadows soft --ambient-occlusion live"},
    {"Silhouettes", "Lines where depth jumps.",
      "mote render run.dump -o lines.png --silhouettes=4 --silhouette-color navy"},
    {"Picture", "Size, smoothness, and what lies over the picture.",
      "mote render run.dump -o big.png --size 3840x2160 --samples 64 --background white"},
  };
  return all;
}

std::string limitsText(const Row& row)
{
  const std::string limits = row.limits.text();
  return !row.words.empty() ? joined(row.words, ", ") : limits;
}

std::string usualText(const Row& row)
{
  const Settings settings;
  return !row.usual.empty() ? row.usual : joined(row.get(settings), row.commas ? "," : " ");
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

std::string optionText(const Row& row)
{
  return row.option() + (row.value.empty() ? "" : " " + row.value);
}

std::string rowText(const Row& row)
{
  std::string text = "  " + optionText(row) + "\n      " + row.help + ".\n";
  if (const std::string limits = limitsText(row); !limits.empty())
    text += "      Values: " + limits + ".\n";
  if (row.shape != Shape::Flag)
    text += "      Default: " + usualText(row) + ".\n";
  return text;
}

std::string groupText(const Topic& topic)
{
  std::string text =
    std::string(topic.group) + ": " + topic.about + "\n\n  " + topic.example + "\n\n";
  for (const Row& row : settingsTable())
    if (row.group == topic.group)
      text += rowText(row);
  return text;
}

std::string topicText(const std::string& name)
{
  if (name == "keys")
    return keysHelp() + "\n";
  if (name == "formats")
    return vtkMoteReaderTable::GetFormatsHelp();
  for (const Topic& topic : topics())
    if (lowerCase(topic.group) == lowerCase(name))
      return groupText(topic);
  const std::size_t dashes = name.find_first_not_of('-');
  const std::string bare = dashes == std::string::npos ? name : name.substr(dashes);
  for (const Row& row : settingsTable())
    if (row.name == bare || row.option() == "--" + bare)
      return rowText(row);
  std::vector<std::string> known = {"keys", "formats"};
  for (const Topic& topic : topics())
    known.push_back(lowerCase(topic.group));
  throw Failure("there is no help about '" + name + "'; there is about " + joined(known, ", ") +
                " and every option");
}

std::string overview()
{
  std::string text = "mote help TOPIC tells more about a topic or an option:\n\n";
  for (const Topic& topic : topics())
  {
    std::string name = lowerCase(topic.group);
    name.resize(13, ' ');
    text += "  " + name + topic.about + "\n";
  }
  return text + "  keys         What keys do in the window.\n"
                "  formats      What files are read.\n";
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
  std::string text = "# Settings\n\nEvery choice that a user can make of a picture. "
                     "A row is an option of `mote` and `mote render`, and an\nentry of sessions. "
                     "`mote help --format markdown` writes this page.\n";
  for (const Topic& topic : topics())
  {
    text += "\n## " + std::string(topic.group) + "\n\n" + topic.about + "\n\n    " + topic.example +
            "\n\n| option | what | values | default | a change makes anew |\n" +
            "|---|---|---|---|---|\n";
    for (const Row& row : settingsTable())
      if (row.group == topic.group)
        text += "| `" + cell(optionText(row)) + "` | " + cell(row.help) + " | " +
                cell(limitsText(row)) + " | " +
                (row.shape == Shape::Flag ? "" : cell(usualText(row))) + " | " +
                invalidatesText(row.invalidates) + " |\n";
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
    text += ".SH " + std::string(topic.group) + "\n" + troff(topic.about) + "\n";
    for (const Row& row : settingsTable())
      if (row.group == topic.group)
        text += ".TP\n.B " + troff(optionText(row)) + "\n" + troff(row.help) + ".\n" +
                (row.shape == Shape::Flag ? "" : "Default: " + troff(usualText(row)) + ".\n");
  }
  return text + ".SH KEYS\n.nf\n" + troff(keysHelp()) + "\n.fi\n";
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
    if (!row.words.empty())
      words += "    --" + row.name + ") COMPREPLY=($(compgen -W \"" + joined(row.words, " ") +
               "\" -- \"$word\")); return ;;\n";
  return "# Completion of mote for bash.\n_mote() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} options\n"
         "  case ${COMP_WORDS[COMP_CWORD-1]} in\n" +
         words + "  esac\n  case ${COMP_WORDS[1]} in\n" + cases + "    *) options=\"" +
         optionNames(app) + "\" ;;\n  esac\n  if [[ $word == -* ]]; then\n" +
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n" +
         "  elif [ \"$COMP_CWORD\" = 1 ]; then\n    COMPREPLY=($(compgen -f -W \"" + commands +
         "\" -- \"$word\"))\n  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\n"
         "complete -o filenames -F _mote mote\n";
}

} // namespace

void addHelpOptions(CLI::App& app, HelpOptions& options)
{
  app.add_option("TOPIC", options.topic, "A group of options, an option, keys or formats")
    ->type_name("");
  app
    .add_option("--format", options.format,
      "Print all of it: markdown for the reference, man for a manual page, bash for a completion")
    ->check(CLI::IsMember({"text", "markdown", "man", "bash"}).description(""))
    ->type_name("text|markdown|man|bash");
}

void printHelp(const CLI::App& app, const HelpOptions& options)
{
  const std::string text = options.format == "markdown" ? markdown()
                           : options.format == "man"    ? manPage(app)
                           : options.format == "bash"   ? bashCompletion(app)
                           : options.topic.empty()      ? overview()
                                                        : topicText(options.topic);
  std::fputs(text.c_str(), stdout);
}

} // namespace mote::app
