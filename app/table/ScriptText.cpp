#include "ScriptText.h"

#include "settings/Values.h"

#include <cmath>

namespace mote::app
{

std::string python(double value)
{
  return std::isinf(value) ? value > 0.0 ? "math.inf" : "-math.inf" : exactText(value);
}

std::string python(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text)
    if (c == '\n')
      quoted += "\\n";
    else
      quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "\"";
}

std::string python(const char* text)
{
  return python(std::string(text ? text : ""));
}

std::string python(int value)
{
  return std::to_string(value);
}

std::string python(bool value)
{
  return value ? "True" : "False";
}

std::string python(const double* values, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i > 0 ? ", " : "") + python(values[i]);
  return text;
}

} // namespace mote::app
