/**
 * @class   vtkMoteAmbientOcclusionBaker
 * @brief   bakes how much of the sky the surfaces of particles see
 *
 * The points are spheres, with radii as vtkMoteParticleMapper finds them. The output is the input
 * with a latitude-longitude map of the open share of the sky over each, in field data, by which a
 * vtkMoteParticleMapper lights them where vtkMoteShading asks for OCCLUSION_BAKED:
 *
 * - MoteOcclusion: the settings, one tuple with named components;
 * - MoteOcclusionContent: a fingerprint of positions and radii, two 64-bit numbers. A mapper does
 *   not use maps of other particles;
 * - MoteOcclusionLevels: what is stored for each point: 0 nothing, no light reaches it; 1 to 6 a
 * map of 1, 2, 4, 8, 16 or 32 texels along a side; 7 nothing, it sees all of the sky; 15 not baked;
 * - MoteOcclusionTexels: the texels of all points one after another, q standing for
 *   maximum (q / 255)^2; row r covers the polar angles from +z from r to r + 1 times pi / side,
 *   column c the longitudes atan2(y, x) from c to c + 1 times 2 pi / side;
 * - MoteOcclusionShown: which points were there to occlude, a bit each, where not all were.
 *
 * With a FileName the maps are saved, and when the filter runs again, in this program or another,
 * those that belong to the particles and were made with these settings are taken from the file, and
 * only what they lack is baked. Likewise a change of selection bakes again what it affects and no
 * more. ProgressEvents tell the share done; SetAbortExecute(1) from within one stops: what is baked
 * by then is in the output and in the file, the rest is not baked; but a file with all the maps of
 * other settings or particles is only replaced by as many.
 *
 * Source: Bigler, "Use of Silhouette Edges and Ambient Occlusion in Particle Visualization",
 * University of Utah, 2004; docs/ambient-occlusion.md.
 */

#ifndef vtkMoteAmbientOcclusionBaker_h
#define vtkMoteAmbientOcclusionBaker_h

#include "MoteFiltersParticlesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For ids

#include <memory> // For the implementation
#include <string> // For sentences

class vtkIdTypeArray;

class MOTEFILTERSPARTICLES_EXPORT vtkMoteAmbientOcclusionBaker : public vtkPolyDataAlgorithm
{
public:
  static vtkMoteAmbientOcclusionBaker* New();
  vtkTypeMacro(vtkMoteAmbientOcclusionBaker, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Where radii come from: as the methods of vtkMoteParticleMapper by these names, RadiusMode being
   * one of its RadiusModes. Maps serve a mapper with the same radii.
   */
  vtkSetClampMacro(RadiusMode, int, 0, 4);
  vtkGetMacro(RadiusMode, int);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  vtkSetMacro(RadiusScale, double);
  vtkGetMacro(RadiusScale, double);
  vtkSetStringMacro(RadiusArrayName);
  vtkGetStringMacro(RadiusArrayName);
  vtkSetStringMacro(TypeArrayName);
  vtkGetStringMacro(TypeArrayName);
  void SetTypeRadius(int type, double radius);
  void RemoveAllTypeRadii();
  //@}

  //@{
  /** The structure that rays are cast through, as vtkMoteParticleMapper has them by name. */
  vtkSetStringMacro(StructureName);
  vtkGetStringMacro(StructureName);
  //@}

  //@{
  /**
   * Texels along a side of the largest maps: 1, 2, 4, 8, 16 (default) or 32. Others are an error
   * when the filter runs.
   */
  vtkSetMacro(Side, int);
  vtkGetMacro(Side, int);
  //@}

  //@{
  /** Rays a texel, in [1, 65536]. Default 49. */
  vtkSetClampMacro(Samples, int, 1, 65536);
  vtkGetMacro(Samples, int);
  //@}

  //@{
  /**
   * How far away particles occlude, in the unit of the points: the shorter, the faster. 0, the
   * default, is a tenth of the longest side of their bounds, VTK_DOUBLE_MAX no limit.
   */
  vtkSetClampMacro(Reach, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Reach, double);
  //@}

  //@{
  /**
   * Whether particles whose maps vary little have smaller ones, and fewer rays, and the error that
   * the smaller may have, as a share of the brightest sky. On; 0.005.
   */
  vtkSetMacro(Adaptive, vtkTypeBool);
  vtkGetMacro(Adaptive, vtkTypeBool);
  vtkBooleanMacro(Adaptive, vtkTypeBool);
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Whether texels that lie within other particles are filled from their neighbours, so that no
   * darkness shows along the line where two meet. On.
   */
  vtkSetMacro(Dilate, vtkTypeBool);
  vtkGetMacro(Dilate, vtkTypeBool);
  vtkBooleanMacro(Dilate, vtkTypeBool);
  //@}

  //@{
  /**
   * The light of the sky from the direction SkyUp and from the other; in between it changes with
   * the cosine. 1 and 1, an even sky, and +z unless set.
   */
  vtkSetMacro(SkyTop, double);
  vtkGetMacro(SkyTop, double);
  vtkSetMacro(SkyBottom, double);
  vtkGetMacro(SkyBottom, double);
  vtkSetVector3Macro(SkyUp, double);
  vtkGetVector3Macro(SkyUp, double);
  //@}

  //@{
  /**
   * Point array outside of whose SelectionRange (both ends belong to it) particles are hidden: they
   * neither occlude nor are baked, as with the ranges of a mapper. None if empty, the default.
   * SelectionComponent -1 is the magnitude.
   */
  vtkSetStringMacro(SelectionArrayName);
  vtkGetStringMacro(SelectionArrayName);
  vtkSetMacro(SelectionComponent, int);
  vtkGetMacro(SelectionComponent, int);
  vtkSetVector2Macro(SelectionRange, double);
  vtkGetVector2Macro(SelectionRange, double);
  //@}

  //@{
  /**
   * Point array of one component: particles where it is 0 occlude, and are not baked themselves.
   * None if empty, the default.
   */
  vtkSetStringMacro(MaskArrayName);
  vtkGetStringMacro(MaskArrayName);
  //@}

  //@{
  /**
   * Indices of the points to bake, such as a picture shows (vtkMoteRendererSource, array
   * "particle"; those below 0 do not count); the others occlude. Null, the default: all.
   */
  void SetVisibleIds(vtkIdTypeArray* ids);
  vtkIdTypeArray* GetVisibleIds();
  //@}

  //@{
  /**
   * The file (.moteao) that maps are read from, where they fit, and written to. None if null, the
   * default. A file that cannot be read is a warning, one that cannot be written an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /** Threads to bake with; 0, the default, for all. */
  vtkSetClampMacro(NumberOfThreads, int, 0, 4096);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * Facts of the last run: particles that it baked, and rays and seconds that took; particles that
   * have a map now; bytes that maps take a particle of the input, on average; and whether any came
   * from the file.
   */
  vtkGetMacro(NumberOfNewlyBaked, vtkIdType);
  vtkGetMacro(NumberOfRays, vtkTypeInt64);
  vtkGetMacro(BakeTime, double);
  vtkGetMacro(NumberOfBaked, vtkIdType);
  vtkGetMacro(BytesPerParticle, double);
  vtkGetMacro(ReadFromFile, bool);
  //@}

  /**
   * Seconds that a run will still take, from the share done and the time that took; for observers
   * of ProgressEvents. Infinite before anything is done, 0 outside of runs.
   */
  double GetRemainingTime();

  /**
   * Adds the maps of a .moteao file to the field data of a data set, as this filter does, whatever
   * they belong to: a mapper finds out. A sentence where that fails; else empty.
   */
  static std::string ReadMaps(const std::string& fileName, vtkDataSet* data);

protected:
  vtkMoteAmbientOcclusionBaker();
  ~vtkMoteAmbientOcclusionBaker() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int RadiusMode = 0;
  double Radius = 0.5;
  double RadiusScale = 1.0;
  char* RadiusArrayName = nullptr;
  char* TypeArrayName = nullptr;
  char* StructureName = nullptr;
  int Side = 16;
  int Samples = 49;
  double Reach = 0.0;
  vtkTypeBool Adaptive = 1;
  double Tolerance;
  vtkTypeBool Dilate = 1;
  double SkyTop = 1.0;
  double SkyBottom = 1.0;
  double SkyUp[3] = {0.0, 0.0, 1.0};
  char* SelectionArrayName = nullptr;
  int SelectionComponent = 0;
  double SelectionRange[2] = {0.0, 1.0};
  char* MaskArrayName = nullptr;
  char* FileName = nullptr;
  int NumberOfThreads = 0;
  vtkIdType NumberOfNewlyBaked = 0;
  vtkTypeInt64 NumberOfRays = 0;
  double BakeTime = 0.0;
  vtkIdType NumberOfBaked = 0;
  double BytesPerParticle = 0.0;
  bool ReadFromFile = false;
  vtkSmartPointer<vtkIdTypeArray> VisibleIds;

private:
  vtkMoteAmbientOcclusionBaker(const vtkMoteAmbientOcclusionBaker&) = delete;
  void operator=(const vtkMoteAmbientOcclusionBaker&) = delete;

  void Run(vtkPolyData* data);
  void BeginMaps(vtkPolyData* data);
  bool Bake(vtkPolyData* data);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
