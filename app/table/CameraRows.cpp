#include "Table.h"

#include "stage/Framing.h"

#include <algorithm>

namespace mote::app
{

namespace
{

void checkCamera(const std::vector<double>& c)
{
  if (c.empty())
    return;
  const double look[3] = {c[3] - c[0], c[4] - c[1], c[5] - c[2]};
  if (look[0] == 0.0 && look[1] == 0.0 && look[2] == 0.0)
    throw WrongValue{"the camera must not stand where it looks at"};
  const double cross[3] = {look[1] * c[8] - look[2] * c[7], look[2] * c[6] - look[0] * c[8],
    look[0] * c[7] - look[1] * c[6]};
  if (cross[0] == 0.0 && cross[1] == 0.0 && cross[2] == 0.0)
    throw WrongValue{"up must point another way than the camera looks"};
  if (!(c[9] > 0.0))
    throw WrongValue{"the angle, or half the height, must be above zero, not " + exactText(c[9])};
}

void checkViews(const std::vector<NamedView>& views)
{
  for (const NamedView& view : views)
  {
    checkCamera(view.camera);
    if (std::count_if(views.begin(), views.end(),
          [&](const NamedView& other) { return other.name == view.name; }) > 1)
      throw WrongValue{"'" + view.name + "' is given twice"};
  }
}

const std::string cameraGroup = "Camera";

/// Of views beside the present one.
void addViewRows(std::vector<Row>& table)
{
  table.push_back(row<ViewSettings, std::vector<NamedView>>(&Settings::views, &ViewSettings::saved,
    {.group = cameraGroup,
      .name = "saved-view",
      .value = "NAME=CAMERA",
      .help =
        "A view to come back to in the window, as --camera writes cameras; behind 'parallel,' "
        "for a parallel projection. May be given several times. It changes no picture",
      .invalidates = Invalidates::Nothing,
      .commas = false,
      .usual = "none"},
    checkViews));
  table.push_back(row(&Settings::views, &ViewSettings::sideBySide,
    {.group = cameraGroup,
      .name = "side-by-side",
      .help =
        "Show data sets beside one another, in up to four views that share one camera and one "
        "range of colours: a view for each file, or for each data set of one file. Those that "
        "are hidden have none",
      .invalidates = Invalidates::Picture}));
}

} // namespace

void addCameraRows(std::vector<Row>& table)
{
  const auto camera = &Settings::camera;
  table.push_back(row(camera, &CameraSettings::view,
    {.group = cameraGroup,
      .name = "view",
      .value = "SIDE",
      .help = "Side to look from. iso has z up, iso-y has y up; auto looks along the thin axis of "
              "flat data, as iso-y at surface meshes, and as iso at all else",
      .invalidates = Invalidates::Picture,
      .words = viewNames()}));
  table.push_back(row(camera, &CameraSettings::azimuth,
    {.group = cameraGroup,
      .name = "azimuth",
      .value = "DEG",
      .help = "Then turn the camera to the right around the data by so many degrees",
      .invalidates = Invalidates::Picture}));
  table.push_back(row(camera, &CameraSettings::elevation,
    {.group = cameraGroup,
      .name = "elevation",
      .value = "DEG",
      .help = "Then raise it by so many degrees",
      .invalidates = Invalidates::Picture}));
  table.push_back(row(camera, &CameraSettings::zoom,
    {.group = cameraGroup,
      .name = "zoom",
      .value = "F",
      .help = "Factor on the size of what is seen",
      .invalidates = Invalidates::Picture,
      .limits = {.aboveZero = true}}));
  table.push_back(row(camera, &CameraSettings::orthographic,
    {.group = cameraGroup,
      .name = "orthographic",
      .help = "Parallel projection instead of perspective",
      .invalidates = Invalidates::Picture}));
  table.push_back(row<CameraSettings, std::vector<double>>(camera, &CameraSettings::camera,
    {.group = cameraGroup,
      .name = "camera",
      .value = "X,Y,Z,FX,FY,FZ,UX,UY,UZ,A",
      .help = "Camera at X,Y,Z that looks at FX,FY,FZ, with up vector UX,UY,UZ and a vertical view "
              "angle of A degrees; with --orthographic, A is half the height of the view in the "
              "data's units. Overrides --view, --azimuth, --elevation and --zoom",
      .invalidates = Invalidates::Picture,
      .count = 10,
      .usual = "frames what is shown"},
    checkCamera));
  addViewRows(table);
}

} // namespace mote::app
