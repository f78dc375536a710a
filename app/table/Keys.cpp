#include "Keys.h"

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
    {"drag", "turn; with Shift or the middle button shift, with the right zoom", {}},
    {"wheel  + -", "zoom",
      {{ZoomIn, {"plus", "equal", "KP_Add"}, ""}, {ZoomOut, {"minus", "KP_Subtract"}, ""}}},
    {"r", "reset the view", {{ResetView, {"r", "R"}, ""}}},
    {"x y z", "look from +x, +y, +z; X Y Z from the other side",
      {{View, {"x"}, "+x"}, {View, {"X"}, "-x"}, {View, {"y"}, "+y"}, {View, {"Y"}, "-y"},
        {View, {"z"}, "+z"}, {View, {"Z"}, "-z"}}},
    {"o", "perspective or parallel projection", {{Projection, {"o", "O"}, ""}}},
    {"f", "center the view on the particle under the cursor", {{Center, {"f", "F"}, ""}}},
    {"p", "pick the particle under the cursor and list its values", {{Pick, {"p", "P"}, ""}}},
    {"c  C", "colour by the next array; by its next component",
      {{NextArray, {"c"}, ""}, {NextComponent, {"C"}, ""}}},
    {"m", "next colour map", {{NextMap, {"m", "M"}, ""}}},
    {"[  ]", "smaller, larger particles",
      {{Smaller, {"bracketleft"}, ""}, {Larger, {"bracketright"}, ""}}},
    {"Left Right", "previous, next time step (or , and .); Home first, End last",
      {{PreviousStep, {"Left", "comma"}, ""}, {NextStep, {"Right", "period"}, ""},
        {FirstStep, {"Home"}, ""}, {LastStep, {"End"}, ""}}},
    {"space", "play the time steps, or pause", {{Play, {"space"}, ""}}},
    {"b l a g", "box, legend, axes, light or dark background",
      {{Toggle, {"b", "B"}, "box"}, {Toggle, {"l", "L"}, "legend"}, {Toggle, {"a", "A"}, "axes"},
        {Background, {"g", "G"}, ""}}},
    {"d", "shadows: none, hard, soft", {{Shadows, {"d", "D"}, ""}}},
    {"t", "light: plain, ambient occlusion, the same precomputed, path tracing",
      {{Shading, {"t", "T"}, ""}}},
    {"e", "silhouettes: lines where depth jumps", {{Silhouettes, {"e", "E"}, ""}}},
    {"s", "save a picture of the view, as mote render makes it", {{SavePicture, {"s", "S"}, ""}}},
    {"Ctrl+S", "save the session: data, view and all settings",
      {{SaveSession, {"Control+s", "Control+S"}, ""}}},
    {"k  K", "print the view as a mote render command; as a Python script",
      {{PrintCommand, {"k"}, ""}, {PrintScript, {"K"}, ""}}},
    {"Ctrl+Z Ctrl+Y", "undo, redo",
      {{Undo, {"Control+z"}, ""}, {Redo, {"Control+y", "Control+Z", "Control+Y"}, ""}}},
    {"Escape", "stop long work; dismiss messages", {{Escape, {"Escape"}, ""}}},
    {"h ?", "these keys", {{Help, {"h", "H", "question", "F1"}, ""}}},
    {"q", "quit", {{Quit, {"q", "Q"}, ""}}},
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

std::string keysHelp()
{
  std::string text;
  for (const Line& line : lines())
  {
    std::string keys = line.keys;
    keys.resize(15, ' ');
    text += (text.empty() ? " " : "\n ") + keys + line.help + " ";
  }
  return text;
}

} // namespace mote::app
