#include "FieldDerivatives.h"

#include "kernels/core/Error.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGradientFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cctype>

namespace mote
{

namespace
{

const std::vector<std::string> kinds = {"gradient", "vorticity", "divergence", "q_criterion"};

bool isOfName(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
}

std::string trimmed(const std::string& text)
{
  const auto from = text.find_first_not_of(" \t");
  return from == std::string::npos ? ""
                                   : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

/// The kind of a derivative whose name and opening bracket begin here; `at` goes behind the
/// bracket. Empty where none does.
std::string kindAt(const std::string& text, std::size_t& at)
{
  if (at > 0 && isOfName(text[at - 1]))
    return {};
  for (const std::string& kind : kinds)
  {
    const std::size_t bracket = text.find_first_not_of(' ', at + kind.size());
    if (text.compare(at, kind.size(), kind) != 0 || bracket == std::string::npos ||
        text[bracket] != '(')
      continue;
    at = bracket + 1;
    return kind;
  }
  return {};
}

/// Where what a quotation mark begins, or a bracket, ends.
std::size_t endOf(const std::string& text, std::size_t from, char mark)
{
  const std::size_t end = text.find(mark, from);
  if (end == std::string::npos)
    throw Error(std::string("a name has no ") + mark + " behind it");
  return end;
}

vtkSmartPointer<vtkDataArray> derivativeOf(
  vtkDataSet* data, const FieldDerivative& wanted, bool ofCells)
{
  vtkSmartPointer<vtkDataSet> shape;
  shape.TakeReference(data->NewInstance());
  shape->CopyStructure(data);
  const auto arraysOf = [ofCells](vtkDataSet* of)
  { return ofCells ? static_cast<vtkDataSetAttributes*>(of->GetCellData()) : of->GetPointData(); };
  arraysOf(shape)->AddArray(arraysOf(data)->GetArray(wanted.array.c_str()));
  vtkNew<vtkGradientFilter> filter;
  filter->SetInputData(shape);
  filter->SetInputScalars(
    ofCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    wanted.array.c_str());
  filter->SetComputeGradient(wanted.kind == "gradient");
  filter->SetComputeVorticity(wanted.kind == "vorticity");
  filter->SetComputeDivergence(wanted.kind == "divergence");
  filter->SetComputeQCriterion(wanted.kind == "q_criterion");
  filter->SetResultArrayName(wanted.name.c_str());
  filter->SetVorticityArrayName(wanted.name.c_str());
  filter->SetDivergenceArrayName(wanted.name.c_str());
  filter->SetQCriterionArrayName(wanted.name.c_str());
  filter->Update();
  return arraysOf(vtkDataSet::SafeDownCast(filter->GetOutput()))->GetArray(wanted.name.c_str());
}

} // namespace

std::string withoutDerivatives(const std::string& expression, std::vector<FieldDerivative>& found)
{
  std::string plain;
  for (std::size_t i = 0; i < expression.size();)
  {
    const char c = expression[i];
    std::size_t at = i;
    if (const std::string kind = kindAt(expression, at); !kind.empty())
    {
      at = expression.find_first_not_of(' ', at);
      const char mark = at == std::string::npos ? ' ' : expression[at];
      const bool isQuoted = mark == '\'' || mark == '"';
      const std::size_t from = isQuoted ? at + 1 : std::min(at, expression.size());
      const std::size_t end = endOf(expression, from, isQuoted ? mark : ')');
      const std::string array = isQuoted ? expression.substr(from, end - from)
                                         : trimmed(expression.substr(from, end - from));
      i = (isQuoted ? endOf(expression, end, ')') : end) + 1;
      const std::string name = kind + "(" + array + ")";
      const char quote = name.find('\'') == std::string::npos ? '\'' : '"';
      plain += quote + name + quote;
      if (std::none_of(found.begin(), found.end(),
            [&](const FieldDerivative& one) { return one.name == name; }))
        found.push_back({kind, array, name});
      continue;
    }
    const std::size_t end = c == '\'' || c == '"' ? expression.find(c, i + 1) : i;
    const std::size_t next = end == std::string::npos ? expression.size() : end + 1;
    plain += expression.substr(i, next - i);
    i = next;
  }
  return plain;
}

vtkSmartPointer<vtkDataSet> withArraysOf(
  vtkDataSet* data, const std::vector<FieldDerivative>& derivatives)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->ShallowCopy(data);
  for (const FieldDerivative& wanted : derivatives)
  {
    const bool ofCells = !data->GetPointData()->GetArray(wanted.array.c_str());
    vtkDataSetAttributes* arrays =
      ofCells ? static_cast<vtkDataSetAttributes*>(copy->GetCellData()) : copy->GetPointData();
    vtkDataArray* array = arrays->GetArray(wanted.array.c_str());
    if (!array)
      throw Error("there is no array '" + wanted.array + "' for " + wanted.name);
    if (wanted.kind != "gradient" && array->GetNumberOfComponents() != 3)
      throw Error(wanted.name + " needs an array with three components, and '" + wanted.array +
                  "' has " + std::to_string(array->GetNumberOfComponents()));
    if (data->GetNumberOfCells() == 0)
      throw Error(wanted.name + " needs cells, and there are none");
    const auto derived = derivativeOf(data, wanted, ofCells);
    if (!derived)
      throw Error(wanted.name + " could not be computed");
    arrays->AddArray(derived);
  }
  return copy;
}

} // namespace mote
