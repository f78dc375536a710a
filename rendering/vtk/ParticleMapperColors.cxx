// The part of vtkMoteParticleMapper that says how particles look.

#include "ParticleMapperInternals.h"

#include "ColorBridge.h"
#include "Names.h"

#include "kernels/scene/Scene.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkDataArray* vtkMoteParticleMapper::GetColorArray()
{
  vtkPointSet* input = this->GetInput();
  if (!input || !this->ScalarVisibility)
    return nullptr;
  int cellFlag = 0;
  auto* array = vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  // Cells are not particles: only arrays with a tuple for every point can colour them.
  if (!array || cellFlag == 1 || array->GetNumberOfTuples() != input->GetNumberOfPoints())
    return nullptr;
  return array;
}

std::string vtkMoteParticleMapper::WhyNoColorArray()
{
  const bool named = this->ScalarVisibility && this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME &&
                     this->ArrayName && *this->ArrayName &&
                     this->ScalarMode >= VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  vtkPointSet* input = this->GetInput();
  if (!named || !input || input->GetNumberOfPoints() == 0)
    return {};
  vtkPointData* data = input->GetPointData();
  std::string quoted = "\"";
  quoted.append(this->ArrayName).append("\"");
  if (data->HasArray(this->ArrayName))
    return "The point array " + quoted + " cannot colour particles: it is text, or was asked for " +
           "as something else than point data.";
  return "There is no point array " + quoted +
         " to colour by; there are: " + mote::arrayNames(data) + ".";
}

int vtkMoteParticleMapper::GetColorComponent(vtkDataArray* array)
{
  vtkScalarsToColors* colors = this->GetLookupTable();
  if (array->GetNumberOfComponents() == 1)
    return 0;
  if (colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
    return mote::ArrayView::magnitude;
  const int component =
    this->ArrayComponent > 0 ? this->ArrayComponent : colors->GetVectorComponent();
  return std::clamp(component, 0, array->GetNumberOfComponents() - 1);
}

double vtkMoteParticleMapper::GetParticleValue(vtkIdType id)
{
  vtkDataArray* array = this->GetColorArray();
  if (!array || id < 0 || id >= array->GetNumberOfTuples())
    return vtkMath::Nan();
  const int component = this->GetColorComponent(array);
  if (component >= 0)
    return array->GetComponent(id, component);
  const double* tuple = array->GetTuple(id);
  return std::sqrt(std::inner_product(tuple, tuple + array->GetNumberOfComponents(), tuple, 0.0));
}

void vtkMoteParticleMapper::GetColorArrayRange(double range[2])
{
  range[0] = 1.0;
  range[1] = 0.0;
  if (vtkDataArray* array = this->GetColorArray())
    array->GetFiniteRange(range, this->GetColorComponent(array));
}

void vtkMoteParticleMapper::DescribeColors(mote::SurfaceColoring& coloring)
{
  Internals& impl = *this->Impl;
  vtkDataArray* array = this->GetColorArray();
  const std::string problem = array ? "" : this->WhyNoColorArray();
  if (!problem.empty() && problem != impl.reportedColors)
    vtkErrorMacro(<< problem);
  impl.reportedColors = problem;
  if (!array)
    return;
  vtkScalarsToColors* colors = this->GetLookupTable(); // creates the default one
  if (!this->UseLookupTableScalarRange)
    colors->SetRange(this->ScalarRange);
  const bool bytes = vtkUnsignedCharArray::SafeDownCast(array) != nullptr;
  const bool direct = this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
                      (this->ColorMode == VTK_COLOR_MODE_DEFAULT && bytes);
  const bool vectorColors =
    array->GetNumberOfComponents() > 1 && colors->GetVectorMode() == vtkScalarsToColors::RGBCOLORS;
  // Arrays that are not one piece of memory are copied: once, not every frame.
  mote::InputKey valuesKey;
  mote::addArray(valuesKey, array);
  if (valuesKey != impl.colorValuesKey)
  {
    impl.colorValues = mote::DataArrayView(array);
    impl.colorValuesKey = valuesKey;
  }
  if (direct && bytes)
  {
    coloring.direct = impl.colorValues.view;
    return;
  }
  if (!direct && !vectorColors && mote::toColorMap(colors, coloring.map))
  {
    coloring.values = impl.colorValues.view;
    coloring.component = this->GetColorComponent(array);
    return;
  }
  // What only VTK itself can map: annotated values, floating point colours, vectors as colours.
  const int component = vectorColors ? -1 : this->GetColorComponent(array);
  mote::InputKey key = {double(colors->GetMTime()), double(this->ColorMode), double(component)};
  mote::addArray(key, array);
  if (key != impl.directKey)
  {
    impl.directColors.TakeReference(colors->MapScalars(array, this->ColorMode, component));
    impl.directKey = key;
  }
  coloring.direct = mote::DataArrayView(impl.directColors).view;
}
