/**
 * @class   vtkMoteImageSilhouettes
 * @brief   silhouettes of depth images, with all that they are in properties of one filter
 *
 * See vtkMoteSilhouetteFilter and vtkMoteSilhouettes. To begin with depths are those of an
 * orthographic view, such as heights of a terrain.
 */

#ifndef vtkMoteImageSilhouettes_h
#define vtkMoteImageSilhouettes_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkMoteSilhouetteFilter.h"

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteImageSilhouettes : public vtkMoteSilhouetteFilter
{
public:
  static vtkMoteImageSilhouettes* New();
  vtkTypeMacro(vtkMoteImageSilhouettes, vtkMoteSilhouetteFilter);

  /**
   * The array of depths, as ParaView tells it; all but its name is passed over.
   */
  void SelectDepthArray(int, int, int, int, const char* name);

  //@{
  /**
   * See vtkMoteSilhouettes.
   */
  void SetThreshold(double step);
  void SetThresholdMode(int mode);
  void SetThickness(double pixels);
  void SetHulls(int on);
  //@}

protected:
  vtkMoteImageSilhouettes();
  ~vtkMoteImageSilhouettes() override;

private:
  vtkMoteImageSilhouettes(const vtkMoteImageSilhouettes&) = delete;
  void operator=(const vtkMoteImageSilhouettes&) = delete;
};

#endif
