#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

// What commands may be told besides the settings of the picture. No session keeps it.

namespace mote::app
{

/// What is written, and where.
struct OutputSettings
{
  std::string file;      ///< empty: as the command has it
  std::string session;   ///< file for a session; empty: none, or the window's choice
  bool allSteps = false; ///< a picture of every time step
  bool json = false;
  int pieces = 0;         ///< of a .pvtp or .pvtu file; 0: as many as the writer makes by itself
  std::string memory;     ///< "4G"; empty: half of the machine's
  bool preview = true;    ///< in the window, of large sets until they are built
  bool panel = true;      ///< at the window's side
  bool isSession = false; ///< whether a session says all this
  bool fitsView = false; ///< the picture's size, of a session, is that of the view beside the panel
  std::optional<double> uiScale;    ///< of the panel's texts; none: as the display says
  std::string cache = "25%";        ///< memory for time steps ahead: a size, or a share
  double speed = 10.0;              ///< time steps a second, of playing, at most
  bool follow = false;              ///< whether steps that are written meanwhile are read
  bool loop = true;                 ///< whether playing goes on from the last step to the first
  std::array<int, 2> size = {0, 0}; ///< of pictures and films that the window saves; 0: the view's
  int seenHeight = 0; ///< of a session's view, for which its lines are as thick; 0: of the picture
  std::string record; ///< file for what is done in the window; empty: none
  std::string play;   ///< such a file; empty: none
  double playSpeed = 1.0; ///< factor on that of the user's; 0: as fast as it goes
  bool operator==(const OutputSettings&) const = default;
};

/// Of `mote animate`, and of films that the window makes.
struct FilmSettings
{
  double orbit = 0.0;                 ///< degrees, to the right
  std::optional<int> frames;          ///< none: choose
  int rate = 25;                      ///< frames a second
  std::string steps;                  ///< "all", "A:B" or "A:B:STRIDE" from 1; empty: choose
  std::optional<int> framesPerStep;   ///< none: choose
  std::vector<std::string> keyFrames; ///< sessions
  std::string quality = "high";       ///< "low", "medium" or "high"
  bool operator==(const FilmSettings&) const = default;
};

/// What the window's panel plots.
struct PlotSettings
{
  std::string x, y;       ///< as ColorSettings::array, or x, y, z; no x: choose; no y: a histogram
  std::string of = "all"; ///< or "visible", or "picked"
  bool logarithmic = false;
  std::string overTime; ///< of the picked; empty: choose
  bool operator==(const PlotSettings&) const = default;
};

/// Of pictures of tables, which `mote average`, `integrate` and `probe` draw.
struct ChartSettings
{
  std::vector<std::string> curves; ///< columns or arrays, one above the other; empty: choose
  std::string over;                ///< what the curves run over; empty: choose
  bool operator==(const ChartSettings&) const = default;
};

/// Of `mote average`.
struct AverageSettings
{
  std::string array;
  int resolution = 200;              ///< bins along the longer edge
  std::vector<double> axis, origin;  ///< three each, or none: as the data say
  std::vector<double> axial, radial; ///< ranges of what is averaged, two each, or none: all
  bool operator==(const AverageSettings&) const = default;
};

/// Of `mote bake`; see vtkMoteAmbientOcclusionBaker.
struct BakeSettings
{
  int side = 16;               ///< texels of the largest maps
  int samples = 49;            ///< rays a texel
  double tolerance = 0.005;    ///< of smaller maps; 0: all maps have the same size
  std::optional<double> reach; ///< none: choose
  bool operator==(const BakeSettings&) const = default;
};

/// Of `mote probe`.
struct ProbeSettings
{
  std::vector<double> from, to; ///< three each, or none
  std::vector<double> at;       ///< three for each point; none: the line
  int points = 101;             ///< along the line
  bool operator==(const ProbeSettings&) const = default;
};

/// Of `mote integrate`, beside slices and their axis.
struct IntegrateSettings
{
  bool boundary = false;
  std::vector<std::string> arrays;
  std::string velocity, pressure; ///< "none", or empty: choose
  double density = 1.0;
  bool kinematic = false;    ///< whether the pressure is given over the density
  std::optional<double> rpm; ///< turns a minute about the axis, for powers; none: none
  bool operator==(const IntegrateSettings&) const = default;
};

/// Of `mote silhouettes`; see vtkMoteSilhouetteFilter.
struct DepthImageSettings
{
  std::string depth; ///< channel or array; empty: choose
  int reduction = 1;
  bool linesAlone = false;
  double viewAngle = 30.0;
  std::optional<double> height; ///< of an orthographic view, in world units
  bool alongRays = false;
  std::optional<double> farDepth;
  bool operator==(const DepthImageSettings&) const = default;
};

} // namespace mote::app
