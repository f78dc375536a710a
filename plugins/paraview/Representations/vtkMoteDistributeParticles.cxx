#include "vtkMoteDistributeParticles.h"

#include "BoxCuts.h"
#include "CommonSpacing.h"
#include "DataParts.h"
#include "PointParts.h"
#include "RankBoxes.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkMoteDistributeParticles);

namespace
{

using Place = mote::BoxCuts::Place;
using Points = vtkSmartPointer<vtkPolyData>;

/// Places that tell where to cut, of all ranks together: counts of boxes are right to within about
/// half a percent.
constexpr vtkIdType placesInAll = 1 << 17;

/// As many particles are sent at a time: messages stay small.
constexpr vtkIdType particlesOfMessage = 1 << 20;

/// Ghosts lie so far away where nothing else is said: this share of the longest side of all bounds,
/// or so many distances of neighbours where that is more.
constexpr double automaticShare = 0.12, automaticSpacings = 8.0;

constexpr int countTag = 71001, pointsTag = 71002;

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

/// Particles by their numbers, for one rank.
using Ids = std::vector<vtkIdType>;

/// Some of the points, with their arrays.
Points partOf(vtkPolyData* all, const vtkIdType* ids, vtkIdType count)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(count);
  std::copy_n(ids, count, list->GetPointer(0));
  return mote::pointsOf(all, list);
}

/// Particles of one rank for another, array by array. Where some arrays are strings, which such
/// messages cannot hold, the whole goes as one data set: that is written to a stream first.
class Messages
{
public:
  explicit Messages(vtkMultiProcessController* controller)
    : controller_(controller)
  {
  }

  void send(vtkPolyData* from, const Ids& ids, int to) const
  {
    auto left = static_cast<vtkIdType>(ids.size());
    controller_->Send(&left, 1, to, countTag);
    for (const vtkIdType* next = ids.data(); left > 0;)
    {
      const vtkIdType count = std::min(left, particlesOfMessage);
      this->sendPart(partOf(from, next, count), to);
      next += count;
      left -= count;
    }
  }

  void receive(int from, std::vector<Points>& parts) const
  {
    vtkIdType left = 0;
    controller_->Receive(&left, 1, from, countTag);
    while (left > 0)
    {
      const Points part = this->receivePart(from);
      if (part->GetNumberOfPoints() == 0)
        return; // the connection has failed, which the controller has said
      left -= part->GetNumberOfPoints();
      parts.push_back(part);
    }
  }

private:
  void sendPart(vtkPolyData* part, int to) const
  {
    std::vector<vtkDataArray*> arrays = {part->GetPoints()->GetData()};
    vtkPointData* data = part->GetPointData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      if (vtkDataArray* array = data->GetArray(i))
        arrays.push_back(array);
    const bool areAll = static_cast<int>(arrays.size()) == data->GetNumberOfArrays() + 1;
    std::vector<int> types;
    for (vtkDataArray* array : arrays)
      types.push_back(array->GetDataType());
    int count = areAll ? static_cast<int>(arrays.size()) : 0;
    controller_->Send(&count, 1, to, countTag);
    if (!areAll)
    {
      controller_->Send(part, to, pointsTag);
      return;
    }
    controller_->Send(types.data(), count, to, countTag);
    for (vtkDataArray* array : arrays)
      controller_->Send(array, to, pointsTag);
  }

  Points receivePart(int from) const
  {
    auto part = Points::New();
    int count = 0;
    controller_->Receive(&count, 1, from, countTag);
    if (count == 0)
    {
      controller_->Receive(part.Get(), from, pointsTag);
      return part;
    }
    std::vector<int> types(count);
    controller_->Receive(types.data(), count, from, countTag);
    for (int i = 0; i < count; ++i)
    {
      const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(types[i]));
      controller_->Receive(array.Get(), from, pointsTag);
      if (i > 0)
        part->GetPointData()->AddArray(array);
      else
      {
        vtkNew<vtkPoints> points;
        points->SetData(array);
        part->SetPoints(points);
      }
    }
    return part;
  }

  vtkMultiProcessController* controller_;
};

/// What each rank is to have of the particles of this one.
struct Shares
{
  std::vector<Ids> own, ghosts;
};

/// What a rank has in the end.
struct Parts
{
  std::vector<Points> own, ghosts;
};

/// Sends all ranks their shares, in one order of pairs, so that none waits for one that waits for
/// it.
Parts exchange(vtkMultiProcessController* controller, vtkPolyData* from, const Shares& shares)
{
  const int ranks = controller->GetNumberOfProcesses(), mine = controller->GetLocalProcessId();
  const Messages messages(controller);
  Parts parts;
  const auto send = [&](int to)
  {
    messages.send(from, shares.own[to], to);
    messages.send(from, shares.ghosts[to], to);
  };
  const auto receive = [&](int rank)
  {
    messages.receive(rank, parts.own);
    messages.receive(rank, parts.ghosts);
  };
  const auto keep = [&](const Ids& ids, std::vector<Points>& kept)
  {
    if (!ids.empty())
      kept.push_back(partOf(from, ids.data(), static_cast<vtkIdType>(ids.size())));
  };
  for (int other = 0; other < ranks; ++other)
    if (other < mine)
    {
      receive(other);
      send(other);
    }
    else if (other > mine)
    {
      send(other);
      receive(other);
    }
    else
    {
      keep(shares.own[mine], parts.own);
      keep(shares.ghosts[mine], parts.ghosts);
    }
  return parts;
}

/// The points of a rank, and behind them the ghosts, which an array tells apart.
Points together(const Parts& parts, bool isMarked)
{
  std::vector<vtkPointSet*> all(parts.own.begin(), parts.own.end());
  all.insert(all.end(), parts.ghosts.begin(), parts.ghosts.end());
  Points points = mote::collectPoints(all);
  if (!isMarked)
    return points;
  vtkIdType own = 0;
  for (const Points& part : parts.own)
    own += part->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(points->GetNumberOfPoints());
  std::fill_n(marks->GetPointer(0), own, static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(own), points->GetNumberOfPoints() - own,
    static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT));
  points->GetPointData()->AddArray(marks);
  return points;
}

/// Messages do not tell what components are called.
void copyNames(vtkPolyData* from, vtkPolyData* to)
{
  for (int i = 0; i < from->GetPointData()->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = from->GetPointData()->GetArray(i); array && array->GetName())
      if (vtkDataArray* copy = to->GetPointData()->GetArray(array->GetName()))
        copy->CopyComponentNames(array);
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
  const Points points = mote::collectPoints(mote::pointSetsOf(input));
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
    this->Distribute(controller, mote::withoutGhosts(points), output);
  else
    output->ShallowCopy(points);
  if (input)
    for (int i = 0; i < input->GetFieldData()->GetNumberOfArrays(); ++i)
      output->GetFieldData()->AddArray(input->GetFieldData()->GetAbstractArray(i));
  return 1;
}

void vtkMoteDistributeParticles::Distribute(
  vtkMultiProcessController* controller, vtkPolyData* points, vtkPolyData* output)
{
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
  Shares shares{std::vector<Ids>(ranks), std::vector<Ids>(ranks)};
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
  output->ShallowCopy(together(exchange(controller, points, shares), this->Ghosts));
  copyNames(points, output);
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
}
