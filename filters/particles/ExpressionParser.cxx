#include "ExpressionParser.h"

#include "kernels/core/Error.h"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace mote
{

struct ExpressionParser::Parser
{
  mu::Parser parser;
};

namespace
{

/// What a name in quotes is for the parser, which takes no other characters.
const std::string quotedName = "quoted_name_";

/// muParser takes = for an assignment, and & and | for nothing.
void refuseSingle(const std::string& text, char sign, const std::string& partners)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] != sign)
      continue;
    if (i + 1 < text.size() && text[i + 1] == sign)
    {
      ++i;
      continue;
    }
    if (i == 0 || partners.find(text[i - 1]) == std::string::npos)
      throw Error(std::string("write ") + sign + sign + " for " +
                  (sign == '='    ? "equal"
                    : sign == '&' ? "and"
                                  : "or") +
                  ", not " + sign);
  }
}

std::string wordFor(std::size_t quoted)
{
  return quotedName + std::to_string(quoted) + "_";
}

/// Puts names of the parser's own in the place of those in quotes.
std::string withoutQuotes(const std::string& text, std::vector<std::string>& quoted)
{
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] != '\'' && text[i] != '"')
    {
      plain += text[i];
      continue;
    }
    const std::size_t end = text.find(text[i], i + 1);
    if (end == std::string::npos)
      throw Error(std::string("the quote ") + text[i] + " has no end");
    plain += wordFor(quoted.size());
    quoted.push_back(text.substr(i + 1, end - i - 1));
    i = end;
  }
  return plain;
}

double magnitudeOf(double value)
{
  return std::abs(value);
}

double isZero(double value)
{
  return value == 0.0 ? 1.0 : 0.0;
}

bool isOfName(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
}

/// The name that ends before a place of the text, or an empty one.
std::string nameBefore(const std::string& text, std::size_t place)
{
  const std::size_t end = std::min(place, text.size());
  std::size_t begin = end;
  while (begin > 0 && isOfName(text[begin - 1]))
    --begin;
  return text.substr(begin, end - begin);
}

/// muParser wants no space between a function and its parenthesis.
std::string withCallsClosed(const std::string& text)
{
  std::string closed;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const std::size_t next = std::min(text.find_first_not_of(" \t\n", i), text.size());
    const bool isCall = next > i && next < text.size() && text[next] == '(' && !closed.empty() &&
                        isOfName(closed.back());
    if (!isCall)
      closed += text[i];
  }
  return closed;
}

/// Whether a name stands before a parenthesis: else it may be that of an array.
bool calls(const std::string& text, const std::string& name)
{
  for (std::size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1))
    if (nameBefore(text, at) == name)
      return true;
  return false;
}

} // namespace

ExpressionParser::ExpressionParser(const std::string& expression)
  : parser_(std::make_unique<Parser>())
{
  mu::Parser& parser = parser_->parser;
  std::string plain;
  try
  {
    plain = withCallsClosed(withoutQuotes(expression, quoted_));
    if (plain.find_first_not_of(" \t\n") == std::string::npos)
      throw Error("it is empty");
    refuseSingle(plain, '=', "<>!");
    refuseSingle(plain, '&', "");
    refuseSingle(plain, '|', "");
    std::string letters = "0123456789_.";
    for (char c = 'a'; c <= 'z'; ++c)
      letters += c, letters += static_cast<char>(c - 'a' + 'A');
    parser.DefineNameChars(letters.c_str());
    parser.DefineInfixOprt("!", isZero);
    parser.DefineConst("pi", 3.14159265358979323846);
    // A vector's name is its magnitude already.
    if (calls(plain, "mag"))
      parser.DefineFun("mag", magnitudeOf);
    parser.SetVarFactory(&ExpressionParser::variableNamed, this);
    parser.SetExpr(plain);
    // The first evaluation of one value by itself makes the code that the others run.
    parser.Eval();
    if (parser.GetNumResults() != 1)
      throw Error("it has several results, separated by commas");
  }
  catch (const mu::ParserError& error)
  {
    if (error.GetCode() == mu::ecUNEXPECTED_PARENS)
      if (const std::string name = nameBefore(plain, static_cast<std::size_t>(error.GetPos()));
          !name.empty() && name.rfind(quotedName, 0) != 0)
        throw Error("there is no function " + name);
    std::string sentence = error.GetMsg();
    for (std::size_t i = 0; i < quoted_.size(); ++i)
      if (const std::size_t at = sentence.find(wordFor(i)); at != std::string::npos)
        sentence.replace(at, wordFor(i).size(), quoted_[i]);
    while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == '\n'))
      sentence.pop_back();
    throw Error(sentence);
  }
}

ExpressionParser::~ExpressionParser() = default;

double* ExpressionParser::variableNamed(const char* text, void* self)
{
  auto* me = static_cast<ExpressionParser*>(self);
  std::string name = text;
  for (std::size_t i = 0; i < me->quoted_.size(); ++i)
    if (const std::string word = wordFor(i); name.compare(0, word.size(), word) == 0)
    {
      const std::string rest = name.substr(word.size());
      if (!rest.empty() && rest.front() != '.')
        throw Error("after '" + me->quoted_[i] + "' stands " + rest);
      name = me->quoted_[i] + rest;
      break;
    }
  me->names_.push_back(name);
  me->values_.emplace_back(blockSize, 0.0);
  return me->values_.back().data();
}

void ExpressionParser::evaluate(double* results, int count)
{
  parser_->parser.Eval(results, count);
}

} // namespace mote
