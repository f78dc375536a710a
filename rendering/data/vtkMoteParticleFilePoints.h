/**
 * @class   vtkMoteParticleFilePoints
 * @brief   points that stay in a .mote file
 *
 * The points of a data set that vtkMoteParticleFileReader gives: their coordinates are worked out
 * from the file's pages when they are asked for, and bounds are known without.
 *
 * A vtkMoteParticleMapper that meets such points draws the tree in the file itself; everybody else
 * sees points as any.
 */

#ifndef vtkMoteParticleFilePoints_h
#define vtkMoteParticleFilePoints_h

#include "MoteRenderingDataModule.h" // For export macro
#include "vtkMoteSourcePoints.h"

#include <memory> // For the file
#include <string> // For the form

class vtkDataArray;

namespace mote
{
class PkdTreeFile;
} // namespace mote

class MOTERENDERINGDATA_EXPORT vtkMoteParticleFilePoints : public vtkMoteSourcePoints
{
public:
  static vtkMoteParticleFilePoints* New();
  vtkTypeMacro(vtkMoteParticleFilePoints, vtkMoteSourcePoints);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The typical distance between neighbours as the file has it, in its unit of length; 0 where it
   * says nothing.
   */
  double GetSpacing();

  //@{
  /**
   * The form that the file keeps centres in (see vtkMoteParticleMapper::SetStructureForm()), and by
   * how much a coordinate may differ from what the file was made from. Empty and 0 for points that
   * lie in no file.
   */
  std::string GetForm();
  double GetPositionError();
  //@}

  /**
   * The bounds of the points, from the file's header.
   */
  void ComputeBounds() override;

#ifndef __VTK_WRAP__
  //@{
  /**
   * The file, which stays open as long as these points. Null for points that do not lie in one any
   * more: those that were copied into this object.
   */
  void SetFile(std::shared_ptr<const mote::PkdTreeFile> file);
  std::shared_ptr<const mote::PkdTreeFile> GetFile() const;
  //@}

  /**
   * Array `index` of the file's arrays(), or with `ofWhole` of its facts(): a view of the file's
   * memory with name, components' names and ranges, which keeps the file open. It must not be
   * written to. The caller owns the reference.
   */
  static vtkDataArray* NewArray(
    const std::shared_ptr<const mote::PkdTreeFile>& file, std::size_t index, bool ofWhole);
#endif

protected:
  vtkMoteParticleFilePoints();
  ~vtkMoteParticleFilePoints() override;

private:
  vtkMoteParticleFilePoints(const vtkMoteParticleFilePoints&) = delete;
  void operator=(const vtkMoteParticleFilePoints&) = delete;

  std::shared_ptr<const mote::PkdTreeFile> File;
};

#endif
