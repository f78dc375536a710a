/**
 * @class   vtkMoteParticleRepresentation
 * @brief   shows points as spheres, drawn by vtkMoteParticleMapper
 *
 * Cells of the input are of no account. Where a radius follows from the spacing of the points all
 * ranks take the same one: the mean over all points.
 */

#ifndef vtkMoteParticleRepresentation_h
#define vtkMoteParticleRepresentation_h

#include "vtkMoteActorRepresentation.h"

class vtkMoteParticleMapper;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteParticleRepresentation
  : public vtkMoteActorRepresentation
{
public:
  static vtkMoteParticleRepresentation* New();
  vtkTypeMacro(vtkMoteParticleRepresentation, vtkMoteActorRepresentation);

  //@{
  /**
   * See vtkMoteParticleMapper. Arrays are told as ParaView tells arrays to process: only the name
   * counts.
   */
  void SetRadiusMode(int mode);
  void SelectRadiusArray(int, int, int, int, const char* name);
  void SetRadius(double radius);
  void SetRadiusScale(double scale);
  void SetStructureName(const char* name);
  void SetSamplesPerPixel(int samples);
  void SetUseVisibilityRange(int on);
  void SelectVisibilityArray(int, int, int, int, const char* name);
  void SetVisibilityRange(double low, double high);
  void SetPixelsOfError(double pixels);
  //@}

protected:
  vtkMoteParticleRepresentation();
  ~vtkMoteParticleRepresentation() override;

  vtkMapper* GetMapper() override;
  vtkSmartPointer<vtkPointSet> Collect(const std::vector<vtkPointSet*>& parts) override;
  double GetReach() override;
  void Connect(vtkAlgorithmOutput* piece) override;

private:
  vtkMoteParticleRepresentation(const vtkMoteParticleRepresentation&) = delete;
  void operator=(const vtkMoteParticleRepresentation&) = delete;

  bool HasOwnRadii();
  double GetCommonSpacing();
  double GetLargestRadius();

  vtkNew<vtkMoteParticleMapper> Mapper;
  int RadiusMode = 0;
  double Radius = 0.5;
};

#endif
