/**
 * @class   vtkMoteShading
 * @brief   How rays find the light on what Mote draws, besides the lights' own shadows.
 *
 * One object may serve any number of vtkMoteRayCastPass and vtkMoteRendererSource, which then make
 * the same picture: SetShading() of either.
 *
 * Ambient occlusion. The ambient part of an actor's vtkProperty is the light of an even sky; with
 * AmbientOcclusion a surface receives the share of it that it sees: of all directions above the
 * surface, each weighted by its cosine to the normal, those along which no particle stands within
 * AmbientOcclusionReach. Crevices darken. Lights and their shadows add to that as ever; properties
 * with no ambient part show nothing of it.
 *
 * LIVE finds that share by rays at every hit. BAKED looks it up in a map of each particle, of up to
 * BakeSide x BakeSide numbers, which costs next to nothing: maps come with the data
 * (vtkMoteAmbientOcclusionBaker), and what a picture at rest shows and has no map is baked before
 * it is traced; maps stay until particles, radii or settings change, and a change of a mapper's
 * ranges bakes again what it affects. Nothing is baked while the view moves. Maps count the
 * particles of their own actor alone. Iso-surfaces and particles that first show up at a later
 * sample of a pixel are lit as by LIVE; so are spheres seen from within, until all have maps, from
 * when on they see all of the sky.
 *
 * Path tracing. Light comes from a sky all around and from the lights, straight and by way of up to
 * MaximumBounces particles. Of a vtkProperty the colour times Diffuse, Metallic and Roughness tell
 * how particles answer; the ambient and the specular part do not count, except that a property
 * with Lighting off, or Diffuse and Metallic 0, shines with its ambient colour. All lights cast
 * shadows, vtkMoteAreaLight with its size and any other light from a point; a headlight stands in
 * the eye. The picture is noisy until many rays a pixel have been cast: see SamplesPerPixel and
 * NoiseLevel of what traces. Colours may exceed 1.
 */

#ifndef vtkMoteShading_h
#define vtkMoteShading_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkObject.h"

class MOTERENDERINGVTK_EXPORT vtkMoteShading : public vtkObject
{
public:
  static vtkMoteShading* New();
  vtkTypeMacro(vtkMoteShading, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    LOCAL,      ///< lights, their shadows, and ambient light with or without occlusion
    PATH_TRACED ///< light by way of other particles, too
  };

  //@{
  /**
   * How light is found. Default LOCAL.
   */
  vtkSetClampMacro(Mode, int, LOCAL, PATH_TRACED);
  vtkGetMacro(Mode, int);
  void SetModeToLocal() { this->SetMode(LOCAL); }
  void SetModeToPathTraced() { this->SetMode(PATH_TRACED); }
  //@}

  enum AmbientOcclusions
  {
    OCCLUSION_NONE, ///< all ambient light reaches every surface
    OCCLUSION_LIVE, ///< rays at every hit
    OCCLUSION_BAKED ///< maps of the particles
  };

  //@{
  /**
   * How the ambient light that surfaces receive is found, in LOCAL mode. Default OCCLUSION_NONE.
   * The others make AmbientOcclusionSamples 4 where they are 0.
   */
  void SetAmbientOcclusion(int how);
  vtkGetMacro(AmbientOcclusion, int);
  void SetAmbientOcclusionToNone() { this->SetAmbientOcclusion(OCCLUSION_NONE); }
  void SetAmbientOcclusionToLive() { this->SetAmbientOcclusion(OCCLUSION_LIVE); }
  void SetAmbientOcclusionToBaked() { this->SetAmbientOcclusion(OCCLUSION_BAKED); }
  //@}

  //@{
  /**
   * Rays that look for the sky at each hit of each of a pixel's rays, in [0, 4096]. 4, with 16 rays
   * a pixel, make a smooth picture; powers of two spread best. More than 0 turn OCCLUSION_NONE
   * into OCCLUSION_LIVE, and 0, the default, turns that into OCCLUSION_NONE. With OCCLUSION_BAKED
   * they light what has no map, and with 0 that is lit as if it saw all of the sky.
   */
  void SetAmbientOcclusionSamples(int samples);
  vtkGetMacro(AmbientOcclusionSamples, int);
  //@}

  //@{
  /**
   * How far those rays go, in world units: what is farther away darkens nothing. VTK_DOUBLE_MAX
   * for all that there is; 0, the default, for a tenth of the longest side of what is drawn.
   */
  vtkSetClampMacro(AmbientOcclusionReach, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AmbientOcclusionReach, double);
  //@}

  //@{
  /**
   * What is baked where maps are missing: texels along a side of a map, at most, a power of two in
   * [1, 32] (16); rays a texel, in [1, 4096] (49); whether particles whose maps vary little get
   * smaller ones (on), and how much the light may then be wrong, in [0, 1] (0.01). See
   * vtkMoteAmbientOcclusionBaker, which has more settings.
   */
  void SetBakeSide(int side);
  vtkGetMacro(BakeSide, int);
  vtkSetClampMacro(BakeSamples, int, 1, 4096);
  vtkGetMacro(BakeSamples, int);
  vtkSetMacro(BakeAdaptive, vtkTypeBool);
  vtkGetMacro(BakeAdaptive, vtkTypeBool);
  vtkBooleanMacro(BakeAdaptive, vtkTypeBool);
  vtkSetClampMacro(BakeTolerance, double, 0.0, 1.0);
  vtkGetMacro(BakeTolerance, double);
  //@}

  //@{
  /**
   * Particles that light comes by before it reaches the eye, at most, in [1, 1000]. 1 is light
   * straight from sky and lights. Default 16, with which little is lost even among bright
   * particles. Of path tracing.
   */
  vtkSetClampMacro(MaximumBounces, int, 1, 1000);
  vtkGetMacro(MaximumBounces, int);
  //@}

  //@{
  /**
   * The light of the sky, of path tracing: red, green and blue (1 is as bright as white paper under
   * it) from the direction SkyUp, in world coordinates, and from the other; in between it changes
   * with the cosine. Default: white all around; up is +z, of any length but 0. The sky is not in
   * the picture: where there are no particles the background stays.
   */
  vtkSetVector3Macro(SkyTop, double);
  vtkGetVector3Macro(SkyTop, double);
  vtkSetVector3Macro(SkyBottom, double);
  vtkGetVector3Macro(SkyBottom, double);
  vtkSetVector3Macro(SkyUp, double);
  vtkGetVector3Macro(SkyUp, double);
  //@}

  //@{
  /**
   * Where a cloud's colour changes so evenly from pixel to pixel that interpolation is right to
   * within this, in [0, 1] of a colour, not every pixel is traced. Default 0: every pixel is.
   * While the view moves it is 0.02 at least.
   */
  vtkSetClampMacro(CloudTolerance, double, 0.0, 1.0);
  vtkGetMacro(CloudTolerance, double);
  //@}

protected:
  vtkMoteShading();
  ~vtkMoteShading() override = default;

  int Mode = LOCAL;
  int AmbientOcclusion = OCCLUSION_NONE;
  int AmbientOcclusionSamples = 0;
  double AmbientOcclusionReach = 0.0;
  int BakeSide;
  int BakeSamples;
  vtkTypeBool BakeAdaptive;
  double BakeTolerance;
  int MaximumBounces = 16;
  double SkyTop[3] = {1.0, 1.0, 1.0};
  double SkyBottom[3] = {1.0, 1.0, 1.0};
  double SkyUp[3] = {0.0, 0.0, 1.0};
  double CloudTolerance = 0.0;

private:
  vtkMoteShading(const vtkMoteShading&) = delete;
  void operator=(const vtkMoteShading&) = delete;
};

#endif
