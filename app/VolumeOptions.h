#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

/// A point of an opacity function: at a value of the scalar, or at a share of the colours' range.
struct OpacityPoint
{
  double value = 0.0;
  bool isShare = false; ///< `value` is in [0, 1]
  double opacity = 0.0;
};

/// What the user may say about how volumes look.
struct VolumeOptions
{
  std::string cells = "auto"; ///< "auto", "volume" or "surface"
  std::vector<OpacityPoint> opacity;
  double opacityUnit = 0.0; ///< the length that opacities are of; 0: choose
  std::vector<double> isoValues;
  bool cloud = true; ///< whether the volume itself is seen, beside iso-surfaces
  bool lit = false;
  std::string integrator; ///< a name of vtkMoteVolumeMapper::GetIntegratorNames(); empty: the first
  double sampleDistance = 0.0;
  double tolerance = 0.0;      ///< 0: choose
  double cloudTolerance = 0.0; ///< between pixels; 0: every pixel is traced
  std::string structure; ///< a name of vtkMoteVolumeMapper::GetStructureNames(); empty: choose
  std::string nanColor;  ///< empty: cells with NaN are left out
};

/// Declares them to the command line.
void addVolumeOptions(CLI::App& app, VolumeOptions& options);

/// "12.5=0.3" or "40%=0.3". Throws a sentence, as a string, for anything else.
OpacityPoint parseOpacityPoint(const std::string& text);

} // namespace mote::app
