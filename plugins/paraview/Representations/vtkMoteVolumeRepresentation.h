/**
 * @class   vtkMoteVolumeRepresentation
 * @brief   shows the cells of unstructured grids as a cloud, drawn by vtkMoteVolumeMapper
 *
 * Colours and opacities are those of ParaView's transfer function editor. No cell is cut into
 * tetrahedra.
 */

#ifndef vtkMoteVolumeRepresentation_h
#define vtkMoteVolumeRepresentation_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkNew.h"                            // For members
#include "vtkSmartPointer.h"                   // For members
#include "vtkVolumeRepresentation.h"

class vtkMoteVolumeMapper;
class vtkUnstructuredGrid;
class vtkVolume;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteVolumeRepresentation
  : public vtkVolumeRepresentation
{
public:
  static vtkMoteVolumeRepresentation* New();
  vtkTypeMacro(vtkMoteVolumeRepresentation, vtkVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  vtkDataObject* GetRenderedDataObject(int port) override;

  //@{
  /**
   * See vtkMoteVolumeMapper.
   */
  void SetIntegratorName(const char* name);
  void SetTolerance(double tolerance);
  void SetCloudTolerance(double tolerance);
  void SetSamplesPerPixel(int samples);
  //@}
  /// Whether the cloud is lit by its gradient.
  void SetShade(int shade);

protected:
  vtkMoteVolumeRepresentation();
  ~vtkMoteVolumeRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteVolumeRepresentation(const vtkMoteVolumeRepresentation&) = delete;
  void operator=(const vtkMoteVolumeRepresentation&) = delete;

  void FollowArray();

  vtkNew<vtkVolume> Volume;
  vtkNew<vtkMoteVolumeMapper> Mapper;
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< as of the last RequestData()
};

#endif
