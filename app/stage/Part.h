#pragma once

#include "Arrays.h"
#include "Cuts.h"
#include "MemoryPieces.h"
#include "ShownCells.h"
#include "Surface.h"
#include "Turning.h"
#include "Volume.h"
#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkDataSet.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkLookupTable;
class vtkMoteParticleMapper;
class vtkPoints;
class vtkProp;
class vtkProp3D;

namespace mote
{
struct BuiltMesh;
struct BuiltParticles;
struct BuiltVolume;
} // namespace mote

namespace mote::app
{

/// What a part builds of its data, and hands to another part. Null for what it does not build.
struct BuiltPart
{
  std::shared_ptr<const BuiltParticles> particles;
  std::shared_ptr<const BuiltVolume> volume;
  std::shared_ptr<const BuiltMesh> mesh;
  vtkSmartPointer<vtkPointSet> drawn; ///< in place of the data, where Surface made something of it
  MemoryPieces memory;
};

/// One data set in the picture: its points as particles, its cells as a volume, or their surface.
class Part
{
public:
  /// `ambient` is the share of light from all sides.
  Part(const std::string& name, vtkDataSet* data, const Settings& settings, double ambient);

  /// Sets the share of light from all sides.
  void setAmbient(double ambient);

  /// Follows the settings: radii, structures, what volumes are made of. Colours and what is shown
  /// are set by others. Throws Failure.
  void followSettings();
  /// Pixels that levels of detail may err by, as the settings say; 0 where there are none.
  double lodError() const;
  void followLodError();

  enum class Kind
  {
    Particles,
    Surface,
    Volume
  };
  /// How a data set is shown.
  static Kind kindOf(vtkDataSet* data, const Settings& settings);

  /// Whether a data set has cells to show rather than particles.
  static bool isMesh(vtkDataSet* data);

  /// Whether a data set is of lines alone. Those between points that have types are bonds of
  /// particles, and do not count.
  static bool isLines(vtkDataSet* data);

  /// Whether --radius means something: to particles and lines.
  bool hasRadius() const { return particles_ || isLines(data_); }

  /// Whether points come from a generator or a .mote file, which tells their radii too.
  static bool isOfSource(vtkDataSet* data);

  /// Other data of the same kind, such as the next time step.
  void setData(const std::string& name, vtkDataSet* data);

  /// Turns it from where its data say that it is; nothing is built for that. Slices and cuts stay.
  void setTurn(const Turn& turn);
  const Turn& turn() const { return turn_; }
  /// From the data's coordinates to where they are seen: one for each repetition around the axis.
  std::vector<vtkSmartPointer<vtkTransform>> placements() const;

  /// Brings structures up to date. Throws Failure and Interrupted, after which nothing is drawn.
  void build(ProgressRelay& progress);
  void build(const Runner& runner);

  /// What was built, for another part with the same data; `forPicture` makes the last of it ready.
  BuiltPart built(bool forPicture = false) const;
  /// The next build() takes this where it fits data and settings.
  void offer(const BuiltPart& built);
  /// Begins with what another part keeps over time steps: its radius, and by what a volume is seen.
  void keep(double radius, const ArrayChoice& colored);
  const ArrayChoice& colored() const { return colored_; }
  /// Whether what is built would be built otherwise for the same data later: a preview, or spheres
  /// whose radius is kept from now on.
  bool isProvisional() const;

  /// Whether build() of many particles leaves them to another thread, with a preview meanwhile.
  void setPreview(bool on);
  /// Whether what is drawn is such a preview, of a part of the particles.
  bool isPreview() const;
  /// Takes what another thread has built by now. Returns what went wrong, or nothing.
  std::string update();
  /// Waits for what another thread builds. Throws Failure and Interrupted.
  void finishBuild(ProgressRelay& progress);
  void stopBuild();

  /// Tells how large all that is shown is.
  void setSceneSize(double diagonal) { sceneSize_ = diagonal; }

  /// Colours by an array through the table; by none with one colour. A volume takes the opacities.
  void setColors(
    const ArrayChoice& choice, vtkLookupTable* table, const std::vector<OpacityPoint>& opacity);

  /// Hides all of it, or shows again what is not hidden otherwise.
  void setHidden(bool on);
  bool isHidden() const { return isHidden_; }

  /// Whether both are volumes with the same arrays.
  bool isBlockWith(const Part& other) const;
  /// Parts of the same mesh: where cells of them go on there is no wall of a volume.
  void setNeighbors(const std::vector<const Part*>& others);

  /// Which cells are shown, in place of those before; volumes hide values of the array that colours
  /// within cells, too. Nothing but triangles of surfaces is built anew, in the next build().
  void limitCells(const std::vector<CellLimit>& limits);
  const ShownCells& cells() const { return cells_; }

  /// Cuts it open.
  void setCuts(const Cuts& cuts);

  /// Hides no particle.
  void showAll();
  /// Hides particles with values outside, besides those that are hidden already.
  void limit(const ArrayChoice& choice, const std::vector<Interval>& intervals);
  /// The same by place: 0, 1, 2 for x, y, z, 3 for the radius.
  void limitPlace(int place, double low, double high);
  /// The same by one more array, if the part has it.
  void setVisible(const ArrayChoice& choice, const double range[2]);
  /// Brings what is shown up to date with the limits.
  void applyRanges();

  /// How many cells of a volume, or of a surface, are of a kind that cannot be drawn, or are
  /// spoilt.
  vtkIdType numberLeftOut() const;

  /// How often the particles are drawn, side by side.
  int images() const;

  /// How many particles, or cells, are not hidden.
  vtkIdType numberShown() const;
  vtkIdType numberOfCellsShown() const;

  /// Bounds of what is not hidden; not initialized where there is nothing.
  void shownBounds(double bounds[6]) const;

  /// The radius that stays from the first step with particles on, where it is half their spacing;
  /// else 0.
  double keptRadius() const { return keptRadius_; }

  const std::string& name() const { return name_; }
  vtkDataSet* data() const { return data_; }
  Kind kind() const { return kind_; }
  vtkProp3D* prop() const; ///< the first of props()
  /// All that is drawn of it: what shows the data, and of a volume its walls.
  std::vector<vtkProp3D*> props() const;
  bool draws(const vtkProp* prop) const;
  /// Whether the settings ask for the walls of a volume, the last of props().
  bool hasWalls() const { return volume_ && settings_.volume.walls.value_or(0.0) > 0.0; }
  vtkMoteParticleMapper* particles() const { return particles_; } ///< null for cells
  Surface* surface() const { return surface_.get(); }             ///< null for all else
  vtkTypeInt64 structureBytes() const;
  double buildTime() const;

private:
  void setRadius();
  void setParticleRadius();
  void setImages();
  void placeProp();
  void placeSlices();
  void followLook();
  void followRepetitions();
  void work(const Runner& runner, const std::function<void()>& build);

  vtkAlgorithm* worker() const;

  std::string name_;
  vtkSmartPointer<vtkDataSet> data_;
  const Settings& settings_;
  Kind kind_;
  vtkNew<vtkActor> actor_;
  std::unique_ptr<Volume> volume_;
  vtkSmartPointer<vtkMoteMeshMapper> walls_; ///< of a volume
  std::string arrays_;                       ///< names of a volume's
  std::vector<const Part*> neighbors_;       ///< that the walls know
  std::unique_ptr<Surface> surface_;
  ShownCells cells_; // of a volume or a surface
  ArrayChoice colored_;
  ArrayChoice missed_; // colours that a step lacked, which was told
  Turn turn_;
  double sceneSize_ = 1.0;
  bool isHidden_ = false;
  bool isWhole_ = true; ///< false: nothing is drawn, as it could not be built
  vtkSmartPointer<vtkMapper> mapper_;
  vtkMoteParticleMapper* particles_ = nullptr;
  double keptRadius_ = 0.0;           // from the spacing of the first step with particles
  vtkSmartPointer<vtkPoints> spaced_; // whose spacing that was, while nothing else is shown
};

/// The data of the parts that are volumes.
std::vector<vtkDataSet*> volumesOf(const std::vector<std::unique_ptr<Part>>& parts);

/// Leaves out the walls between volumes that touch with the same points and have the same arrays,
/// as blocks of a mesh do, but those of parts that are hidden. Walls between a fluid and a solid
/// stay: these have others.
void joinWalls(const std::vector<std::unique_ptr<Part>>& parts);

} // namespace mote::app
