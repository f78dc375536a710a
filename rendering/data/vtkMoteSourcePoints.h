/**
 * @class   vtkMoteSourcePoints
 * @brief   points that nobody holds in memory
 *
 * The coordinates (double) come from a source, such as a generator or a file, whenever they are
 * asked for. Nothing is copied, so that there may be more points than memory has room for; only
 * GetVoidPointer(), as many filters of VTK call it, makes a copy of all, 24 bytes a point, when it
 * is first called.
 *
 * They cannot be changed. A vtkMoteParticleMapper that meets such points takes the source's radii
 * unless it is told others.
 */

#ifndef vtkMoteSourcePoints_h
#define vtkMoteSourcePoints_h

#include "MoteRenderingDataModule.h" // For export macro
#include "vtkPoints.h"

#include <memory> // For the source

namespace mote
{
class ParticleSource;
} // namespace mote

class MOTERENDERINGDATA_EXPORT vtkMoteSourcePoints : public vtkPoints
{
public:
  static vtkMoteSourcePoints* New();
  vtkTypeMacro(vtkMoteSourcePoints, vtkPoints);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The bounds of the points, for which all are looked at once.
   */
  void ComputeBounds() override;

#ifndef __VTK_WRAP__
  //@{
  /**
   * Where points come from. Null for points that do not come from there any more: those that were
   * copied into this object.
   */
  void SetSource(std::shared_ptr<const mote::ParticleSource> source);
  std::shared_ptr<const mote::ParticleSource> GetSource() const;
  //@}
#endif

protected:
  vtkMoteSourcePoints();
  ~vtkMoteSourcePoints() override;

private:
  vtkMoteSourcePoints(const vtkMoteSourcePoints&) = delete;
  void operator=(const vtkMoteSourcePoints&) = delete;
};

#endif
