#include "vtkMoteDistribute.h"

#include "BoxCuts.h"
#include "CommonSpacing.h"
#include "PointParts.h"
#include "RankBoxes.h"
#include "RankExchange.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace
{

using Place = mote::BoxCuts::Place;
using Ids = std::vector<vtkIdType>;

/// Places that tell where to cut, of all ranks together: counts of boxes are right to within about
/// half a percent.
constexpr vtkIdType placesInAll = 1 << 17;

/// Ghosts lie so far away where nothing else is said: this share of the longest side of all bounds,
/// or so many distances of neighbours where that is more.
constexpr double automaticShare = 0.12, automaticSpacings = 8.0;

/// The particles or polygons of a rank, as what they take up.
class Elements
{
public:
  Elements(vtkPolyData* data, bool areCells)
    : data_(data)
    , areCells_(areCells)
  {
  }

  vtkIdType count() const
  {
    return areCells_ ? data_->GetNumberOfCells() : data_->GetNumberOfPoints();
  }

  /// Cells are polygons alone. What vtkPolyData tells of cells has a table of them made first.
  vtkBoundingBox box(vtkIdType i) const
  {
    const vtkIdType* corners = &i;
    vtkIdType count = 1;
    if (areCells_)
      data_->GetPolys()->GetCellAtId(i, count, corners);
    vtkBoundingBox box;
    for (vtkIdType k = 0; k < count; ++k)
    {
      double place[3];
      data_->GetPoints()->GetPoint(corners[k], place);
      box.AddPoint(place);
    }
    return box;
  }

  Place place(vtkIdType i) const
  {
    Place middle;
    this->box(i).GetCenter(middle.data());
    return middle;
  }

private:
  vtkPolyData* data_;
  bool areCells_;
};

/// Places of all ranks, spread evenly over their elements.
std::vector<Place> gatherPlaces(vtkMultiProcessController* controller, const Elements& own)
{
  const int ranks = controller->GetNumberOfProcesses();
  vtkIdType count = own.count();
  std::vector<vtkIdType> counts(ranks), lengths(ranks), offsets(ranks);
  controller->AllGather(&count, counts.data(), 1);
  const vtkIdType total = std::accumulate(counts.begin(), counts.end(), vtkIdType(0));
  const vtkIdType step = total / placesInAll + 1;
  std::transform(counts.begin(), counts.end(), lengths.begin(),
    [&](vtkIdType n) { return 3 * ((n + step - 1) / step); });
  std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), vtkIdType(0));
  std::vector<Place> mine, all((offsets.back() + lengths.back()) / 3);
  for (vtkIdType i = 0; i < count; i += step)
    mine.push_back(own.place(i));
  controller->AllGatherV(mine.empty() ? nullptr : mine.front().data(),
    all.empty() ? nullptr : all.front().data(), static_cast<vtkIdType>(3 * mine.size()),
    lengths.data(), offsets.data());
  return all;
}

/// The box, so much larger on all sides.
vtkBoundingBox around(vtkBoundingBox box, double distance)
{
  if (box.IsValid())
    box.Inflate(distance);
  return box;
}

bool isWithin(const vtkBoundingBox& element, const vtkBoundingBox& box, double distance)
{
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double low = box.GetMinPoint()[c] - element.GetMaxPoint()[c];
    const double high = element.GetMinPoint()[c] - box.GetMaxPoint()[c];
    const double away = std::max({low, high, 0.0});
    sum += away * away;
  }
  return sum <= distance * distance;
}

/// The boxes of all ranks, grown by what their own elements reach out of them, wherever these are
/// now. All ranks must ask together.
std::vector<vtkBoundingBox> withElements(vtkMultiProcessController* controller,
  std::vector<vtkBoundingBox> boxes, const Elements& own, const std::vector<int>& owners)
{
  for (vtkIdType i = 0; i < own.count(); ++i)
    boxes[owners[i]].AddBox(own.box(i));
  std::vector<double> mine, all(6 * boxes.size());
  for (const vtkBoundingBox& box : boxes)
    for (int c = 0; c < 3; ++c)
      mine.insert(mine.end(), {-box.GetMinPoint()[c], box.GetMaxPoint()[c]});
  controller->AllReduce(
    mine.data(), all.data(), static_cast<vtkIdType>(mine.size()), vtkCommunicator::MAX_OP);
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
  {
    const double* of = &all[6 * rank];
    boxes[rank] = vtkBoundingBox(-of[0], of[1], -of[2], of[3], -of[4], of[5]);
  }
  return boxes;
}

/// The ranks whose boxes may have elements of this one within the distance.
Ids neighborsOf(int mine, const std::vector<vtkBoundingBox>& held,
  const std::vector<vtkBoundingBox>& boxes, double distance)
{
  Ids neighbors;
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    if (const vtkBoundingBox box = around(boxes[rank], distance);
        box.IsValid() && held[mine].IsValid() && box.Intersects(held[mine]))
      neighbors.push_back(static_cast<vtkIdType>(rank));
  return neighbors;
}

/// Frees what the sources and filters before this one hold. Data that a pipeline was given, and
/// cannot make anew, stay.
void releaseUpstream(vtkAlgorithm* consumer)
{
  for (int port = 0; port < consumer->GetNumberOfInputPorts(); ++port)
    for (int i = 0; i < consumer->GetNumberOfInputConnections(port); ++i)
    {
      int output = 0;
      vtkAlgorithm* producer = consumer->GetInputAlgorithm(port, i, output);
      if (!producer || vtkTrivialProducer::SafeDownCast(producer))
        continue;
      releaseUpstream(producer);
      if (vtkDataObject* data = producer->GetOutputDataObject(output))
        data->ReleaseData();
    }
}

} // namespace

int vtkMoteDistribute::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  // Taken whole: ranks may have different numbers of parts, and all must do the same.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkMoteDistribute::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkNew<vtkFieldData> fields; // now, as the input may be freed
  if (input)
    fields->ShallowCopy(input->GetFieldData());
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
    this->Distribute(controller, input, output);
  else
    output->ShallowCopy(this->Collect(mote::pointSetsOf(input)));
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    if (const char* name = fields->GetArrayName(i);
        !name || !output->GetFieldData()->HasArray(name))
      output->GetFieldData()->AddArray(fields->GetAbstractArray(i));
  return 1;
}

void vtkMoteDistribute::Distribute(
  vtkMultiProcessController* controller, vtkDataObject* input, vtkPolyData* output)
{
  auto data = this->Collect(mote::pointSetsOf(input));
  const bool ofCells = this->IsOfCells();
  const Elements elements(data, ofCells);
  const int ranks = controller->GetNumberOfProcesses(), mine = controller->GetLocalProcessId();
  // In the order of the file; polygons have none.
  const double spacing = ofCells ? 0.0 : mote::commonSpacingOf(data);
  const auto held = mote::gatherBoxes(controller, mote::ownBoundsOf(data));
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : held)
    all.AddBox(box);
  if (!all.IsValid())
    return; // no rank has any
  auto boxes = held;
  std::vector<int> owners(elements.count(), mine);
  if (this->Redistribute)
  {
    const mote::BoxCuts cuts(gatherPlaces(controller, elements), all, ranks);
    for (int rank = 0; rank < ranks; ++rank)
      boxes[rank] = cuts.bounds(rank);
    for (vtkIdType i = 0; i < elements.count(); ++i)
      owners[i] = cuts.boxOf(elements.place(i).data());
  }
  const vtkBoundingBox box = boxes[mine];
  if (ofCells)
    boxes = withElements(controller, std::move(boxes), elements, owners);
  const double distance = this->GhostDistance > 0.0 ? this->GhostDistance
                                                    : std::max(automaticShare * all.GetMaxLength(),
                                                        automaticSpacings * spacing);
  const Ids neighbors = this->Ghosts ? neighborsOf(mine, held, boxes, distance) : Ids{};
  mote::RankShares shares(ranks, ofCells);
  for (vtkIdType i = 0; i < elements.count(); ++i)
  {
    shares.own[owners[i]].push_back(i);
    const vtkBoundingBox element = elements.box(i);
    for (const vtkIdType rank : neighbors)
      if (rank != owners[i] && isWithin(element, boxes[rank], distance))
        shares.ghosts[rank].push_back(i);
  }
  owners = {};
  const auto whenSent = [this]
  {
    if (this->ReleaseInput)
      releaseUpstream(this);
  };
  output->ShallowCopy(
    mote::exchange(controller, std::move(data), std::move(shares), this->Ghosts, whenSent));
  if (!ofCells)
    mote::keepSpacing(spacing, output);
  if (this->Redistribute && box.IsValid())
    mote::keepBox(box, output);
}

void vtkMoteDistribute::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Redistribute: " << (this->Redistribute ? "On" : "Off") << "\n";
  os << indent << "Ghosts: " << (this->Ghosts ? "On" : "Off") << "\n";
  os << indent << "GhostDistance: " << this->GhostDistance << "\n";
  os << indent << "ReleaseInput: " << (this->ReleaseInput ? "On" : "Off") << "\n";
}
