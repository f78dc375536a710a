#pragma once

#include "CommandSettings.h"
#include "IdRanges.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

using Color = std::array<double, 3>;

/// An array that an expression of others makes; see vtkMoteExpression.
struct Calculation
{
  std::string name, expression;
  bool operator==(const Calculation&) const = default;
};

/// What is read, and when.
struct DataSettings
{
  std::vector<std::string> files;
  std::string positions = "file"; ///< or "wrapped" into the box, or "unwrapped"
  std::string lines = "tubes";    ///< or "particles": their points
  std::vector<Calculation> calculations;
  std::optional<double> time;
  std::string step = "last"; ///< a number from 1, "first" or "last"
  int threads = 0;           ///< 0: all
  bool operator==(const DataSettings&) const = default;
};

/// What colours mean.
struct ColorSettings
{
  std::string array;         ///< NAME, NAME:component, NAME:magnitude or "none"; empty: choose
  std::string map;           ///< a name of colorMapNames(), or a file; empty: choose
  std::vector<double> range; ///< none or two
  std::vector<double>
    percentiles; ///< of the values, where the range is to begin and to end; none or two
  bool logarithmic = false;
  bool reversed = false;  ///< the map's colours
  std::vector<int> types; ///< that have the first colours of the map of types, in this order
  std::map<int, std::string> typeNames; ///< of types; what is not named here the data may name
  std::map<int, Color> typeColors;      ///< of types; others have the map's or the elements'
  std::string plain = "#e8dec9"; ///< of what no array colours; warm against the cool background
  bool operator==(const ColorSettings&) const = default;
};

/// From `low` to `high`, both included.
struct Interval
{
  double low, high;
  bool operator==(const Interval&) const = default;
};

/// Values of x, y, z, radius or an array: those in any of the intervals, in ascending order.
struct ShowRange
{
  std::string name;
  std::vector<Interval> intervals;
  bool operator==(const ShowRange&) const = default;
};

/// What is shown.
struct SelectionSettings
{
  std::vector<int> hiddenData;          ///< numbers of data sets, from 1, that are not shown
  std::vector<std::string> hiddenParts; ///< names of data sets that are not shown, with *
  std::vector<std::string> shownParts;  ///< of those that are, whatever hides them
  std::string where;                    ///< an expression that holds for what is shown; empty: all
  IdRanges hidden;                      ///< particles that are not shown
  IdRanges only;                        ///< those that are shown alone; none: all
  std::vector<ShowRange> ranges;
  std::vector<double> range; ///< none or two
  std::string array;         ///< that `range` speaks of, as ColorSettings::array; empty: its own
  bool operator==(const SelectionSettings&) const = default;
};

/// What is cut open.
struct CutSettings
{
  /// By x, y, z, a direction "NX,NY,NZ", or r, h, angle about the axis: one interval each.
  std::vector<ShowRange> ranges;
  std::vector<double> axis; ///< none; its direction; or a point on it and its direction
  bool operator==(const CutSettings&) const = default;
};

/// How large particles are, and what rays are cast through.
struct ParticleSettings
{
  std::string radius = "auto"; ///< a number, "auto", "spacing" or an array's name
  std::map<int, double> typeRadius;
  double radiusScale = 1.0;
  std::string structure = "auto"; ///< a name of vtkMoteParticleMapper::GetStructureNames()
  std::string form = "auto";      ///< a name of vtkMoteParticleMapper::GetStructureForms()
  std::vector<int> replicate;     ///< images along the box's three edges; none: one of each
  bool operator==(const ParticleSettings&) const = default;
};

/// A point of an opacity function: at a value of the scalar, or at so many per cent of the colours'
/// range.
struct OpacityPoint
{
  double value = 0.0;
  bool isShare = false; ///< `value` is in per cent
  double opacity = 0.0;
  bool operator==(const OpacityPoint&) const = default;
};

/// How cells look.
struct VolumeSettings
{
  std::string cells = "auto";        ///< "auto", "volume" or "surface"
  std::vector<OpacityPoint> opacity; ///< none: choose
  std::optional<double> opacityUnit; ///< the length that opacities are of; none: choose
  std::vector<double> isoValues;
  std::string isoArray;       ///< that they are of; empty: the one that colours
  std::string cloud = "auto"; ///< "on", "off", "auto": whether the volume itself is seen
  /// By names of CutSettings::ranges, at places in place of ranges. No list: choose.
  std::optional<std::vector<ShowRange>> slices;
  bool unroll = false;               ///< whether slices by r are rolled out flat
  std::optional<double> walls;       ///< opacity of the boundary; 0: it is not shown; none: choose
  std::optional<double> nearWalls;   ///< of its parts that face the eye; none: choose
  std::string wallColor = "#d5cfc4"; ///< or "data"
  int repeatAround = 1;              ///< copies around the axis of the cuts
  std::vector<ShowRange> turns;      ///< of parts, by name: a number of turns a minute each
  double edges = 0.0;                ///< pixels, of lines along the edges of cells; 0: none
  bool lit = false;
  std::string nanColor;                    ///< empty: cells with NaN are left out
  std::string integrator = "cell-by-cell"; ///< a name of vtkMoteVolumeMapper::GetIntegratorNames()
  std::optional<double> sampleDistance;    ///< none: choose
  double tolerance = 0.001;
  double cloudTolerance = 0.0; ///< between pixels; 0: every pixel is traced
  std::string structure; ///< a name of vtkMoteVolumeMapper::GetStructureNames(); empty: its default
  bool operator==(const VolumeSettings&) const = default;
};

/// Streamlines and arrows of vectors in volumes.
struct FlowSettings
{
  int lines = 0, arrows = 0;
  std::string array;        ///< of vectors; empty: choose
  std::vector<double> from; ///< none: throughout; or both ends of a line
  std::optional<double> length, width;
  std::string arrowsOn = "volume";   ///< or "slices"
  std::string arrowVectors = "full"; ///< or "tangential", of those on slices
  double arrowScale = 0.7;           ///< length of a mean one, as a share of how far they lie apart
  bool operator==(const FlowSettings&) const = default;
};

struct CameraSettings
{
  std::string view = "auto"; ///< a name of viewNames()
  double azimuth = 0.0;      ///< degrees, from the view
  double elevation = 0.0;
  double zoom = 1.0;
  bool orthographic = false;
  /// Position, focal point, view up, and the view angle in degrees or, of a parallel projection,
  /// half the height of the view: ten numbers; or none: `view` frames what is shown.
  std::vector<double> camera;
  bool operator==(const CameraSettings&) const = default;
};

/// A view to come back to.
struct NamedView
{
  std::string name;
  bool orthographic = false;
  std::vector<double> camera; ///< as CameraSettings::camera
  bool operator==(const NamedView&) const = default;
};

struct ViewSettings
{
  std::vector<NamedView> saved; ///< each with a name of its own
  bool sideBySide = false;      ///< data sets have views of their own, with one camera
  bool operator==(const ViewSettings&) const = default;
};

struct LightSettings
{
  std::string place = "auto";   ///< a name of lightNames(), "azimuth,elevation" or "x,y,z"
  std::string shadows = "none"; ///< "none", "hard", "soft", or a side of the square of samples
  double size = 15.0;           ///< degrees
  double intensity = 1.0;       ///< factor on the main light
  double headlight = 1.0;       ///< factor on the light that comes from the viewer
  std::string ambientOcclusion = "none"; ///< or "live", "baked", or rays a hit
  std::optional<double> occlusionReach;  ///< world units; none: choose
  bool pathTrace = false;
  bool operator==(const LightSettings&) const = default;
};

/// The lines that outline things.
struct SilhouetteSettings
{
  /// "on", "off", "auto" for on where anything else is set; or the least step of depth: a number
  /// (of radii, in a depth image of world units), or with % a share of the scene's size
  std::string lines = "auto";
  std::string thickness = "1.5"; ///< pixels, or LEAST:MOST
  double opacity = 1.0;          ///< of the least steps
  Color color = {13.0 / 255, 13.0 / 255, 13.0 / 255};
  double stepInPixels = 2.0;
  std::string groups;    ///< array between whose values lines stand, too; empty: none
  bool noHulls = false;  ///< whether no lines stand against the background
  bool onPixels = false; ///< whether they lie on the farther pixels alone
  bool operator==(const SilhouetteSettings&) const = default;
};

/// What is marked over the data.
struct MarkSettings
{
  std::vector<std::string> picked; ///< ids of particles in the order of picking, as IdRanges' words
  IdRanges trajectories;           ///< of particles whose paths are shown
  bool operator==(const MarkSettings&) const = default;
};

struct PictureSettings
{
  std::array<int, 2> size = {0, 0}; ///< pixels; 0: the command's own default
  std::optional<int> samples;       ///< a pixel, at most; none: choose
  std::optional<double> noise;      ///< standard error that is good enough; none: all samples
  std::string error;                ///< "1%" of colours or "0.5px"; see ErrorBudget.h; empty: none
  double lodError = 0.0;            ///< pixels that levels of detail may err by; 0: there are none
  std::optional<double> fps;        ///< frames a second while the view moves; none: choose
  std::vector<Color> background;    ///< none: the default; one; or bottom and top
  bool legend = true;
  std::optional<std::string> title;
  std::string legendSide = "right"; ///< or "left"
  std::string legendFormat;         ///< of printf; empty: choose
  double fontScale = 1.0;           ///< factor on the size of texts
  std::optional<std::string> caption;
  bool box = true; ///< around the data, in the window
  bool axes = true;
  std::string handles = "auto"; ///< of slices and cuts, in the window: "on", "off" or "auto"
  bool operator==(const PictureSettings&) const = default;

  /// Samples per pixel, at most; `paths` are noisier than other light.
  int mostSamples(bool paths) const
  {
    const bool isJudged = noise || (!error.empty() && error.back() == '%');
    return samples.value_or(isJudged ? 4096 : paths ? 64 : 16);
  }
};

/// Every choice that a user can make, as a value: of the picture, which settingsTable() describes,
/// and of what a command does with it, which commandTable() describes.
struct Settings
{
  DataSettings data;
  ColorSettings color;
  SelectionSettings selection;
  CutSettings cuts;
  ParticleSettings particles;
  VolumeSettings volume;
  FlowSettings flow;
  CameraSettings camera;
  ViewSettings views;
  LightSettings light;
  SilhouetteSettings silhouettes;
  MarkSettings marks;
  PictureSettings picture;

  OutputSettings output;
  FilmSettings film;
  ChartSettings chart;
  AverageSettings average;
  BakeSettings bake;
  ProbeSettings probe;
  IntegrateSettings integrate;
  DepthImageSettings depthImage;
  PlotSettings plot;
  std::vector<Settings> keyFrames; ///< of films that the window makes; these have none themselves
  bool operator==(const Settings&) const = default;
};

} // namespace mote::app
