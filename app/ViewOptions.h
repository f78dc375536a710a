#pragma once

#include "SilhouetteChoices.h"
#include "VolumeOptions.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace mote::app
{

using Color = std::array<double, 3>;

/// What --show asks for: values of x, y, z, radius or an array from `low` to `high`.
struct ShowRange
{
  std::string name;
  double low, high;
};

/// What the user may say about a picture, in the window as in a file. Declared to the command line
/// once, by addViewOptions().
struct ViewOptions
{
  std::vector<std::string> files;

  // Time
  std::optional<double> time;
  std::string step = "last"; ///< a number from 1, "first" or "last"

  // Colour
  std::string colorBy;       ///< NAME, NAME:component, NAME:magnitude or "none"; empty: choose
  std::string colorMap;      ///< a name of colorMapNames(); empty: choose
  std::vector<double> range; ///< none or two
  bool logarithmic = false;

  // Selection
  std::vector<ShowRange> show;
  std::vector<double> showRange; ///< none or two
  std::string showBy;            ///< as colorBy; empty: what colours

  // Radius
  std::string radius = "auto"; ///< a number, "auto", "spacing" or an array's name
  std::map<int, double> typeRadius;
  double radiusScale = 1.0;

  // Structure
  std::string structure = "auto"; ///< a name of vtkMoteParticleMapper::GetStructureNames()
  std::string form = "auto";      ///< a name of vtkMoteParticleMapper::GetStructureForms()

  VolumeOptions volume;

  // Light
  std::string light = "auto";   ///< a name of lightNames(), "azimuth,elevation" or "x,y,z"
  std::string shadows = "none"; ///< "none", "hard", "soft", or a side of the square of samples
  double lightSize = 15.0;      ///< degrees
  std::string ambientOcclusion = "none"; ///< or "live", "baked", or rays a hit
  double occlusionReach = 0.0;           ///< world units; 0: choose
  bool pathTrace = false;
  SilhouetteChoices silhouettes;

  // Camera
  std::string view = "auto";
  double azimuth = 0.0;
  double elevation = 0.0;
  double zoom = 1.0;
  bool orthographic = false;

  // Picture
  std::array<int, 2> size = {0, 0}; ///< 0: the command's own default
  int samples = 0;                  ///< at most; 0: choose
  double noise = 0.0;               ///< standard error that is good enough; 0: take all samples
  std::vector<Color> background;    ///< none: the default; one; or bottom and top
  bool legend = true;
  std::optional<std::string> title;
  std::optional<std::string> caption;
  int threads = 0;

  bool preview = false; ///< of large sets, until they are built; the window's alone

  /// Rays a pixel, at most; `paths` are noisier than other light.
  int mostSamples(bool paths) const
  {
    return samples > 0 ? samples : noise > 0.0 ? 4096 : paths ? 64 : 16;
  }
};

/// Declares the files and all options of a view.
void addViewOptions(CLI::App& app, ViewOptions& options);

/// Declares those of them that say how large particles are.
void addRadiusOptions(CLI::App& app, ViewOptions& options);

/// Declares --form, the one of a structure that files have too.
void addFormOption(CLI::App& app, ViewOptions& options);

/// Declares those of them that say what colours mean.
void addColorOptions(CLI::App& app, ViewOptions& options);

/// Declares an option of three numbers with commas.
CLI::Option* addVectorOption(CLI::App& app, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& help);

/// Declares what belongs to reading alone: the files, --time, --step and --threads.
void addReadOptions(CLI::App& app, ViewOptions& options);

} // namespace mote::app
