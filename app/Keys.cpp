#include "Keys.h"

#include <vector>

namespace mote::app
{

namespace
{

struct Binding
{
  Action action;
  std::vector<const char*> symbols; // as X11 calls the keys
};

const std::vector<Binding>& bindings()
{
  static const std::vector<Binding> table = {
    {Action::Help, {"h", "H", "question", "F1"}},
    {Action::ResetView, {"r", "R"}},
    {Action::ViewPlusX, {"x"}},
    {Action::ViewMinusX, {"X"}},
    {Action::ViewPlusY, {"y"}},
    {Action::ViewMinusY, {"Y"}},
    {Action::ViewPlusZ, {"z"}},
    {Action::ViewMinusZ, {"Z"}},
    {Action::Projection, {"o", "O"}},
    {Action::ZoomIn, {"plus", "equal", "KP_Add"}},
    {Action::ZoomOut, {"minus", "KP_Subtract"}},
    {Action::NextArray, {"c"}},
    {Action::NextComponent, {"C"}},
    {Action::NextMap, {"m", "M"}},
    {Action::Smaller, {"bracketleft"}},
    {Action::Larger, {"bracketright"}},
    {Action::PreviousStep, {"Left", "comma"}},
    {Action::NextStep, {"Right", "period"}},
    {Action::FirstStep, {"Home"}},
    {Action::LastStep, {"End"}},
    {Action::Play, {"space"}},
    {Action::Pick, {"p", "P"}},
    {Action::Center, {"f", "F"}},
    {Action::Box, {"b", "B"}},
    {Action::Legend, {"l", "L"}},
    {Action::Axes, {"a", "A"}},
    {Action::Background, {"g", "G"}},
    {Action::Shadows, {"d", "D"}},
    {Action::Shading, {"t", "T"}},
    {Action::Silhouettes, {"e", "E"}},
    {Action::Save, {"s", "S"}},
    {Action::Escape, {"Escape"}},
    {Action::Quit, {"q", "Q"}},
  };
  return table;
}

} // namespace

Action actionOf(const std::string& keySymbol)
{
  for (const Binding& binding : bindings())
    for (const char* symbol : binding.symbols)
      if (keySymbol == symbol)
        return binding.action;
  return Action::None;
}

std::string keysHelp()
{
  return " drag          turn; with Shift or the middle button shift, with the right zoom \n"
         " wheel  + -    zoom \n"
         " r             reset the view \n"
         " x y z         look from +x, +y, +z; X Y Z from the other side \n"
         " o             perspective or parallel \n"
         " f             put the particle under the cursor in the middle \n"
         " p             pick the particle under the cursor and list its values \n"
         " c  C          colour by the next array; by its next component \n"
         " m             next colour map \n"
         " [  ]          smaller, larger particles \n"
         " Left Right    previous, next time step (or , and .); Home first, End last \n"
         " space         play the time steps, or pause \n"
         " b l a g       box, legend, axes, light or dark background \n"
         " d             shadows: none, hard, soft \n"
         " t             light: plain, ambient occlusion, the same baked, path tracing \n"
         " e             silhouettes: lines where depth jumps \n"
         " s             save a picture of the view \n"
         " Escape        stop long work; take messages away \n"
         " h ?           these keys \n"
         " q             quit ";
}

} // namespace mote::app
