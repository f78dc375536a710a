// Any text as an expression: it is computed, or there is one sentence.

#include "vtkMoteExpression.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const auto points = []
  {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> places;
    vtkNew<vtkDoubleArray> v;
    v->SetName("v");
    v->SetNumberOfComponents(3);
    for (int i = 0; i < 3; ++i)
    {
      places->InsertNextPoint(i, 2.0 * i, -i);
      v->InsertNextTuple3(i, 0.5, -1.0);
    }
    data->SetPoints(places);
    data->GetPointData()->AddArray(v);
    return vtkSmartPointer<vtkPolyData>(data);
  }();
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  const std::string problem = vtkMoteExpression::AddTo(points, text, "result");
  if (problem.empty() == !points->GetPointData()->HasArray("result"))
  {
    std::fprintf(stderr, "neither a result nor a sentence, or both: '%s'\n", problem.c_str());
    std::abort();
  }
  points->GetPointData()->RemoveArray("result");
  return 0;
}
