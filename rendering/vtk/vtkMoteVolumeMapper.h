/**
 * @class   vtkMoteVolumeMapper
 * @brief   Draws a scalar on hexahedral cells as a cloud, as iso-surfaces, as slices, or as any of
 * these together, ray cast on the CPU.
 *
 * Input is a vtkUnstructuredGrid. Hexahedra, voxels, wedges, pyramids, tetrahedra and polyhedra
 * are drawn, with warped faces as they are; what cannot be is left out, counted and told of once
 * for each mesh. Polyhedra are cut about the mean of their points, where values are the mean of
 * theirs; one whose middle does not see all of its faces from inside is left out. Use it with a
 * vtkVolume, as any volume mapper: its position, scale and orientation, its visibility, and of its
 * vtkVolumeProperty the colour (RGB or gray), scalar opacity and its unit distance (in world
 * units), Shade, Ambient, Diffuse, Specular and SpecularPower hold, those of component 0. With
 * ShowIsoSurfaces each of the property's IsoSurfaceValues adds an opaque surface, coloured by the
 * colour function and lit by the property's material, Shade or not.
 *
 * Which array is drawn is chosen as in other mappers: ScalarMode, SelectScalarArray(); of arrays
 * with several components VectorMode and VectorComponent say what counts. Point values vary
 * trilinearly in a cell, cell values are even.
 *
 * In a renderer with a vtkMoteRayCastPass volumes and particles are traced together: they hide one
 * another exactly, and volumes that lie behind one another are put in order pixel by pixel. Without
 * one each volume is traced alone. Either way rays end at the opaque props that VTK has drawn
 * before.
 *
 * What rays need is made for a mesh and kept while points and cells stay what they are; where a
 * reader makes them anew for each time step their content is compared. Clouds that are integrated
 * cell by cell need to know which cells share faces, and no structure; one is built when first
 * needed: by iso-surfaces, slices, other integrators, a Tolerance below 1e-5. Other scalars refresh
 * its ranges, where it is needed still; other colours, opacities, camera or light nothing.
 *
 * What an input, a property or a setting lacks or has that cannot be drawn is told once, in one
 * sentence, and nothing is drawn: bad connectivity, no cells, no such array, arrays of another
 * length, blend modes other than composite, two-dimensional transfer functions. Gradient opacity
 * and clipping planes are not used, with a warning.
 */

#ifndef vtkMoteVolumeMapper_h
#define vtkMoteVolumeMapper_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory>  // for the implementation
#include <string>  // for messages
#include <utility> // for memory
#include <vector>  // for names

class vtkMoteClipCylinder;
class vtkMoteSlice;
class vtkDataArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace mote
{
struct BuiltVolume;
struct CloudObject;
struct HexScalar;
struct HexStructureOptions;
struct Scene;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteVolumeMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkMoteVolumeMapper* New();
  vtkTypeMacro(vtkMoteVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum VectorModes
  {
    COMPONENT = 0, ///< VectorComponent
    MAGNITUDE      ///< the Euclidean length
  };

  //@{
  /**
   * What counts of arrays with several components: one of VectorModes, and the component, from 0
   * on. Default component 0.
   */
  vtkSetClampMacro(VectorMode, int, COMPONENT, MAGNITUDE);
  vtkGetMacro(VectorMode, int);
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  vtkSetClampMacro(VectorComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(VectorComponent, int);
  //@}

  //@{
  /**
   * The structure that rays are cast through, by name: "cartbvh" (default), a
   * hierarchy that neighbouring rays go through together, with the least memory; "cylbvh", a
   * hierarchy, "cylgrid" and "cartgrid", two-level grids, which rays go through one by one; grids
   * take 3 to 10 times the memory. Bounds are in Cartesian or cylindrical coordinates. The picture
   * is the same; docs/hexahedra.md compares them. None stands for the default.
   */
  vtkSetStringMacro(StructureName);
  vtkGetStringMacro(StructureName);
  //@}

  //@{
  /**
   * The axis of cylindrical structures, in the input's coordinates. A direction of 0 0 0 (default)
   * has it found.
   */
  vtkSetVector3Macro(AxisOrigin, double);
  vtkGetVector3Macro(AxisOrigin, double);
  vtkSetVector3Macro(AxisDirection, double);
  vtkGetVector3Macro(AxisDirection, double);
  //@}

  //@{
  /**
   * How colour is integrated along rays, by name: "cell-by-cell" (default), between the exact
   * places of entry and exit, to Tolerance; "trilinear", even samples of the trilinear cell;
   * "inverse-distance", even samples of the mean of a cell's corners by inverse distance, as
   * published and not continuous between cells.
   */
  vtkSetStringMacro(IntegratorName);
  vtkGetStringMacro(IntegratorName);
  //@}

  //@{
  /**
   * Distance of even samples, in world units. 0 (default): half the edge of a cube as large as the
   * mean cell, or 1/2000 of the size of the mesh where that is more.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  //@}

  //@{
  /**
   * What a pixel's colour, in [0, 1], may err by in "cell-by-cell" integration; in [1e-9, 1].
   * Default 0.001.
   */
  vtkSetClampMacro(Tolerance, double, 1e-9, 1.0);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * The opacity at which a ray ends; in [0, 1], 1: never. Default 0.999.
   */
  vtkSetClampMacro(Saturation, double, 0.0, 1.0);
  vtkGetMacro(Saturation, double);
  //@}

  //@{
  /**
   * Whether the cloud is drawn. On by default.
   */
  vtkSetMacro(ShowCloud, vtkTypeBool);
  vtkGetMacro(ShowCloud, vtkTypeBool);
  vtkBooleanMacro(ShowCloud, vtkTypeBool);
  //@}

  //@{
  /**
   * Whether there is an opaque surface wherever the scalar has one of the property's
   * IsoSurfaceValues. Where it is of cells the surface follows its means at points, of the cells
   * around each. Off by default, as a new property holds the value 0.
   */
  vtkSetMacro(ShowIsoSurfaces, vtkTypeBool);
  vtkGetMacro(ShowIsoSurfaces, vtkTypeBool);
  vtkBooleanMacro(ShowIsoSurfaces, vtkTypeBool);
  //@}

  //@{
  /**
   * Which array isosurfaces follow in place of the one that colours: a name, null or empty, the
   * default, for that one; whether it is of cells; and its component, -1 for the magnitude.
   * Isosurfaces have the colour that the array that colours has there. It is an error to name an
   * array that the input lacks.
   */
  void SetIsoArray(const char* name, bool ofCells = false, int component = 0);
  const char* GetIsoArrayName() { return this->IsoArrayName.c_str(); }
  bool GetIsoArrayOfCells() { return this->IsoArrayOfCells; }
  int GetIsoArrayComponent() { return this->IsoArrayComponent; }
  //@}

  //@{
  /**
   * Where cells are shown sliced; see vtkMoteSlice. Slices are opaque, and no light changes the
   * colours that the property's colour function gives them. None by default; null where there is
   * none of this number, from 0 on. The bounds are those of the slices in the input's coordinates,
   * as of the last Update(), which takes a look at all points; not initialized where there is none.
   */
  void AddSlice(vtkMoteSlice* slice);
  void RemoveAllSlices();
  int GetNumberOfSlices();
  vtkMoteSlice* GetSlice(int number);
  void GetSliceBounds(double bounds[6]);
  //@}

  //@{
  /**
   * Which values slices show: those in any of the ranges, ends included; all of them without any.
   */
  void AddSliceRange(double low, double high);
  void RemoveAllSliceRanges();
  int GetNumberOfSliceRanges();
  void GetSliceRange(int number, double range[2]); ///< 1, 0 where there is none of this number
  //@}

  //@{
  /**
   * Width in pixels, and colour, of lines on slices along the edges of cells. Width 0 (default): no
   * lines. Where cells are only a few pixels wide the lines fade.
   */
  vtkSetClampMacro(EdgeWidth, double, 0.0, 100.0);
  vtkGetMacro(EdgeWidth, double);
  vtkSetVector3Macro(EdgeColor, double);
  vtkGetVector3Macro(EdgeColor, double);
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
   * The CloudTolerance of vtkMoteShading, in [0, 1], where the mapper draws by itself. Default 0:
   * every pixel is traced. Below 1/255 nothing of it is seen in a picture of 8 bits.
   */
  vtkSetClampMacro(CloudTolerance, double, 0.0, 1.0);
  vtkGetMacro(CloudTolerance, double);
  //@}

  //@{
  /**
   * Whether these surfaces keep the light of lights that cast shadows from others, and from one
   * another. On unless set. Clouds never do.
   */
  vtkSetMacro(CastsShadows, bool);
  vtkGetMacro(CastsShadows, bool);
  vtkBooleanMacro(CastsShadows, bool);
  //@}

  //@{
  /**
   * Colour, and opacity per unit distance, of cells that have a value that is not a finite number.
   * With opacity 0, the default, they are left out. Default colour 0.5 0 0, as in VTK's tables.
   */
  vtkSetVector3Macro(NanColor, double);
  vtkGetVector3Macro(NanColor, double);
  vtkSetClampMacro(NanOpacity, double, 0.0, 1.0);
  vtkGetMacro(NanOpacity, double);
  //@}

  //@{
  /**
   * Which of the input's cells are drawn: an array with a value for each, of which 0 hides the
   * cell; null, the default, for all. What is seen is what would be seen if the input did not have
   * the hidden cells. Nothing is built for it.
   */
  void SetVisibleCells(vtkUnsignedCharArray* isVisible);
  vtkUnsignedCharArray* GetVisibleCells();
  //@}

  //@{
  /**
   * Which piece about an axis is shown, beside what SetClippingPlanes() leaves: null, the default,
   * for all. Rays are cut where planes and cylinder are; isosurfaces are open there, and slices
   * that lie in a face of the cut are shown whole. Nothing is built for either.
   */
  void SetClipCylinder(vtkMoteClipCylinder* cylinder);
  vtkMoteClipCylinder* GetClipCylinder();
  //@}

  //@{
  /**
   * How often it is drawn, evenly around an axis, in the input's coordinates: a sector as the whole
   * wheel. Nothing is copied: copies share what is built. They have the same cells for picks, and
   * the same values; for components of vectors see TurnVectors. Default 1, about z.
   */
  vtkSetClampMacro(Repetitions, int, 1, 10000);
  vtkGetMacro(Repetitions, int);
  vtkSetVector3Macro(RepetitionCenter, double);
  vtkGetVector3Macro(RepetitionCenter, double);
  vtkSetVector3Macro(RepetitionAxis, double);
  vtkGetVector3Macro(RepetitionAxis, double);
  //@}

  //@{
  /**
   * Whether arrays with three components are vectors that turn with what is drawn, by its prop and
   * its repetition: a component is then that along an axis of the world. Default off.
   */
  vtkSetMacro(TurnVectors, bool);
  vtkGetMacro(TurnVectors, bool);
  vtkBooleanMacro(TurnVectors, bool);
  //@}

  /**
   * Bounds of the cells that can be drawn, hidden ones included.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }

  //@{
  /**
   * Brings the input up to date, builds the structure where points or cells changed, and takes the
   * scalars where they did. Fires Start-, Progress- and EndEvents around a build;
   * SetAbortExecute(1) from within one stops it between two of its steps and leaves nothing to
   * draw.
   */
  using Superclass::Update;
  void Update() override { this->Update(0); }
  void Update(int port) override;
  //@}

  /**
   * Update() for another time step of the input's pipeline, which stays the one that is shown.
   * 1 where there is something to draw, else 0.
   */
  int UpdateTimeStep(double time, int piece = -1, int pieces = 1, int ghostLevels = 0,
    const int extents[6] = nullptr) override;

  //@{
  /**
   * Facts as of the last Update(): cells that are drawn; a sentence about cells that were left out
   * or mended, empty where none was; bytes of mesh, structure and scalars; seconds of the last
   * build; number of builds, and of times that scalars were taken, so far; and the range of the
   * finite scalars (1, 0 where there is none).
   */
  vtkIdType GetNumberOfCells();
  std::string GetReport();
  vtkTypeInt64 GetStructureBytes();
  double GetBuildTime();
  int GetNumberOfBuilds();
  int GetNumberOfFieldUpdates();
  double* GetScalarRange() VTK_SIZEHINT(2);
  void GetScalarRange(double range[2]);
  //@}

  /// Why a cell of the input is not drawn.
  enum ReasonsToLeaveOut
  {
    ANY_REASON = 0,
    OTHER_TYPE,       ///< no type that fills space with straight edges
    UNFIT_POLYHEDRON, ///< its faces do not close, or its middle does not see all of them
    NOT_FINITE,       ///< a coordinate is not a number or infinite
    TOO_FAR,          ///< a coordinate is beyond 1e30
    NO_VOLUME,
    FLAT ///< of OTHER_TYPE: points, lines and surfaces, of which no report tells
  };

  /**
   * The number of the input's cells that are not drawn for one of ReasonsToLeaveOut, or for any, as
   * of the last Update(); 0 for other numbers, and where nothing can be drawn.
   */
  vtkIdType GetNumberOfCellsLeftOut(int reason = ANY_REASON);

  /**
   * Draws this one volume. Called by vtkVolume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Changes with everything that the picture of this mapper depends on, its input included.
   */
  vtkMTimeType GetPictureMTime();

#ifndef __VTK_WRAP__
  /**
   * Updates, and adds cloud, iso-surfaces and slices to the scene as this prop shows them, by the
   * same id; false where there is nothing to draw.
   */
  bool DescribeTo(mote::Scene& scene, vtkVolume* volume, int id = 0);

  //@{
  /**
   * Hands what is made of a grid from one mapper to another: the next Update() of a mapper that is
   * offered it takes mesh and structure where its grid has the same cells, and the field where it
   * is of the very same array. So a thread with a mapper of its own makes time steps ready. With
   * `forPicture` what else a picture needs is made first. Null where there is nothing to hand on.
   */
  std::shared_ptr<const mote::BuiltVolume> GetBuilt(bool forPicture = false);
  void OfferBuilt(std::shared_ptr<const mote::BuiltVolume> built);
  //@}

  /**
   * The pieces of GetStructureBytes(): what there is, and its bytes. Mappers that handed over to
   * one another have some in common.
   */
  std::vector<std::pair<const void*, std::size_t>> GetMemory();

  //@{
  /**
   * The names that StructureName and IntegratorName may be.
   */
  static std::vector<std::string> GetStructureNames();
  static std::vector<std::string> GetIntegratorNames();
  //@}
#endif

protected:
  vtkMoteVolumeMapper();
  ~vtkMoteVolumeMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int VectorMode = COMPONENT;
  int VectorComponent = 0;
  char* StructureName = nullptr;
  double AxisOrigin[3] = {0.0, 0.0, 0.0};
  double AxisDirection[3] = {0.0, 0.0, 0.0};
  char* IntegratorName = nullptr;
  double SampleDistance = 0.0;
  double Tolerance = 1e-3;
  double Saturation = 0.999;
  vtkTypeBool ShowCloud = 1;
  vtkTypeBool ShowIsoSurfaces = 0;
  std::string IsoArrayName;
  bool IsoArrayOfCells = false;
  int IsoArrayComponent = 0;
  double EdgeWidth = 0.0;
  double EdgeColor[3] = {0.05, 0.05, 0.05};
  int Repetitions = 1;
  double RepetitionCenter[3] = {0.0, 0.0, 0.0};
  double RepetitionAxis[3] = {0.0, 0.0, 1.0};
  bool TurnVectors = false;
  int SamplesPerPixel = 4;
  double CloudTolerance = 0.0;
  bool CastsShadows = true;
  double NanColor[3] = {0.5, 0.0, 0.0};
  double NanOpacity = 0.0;
  double ScalarRange[2] = {1.0, 0.0};

private:
  vtkMoteVolumeMapper(const vtkMoteVolumeMapper&) = delete;
  void operator=(const vtkMoteVolumeMapper&) = delete;

  void UpdateVolume();
  bool Walks();
  bool NeedsStructure();
  bool UpdateGeometry(vtkUnstructuredGrid* grid);
  void UpdateWalk();
  void UpdateField(vtkUnstructuredGrid* grid);
  int ChosenComponent(vtkDataArray* array);
  vtkDataArray* FindFollowed(vtkUnstructuredGrid* grid, mote::HexScalar& scalar);
  void UpdateFollowed(vtkUnstructuredGrid* grid);
  vtkDataArray* FindArray(vtkUnstructuredGrid* grid, bool& ofCells);
  void WarnOfUnused(vtkVolumeProperty* property);
#ifndef __VTK_WRAP__
  mote::HexStructureOptions StructureOptions();
  mote::BuiltVolume& UpdateTurned(const mote::CloudObject& placed);
  void DescribeLook(mote::CloudObject& cloud, vtkVolumeProperty* property);
#endif

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
