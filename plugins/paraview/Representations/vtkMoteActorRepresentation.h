/**
 * @class   vtkMoteActorRepresentation
 * @brief   what representations that draw with an actor have in common
 *
 * Takes point sets and composite data of them, keeps what is to be drawn as one data set, and hands
 * the colour array, ParaView's colour map and the look of the actor on to the mapper, which a
 * subclass gives. Nothing is cut into triangles or moved between the pipeline and the mapper.
 */

#ifndef vtkMoteActorRepresentation_h
#define vtkMoteActorRepresentation_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkNew.h"                            // For members
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // For members

#include <vector> // For parts

class vtkActor;
class vtkMapper;
class vtkAlgorithmOutput;
class vtkPointSet;
class vtkScalarsToColors;

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteActorRepresentation : public vtkPVDataRepresentation
{
public:
  vtkTypeMacro(vtkMoteActorRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  vtkDataObject* GetRenderedDataObject(int port) override;

  //@{
  /**
   * Handed on to the mapper.
   */
  void SetLookupTable(vtkScalarsToColors* colors);
  void SetMapScalars(int map);
  //@}

  //@{
  /**
   * Handed on to the actor and its property.
   */
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetPickable(int pickable);
  void SetAmbientColor(double r, double g, double b);
  void SetDiffuseColor(double r, double g, double b);
  void SetSpecularColor(double r, double g, double b);
  void SetOpacity(double opacity);
  void SetAmbient(double share);
  void SetDiffuse(double share);
  void SetSpecular(double share);
  void SetSpecularPower(double power);
  //@}

protected:
  vtkMoteActorRepresentation();
  ~vtkMoteActorRepresentation() override;

  /// The mapper that draws.
  virtual vtkMapper* GetMapper() = 0;
  /// One data set of what the input holds, which may be nothing; never null.
  virtual vtkSmartPointer<vtkPointSet> Collect(const std::vector<vtkPointSet*>& parts) = 0;
  /// How far what is drawn reaches beyond its points. Called on all ranks, in the same order.
  virtual double GetReach() { return 0.0; }

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkNew<vtkActor> Actor;
  /// Has the mapper draw what the view has delivered.
  virtual void Connect(vtkAlgorithmOutput* piece);
  bool IsTranslucent();

  vtkSmartPointer<vtkPointSet> Drawn; ///< as of the last RequestData()
  bool HaveBoxesAndGhosts = false;    ///< all ranks together

private:
  vtkMoteActorRepresentation(const vtkMoteActorRepresentation&) = delete;
  void operator=(const vtkMoteActorRepresentation&) = delete;

  void TellBounds(vtkInformation* inInfo, vtkInformation* outInfo);
  void FollowColors();
};

#endif
