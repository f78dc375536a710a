/**
 * @class   vtkMoteMeshFilePoints
 * @brief   points of triangles that stay in a .mote file
 *
 * The points of a data set that vtkMoteMeshFileReader gives: they view the file, mapped into
 * memory, and their bounds are known without a look at them. They cannot be written to.
 *
 * A vtkMoteMeshMapper that meets such points, with the file's triangles and no others, draws the
 * tree in the file itself; everybody else sees points as any.
 */

#ifndef vtkMoteMeshFilePoints_h
#define vtkMoteMeshFilePoints_h

#include "MoteRenderingDataModule.h" // For export macro
#include "vtkPoints.h"

#include <memory> // For the file

class vtkPointSet;

namespace mote
{
class RlodTreeFile;
} // namespace mote

class MOTERENDERINGDATA_EXPORT vtkMoteMeshFilePoints : public vtkPoints
{
public:
  static vtkMoteMeshFilePoints* New();
  vtkTypeMacro(vtkMoteMeshFilePoints, vtkPoints);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  void SetFile(std::shared_ptr<const mote::RlodTreeFile> file);
  std::shared_ptr<const mote::RlodTreeFile> GetFile() const;
  //@}

  /**
   * The file whose points and triangles a data set has, all of them and nothing else; or null.
   */
  static std::shared_ptr<const mote::RlodTreeFile> FileOf(vtkPointSet* data);
#endif

protected:
  vtkMoteMeshFilePoints();
  ~vtkMoteMeshFilePoints() override;

private:
  vtkMoteMeshFilePoints(const vtkMoteMeshFilePoints&) = delete;
  void operator=(const vtkMoteMeshFilePoints&) = delete;

  std::shared_ptr<const mote::RlodTreeFile> File;
};

#endif
