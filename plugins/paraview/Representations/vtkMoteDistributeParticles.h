/**
 * @class   vtkMoteDistributeParticles
 * @brief   gives each rank the particles of one box, and copies of those beside it
 *
 * See vtkMoteDistribute. The input has points; the output has these and their arrays alone, no
 * cells.
 */

#ifndef vtkMoteDistributeParticles_h
#define vtkMoteDistributeParticles_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkMoteDistribute.h"

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteDistributeParticles : public vtkMoteDistribute
{
public:
  static vtkMoteDistributeParticles* New();
  vtkTypeMacro(vtkMoteDistributeParticles, vtkMoteDistribute);

protected:
  vtkMoteDistributeParticles() = default;
  ~vtkMoteDistributeParticles() override = default;
  vtkSmartPointer<vtkPolyData> Collect(const std::vector<vtkPointSet*>& parts) override;
  bool IsOfCells() const override { return false; }

private:
  vtkMoteDistributeParticles(const vtkMoteDistributeParticles&) = delete;
  void operator=(const vtkMoteDistributeParticles&) = delete;
};

#endif
