#include "vtkMoteExpression.h"

#include "CellCorners.h"
#include "DataArrayView.h"
#include "ExpressionParser.h"
#include "FieldDerivatives.h"

#include "kernels/core/Error.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdlib>
#include <functional>

vtkStandardNewMacro(vtkMoteExpression);

namespace
{

/// A component of an array, or the magnitude of all.
struct Variable
{
  vtkDataArray* array = nullptr; ///< null: a coordinate
  int component = 0;             ///< or axis
  bool ofCells = false;
  mote::DataArrayView values{};
};

/// -2 where an array has no component of that name.
int componentNamed(vtkDataArray* array, const std::string& name)
{
  const int components = array->GetNumberOfComponents();
  if (name == "magnitude" || name == "mag")
    return mote::ArrayView::magnitude;
  for (int c = 0; c < components; ++c)
    if (array->GetComponentName(c) && name == array->GetComponentName(c))
      return c;
  const std::size_t axis = std::string("xyz").find(name);
  if (name.size() == 1 && axis != std::string::npos && static_cast<int>(axis) < components)
    return static_cast<int>(axis);
  char* end = nullptr;
  const long number = std::strtol(name.c_str(), &end, 10);
  return !name.empty() && *end == '\0' && number >= 0 && number < components
           ? static_cast<int>(number)
           : -2;
}

bool findVariable(vtkDataSetAttributes* attributes, const std::string& name, Variable& variable)
{
  const auto take = [&](vtkDataArray* array, int component)
  {
    variable.array = array;
    variable.component = component;
    return true;
  };
  if (vtkDataArray* array = attributes->GetArray(name.c_str()))
    return take(array, array->GetNumberOfComponents() > 1 ? mote::ArrayView::magnitude : 0);
  if (const std::size_t dot = name.rfind('.'); dot != std::string::npos)
    if (vtkDataArray* array = attributes->GetArray(name.substr(0, dot).c_str()))
      if (const int component = componentNamed(array, name.substr(dot + 1)); component != -2)
        return take(array, component);
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = attributes->GetArray(i))
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        if (array->GetComponentName(c) && name == array->GetComponentName(c))
          return take(array, c);
  return false;
}

std::string namesOf(vtkDataSet* data)
{
  std::string names;
  for (vtkDataSetAttributes* attributes : {static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData())})
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      if (vtkDataArray* array = attributes->GetArray(i); array && array->GetName())
        names += (names.empty() ? "" : ", ") + std::string(array->GetName());
  return names.empty() ? "none" : names;
}

/// A value of points, which may be a coordinate, or of cells.
bool findVariable(vtkDataSet* data, bool ofCells, const std::string& name, Variable& variable)
{
  const std::size_t axis = std::string("xyz").find(name);
  variable = {nullptr, static_cast<int>(axis), ofCells};
  if (!ofCells && name.size() == 1 && axis != std::string::npos)
    return true;
  return ofCells ? findVariable(data->GetCellData(), name, variable)
                 : findVariable(data->GetPointData(), name, variable);
}

[[noreturn]] void throwMissing(vtkDataSet* data, const std::string& name)
{
  throw mote::Error(
    "there is no array '" + name + "'; there are x, y, z of points, and " + namesOf(data));
}

/// All variables, each of points or else of cells. Throws Error.
std::vector<Variable> mixedVariablesOf(vtkDataSet* data, const std::vector<std::string>& names)
{
  std::vector<Variable> variables(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!findVariable(data, false, names[i], variables[i]) &&
        !findVariable(data, true, names[i], variables[i]))
      throwMissing(data, names[i]);
  return variables;
}

/// All variables, of points or else of cells. Throws Error.
std::vector<Variable> variablesOf(
  vtkDataSet* data, const std::vector<std::string>& names, bool& ofCells)
{
  std::vector<Variable> variables(names.size());
  std::string missing;
  for (const bool cells : {false, true})
  {
    ofCells = cells;
    bool complete = true;
    for (std::size_t i = 0; i < names.size() && complete; ++i)
    {
      complete = findVariable(data, cells, names[i], variables[i]);
      if (!complete && missing.empty())
        missing = names[i];
    }
    if (complete)
      return variables;
  }
  throwMissing(data, missing);
}

template <typename Array>
vtkSmartPointer<vtkDataArray> newArray(
  vtkIdType tuples, const std::function<void(std::size_t, std::size_t, double*)>& evaluate)
{
  using Value = typename Array::ValueType;
  const auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfTuples(tuples);
  Value* values = array->GetPointer(0);
  constexpr std::size_t block = mote::ExpressionParser::blockSize;
  tbb::parallel_for(
    tbb::blocked_range<std::size_t>(0, (static_cast<std::size_t>(tuples) + block - 1) / block),
    [&](const tbb::blocked_range<std::size_t>& blocks)
    {
      double results[block];
      for (std::size_t b = blocks.begin(); b != blocks.end(); ++b)
      {
        const std::size_t from = b * block;
        const std::size_t to = std::min(from + block, static_cast<std::size_t>(tuples));
        evaluate(from, to, results);
        for (std::size_t i = from; i < to; ++i)
          if constexpr (std::is_same_v<Value, unsigned char>)
            values[i] = results[i - from] != 0.0 && !std::isnan(results[i - from]) ? 1 : 0;
          else
            values[i] = static_cast<Value>(results[i - from]);
      }
    });
  return array;
}

/// What it is that an expression is computed for.
enum class Elements
{
  Either, ///< points, else cells
  Cells
};

/// The values of an expression without derivatives for all points or cells. Throws Error.
vtkSmartPointer<vtkDataArray> evaluated(
  vtkDataSet* data, const std::string& expression, int type, Elements of, bool& ofCells)
{
  const mote::ExpressionParser first(expression);
  ofCells = of == Elements::Cells;
  std::vector<Variable> variables =
    ofCells ? mixedVariablesOf(data, first.names()) : variablesOf(data, first.names(), ofCells);
  if (ofCells)
    mote::CellCorners::prepare(data);
  auto* points = vtkPointSet::SafeDownCast(data);
  for (Variable& variable : variables)
    if (variable.array)
      variable.values = mote::DataArrayView(variable.array);
    else if (points && points->GetPoints())
      variable.values = mote::DataArrayView(points->GetPoints()->GetData());
  const vtkIdType tuples = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  tbb::enumerable_thread_specific<mote::ExpressionParser> parsers(
    [&] { return mote::ExpressionParser(expression); });
  const auto evaluate = [&](std::size_t from, std::size_t to, double* results)
  {
    mote::ExpressionParser& parser = parsers.local();
    mote::CellCorners corners(data);
    for (std::size_t v = 0; v < variables.size(); ++v)
    {
      double* values = parser.values(v);
      const Variable& variable = variables[v];
      const auto valueAt = [&](vtkIdType i)
      {
        if (variable.values.owner)
          return variable.values.view.value(static_cast<std::size_t>(i), variable.component);
        double place[3]; // of a grid
        data->GetPoint(i, place);
        return place[variable.component];
      };
      const bool isMean = ofCells && !variable.ofCells;
      for (std::size_t i = from; i < to; ++i)
      {
        const auto id = static_cast<vtkIdType>(i);
        values[i - from] = isMean ? corners.mean(id, valueAt) : valueAt(id);
      }
    }
    parser.evaluate(results, static_cast<int>(to - from));
  };
  switch (type)
  {
  case VTK_UNSIGNED_CHAR:
    return newArray<vtkUnsignedCharArray>(tuples, evaluate);
  case VTK_FLOAT:
    return newArray<vtkFloatArray>(tuples, evaluate);
  case VTK_DOUBLE:
    return newArray<vtkDoubleArray>(tuples, evaluate);
  default:
    throw mote::Error("results are of type double, float or unsigned char, and of no other");
  }
}

/// At most so many bytes of UTF-8: an expression, or the names of all arrays, may be of any length.
std::string shortened(const std::string& text, std::size_t most)
{
  if (text.size() <= most)
    return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80)
    --most; // within a letter
  return text.substr(0, most) + "...";
}

std::string about(const std::string& expression, const mote::Error& error)
{
  return "'" + shortened(expression, 200) + "': " + shortened(error.what(), 2000);
}

} // namespace

vtkMoteExpression::vtkMoteExpression()
{
  this->SetResultArrayName("result");
}

vtkMoteExpression::~vtkMoteExpression()
{
  this->SetExpression(nullptr);
  this->SetResultArrayName(nullptr);
}

std::string vtkMoteExpression::Check(const std::string& expression)
{
  try
  {
    std::vector<mote::FieldDerivative> derivatives;
    const mote::ExpressionParser parser(mote::withoutDerivatives(expression, derivatives));
    return {};
  }
  catch (const mote::Error& error)
  {
    return about(expression, error);
  }
}

namespace
{

std::string addTo(
  vtkDataSet* data, const std::string& expression, const std::string& name, int type, Elements of)
{
  if (!data)
    return "there is no data set";
  try
  {
    bool ofCells = false;
    std::vector<mote::FieldDerivative> derivatives;
    const std::string plain = mote::withoutDerivatives(expression, derivatives);
    vtkSmartPointer<vtkDataSet> all = data;
    if (!derivatives.empty())
      all = mote::withArraysOf(data, derivatives);
    const auto array = evaluated(all, plain, type, of, ofCells);
    array->SetName(name.c_str());
    if (ofCells)
      data->GetCellData()->AddArray(array);
    else
      data->GetPointData()->AddArray(array);
    return {};
  }
  catch (const mote::Error& error)
  {
    return about(expression, error);
  }
}

} // namespace

std::string vtkMoteExpression::AddTo(
  vtkDataSet* data, const std::string& expression, const std::string& name, int type)
{
  return addTo(data, expression, name, type, Elements::Either);
}

std::string vtkMoteExpression::AddToCells(
  vtkDataSet* data, const std::string& expression, const std::string& name, int type)
{
  return addTo(data, expression, name, type, Elements::Cells);
}

int vtkMoteExpression::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkMoteExpression::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  output->ShallowCopy(input);
  const std::string problem = AddTo(output, this->Expression ? this->Expression : "",
    this->ResultArrayName ? this->ResultArrayName : "result", this->ResultType);
  if (problem.empty())
    return 1;
  vtkErrorMacro(<< problem);
  return 0;
}

void vtkMoteExpression::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Expression: " << (this->Expression ? this->Expression : "(none)") << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
  os << indent << "ResultType: " << this->ResultType << "\n";
}
