#pragma once

#include "Text.h"

#include <CLI/CLI.hpp>

#include <string>

namespace mote::app
{

/// That a text is a number; the library's own checks of ranges let "nan" pass.
inline CLI::Validator isNumber()
{
  return {[](std::string& text)
    {
      double number = 0.0;
      return parseNumber(text, number) ? std::string() : "'" + text + "' is not a number";
    },
    "", "number"};
}

} // namespace mote::app
