#include "Keys.h"

#include "base/Text.h"

#include <algorithm>

namespace mote::app
{

namespace
{

/// A line of the help with the bindings that it speaks of.
struct Line
{
  const char* keys;
  const char* help;
  std::vector<Binding> bindings;
};

const std::vector<Line>& lines()
{
  using enum Action;
  static const std::vector<Line> table = {
    {"drag", "rotate; with Shift or the middle button pan, with the right one zoom", {}},
    {"wheel  + -", "zoom",
      {{ZoomIn, {"plus", "equal", "KP_Add"}}, {ZoomOut, {"minus", "KP_Subtract"}}}},
    {"r", "reset the view", {{ResetView, {"r", "R"}}}},
    {"x y z", "look from +x, +y, +z; X Y Z from the other side",
      {{Set, {"x"}, "view", "+x"}, {Set, {"X"}, "view", "-x"}, {Set, {"y"}, "view", "+y"},
        {Set, {"Y"}, "view", "-y"}, {Set, {"z"}, "view", "+z"}, {Set, {"Z"}, "view", "-z"}}},
    {"o", "perspective or parallel projection", {{Next, {"o", "O"}, "orthographic"}}},
    {"v", "data sets beside one another, or in one", {{Next, {"v", "V"}, "side-by-side"}}},
    {"f", "centre the view on the particle under the cursor", {{Center, {"f", "F"}}}},
    {"click  p",
      "pick what is under the cursor and list its values; Shift and a click, P: add it, "
      "or take it away",
      {{Pick, {"p"}}, {PickMore, {"P"}}}},
    {"Ctrl and drag",
      "pick what is seen in a rectangle; right button: also what is hidden behind; "
      "Shift: add it",
      {}},
    {"Alt and drag", "move the slice, or the face of a cut, that is under the cursor", {}},
    {"n",
      "handles of slices and cuts, to be dragged without Alt: while their lists are open in "
      "the panel, always, never",
      {{Next, {"n", "N"}, "handles"}}},
    {"i Delete u", "show only the picked particles; hide them; show again what these hid",
      {{OnlyPicked, {"i", "I"}}, {HidePicked, {"Delete"}}, {ShowHidden, {"u", "U"}}}},
    {"Ctrl+C Ctrl+E", "copy the list of the picked; save it as a CSV file",
      {{CopyPicked, {"Control+c", "Control+C"}}, {SavePicked, {"Control+e", "Control+E"}}}},
    {"j", "show the paths of the picked particles through time as lines, or show none",
      {{PathsOfPicked, {"j", "J"}}}},
    {"c  C", "colour by the next array; by its next component",
      {{Next, {"c"}, "color-by"}, {NextPart, {"C"}, "color-by"}}},
    {"m", "next colour map", {{Next, {"m", "M"}, "color-map"}}},
    {"[  ]", "smaller, larger particles",
      {{Less, {"bracketleft"}, "radius-scale"}, {More, {"bracketright"}, "radius-scale"}}},
    {"Left Right", "previous, next time step (or , and .); Home first, End last",
      {{Less, {"Left", "comma"}, "step"}, {More, {"Right", "period"}, "step"},
        {First, {"Home"}, "step"}, {Last, {"End"}, "step"}}},
    {"space", "play the time steps, or pause", {{Play, {"space"}}}},
    {"b l a g", "box, legend, axes, light or dark background",
      {{Next, {"b", "B"}, "box"}, {Next, {"l", "L"}, "legend"}, {Next, {"a", "A"}, "axes"},
        {Next, {"g", "G"}, "background"}}},
    {"w", "volumes: walls and slices, or the cloud", {{Next, {"w", "W"}, "cloud"}}},
    {"d", "shadows: none, hard, soft", {{Next, {"d", "D"}, "shadows"}}},
    {"t", "light: plain, ambient occlusion, baked ambient occlusion, path tracing",
      {{Next, {"t", "T"}, "ambient-occlusion"}}},
    {"e", "silhouettes: lines where depth jumps", {{Next, {"e", "E"}, "silhouettes"}}},
    {"Ctrl+O", "open other files, or add some", {{Open, {"Control+o", "Control+O"}}}},
    {"s", "save a picture of the view, as mote render makes it", {{SavePicture, {"s", "S"}}}},
    {"Ctrl+S", "save the session: data, view and all settings",
      {{SaveSession, {"Control+s", "Control+S"}}}},
    {"k  K", "print the view as a mote render command; as a Python script",
      {{PrintCommand, {"k"}}, {PrintScript, {"K"}}}},
    {"Ctrl+Z Ctrl+Y", "undo, redo",
      {{Undo, {"Control+z"}}, {Redo, {"Control+y", "Control+Z", "Control+Y"}}}},
    {"Escape", "stop long work; dismiss messages; pick nothing", {{Escape, {"Escape"}}}},
    {"Tab", "show the panel and give it the keys (arrows, space; Escape); again: hide it",
      {{Panel, {"Tab"}}}},
    {"h ?", "these keys; Page Up and Page Down go through them where the view is small",
      {{Help, {"h", "H", "question", "F1"}}, {HelpUp, {"Prior", "KP_Prior"}},
        {HelpDown, {"Next", "KP_Next"}}}},
    {"q", "quit", {{Quit, {"q", "Q"}}}},
  };
  return table;
}

} // namespace

const Binding& bindingOf(const std::string& keySymbol)
{
  static const Binding none;
  for (const Line& line : lines())
    for (const Binding& binding : line.bindings)
      for (const std::string& symbol : binding.symbols)
        if (keySymbol == symbol)
          return binding;
  return none;
}

std::string keysHelp(std::size_t columns)
{
  constexpr std::size_t indent = 15, least = 20;
  const std::size_t room = std::max(columns, indent + least + 2) - indent - 2;
  const std::string between = "\n" + std::string(indent + 1, ' ');
  std::string text;
  for (const Line& line : lines())
  {
    std::string keys = line.keys;
    keys.resize(indent, ' ');
    std::string help = wrapped(line.help, room);
    for (std::size_t at = 0; (at = help.find('\n', at)) != std::string::npos; at += between.size())
      help.replace(at, 1, between);
    text += (text.empty() ? " " : "\n ") + keys + help + " ";
  }
  return text;
}

std::string keysMarkdown()
{
  std::string text =
    "# Keys\n\nWhat keys and the mouse do in the window. `h` shows them there. The last column "
    "names the option that a key\nchanges, where there is one: [settings.md](settings.md) tells "
    "more about it. `mote help keys --format markdown`\nwrites this page.\n\n"
    "| keys | what they do | options |\n|---|---|---|\n";
  for (const Line& line : lines())
  {
    std::vector<std::string> options;
    for (const Binding& binding : line.bindings)
      if (const std::string option = "`--" + binding.row + "`";
          !binding.row.empty() && (options.empty() || options.back() != option))
        options.push_back(option);
    text +=
      std::string("| ") + line.keys + " | " + line.help + " | " + joined(options, ", ") + " |\n";
  }
  return text;
}

} // namespace mote::app
