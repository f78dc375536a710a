/**
 * @class   vtkMoteMeshRepresentation
 * @brief   shows polygons and the cells of surfaces, drawn by vtkMoteMeshMapper
 */

#ifndef vtkMoteMeshRepresentation_h
#define vtkMoteMeshRepresentation_h

#include "vtkMoteActorRepresentation.h"

class vtkMoteMeshMapper;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteMeshRepresentation
  : public vtkMoteActorRepresentation
{
public:
  static vtkMoteMeshRepresentation* New();
  vtkTypeMacro(vtkMoteMeshRepresentation, vtkMoteActorRepresentation);

  //@{
  /**
   * See vtkMoteMeshMapper.
   */
  void SetSamplesPerPixel(int samples);
  void SetPixelsOfError(double pixels);
  //@}

protected:
  vtkMoteMeshRepresentation();
  ~vtkMoteMeshRepresentation() override;

  vtkMapper* GetMapper() override;
  vtkSmartPointer<vtkPointSet> Collect(const std::vector<vtkPointSet*>& parts) override;
  void Connect(vtkAlgorithmOutput* piece) override;

private:
  vtkMoteMeshRepresentation(const vtkMoteMeshRepresentation&) = delete;
  void operator=(const vtkMoteMeshRepresentation&) = delete;

  vtkNew<vtkMoteMeshMapper> Mapper;
};

#endif
