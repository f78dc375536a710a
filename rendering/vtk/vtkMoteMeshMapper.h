/**
 * @class   vtkMoteMeshMapper
 * @brief   Draws triangles, ray cast on the CPU.
 *
 * Input is a vtkPolyData, whose polygons and strips are cut into triangles, or any other
 * vtkPointSet, such as a vtkUnstructuredGrid, of which the faces are drawn that no two cells share,
 * and the cells that are flat; where parts of a grid that share no point meet, as a rotor and its
 * stator do, faces that cells of the other part cover are left out. Lines and vertices are left
 * out, as are triangles with a corner that is not finite, with a warning that counts them. Both
 * sides of triangles are drawn alike, but for the opacity of the actor's BackfaceProperty, where it
 * has one: walls of cells that face the eye can be left out by opacity 0, and those behind them be
 * opaque. Outer faces of cells look outwards, polygons to where their corners go round against the
 * clock.
 *
 * Use it with a vtkActor, as any mapper: position, scale and orientation of the actor, visibility,
 * and the ambient, diffuse, specular and opacity terms and the colour of its vtkProperty hold. What
 * lies behind an opacity below 1 shines through, in order. Normals of the points make triangles
 * look smooth, unless the property's interpolation is flat; without them triangles are flat.
 * Texture coordinates are not used, nor are edges, points and wireframes drawn.
 *
 * Colours come from any array of points or cells, as in other mappers: ScalarVisibility,
 * ScalarMode, SelectColorArray(), ColorMode, LookupTable, ScalarRange; component or magnitude of a
 * vector are chosen by the lookup table's VectorMode. Values of points are interpolated before they
 * are looked up, whatever InterpolateScalarsBeforeMapping says; colours that the array holds are
 * interpolated themselves.
 *
 * In a renderer with a vtkMoteRayCastPass triangles are traced together with particles and volumes,
 * so that they hide, shadow and outline one another; without one each actor is traced alone and
 * composited by depth.
 */

#ifndef vtkMoteMeshMapper_h
#define vtkMoteMeshMapper_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkMapper.h"

#include <cstddef>
#include <memory> // for the implementation
#include <string> // for the report
#include <utility>
#include <vector>

class vtkMoteClipCylinder;
class vtkDataArray;
class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote
{
struct BuiltMesh;
struct MeshLook;
struct ScenePick;
struct SurfaceObject;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteMeshMapper : public vtkMapper
{
public:
  static vtkMoteMeshMapper* New();
  vtkTypeMacro(vtkMoteMeshMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /** The mesh: a data object, or (with SetInputConnection) a pipeline's output. */
  void SetInputData(vtkPointSet* input);
  vtkPointSet* GetInput();
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
   * Whether the triangles cast shadows, on others and on one another. On unless set. Where it is
   * off, and the property's opacity is below 1, they occlude nothing either, like glass.
   */
  vtkSetMacro(CastsShadows, bool);
  vtkGetMacro(CastsShadows, bool);
  vtkBooleanMacro(CastsShadows, bool);
  //@}

  //@{
  /**
   * How many pixels the picture may err by, at least 0: groups of triangles that would err by less
   * are drawn as planes (R-LODs), which takes less time and memory where many triangles fall into a
   * pixel, and keeps colours from flickering: planes have the mean colour. 99.9 % of the pixels are
   * displaced by less than this, none by more than about twice as much. Shadows, ambient occlusion
   * and reflections err by as much as the pixels that show them; picks ask the triangles
   * themselves. 0, as unless set, is exact; so is all that is not opaque. See docs/triangles.md.
   */
  vtkSetClampMacro(PixelsOfError, double, 0.0, 1000.0);
  vtkGetMacro(PixelsOfError, double);
  //@}

  //@{
  /**
   * Which of the input's cells are drawn: an array with a value for each, of which 0 hides the
   * cell; null, as unless set, for all. What is seen is what would be seen if the input did not
   * have the hidden cells: faces that they share with others come to light. Where other cells are
   * hidden than before, the structure is built anew; but not for polygons and strips, which take a
   * copy of most of it as long as some are hidden.
   */
  void SetVisibleCells(vtkUnsignedCharArray* isVisible);
  vtkUnsignedCharArray* GetVisibleCells();
  //@}

  //@{
  /**
   * Mappers that show other blocks of the same mesh: of cells with a volume faces are left out that
   * the visible cells of their inputs cover, with the same points or with others. So blocks have no
   * walls between them. Each has to be told of the other. They are not kept: one that is gone
   * covers nothing.
   */
  void AddNeighbor(vtkMoteMeshMapper* other);
  void RemoveAllNeighbors();
  int GetNumberOfNeighbors();
  //@}

  //@{
  /**
   * Whether sheets, flat cells beside cells with a volume such as shells and baffles, are seen from
   * both sides where the property's opacity is 0 and that of the BackfaceProperty is not: they hide
   * nothing that lies within cells. Default off: each is seen from its back.
   */
  vtkSetMacro(TwoSidedSheets, bool);
  vtkGetMacro(TwoSidedSheets, bool);
  vtkBooleanMacro(TwoSidedSheets, bool);
  //@}

  //@{
  /**
   * Which piece about an axis is shown, beside what SetClippingPlanes() leaves: null, the default,
   * for all. Triangles are cut where planes and cylinder are, and open; walls that lie flat
   * in a face of the cut are shown whole, as far as a millionth of the input's size outside.
   * Nothing is built for either.
   */
  void SetClipCylinder(vtkMoteClipCylinder* cylinder);
  vtkMoteClipCylinder* GetClipCylinder();
  //@}

  //@{
  /**
   * How often it is drawn, evenly around an axis, in the input's coordinates: a sector as the whole
   * wheel. Nothing is copied: copies share what is built. They have the same cells for picks, and
   * the same values; for components of vectors see TurnVectors. Of cells with a volume the sides
   * are left out where copies touch. Default 1, about z.
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

  //@{
  /**
   * Whether rays meet polygons that are ghosts: those that vtkGhostType marks as copies
   * (vtkDataSetAttributes::DUPLICATECELL) of what another rank has. They throw shadows and darken
   * what is near them, and a pixel that shows one is left empty, for the rank that it belongs to.
   * Default off: ghosts are left out. Of cells with a volume they always are.
   */
  vtkSetMacro(MeetsGhosts, bool);
  vtkGetMacro(MeetsGhosts, bool);
  vtkBooleanMacro(MeetsGhosts, bool);
  //@}

  /** The marks of cells among which are ghosts that rays meet; null where there are none. */
  vtkUnsignedCharArray* GetGhosts();

  /** Bounds of the triangles that can be drawn. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }

  //@{
  /**
   * Brings the input up to date, and the structure where points or cells have changed: where only
   * points have moved it takes their new places, which is much faster than to build it, unless they
   * have wandered so far that rays would become twice as slow. A change of
   * colours, arrays, camera or light builds nothing. Fires Start-, Progress- and EndEvents where it
   * does either; SetAbortExecute(1) from within one stops it and leaves nothing to draw.
   */
  using Superclass::Update;
  void Update() override { this->Update(0); }
  void Update(int port) override;
  //@}

  /** Update() for another time step of the input's pipeline, which stays the one that is shown. */
  int UpdateTimeStep(double time, int piece = -1, int pieces = 1, int ghostLevels = 0,
    const int extents[6] = nullptr) override;

  //@{
  /**
   * Facts of the present structure, as of the last Update(): triangles drawn; lines, vertices and
   * polygons of the input that have none; triangles with a corner that is not finite; both as
   * sentences, empty where there are none; bytes of structure and triangles; seconds that it took;
   * how often it was built, and how often it took points that had moved.
   */
  vtkIdType GetNumberOfTriangles();
  vtkIdType GetNumberOfCellsLeftOut();
  vtkIdType GetNumberOfUnfitTriangles();
  std::string GetReport();
  vtkTypeInt64 GetStructureBytes();
  double GetBuildTime();
  int GetNumberOfBuilds();
  int GetNumberOfRefits();
  //@}

  /** The array that colours the triangles now; null where they have the property's colour. */
  vtkDataArray* GetColorArray();
  /** Whether that array has a value for each cell, and not for each point. */
  bool IsColoredByCells();
  /** The range of its values over the input, without NaN and infinities; 1, 0 without any. */
  void GetColorArrayRange(double range[2]);

  /** Draws the triangles of this one actor. Called by vtkActor. */
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  //@{
  /**
   * Triangles are drawn with the opaque geometry. vtkHardwareSelector, and with it vtkPropPicker,
   * finds the actor; for the cell use vtkMoteParticlePicker.
   */
  bool HasOpaqueGeometry() override { return true; }
  bool HasTranslucentPolygonalGeometry() override { return false; }
  bool GetSupportsSelection() override { return true; }
  //@}

#ifndef __VTK_WRAP__
  //@{
  /**
   * Hands structures from one mapper to another: the next Update() of a mapper that is offered what
   * another one has built from the very same points and cells takes it and builds nothing; one that
   * has built nothing yet takes it too where they have the same content. So a thread with a mapper
   * of its own builds time steps ahead. Null where there is nothing to hand on.
   */
  std::shared_ptr<const mote::BuiltMesh> GetBuilt();
  void OfferBuilt(std::shared_ptr<const mote::BuiltMesh> built);
  //@}

  /**
   * The pieces of GetStructureBytes(): what there is, and its bytes. Mappers that handed over to
   * one another have some in common.
   */
  std::vector<std::pair<const void*, std::size_t>> GetMemory();

  /**
   * Updates, and describes the triangles to the kernels as this actor shows them; false where there
   * is nothing to draw. The views in the description hold until the next Update().
   */
  bool DescribeTo(mote::SurfaceObject& object, vtkActor* actor);

  /**
   * Follows TurnVectors in what DescribeTo() said, for triangles that are placed so.
   */
  void TurnColors(mote::SurfaceObject& placed);

  /** The value that colours what was picked, NaN where none does. */
  double ValueOf(const mote::ScenePick& pick);
#endif

  /** Changes with everything that the picture of this mapper depends on, its input included. */
  vtkMTimeType GetPictureMTime();

protected:
  vtkMoteMeshMapper();
  ~vtkMoteMeshMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Repetitions = 1;
  double RepetitionCenter[3] = {0.0, 0.0, 0.0};
  double RepetitionAxis[3] = {0.0, 0.0, 1.0};
  bool TurnVectors = false;
  int SamplesPerPixel = 4;
  bool CastsShadows = true;
  double PixelsOfError = 0.0;
  bool MeetsGhosts = false;
  bool TwoSidedSheets = false;

private:
  vtkMoteMeshMapper(const vtkMoteMeshMapper&) = delete;
  void operator=(const vtkMoteMeshMapper&) = delete;

  void UpdateMesh();
  void UpdateGeometry(vtkPointSet* input);
  void AllowError(mote::SurfaceObject& object, mote::MeshLook& look, bool ofCells);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
