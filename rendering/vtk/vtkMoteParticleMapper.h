/**
 * @class   vtkMoteParticleMapper
 * @brief   Draws the points of a data set as spheres, ray cast on the CPU.
 *
 * Input is any vtkPointSet; each of its points is a particle, cells are not looked at. Use it with
 * a vtkActor, as any mapper: position, scale and orientation of the actor, visibility, and the
 * ambient, diffuse, specular and opacity terms and the colour of its vtkProperty hold. What
 * lies behind an opacity below 1 shines through, in order.
 *
 * Colours come from any array, as in other mappers: ScalarVisibility, ScalarMode,
 * SelectColorArray(), ColorMode, LookupTable, ScalarRange; component or magnitude of a vector are
 * chosen by the lookup table's VectorMode. Point data and field data with one tuple a point are
 * taken. Values are looked up for the particles that are seen only, straight from the input's
 * array: no colour array is made, so there is no limit to the number of particles.
 *
 * In a renderer with a vtkMoteRayCastPass all particles are traced together, so that they hide one
 * another exactly; without one each actor is traced alone and composited by depth.
 *
 * Points that stay in a .mote file (vtkMoteParticleFileReader) are drawn from the file's pages,
 * nothing being built or copied, in RADIUS_AUTOMATIC mode with a RadiusScale of 1 and with the
 * structures "auto" and "pkd-tree"; otherwise a structure is built over them as over any.
 *
 * What cannot be drawn, particles at positions that are not finite or with a radius that is not a
 * finite number above zero, is left out, counted and reported once for each input.
 */

#ifndef vtkMoteParticleMapper_h
#define vtkMoteParticleMapper_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkMapper.h"

#include <memory> // for the implementation
#include <string> // for messages
#include <vector> // for names

class vtkMoteClipCylinder;
class vtkDataArray;
class vtkPointData;
class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote
{
class MapperOcclusion;
class ParticleModel;
class ScratchSpace;
struct BuiltParticles;
struct OcclusionRequest;
struct SurfaceObject;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteParticleMapper : public vtkMapper
{
public:
  static vtkMoteParticleMapper* New();
  vtkTypeMacro(vtkMoteParticleMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /** The particles: a data object, or (with SetInputConnection) a pipeline's output. */
  void SetInputData(vtkPointSet* input);
  vtkPointSet* GetInput();
  //@}

  /**
   * Where a particle's radius comes from. AUTOMATIC, the default, takes a point array named radius
   * or radii, or half of one named diameter (see GetRadiusFactor()), else half the typical distance
   * between neighbours; of points that stay in a .mote file the radii that the file has.
   */
  enum RadiusModes
  {
    RADIUS_AUTOMATIC = 0,
    RADIUS_CONSTANT,    ///< Radius for all
    RADIUS_BY_ARRAY,    ///< RadiusArrayName's values
    RADIUS_BY_TYPE,     ///< TypeArrayName's values through the table of SetTypeRadius()
    RADIUS_FROM_SPACING ///< half the typical distance between neighbours
  };

  //@{
  /** One of RadiusModes. */
  vtkSetClampMacro(RadiusMode, int, RADIUS_AUTOMATIC, RADIUS_FROM_SPACING);
  vtkGetMacro(RadiusMode, int);
  void SetRadiusModeToAutomatic() { this->SetRadiusMode(RADIUS_AUTOMATIC); }
  void SetRadiusModeToConstant() { this->SetRadiusMode(RADIUS_CONSTANT); }
  void SetRadiusModeToArray() { this->SetRadiusMode(RADIUS_BY_ARRAY); }
  void SetRadiusModeToType() { this->SetRadiusMode(RADIUS_BY_TYPE); }
  void SetRadiusModeToSpacing() { this->SetRadiusMode(RADIUS_FROM_SPACING); }
  //@}

  /**
   * What an array of this name holds to RADIUS_AUTOMATIC: 1 radii, 0.5 diameters, 0 something else.
   * Names are radius, radii and diameter, alone or behind particle, sphere, grain or atom. The case
   * of letters, blanks, "_", "-" and units in brackets do not count: "Particle Diameter (m)".
   */
  static double GetRadiusFactor(const char* arrayName);
  /** The array of one component that RADIUS_AUTOMATIC takes radii or diameters from; or null. */
  static vtkDataArray* FindRadii(vtkPointData* data);

  //@{
  /** The radius in RADIUS_CONSTANT mode, in the units of the points. Default 0.5. */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /** Multiplies the radius of every mode. Default 1; 0.5 turns an array of diameters into radii. */
  vtkSetMacro(RadiusScale, double);
  vtkGetMacro(RadiusScale, double);
  //@}

  //@{
  /** Point array of one component that holds the radii in RADIUS_BY_ARRAY mode. */
  vtkSetStringMacro(RadiusArrayName);
  vtkGetStringMacro(RadiusArrayName);
  //@}

  //@{
  /** Point array of one component that holds the types in RADIUS_BY_TYPE mode. Default "type". */
  vtkSetStringMacro(TypeArrayName);
  vtkGetStringMacro(TypeArrayName);
  //@}

  //@{
  /** The radius of all particles of a type, for RADIUS_BY_TYPE. Types without one get Radius. */
  void SetTypeRadius(int type, double radius);
  double GetTypeRadius(int type);
  void RemoveAllTypeRadii();
  //@}

  //@{
  /**
   * Hides, rather than recolours, the particles whose value of VisibilityArrayName lies outside
   * VisibilityRange (both ends belong to it; NaN is outside). Off by default. A change rebuilds no
   * structure.
   */
  vtkSetMacro(UseVisibilityRange, vtkTypeBool);
  vtkGetMacro(UseVisibilityRange, vtkTypeBool);
  vtkBooleanMacro(UseVisibilityRange, vtkTypeBool);
  vtkSetVector2Macro(VisibilityRange, double);
  vtkGetVector2Macro(VisibilityRange, double);
  //@}

  //@{
  /**
   * The array that VisibilityRange speaks of, and its component, or -1 for the magnitude. Default
   * component 0 of the array that colours, which an empty name is. Of the array that colours it is
   * the component that the lookup table chooses.
   */
  vtkSetStringMacro(VisibilityArrayName);
  vtkGetStringMacro(VisibilityArrayName);
  vtkSetMacro(VisibilityComponent, int);
  vtkGetMacro(VisibilityComponent, int);
  //@}

  //@{
  /**
   * Hides the particles whose value of a point array lies outside of `low` to `high` (both ends
   * belong to it; NaN is outside; infinite ends are no limit). Component -1 is the magnitude. Up to
   * four arrays or components at a time, besides the visibility range above and the ranges of
   * position and radius below: only what lies in all of them is shown. A second range of an array's
   * component takes the first one's place. False, with an error, for a fifth one and for ranges
   * that end before they begin.
   *
   * Answers are exact whatever type the array has. A change rebuilds no structure, nor does it look
   * at the particles where arrays are of float or of integers up to 16 bit, of which the structure
   * keeps a copy while a range is on (16 bytes a particle for up to four). An array that the input
   * lacks is an error, told once; the other ranges hold.
   */
  bool AddRange(const char* array, int component, double low, double high);
  bool AddRange(const char* array, double low, double high)
  {
    return this->AddRange(array, 0, low, high);
  }
  void RemoveRange(const char* array, int component = 0);
  int GetNumberOfRanges();
  //@}

  /**
   * Adds values to those that the range of an array's component shows, as in "types 1, 3 and 5 to
   * 8": what lies in one of its parts is shown. The same as AddRange() where there is no range yet.
   * A range with gaps looks at all particles when it changes.
   */
  bool AddToRange(const char* array, int component, double low, double high);

  //@{
  /**
   * As AddRange(), of centres along an axis (0, 1, 2 for x, y, z) in the input's coordinates.
   * Infinite at first: no limit.
   */
  bool SetCenterRange(int axis, double low, double high);
  void GetCenterRange(int axis, double range[2]);
  //@}

  //@{
  /** The same for the radius, as drawn: in the units of the points, RadiusScale and all. */
  bool SetRadiusRange(double low, double high);
  void GetRadiusRange(double range[2]);
  //@}

  /** Takes away all these ranges but VisibilityRange. */
  void RemoveAllRanges();

  //@{
  /**
   * The particles that all ranges leave to be seen, as of the last Update(): their number, and the
   * bounds of their spheres with those of their images (GetBounds() are those of all, so that the
   * camera stays when a range changes). The first call after a change looks at all particles.
   */
  vtkIdType GetNumberOfVisibleParticles();
  void GetVisibleBounds(double bounds[6]);
  //@}

  //@{
  /**
   * The structure that rays are cast through, by name: "coherent-grid", the fastest for a camera's
   * rays; "pkd-tree", which takes 12.5 bytes a particle instead of 20 (and 4 for its id, either)
   * and is faster for ambient occlusion; "pkd-paper", that tree as it was published, slower and
   * there to compare with; or "auto" (default), the grid up to 100 million particles and the
   * "pkd-tree" above.
   */
  vtkSetStringMacro(StructureName);
  vtkGetStringMacro(StructureName);
  //@}

  //@{
  /**
   * What the "pkd-tree" keeps centres in, by name: "exact", 12 bytes a particle and as fine as
   * float; "8-byte"; "4-byte"; or "auto" (default), as the file has it that the points stay in,
   * else exact. A form that would move particles by more than a twentieth of the smallest radius
   * is refused. A form but "auto" is one of the "pkd-tree", which "auto" structures then are.
   */
  vtkSetStringMacro(StructureForm);
  vtkGetStringMacro(StructureForm);
  //@}

  //@{
  /**
   * Whether a P-k-d tree keeps the way back from its particles to the points, 4 or 8 bytes a
   * particle. Without it only those can use the tree who ask for neither ids nor values of
   * particles, such as writers of files without arrays. On unless set.
   */
  vtkSetMacro(KeepPointIds, bool);
  vtkGetMacro(KeepPointIds, bool);
  vtkBooleanMacro(KeepPointIds, bool);
  //@}

  //@{
  /**
   * Rays a pixel, in [1, 65536], where the mapper draws by itself, without a vtkMoteRayCastPass.
   * Default 4. With 1 a pixel is covered or not, as compositing by depth needs it.
   */
  vtkSetClampMacro(SamplesPerPixel, int, 1, 65536);
  vtkGetMacro(SamplesPerPixel, int);
  //@}

  //@{
  /**
   * Whether the particles cast shadows, on others and on one another. On unless set. Where it is
   * off, and the property's opacity is below 1, they occlude nothing either, like glass.
   */
  vtkSetMacro(CastsShadows, bool);
  vtkGetMacro(CastsShadows, bool);
  vtkBooleanMacro(CastsShadows, bool);
  //@}

  //@{
  /**
   * How many pixels the picture may err by, at least 0: boxes stand for groups of particles. Most
   * rays that hit a box pass one of its particles by less than so many pixels, and all by less than
   * about twice as much. Boxes cover as much as their particles do and have their mean colour, so
   * far views of many particles take less time and flicker less. Only the "pkd-tree" has them,
   * which "auto" structures then are. Others are exact, and so are 0, as unless set, what is not
   * opaque, sets with baked ambient occlusion, and groups of which a part is hidden. Shadows,
   * ambient occlusion and picks ask the particles themselves. See docs/pkd-tree.md.
   */
  vtkSetClampMacro(PixelsOfError, double, 0.0, 1000.0);
  vtkGetMacro(PixelsOfError, double);
  //@}

  //@{
  /**
   * How often the particles are drawn along each of three vectors: as they are, one vector further,
   * and so on, as with the images of a periodic simulation. Nothing is copied and no structure is
   * built; colours, ids and occlusion maps are those of the particles. 1, 1, 1 at first; less
   * counts as 1. ReplicationVectors are the three vectors, in the input's coordinates, the axes'
   * unit ones at first. Shadows fall from image to image; baked maps know one image alone.
   */
  vtkSetVector3Macro(Replication, int);
  vtkGetVector3Macro(Replication, int);
  vtkSetVectorMacro(ReplicationVectors, double, 9);
  vtkGetVectorMacro(ReplicationVectors, double, 9);
  //@}

  //@{
  /**
   * Whether rays meet ghosts: points that vtkGhostType marks as copies of what another rank has.
   * A pixel that shows one is left to that rank. The data must not hold a point and its copy both.
   * Default off: ghosts are hidden.
   */
  vtkSetMacro(MeetsGhosts, bool);
  vtkGetMacro(MeetsGhosts, bool);
  vtkBooleanMacro(MeetsGhosts, bool);
  //@}
  /** The marks of points among which are ghosts that rays meet; null where there are none. */
  vtkUnsignedCharArray* GetGhosts();

  //@{
  /**
   * Which piece about an axis is shown, beside what SetClippingPlanes() leaves: null, the default,
   * for all. Spheres are cut by planes and cylinder, and closed by flat faces. Nothing is built.
   */
  void SetClipCylinder(vtkMoteClipCylinder* cylinder);
  vtkMoteClipCylinder* GetClipCylinder();
  //@}

  /** Bounds of the spheres, not of their centres alone, and of all images of Replication. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }

  //@{
  /**
   * Brings the input up to date and builds the structure where input or radii changed; a change of
   * colours, ranges, camera or light builds nothing. Fires Start-, Progress- and EndEvents;
   * SetAbortExecute(1) from within one stops the build and leaves nothing to draw.
   */
  using Superclass::Update;
  void Update() override { this->Update(0); }
  void Update(int port) override;
  //@}

  //@{
  /**
   * When on, Update() of a set of more than four times PreviewSize particles does not wait until
   * the structure is built, which another thread does. It makes a preview of PreviewSize particles,
   * evenly taken from the input, with radii times the cube root of the share left out; colours,
   * ranges and ids are those of the input. An Update() that finds the structure built, such as that
   * of the next frame, takes it. StartEvent is fired when the build begins, ProgressEvents by each
   * Update(), EndEvent when the exact structure is there, or will not be.
   *
   * Off, the default, nothing is ever drawn but the exact picture: Update() waits for a build that
   * goes on. A vtkMoteRendererSource and a vtkMoteParticleFileWriter wait in any case.
   *
   * StopBuild() before arrays of the input are written to in place, or resized, while a build goes
   * on. Other input or other radii stop it by themselves.
   */
  vtkSetMacro(Preview, vtkTypeBool);
  vtkGetMacro(Preview, vtkTypeBool);
  vtkBooleanMacro(Preview, vtkTypeBool);
  vtkSetClampMacro(PreviewSize, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(PreviewSize, vtkIdType);
  //@}

  //@{
  /**
   * Whether what is drawn as of the last Update() is a preview; of how many particles (else 0);
   * whether a structure is built on another thread; and the share of it that is built, in [0, 1].
   * Where the build failed, of which there is an error, the preview stays. See also
   * vtkMoteRayCastPass::IsPreview().
   */
  bool IsPreview();
  bool IsBuilding();
  vtkIdType GetNumberOfPreviewParticles();
  double GetBuildProgress();
  //@}

  /** Update() that waits for the exact structure, with ProgressEvents; true when it is there. */
  bool FinishBuild();
  /**
   * Stops what is built on another thread, which takes a moment, and forgets the preview. The next
   * Update() begins anew.
   */
  void StopBuild();

  /**
   * Update() for another time step of the input's pipeline, which stays the one that is shown.
   * Ranges, colours and lookup tables stay what they were. Radii of RADIUS_FROM_SPACING follow each
   * step's spacing: for radii that stay, use RADIUS_CONSTANT with GetRadiusInUse() of one step.
   */
  int UpdateTimeStep(double time, int piece = -1, int pieces = 1, int ghostLevels = 0,
    const int extents[6] = nullptr) override;

  //@{
  /**
   * Facts of the present structure, as of the last Update(): particles drawn or hidden by range,
   * particles left out as unfit, bytes of structure and particles, seconds of the last build,
   * number of builds so far, and the radius in use where it is one for all (else 0). While there is
   * a preview, bytes and GetNumberOfVisibleParticles() are its own, and all else the input's.
   */
  vtkIdType GetNumberOfParticles();
  vtkIdType GetNumberOfUnfitParticles();
  vtkTypeInt64 GetStructureBytes();
  double GetBuildTime();
  int GetNumberOfBuilds();
  double GetRadiusInUse();
  //@}

  //@{
  /** Particles that have an occlusion map as of the last picture, and what the maps take. */
  vtkIdType GetNumberOfBakedParticles();
  vtkTypeInt64 GetOcclusionBytes();
  //@}

  /** The array that colours the particles now; null where they have the property's colour. */
  vtkDataArray* GetColorArray();
  /**
   * The value that colours particle `id` (its index in the input), as the lookup table's
   * VectorMode picks it; NaN where there is none.
   */
  double GetParticleValue(vtkIdType id);
  /** The range of those values over the input, without NaN and infinities; 1, 0 without any. */
  void GetColorArrayRange(double range[2]);

  /** Draws the particles of this one actor. Called by vtkActor. */
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Particles are drawn with the opaque geometry. vtkHardwareSelector, and with it vtkPropPicker,
   * finds the actor; for the particle use vtkMoteParticlePicker, which knows ids of any size.
   */
  bool HasOpaqueGeometry() override { return true; }
  bool HasTranslucentPolygonalGeometry() override { return false; }
  bool GetSupportsSelection() override { return true; }
  //@}

#ifndef __VTK_WRAP__
  /** The names that StructureName and StructureForm may be, the default first. */
  static std::vector<std::string> GetStructureNames();
  static std::vector<std::string> GetStructureForms();

  /**
   * Hands structures from one mapper to another: the next Update() of a mapper that is offered what
   * another one has built from the very same arrays, with the same radii and structure, takes it
   * and builds nothing. So a thread with a mapper of its own builds time steps ahead. One mapper at
   * a time draws what was built. Null where there is nothing to hand on, such as a preview or what
   * stays in a .mote file.
   */
  std::shared_ptr<const mote::BuiltParticles> GetBuilt();
  void OfferBuilt(std::shared_ptr<const mote::BuiltParticles> built);

  /** Where a P-k-d tree that is built from now on lies, in place of the heap; null for the heap. */
  void SetScratchSpace(std::shared_ptr<mote::ScratchSpace> space);
  std::shared_ptr<mote::ScratchSpace> GetScratchSpace() const;

  /** Updates, and describes what this actor shows, until the next Update(); false for nothing. */
  bool DescribeTo(mote::SurfaceObject& object, vtkActor* actor);

  /** The particles as of the last Update(), and what the model's occlusion() gives. */
  mote::ParticleModel& GetModel();
  mote::MapperOcclusion* UpdateOcclusion(const mote::OcclusionRequest* request);
#endif

  /**
   * The typical distance of neighbours among the points, 0 for less than two, whatever radii they
   * have. Builds nothing; looks at all points some times, unless a file knows it.
   */
  static double EstimateSpacing(vtkPointSet* points);

  /** Changes with everything that the picture of this mapper depends on, its input included. */
  vtkMTimeType GetPictureMTime();

protected:
  vtkMoteParticleMapper();
  ~vtkMoteParticleMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int RadiusMode = RADIUS_AUTOMATIC;
  double Radius = 0.5;
  double RadiusScale = 1.0;
  char* RadiusArrayName = nullptr;
  char* TypeArrayName = nullptr;
  vtkTypeBool UseVisibilityRange = 0;
  double VisibilityRange[2] = {0.0, 1.0};
  char* VisibilityArrayName = nullptr;
  int VisibilityComponent = 0;
  char* StructureName = nullptr;
  char* StructureForm = nullptr;
  vtkTypeBool Preview = 0;
  vtkIdType PreviewSize = 1000000;
  bool KeepPointIds = true;
  bool MeetsGhosts = false;
  int SamplesPerPixel = 4;
  bool CastsShadows = true;
  double PixelsOfError = 0.0;
  int Replication[3] = {1, 1, 1};
  double ReplicationVectors[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

private:
  vtkMoteParticleMapper(const vtkMoteParticleMapper&) = delete;
  void operator=(const vtkMoteParticleMapper&) = delete;

  void AllowError(mote::SurfaceObject& object);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
