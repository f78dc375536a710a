#include "vtkMoteResampleWithDataSet.h"

#include "vtkMoteCylindricalLocator.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteResampleWithDataSet);

vtkMoteResampleWithDataSet::vtkMoteResampleWithDataSet()
{
  vtkNew<vtkMoteCylindricalLocator> locator;
  locator->SetStructureName("cartbvh"); // needs no axis
  this->SetCellLocatorPrototype(locator);
}

vtkMoteResampleWithDataSet::~vtkMoteResampleWithDataSet() = default;
