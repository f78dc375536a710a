/**
 * @class   vtkMoteSilhouettes
 * @brief   How silhouettes are drawn: lines where depth jumps.
 *
 * One object may serve any number of vtkMoteRayCastPass, vtkMoteRendererSource,
 * vtkMoteSilhouettePass and vtkMoteSilhouetteFilter. Nothing is drawn unless it is Enabled.
 *
 * A silhouette stands where what lies behind is farther away than what lies in front by more than a
 * threshold, as rays measure it. The line is drawn on the border between the two. Where there is
 * nothing behind, a silhouette stands, too, unless Hulls is off. See docs/silhouettes.md.
 *
 * Source: Bigler, "Use of Silhouette Edges and Ambient Occlusion in Particle Visualization"
 * (University of Utah, 2004).
 */

#ifndef vtkMoteSilhouettes_h
#define vtkMoteSilhouettes_h

#include "MoteRenderingDataModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for GroupArrayName

namespace mote
{
struct SilhouetteOptions;
}

class MOTERENDERINGDATA_EXPORT vtkMoteSilhouettes : public vtkObject
{
public:
  static vtkMoteSilhouettes* New();
  vtkTypeMacro(vtkMoteSilhouettes, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether silhouettes are drawn at all. Off by default.
   */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  //@}

  /// What Threshold counts.
  enum ThresholdModes
  {
    WORLD,     ///< world units
    RADII,     ///< radii of a typical particle
    SCENE_SIZE ///< diagonals of the box around all that is drawn
  };

  //@{
  /**
   * The least step of depth that makes a silhouette, at least 0, in units of ThresholdMode. Default
   * 10 radii: particles that touch have no lines between them, parts and heaps of them have.
   */
  vtkSetClampMacro(Threshold, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Threshold, double);
  //@}

  //@{
  /**
   * Default RADII. Half of the particles' cross-section belongs to particles that are smaller than
   * the typical one, half to larger ones. Where there are no particles, a thousandth of the
   * diagonal stands for a radius. Images have no particles: vtkMoteSilhouetteFilter is told what a
   * radius is, and may be told the scene's size.
   */
  vtkSetClampMacro(ThresholdMode, int, WORLD, SCENE_SIZE);
  vtkGetMacro(ThresholdMode, int);
  void SetThresholdModeToWorld() { this->SetThresholdMode(WORLD); }
  void SetThresholdModeToRadii() { this->SetThresholdMode(RADII); }
  void SetThresholdModeToSceneSize() { this->SetThresholdMode(SCENE_SIZE); }
  //@}

  //@{
  /**
   * And the step is never less than so many times the width of a pixel at its distance: relief that
   * is finer than pixels has no outlines. Default 2; 0 for no such limit.
   */
  vtkSetClampMacro(StepInPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(StepInPixels, double);
  //@}

  //@{
  /**
   * Width of the strongest lines in pixels, in [0.1, 64]. Default 1.5.
   */
  vtkSetClampMacro(Thickness, double, 0.1, 64.0);
  vtkGetMacro(Thickness, double);
  //@}

  //@{
  /**
   * Width, as a share of Thickness, and opacity of the weakest lines, those that hardly reach the
   * threshold; both in [0, 1]. Lines grow with the logarithm of the step up to the full ones, where
   * it is FullStep times the threshold, at least 1, default 8. Default 1: all are alike. Those
   * against the background and between groups are always full.
   */
  vtkSetClampMacro(LeastThickness, double, 0.0, 1.0);
  vtkGetMacro(LeastThickness, double);
  vtkSetClampMacro(LeastOpacity, double, 0.0, 1.0);
  vtkGetMacro(LeastOpacity, double);
  vtkSetClampMacro(FullStep, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FullStep, double);
  //@}

  //@{
  /**
   * Whether silhouettes stand out against the background. On by default.
   */
  vtkSetMacro(Hulls, bool);
  vtkGetMacro(Hulls, bool);
  vtkBooleanMacro(Hulls, bool);
  //@}

  //@{
  /**
   * Whether the middle of a line lies on the border itself. Otherwise it lies on the pixels behind
   * it, as published. On by default.
   */
  vtkSetMacro(Centered, bool);
  vtkGetMacro(Centered, bool);
  vtkBooleanMacro(Centered, bool);
  //@}

  //@{
  /**
   * Red, green and blue of the lines. Default 0.05 each.
   */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  //@}

  //@{
  /**
   * Silhouettes stand, besides, between neighbours in the picture with different values of this
   * point array of the particles (of its first component), such as materials, however little their
   * depths differ. Where no prop has such an array, "object" stands for the props themselves and
   * "particle" for the particles. Empty, the default: depth alone counts. Not of depth buffers; of
   * images it is an array with one number a pixel.
   */
  vtkSetStdStringFromCharMacro(GroupArrayName);
  vtkGetCharFromStdStringMacro(GroupArrayName);
  //@}

#ifndef __VTK_WRAP__
  /**
   * The kernel's options, for a threshold of `step` world units.
   */
  mote::SilhouetteOptions MakeOptions(double step) const;
#endif

protected:
  vtkMoteSilhouettes() = default;
  ~vtkMoteSilhouettes() override = default;

  bool Enabled = false;
  double Threshold = 10.0;
  int ThresholdMode = RADII;
  double StepInPixels = 2.0;
  double Thickness = 1.5;
  double LeastThickness = 1.0;
  double LeastOpacity = 1.0;
  double FullStep = 8.0;
  bool Hulls = true;
  bool Centered = true;
  double Color[3] = {0.05, 0.05, 0.05};
  std::string GroupArrayName;

private:
  vtkMoteSilhouettes(const vtkMoteSilhouettes&) = delete;
  void operator=(const vtkMoteSilhouettes&) = delete;
};

#endif
