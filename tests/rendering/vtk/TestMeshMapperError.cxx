// vtkMoteMeshMapper where some pixels of error are allowed. It needs no display.
#include "MeshTestSupport.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cmath>

using namespace mote::testing;

TEST_F(MeshStage, PixelsOfErrorMakePlanesWhereNothingShowsThrough)
{
  vtkNew<vtkSphereSource> sphere; // far more triangles than pixels
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(400);
  sphere->SetPhiResolution(400);
  sphere->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(sphere->GetOutput());
  data->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkDoubleArray> stripes; // 0 and 1 by turns
  stripes->SetName("stripes");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    stripes->InsertNextValue(static_cast<double>(i % 2));
  data->GetCellData()->SetScalars(stripes);
  mapper->SetInputData(data);
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkLookupTable> grey;
  grey->SetSaturationRange(0, 0);
  grey->SetValueRange(0, 1);
  grey->SetRampToLinear();
  grey->SetRange(0, 1);
  mapper->SetLookupTable(grey);
  mapper->UseLookupTableScalarRangeOn();
  this->unlit();
  const auto spread = [&](const Picture& picture)
  {
    double sum = 0.0;
    for (int p = 0; p < size * size; ++p)
      if (picture.color(p)[3] > 0.0f)
        sum += std::abs(picture.color(p)[0] - 0.5);
    return sum / picture.covered();
  };
  const Picture exact = this->trace();
  const auto bytes = mapper->GetStructureBytes();
  EXPECT_GT(spread(exact), 0.45);

  mapper->SetPixelsOfError(4.0);
  const Picture rough = this->trace();
  EXPECT_LT(spread(rough), 0.25);
  EXPECT_GT(mapper->GetStructureBytes(), bytes);
  EXPECT_GE(rough.covered(), exact.covered());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    stripes->SetValue(i, 0.25);
  stripes->Modified();
  EXPECT_NEAR(spread(this->trace()), 0.25, 0.01) << "means follow the array";

  actor->GetProperty()->SetOpacity(0.5);
  const Picture clear = this->trace();
  mapper->SetPixelsOfError(0.0);
  const Picture clearExact = this->trace();
  for (int p = 0; p < size * size; ++p)
    for (int c = 0; c < 4; ++c)
      ASSERT_EQ(clear.color(p)[c], clearExact.color(p)[c]) << "what shows through is exact";
  mapper->SetPixelsOfError(-1.0);
  EXPECT_EQ(mapper->GetPixelsOfError(), 0.0);
}
