#include "vtkMoteDistributeParticles.h"

#include "BoxCuts.h"
#include "CommonSpacing.h"
#include "ParticleExchange.h"
#include "PointParts.h"
#include "RankBoxes.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMoteDistributeParticles);

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

/// Places of all ranks, spread evenly over their particles.
std::vector<Place> gatherPlaces(vtkMultiProcessController* controller, vtkPolyData* own)
{
  const int ranks = controller->GetNumberOfProcesses();
  vtkIdType count = own->GetNumberOfPoints();
  std::vector<vtkIdType> counts(ranks), lengths(ranks), offsets(ranks);
  controller->AllGather(&count, counts.data(), 1);
  const vtkIdType total = std::accumulate(counts.begin(), counts.end(), vtkIdType(0));
  const vtkIdType step = total / placesInAll + 1;
  std::transform(counts.begin(), counts.end(), lengths.begin(),
    [&](vtkIdType n) { return 3 * ((n + step - 1) / step); });
  std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), vtkIdType(0));
  std::vector<Place> mine, all((offsets.back() + lengths.back()) / 3);
  for (vtkIdType i = 0; i < count; i += step)
    own->GetPoint(i, mine.emplace_back().data());
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

bool isWithin(const double* place, const vtkBoundingBox& box, double distance)
{
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double low = box.GetMinPoint()[c] - place[c], high = place[c] - box.GetMaxPoint()[c];
    const double away = std::max({low, high, 0.0});
    sum += away * away;
  }
  return sum <= distance * distance;
}

/// The ranks whose boxes may have particles of this one within the distance.
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

int vtkMoteDistributeParticles::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  // Taken whole: ranks may have different numbers of parts, and all must do the same.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkMoteDistributeParticles::RequestData(
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
    output->ShallowCopy(mote::collectPoints(mote::pointSetsOf(input)));
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    output->GetFieldData()->AddArray(fields->GetAbstractArray(i));
  return 1;
}

void vtkMoteDistributeParticles::Distribute(
  vtkMultiProcessController* controller, vtkDataObject* input, vtkPolyData* output)
{
  auto points = mote::withoutGhosts(mote::collectPoints(mote::pointSetsOf(input)));
  const int ranks = controller->GetNumberOfProcesses(), mine = controller->GetLocalProcessId();
  const double spacing = mote::commonSpacingOf(points); // in the order of the file
  const auto held = mote::gatherBoxes(controller, mote::ownBoundsOf(points));
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : held)
    all.AddBox(box);
  if (!all.IsValid())
    return; // no rank has any
  auto boxes = held;
  std::unique_ptr<mote::BoxCuts> cuts;
  if (this->Redistribute)
  {
    cuts = std::make_unique<mote::BoxCuts>(gatherPlaces(controller, points), all, ranks);
    for (int rank = 0; rank < ranks; ++rank)
      boxes[rank] = cuts->bounds(rank);
  }
  const double distance = this->GhostDistance > 0.0 ? this->GhostDistance
                                                    : std::max(automaticShare * all.GetMaxLength(),
                                                        automaticSpacings * spacing);
  const Ids neighbors = this->Ghosts ? neighborsOf(mine, held, boxes, distance) : Ids{};
  mote::ParticleShares shares(ranks);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double place[3];
    points->GetPoint(i, place);
    const int owner = cuts ? cuts->boxOf(place) : mine;
    shares.own[owner].push_back(i);
    for (const vtkIdType rank : neighbors)
      if (rank != owner && isWithin(place, boxes[rank], distance))
        shares.ghosts[rank].push_back(i);
  }
  const auto whenSent = [this]
  {
    if (this->ReleaseInput)
      releaseUpstream(this);
  };
  output->ShallowCopy(mote::exchangeParticles(
    controller, std::move(points), std::move(shares), this->Ghosts, whenSent));
  mote::keepSpacing(spacing, output);
  if (cuts && boxes[mine].IsValid())
    mote::keepBox(boxes[mine], output);
}

void vtkMoteDistributeParticles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Redistribute: " << (this->Redistribute ? "On" : "Off") << "\n";
  os << indent << "Ghosts: " << (this->Ghosts ? "On" : "Off") << "\n";
  os << indent << "GhostDistance: " << this->GhostDistance << "\n";
  os << indent << "ReleaseInput: " << (this->ReleaseInput ? "On" : "Off") << "\n";
}
