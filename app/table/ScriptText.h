#pragma once

#include <string>

namespace mote::app
{

/// Values as Python writes them.
std::string python(double value);
std::string python(const std::string& text);
std::string python(const char* text); ///< null: an empty text
std::string python(int value);
std::string python(bool value);
/// So many numbers with commas.
std::string python(const double* values, int count);

/// The text of a program, line by line.
class Script
{
public:
  void line(const std::string& text = {}) { text_ += text + "\n"; }

  /// "object.Function(arguments)"
  template <typename... Arguments>
  void call(const std::string& object, const char* function, const Arguments&... arguments)
  {
    std::string all;
    ((all += (all.empty() ? "" : ", ") + python(arguments)), ...);
    this->line(object + "." + function + "(" + all + ")");
  }
  void vector(const std::string& object, const char* function, const double* values, int count = 3)
  {
    this->line(object + "." + function + "(" + python(values, count) + ")");
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace mote::app
