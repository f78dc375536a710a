#pragma once

#include "Arrays.h"
#include "Progress.h"
#include "ViewOptions.h"

#include <vtkDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <functional>

class vtkActor;
class vtkLookupTable;
class vtkMapper;
class vtkMoteParticleMapper;

namespace mote::app
{

/// One data set in the picture: its points as particles, or, where it has faces or volumes, its
/// surface.
class Part
{
public:
  /// `ambient` is the share of light from all sides.
  Part(const std::string& name, vtkDataSet* data, const ViewOptions& options, double ambient);

  /// Sets the share of light from all sides.
  void setAmbient(double ambient);

  /// Whether a data set is shown by its surface rather than as particles.
  static bool isMesh(vtkDataSet* data);

  /// Whether points come from a generator or a .mote file, which tells their radii too.
  static bool isOfSource(vtkDataSet* data);

  /// Other data of the same kind, such as the next time step.
  void setData(const std::string& name, vtkDataSet* data);

  /// Brings structures up to date. Throws Failure and Interrupted, after which nothing is drawn.
  void build(Progress& progress);

  /// Whether build() of many particles leaves them to another thread, with a preview meanwhile.
  void setPreview(bool on);
  /// Takes what another thread has built by now. Returns what went wrong, or nothing.
  std::string update();
  /// Waits for what another thread builds. Throws Failure and Interrupted.
  void finishBuild(Progress& progress);

  /// Colours by an array through the table; by none with one colour.
  void setColors(const ArrayChoice& choice, vtkLookupTable* table);

  /// Hides no particle.
  void showAll();
  /// Hides particles with values outside, besides those that are hidden already.
  void limit(const ArrayChoice& choice, double low, double high);
  /// The same by place: 0, 1, 2 for x, y, z, 3 for the radius (at the radius scale of the options).
  void limitPlace(int place, double low, double high);
  /// The same by one more array, if the part has it.
  void setVisible(const ArrayChoice& choice, const double range[2]);
  /// Brings what is shown up to date with the limits.
  void applyRanges();

  /// How many particles are not hidden.
  vtkIdType numberShown() const;

  /// Bounds of what is not hidden; not initialized where there is nothing.
  void shownBounds(double bounds[6]) const;

  void setRadiusScale(double scale);

  const std::string& name() const { return name_; }
  vtkDataSet* data() const { return data_; }
  vtkActor* actor() const { return actor_; }
  vtkMoteParticleMapper* particles() const { return particles_; } ///< null for a surface

private:
  void setRadius();
  void limitRadius();
  void work(Progress& progress, const std::function<void()>& build);
  vtkSmartPointer<vtkMapper> makeSurface();

  std::string name_;
  vtkSmartPointer<vtkDataSet> data_;
  const ViewOptions& options_;
  vtkNew<vtkActor> actor_;
  vtkSmartPointer<vtkMapper> mapper_;
  vtkMoteParticleMapper* particles_ = nullptr;
  double radiusRange_[2] = {-HUGE_VAL, HUGE_VAL};
  double radiusScale_ = 1.0;
  double keptRadius_ = 0.0; // from the spacing of the first step with particles
};

} // namespace mote::app
