/**
 * @class   vtkMoteDistributeParticles
 * @brief   gives each rank the particles of one box, and copies of those beside it
 *
 * Files are read by shares of their lines, so each rank may have particles from everywhere. This
 * filter cuts space into as many boxes as there are ranks, with as many particles in each, and
 * sends every particle to the rank of its box. Then each rank receives copies of the particles
 * within GhostDistance of its own: ghosts, which vtkMoteParticleMapper draws nothing of, but which
 * keep light off, occlude and have silhouettes. With them a picture of several ranks is that of
 * one, as far as rays go no farther. ParaView blends the ranks in the order of their boxes, so that
 * several rays a pixel leave no seams.
 *
 * The input has points; a composite of several counts as one. The output has points and their
 * arrays alone, no cells; ghosts come last, and are marked as duplicates in the array vtkGhostType.
 * On one rank all stay as they are, without that array. All ranks must execute it together.
 */

#ifndef vtkMoteDistributeParticles_h
#define vtkMoteDistributeParticles_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMultiProcessController;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteDistributeParticles : public vtkPolyDataAlgorithm
{
public:
  static vtkMoteDistributeParticles* New();
  vtkTypeMacro(vtkMoteDistributeParticles, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Send particles to the rank of their box. On by default; where it is off they stay where they
   * were read.
   */
  vtkSetMacro(Redistribute, bool);
  vtkGetMacro(Redistribute, bool);

  /**
   * Copy what lies beside a rank's own particles. On by default.
   */
  vtkSetMacro(Ghosts, bool);
  vtkGetMacro(Ghosts, bool);

  /**
   * How far from the box of a rank ghosts lie, in world units. 0, the default,
   * stands for 0.12 of the longest side of all points' bounds (a tenth, which ambient occlusion
   * reaches by itself, and something for radii), or eight times the distance of neighbours where
   * that is more (silhouettes tell steps of depth of five of these from smaller ones by
   * themselves).
   */
  vtkSetClampMacro(GhostDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GhostDistance, double);

  /**
   * Free what the readers and filters before this one hold, once it has been sent. They
   * execute again where something else asks for it; data of a vtkTrivialProducer stay. Off by
   * default.
   */
  vtkSetMacro(ReleaseInput, bool);
  vtkGetMacro(ReleaseInput, bool);

protected:
  vtkMoteDistributeParticles() = default;
  ~vtkMoteDistributeParticles() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMoteDistributeParticles(const vtkMoteDistributeParticles&) = delete;
  void operator=(const vtkMoteDistributeParticles&) = delete;

  void Distribute(vtkMultiProcessController* controller, vtkDataObject* input, vtkPolyData* output);

  bool Redistribute = true;
  bool Ghosts = true;
  double GhostDistance = 0.0;
  bool ReleaseInput = false;
};

#endif
