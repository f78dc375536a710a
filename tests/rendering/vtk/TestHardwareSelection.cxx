// What VTK's hardware selector is told, with and without a pass.
#include "WindowTestSupport.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMoteMeshMapper.h"
#include "vtkMoteRayCastPass.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <map>
#include <set>

using namespace mote::testing;

namespace
{

struct HardwareSelection : ::testing::TestWithParam<bool>
{
  static constexpr int width = 120, height = 90;
  std::vector<Ball> balls = someBalls(60);
  Drawing scene{width, height, false};

  HardwareSelection()
  {
    if (this->GetParam())
      scene.renderer->SetPass(vtkNew<vtkMoteRayCastPass>());
  }

  /// The ids that are selected, by prop.
  std::map<vtkProp*, std::set<vtkIdType>> select(int association)
  {
    scene.renderer->ResetCameraClippingRange();
    scene.shoot();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.renderer);
    selector->SetArea(0, 0, width - 1, height - 1);
    selector->SetFieldAssociation(association);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    std::map<vtkProp*, std::set<vtkIdType>> found;
    for (unsigned i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
      const auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
        found[prop].insert(ids->GetValue(k));
    }
    return found;
  }
};

} // namespace

TEST_P(HardwareSelection, NamesPointsOfParticlesThatAreSeen)
{
  auto actor = scene.addParticles(balls, {1, 0, 0});
  const auto found = this->select(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found.begin()->first, actor.Get());
  const Picture traced = trace(scene.renderer, width, height);
  std::set<vtkIdType> seen;
  for (const long long id : traced.particles())
    if (id >= 0)
      seen.insert(id);
  EXPECT_GT(seen.size(), 20u);
  EXPECT_EQ(found.begin()->second, seen);
}

TEST_P(HardwareSelection, LeavesGhostsToTheirRank)
{
  auto actor = scene.addParticles(balls, {1, 0, 0});
  auto* points = vtkPointSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < balls.size(); ++i)
    marks->InsertNextValue(i % 2 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  points->GetPointData()->AddArray(marks);
  const auto found = this->select(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found.begin()->second.size(), 10u);
  for (const vtkIdType id : found.begin()->second)
    EXPECT_EQ(id % 2, 0);
}

TEST_P(HardwareSelection, NamesCellsOfMeshes)
{
  auto particles = scene.addParticles({{-0.7, 0, 0, 0.5}}, {1, 0, 0});
  auto mesh = scene.addTriangles({{0.7, 0, 0, 0.5}}, {0, 1, 0});
  vtkNew<vtkMoteMeshMapper> mapper;
  mesh->GetMapper()->Update();
  mapper->SetInputDataObject(mesh->GetMapper()->GetInputDataObject(0, 0));
  mesh->SetMapper(mapper);
  const auto cells = this->select(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_TRUE(cells.count(mesh.Get()));
  const Picture traced = trace(scene.renderer, width, height);
  std::set<vtkIdType> seen;
  for (int pixel = 0; pixel < traced.count(); ++pixel)
    if (pixel % width > width / 2 && traced.particle(pixel) >= 0)
      seen.insert(traced.particle(pixel));
  EXPECT_GT(seen.size(), 10u);
  EXPECT_EQ(cells.at(mesh.Get()), seen);
}

INSTANTIATE_TEST_SUITE_P(Mappers, HardwareSelection, ::testing::Values(false, true),
  [](const auto& info) { return info.param ? std::string("InAPass") : std::string("Alone"); });
