#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace mote
{

/// An expression of named variables, evaluated for many values of them at once.
class ExpressionParser
{
public:
  /// Throws Error where the expression cannot be read.
  explicit ExpressionParser(const std::string& expression);
  ~ExpressionParser();

  /// The variables' names, each once, in the order in which they appear.
  const std::vector<std::string>& names() const { return names_; }

  /// How many values evaluate() takes of each variable.
  static constexpr int blockSize = 1024;
  /// Where the values of a variable are to be put.
  double* values(std::size_t variable) { return values_[variable].data(); }
  /// Evaluates the first `count` values of each.
  void evaluate(double* results, int count);

private:
  struct Parser;

  static double* variableNamed(const char* name, void* self);

  std::unique_ptr<Parser> parser_;
  std::vector<std::string> names_;
  std::vector<std::string> quoted_;        ///< names in quotes
  std::deque<std::vector<double>> values_; ///< which stay where they are
};

} // namespace mote
