#include "Flow.h"

#include "settings/Colors.h"

#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <utility>

namespace mote::app
{

Flow::Flow(const Settings& settings)
  : settings_(settings)
{
  for (Drawn* drawn : {&lines_, &arrows_})
  {
    drawn->actor->SetMapper(drawn->mapper);
    drawn->actor->PickableOff(); // else its triangles would be taken for cells
    drawn->actor->VisibilityOff();
  }
}

bool Flow::areOther(const Settings& a, const Settings& b)
{
  const bool onSlices = a.flow.arrows > 0 && a.flow.arrowsOn == "slices";
  return (isAny(a) || isAny(b)) &&
         (a.flow != b.flow || a.selection != b.selection || a.volume.turns != b.volume.turns ||
           a.cuts.axis != b.cuts.axis ||
           (onSlices && (a.volume.slices != b.volume.slices || a.volume.unroll != b.volume.unroll ||
                          a.volume.repeatAround != b.volume.repeatAround)));
}

void Flow::clear()
{
  this->show({});
}

void Flow::show(const BuiltFlow& built)
{
  built_ = built;
  this->draw(lines_, built_.lines);
  this->draw(arrows_, built_.arrows);
}

void Flow::build(const std::vector<std::unique_ptr<Part>>& parts, const Runner& runner)
{
  const BuiltFlow offered = std::exchange(offered_, {});
  const FlowKey key = FlowKey::of(parts, settings_);
  if (key == built_.key)
    return;
  this->clear();
  if (!key.isEmpty())
    this->show(offered.key == key ? offered : finder_.find(parts, settings_, runner));
}

/// Null: nothing.
void Flow::draw(Drawn& drawn, vtkPolyData* triangles)
{
  vtkNew<vtkPolyData> own;
  if (triangles)
    own->ShallowCopy(triangles);
  drawn.mapper->SetInputData(own);
  drawn.actor->SetVisibility(own->GetNumberOfCells() > 0);
  this->color(drawn);
}

void Flow::color(Drawn& drawn)
{
  Color plain{};
  parseColor(settings_.color.plain, plain);
  vtkProperty* look = drawn.actor->GetProperty();
  look->SetColor(plain.data());
  look->SetAmbient(ambient_);
  look->SetDiffuse(0.75);
  look->SetSpecular(0.0);
  const bool isColored = choice_ && drawn.mapper->GetInput() &&
                         drawn.mapper->GetInput()->GetPointData()->GetArray(choice_.name.c_str());
  drawn.mapper->SetScalarVisibility(isColored);
  if (!isColored)
    return;
  drawn.mapper->SetScalarModeToUsePointFieldData();
  drawn.mapper->SelectColorArray(choice_.name.c_str());
  drawn.mapper->SetLookupTable(table_);
  drawn.mapper->UseLookupTableScalarRangeOn();
}

void Flow::setAmbient(double ambient)
{
  ambient_ = ambient;
  for (Drawn* drawn : {&lines_, &arrows_})
    drawn->actor->GetProperty()->SetAmbient(ambient);
}

void Flow::setColors(const ArrayChoice& choice, vtkLookupTable* table)
{
  choice_ = choice;
  table_ = table;
  for (Drawn* drawn : {&lines_, &arrows_})
    this->color(*drawn);
}

void Flow::setCuts(const Cuts& cuts)
{
  const CutAxis axis = cutAxisOf(settings_.cuts.axis);
  for (Drawn* drawn : {&lines_, &arrows_})
  {
    drawn->mapper->SetClippingPlanes(cuts.planes());
    drawn->mapper->SetClipCylinder(cuts.cylinder());
    // Those on slices lie on all of these already.
    const bool isEverywhere = drawn == &arrows_ && settings_.flow.arrowsOn == "slices";
    drawn->mapper->SetRepetitions(isEverywhere ? 1 : settings_.volume.repeatAround);
    drawn->mapper->SetRepetitionCenter(axis.point.data());
    drawn->mapper->SetRepetitionAxis(axis.direction.data());
    drawn->mapper->TurnVectorsOn();
  }
}

vtkIdType Flow::numberOfLines() const
{
  return lines_.actor->GetVisibility() ? built_.numberOfLines : 0;
}

} // namespace mote::app
