// The part of vtkMoteParticleMapper that says how particles look, and which are hidden.

#include "ParticleMapperInternals.h"

#include "ColorBridge.h"

#include "kernels/core/Error.h"
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
  const std::string quoted = "\"" + std::string(this->ArrayName) + "\"";
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

vtkDataArray* vtkMoteParticleMapper::FindVisibilityArray(int& component)
{
  vtkPointSet* input = this->GetInput();
  if (!this->VisibilityArrayName || !*this->VisibilityArrayName)
  {
    vtkDataArray* array = this->GetColorArray();
    if (!array)
      throw mote::Error("There is no array for the visibility range.");
    component = this->GetColorComponent(array);
    return array;
  }
  const std::string name = this->VisibilityArrayName;
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array)
    throw mote::Error("There is no point array \"" + name + "\" for the visibility range.");
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
    throw mote::Error(
      "The array \"" + name + "\" for the visibility range has not one tuple a point.");
  component = this->VisibilityComponent;
  if (component < -1 || component >= array->GetNumberOfComponents())
    throw mote::Error("The array \"" + name + "\" for the visibility range has no component " +
                      std::to_string(component) + ".");
  return array;
}

void vtkMoteParticleMapper::UpdateVisibility()
{
  Internals& impl = *this->Impl;
  if (!impl.structure)
    return;
  vtkDataArray* array = nullptr;
  int component = 0;
  std::string problem;
  try
  {
    if (this->UseVisibilityRange && this->GetInput()->GetNumberOfPoints() > 0)
      array = this->FindVisibilityArray(component);
  }
  catch (const mote::Error& error)
  {
    problem = error.what();
    if (problem != impl.arrayError)
      vtkErrorMacro(<< problem);
  }
  impl.arrayError = problem;
  mote::InputKey key;
  if (array)
  {
    key = {this->VisibilityRange[0], this->VisibilityRange[1], double(component)};
    mote::addArray(key, array);
  }
  if (key == impl.visibilityKey)
    return;
  impl.visibilityKey = key;
  impl.builtAt.Modified();
  const mote::DataArrayView values(array);
  const double low = this->VisibilityRange[0], high = this->VisibilityRange[1];
  std::visit(
    [&](auto& s)
    {
      if (!array)
        s.setVisibility({});
      else
        s.setVisibility(
          [&](std::size_t slot)
          {
            const double v = values.view.value(s.inputIndex(slot), component);
            return v >= low && v <= high;
          });
    },
    *impl.structure);
}

void vtkMoteParticleMapper::DescribeColors(mote::ParticleColoring& coloring)
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
