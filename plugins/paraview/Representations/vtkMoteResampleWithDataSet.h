/**
 * @class   vtkMoteResampleWithDataSet
 * @brief   values of hexahedral meshes at the points of another data set
 *
 * ParaView's own filter, on one rank or several, with Mote's hierarchy to find the cells: hexahedra
 * that are twisted count as they are. See vtkMoteCylindricalLocator.
 */

#ifndef vtkMoteResampleWithDataSet_h
#define vtkMoteResampleWithDataSet_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkPResampleWithDataSet.h"

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteResampleWithDataSet : public vtkPResampleWithDataSet
{
public:
  static vtkMoteResampleWithDataSet* New();
  vtkTypeMacro(vtkMoteResampleWithDataSet, vtkPResampleWithDataSet);

protected:
  vtkMoteResampleWithDataSet();
  ~vtkMoteResampleWithDataSet() override;

private:
  vtkMoteResampleWithDataSet(const vtkMoteResampleWithDataSet&) = delete;
  void operator=(const vtkMoteResampleWithDataSet&) = delete;
};

#endif
