#include "TransferBridge.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mote
{

namespace
{

constexpr double colorError = 5e-4, opacityError = 5e-5;
/// Halvings after which what still differs is taken to be a jump.
constexpr int deepest = 24;

/// The two functions of a property as one.
class Functions
{
public:
  explicit Functions(vtkVolumeProperty* property)
    : opacity_(property->GetScalarOpacity())
    , gray_(property->GetColorChannels() == 1 ? property->GetGrayTransferFunction() : nullptr)
    , color_(gray_ ? nullptr : property->GetRGBTransferFunction())
  {
  }

  Vec4d operator()(double value) const
  {
    double rgb[3] = {};
    if (gray_)
      std::fill_n(rgb, 3, at(gray_, value));
    else if (color_->GetSize() > 0)
      color_->GetColor(value, rgb);
    return glm::clamp(Vec4d(rgb[0], rgb[1], rgb[2], at(opacity_, value)), 0.0, 1.0);
  }

  /// Where either function has a node, ascending, each once.
  std::vector<double> nodes() const
  {
    std::vector<double> all;
    const auto add = [&all](auto* function)
    {
      double node[6];
      for (int i = 0; i < function->GetSize(); ++i)
        if (function->GetNodeValue(i, node) == 1)
          all.push_back(node[0]);
    };
    add(opacity_);
    if (gray_)
      add(gray_);
    else
      add(color_);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

private:
  static double at(vtkPiecewiseFunction* function, double value)
  {
    return function->GetSize() > 0 ? function->GetValue(value) : 0.0;
  }

  vtkPiecewiseFunction* opacity_;
  vtkPiecewiseFunction* gray_;
  vtkColorTransferFunction* color_;
};

double badness(const Vec4d& a, const Vec4d& b)
{
  const Vec4d d = glm::abs(a - b);
  return std::max(std::max({d.x, d.y, d.z}) / colorError, d.w / opacityError);
}

/// Draws the functions with straight lines.
class Outline
{
public:
  Outline(const Functions& functions, std::vector<TransferFunction::Knot>& knots)
    : functions_(functions)
    , knots_(knots)
  {
  }

  /// What lies inside of a piece from `a` to `b`, at whose ends the functions come to fa and fb.
  void between(double a, const Vec4d& fa, double b, const Vec4d& fb, int halvings)
  {
    double worst = 0.0;
    for (int i = 1; i < 8; ++i)
      worst = std::max(worst, badness(functions_(a + (b - a) * i / 8), fa + (fb - fa) * (i / 8.0)));
    if (worst <= 1.0)
      return;
    const double middle = a + 0.5 * (b - a);
    const Vec4d f = functions_(middle);
    if (halvings == deepest || !(a < middle && middle < b))
    {
      add(middle, fa);
      add(middle, fb);
      return;
    }
    between(a, fa, middle, f, halvings + 1);
    add(middle, f);
    between(middle, f, b, fb, halvings + 1);
  }

  void add(double value, const Vec4d& color) { knots_.push_back({value, Vec4f(color)}); }

private:
  const Functions& functions_;
  std::vector<TransferFunction::Knot>& knots_;
};

} // namespace

TransferFunction transferOf(vtkVolumeProperty* property)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Functions functions(property);
  TransferFunction transfer;
  transfer.unitDistance = property->GetScalarOpacityUnitDistance();
  transfer.knots.clear();
  Outline outline(functions, transfer.knots);
  const std::vector<double> nodes = functions.nodes();
  if (nodes.empty())
    outline.add(0.0, functions(0.0));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    // Of nodes at one place, and of ends that are not clamped, the values on the two sides differ.
    const Vec4d below = functions(std::nextafter(nodes[i], -infinity));
    const Vec4d above = functions(std::nextafter(nodes[i], infinity));
    if (badness(below, above) > 0.01)
      outline.add(nodes[i], below);
    outline.add(nodes[i], above);
    if (i + 1 < nodes.size())
      outline.between(
        nodes[i], above, nodes[i + 1], functions(std::nextafter(nodes[i + 1], -infinity)), 0);
  }
  return transfer;
}

std::string unusedOf(vtkVolumeProperty* property)
{
  vtkPiecewiseFunction* gradient =
    property->HasGradientOpacity() ? property->GetStoredGradientOpacity() : nullptr;
  if (!gradient || property->GetDisableGradientOpacity())
    return {};
  const double* range = gradient->GetRange();
  double values[64];
  gradient->GetTable(range[0], range[1], 64, values);
  const bool isUsed = std::any_of(values, values + 64, [](double v) { return v != 1.0; });
  return isUsed ? "Gradient opacity is not used. " : "";
}

} // namespace mote
