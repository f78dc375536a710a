/**
 * @class   vtkMoteDistribute
 * @brief   gives each rank what lies in one box, and copies of what lies beside it
 *
 * Files are read by shares, so each rank may have something of everywhere. Filters of this kind cut
 * space into as many boxes as there are ranks, with as many particles or polygons in each, and send
 * every one to the rank of its box. Then each rank receives copies of what lies within
 * GhostDistance of its own: ghosts, of which nothing is drawn, but which keep light off, occlude
 * and have silhouettes. With them a picture of several ranks is that of one, as far as rays go no
 * farther. ParaView blends the ranks in the order of their boxes, so that several rays a pixel
 * leave no seams.
 *
 * A composite of several data sets counts as one. Ghosts are marked as duplicates in the array
 * vtkGhostType. On one rank there are none, and not that array. All ranks must execute it together.
 */

#ifndef vtkMoteDistribute_h
#define vtkMoteDistribute_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;
class vtkPointSet;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteDistribute : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkMoteDistribute, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Send particles or polygons to the rank of their box. On by default; where it is off they stay
   * where they were read.
   */
  vtkSetMacro(Redistribute, bool);
  vtkGetMacro(Redistribute, bool);

  /**
   * Copy what lies beside a rank's own. On by default.
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
  vtkMoteDistribute() = default;
  ~vtkMoteDistribute() override = default;

  /**
   * What of the input is distributed, without ghosts: the points of what is returned, or its cells,
   * which are polygons.
   */
  virtual vtkSmartPointer<vtkPolyData> Collect(const std::vector<vtkPointSet*>& parts) = 0;
  virtual bool IsOfCells() const = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMoteDistribute(const vtkMoteDistribute&) = delete;
  void operator=(const vtkMoteDistribute&) = delete;

  void Distribute(vtkMultiProcessController* controller, vtkDataObject* input, vtkPolyData* output);

  bool Redistribute = true;
  bool Ghosts = true;
  double GhostDistance = 0.0;
  bool ReleaseInput = false;
};

#endif
