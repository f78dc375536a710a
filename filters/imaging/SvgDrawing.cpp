#include "SvgDrawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mote::imaging
{
namespace
{

/// With two digits behind the point at most, whatever the locale.
std::string number(double value)
{
  const long long hundredths = std::llround(100.0 * value);
  const long long whole = std::abs(hundredths) / 100, rest = std::abs(hundredths) % 100;
  std::string text = (hundredths < 0 ? "-" : "") + std::to_string(whole);
  if (rest > 0)
  {
    text += '.';
    text += static_cast<char>('0' + rest / 10);
    if (rest % 10 > 0)
      text += static_cast<char>('0' + rest % 10);
  }
  return text;
}

std::string attribute(const char* name, const std::string& value)
{
  return std::string(" ") + name + "=\"" + value + '"';
}

/// `fill` or `stroke`, opaque or not.
std::string paint(const std::string& what, const Color& color)
{
  const auto byte = [](double share)
  { return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))); };
  char text[8];
  std::snprintf(
    text, sizeof text, "#%02x%02x%02x", byte(color.red), byte(color.green), byte(color.blue));
  std::string result = attribute(what.c_str(), text);
  if (color.alpha < 1.0)
    result += attribute((what + "-opacity").c_str(), number(color.alpha));
  return result;
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      if (static_cast<unsigned char>(c) >= ' ' || c == '\t')
        result += c;
    }
  return result;
}

} // namespace

SvgDrawing::SvgDrawing(int height)
  : m_height(height)
{
}

void SvgDrawing::addRectangle(const Rect& rect, double radius, const Color& color)
{
  if (rect.isEmpty())
    return;
  m_elements +=
    "<rect" + attribute("x", number(rect.x0)) + attribute("y", number(m_height - rect.y1)) +
    attribute("width", number(rect.width())) + attribute("height", number(rect.height()));
  m_elements +=
    radius > 0.0 ? attribute("rx", number(radius)) : attribute("shape-rendering", "crispEdges");
  m_elements += paint("fill", color) + "/>\n";
}

std::string SvgDrawing::points(const Points& points) const
{
  std::string text;
  for (const auto& [x, y] : points)
    text += (text.empty() ? "" : " ") + number(x) + ',' + number(m_height - y);
  return attribute("points", text);
}

void SvgDrawing::addPolygon(const Points& points, const Color& color)
{
  m_elements += "<polygon" + this->points(points) + paint("fill", color) + "/>\n";
}

void SvgDrawing::addDot(double x, double y, double radius, const Color& color)
{
  m_elements += "<circle" + attribute("cx", number(x)) + attribute("cy", number(m_height - y)) +
                attribute("r", number(radius)) + paint("fill", color) + "/>\n";
}

void SvgDrawing::addLine(const Points& points, double width, double dash, const Color& color)
{
  m_elements += "<polyline" + this->points(points) + attribute("fill", "none") +
                paint("stroke", color) + attribute("stroke-width", number(width)) +
                attribute("stroke-linejoin", "round");
  m_elements +=
    dash > 0.0 ? attribute("stroke-dasharray", number(dash)) : attribute("stroke-linecap", "round");
  m_elements += "/>\n";
}

void SvgDrawing::addText(const TextMask& mask, int x, int y, const Color& color)
{
  if (mask.text.empty())
    return;
  const std::string left = number(x), top = number(m_height - y);
  m_elements += "<text" + attribute("x", left) + attribute("y", top) +
                attribute("font-size", number(mask.size)) +
                attribute("textLength", number(mask.advance)) +
                attribute("lengthAdjust", "spacingAndGlyphs");
  if (mask.isTurned)
    m_elements += attribute("transform", "rotate(-90 " + left + ' ' + top + ')');
  m_elements += paint("fill", color) + '>' + escaped(mask.text) + "</text>\n";
}

void SvgDrawing::beginGroup(const std::string& name, const Rect& inside)
{
  const std::string id =
    "inside-" + std::to_string(inside.x0) + '-' + std::to_string(m_height - inside.y1);
  if (m_elements.find("id=\"" + id + '"') == std::string::npos)
    m_elements += "<clipPath" + attribute("id", id) + "><rect" + attribute("x", number(inside.x0)) +
                  attribute("y", number(m_height - inside.y1)) +
                  attribute("width", number(inside.width())) +
                  attribute("height", number(inside.height())) + "/></clipPath>\n";
  m_elements += "<g" + attribute("clip-path", "url(#" + id + ')') + ">\n";
  if (!name.empty())
    m_elements += "<title>" + escaped(name) + "</title>\n";
}

void SvgDrawing::endGroup()
{
  m_elements += "</g>\n";
}

} // namespace mote::imaging
