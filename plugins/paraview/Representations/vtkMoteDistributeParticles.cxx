#include "vtkMoteDistributeParticles.h"

#include "CommonSpacing.h"
#include "PointParts.h"
#include "RankBoxes.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMoteDistributeParticles);

namespace
{

using Place = std::array<double, 3>;
using Points = vtkSmartPointer<vtkPolyData>;

/// Places that tell where to cut, of all ranks together: counts of boxes are right to within about
/// half a percent.
constexpr vtkIdType placesInAll = 1 << 17;

/// As many particles are sent at a time: messages stay small.
constexpr vtkIdType particlesOfMessage = 1 << 20;

/// Ghosts lie so far away where nothing else is said: this share of the longest side of all bounds,
/// or so many distances of neighbours where that is more.
constexpr double automaticShare = 0.12, automaticSpacings = 8.0;

/// Up to so many ranks have slabs side by side. ParaView's order of boxes fails for some views
/// where two are beside one another along an edge alone, as those of more ranks are.
constexpr int mostSlabs = 8;

constexpr int countTag = 71001, pointsTag = 71002;

/// Space, cut in two again and again until there is a box for each rank.
class Boxes
{
public:
  /// `places` tell where to cut what lies in `all`.
  Boxes(std::vector<Place> places, const vtkBoundingBox& all, int ranks)
    : boxes_(ranks)
    , axis_(ranks > mostSlabs ? -1 : longestAxis(places.begin(), places.end()))
  {
    this->cut(places.begin(), places.end(), all, 0, ranks);
  }

  /// Invalid where there are too few particles for all ranks.
  const vtkBoundingBox& boxOf(int rank) const { return boxes_[rank]; }
  bool areSlabs() const { return axis_ >= 0; }

  int rankOf(const double* place) const
  {
    int node = 0;
    while (nodes_[node].axis >= 0)
      node = place[nodes_[node].axis] < nodes_[node].value ? nodes_[node].low : nodes_[node].high;
    return nodes_[node].rank;
  }

private:
  struct Node
  {
    int axis = -1; ///< -1: a box
    double value = 0.0;
    int low = 0, high = 0, rank = 0;
  };
  using Iterator = std::vector<Place>::iterator;

  static int longestAxis(Iterator begin, Iterator end)
  {
    vtkBoundingBox box;
    std::for_each(begin, end, [&](Place& place) { box.AddPoint(place.data()); });
    double sides[3];
    box.GetLengths(sides);
    return static_cast<int>(std::max_element(sides, sides + 3) - sides);
  }

  /// Makes the node of these places and ranks, and those below; answers its number.
  int cut(Iterator begin, Iterator end, const vtkBoundingBox& box, int firstRank, int ranks)
  {
    const auto number = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    nodes_[number].rank = firstRank;
    if (ranks == 1 || begin == end)
    {
      boxes_[firstRank] = box;
      return number;
    }
    const int axis = axis_ >= 0 ? axis_ : longestAxis(begin, end), lowRanks = ranks / 2;
    const Iterator middle = begin + (end - begin) * lowRanks / ranks;
    std::nth_element(
      begin, middle, end, [axis](const Place& a, const Place& b) { return a[axis] < b[axis]; });
    const double value = (*middle)[axis];
    double lowBounds[6], highBounds[6];
    box.GetBounds(lowBounds);
    box.GetBounds(highBounds);
    lowBounds[2 * axis + 1] = highBounds[2 * axis] = value;
    const int low = this->cut(begin, middle, vtkBoundingBox(lowBounds), firstRank, lowRanks);
    const int high =
      this->cut(middle, end, vtkBoundingBox(highBounds), firstRank + lowRanks, ranks - lowRanks);
    nodes_[number] = {axis, value, low, high, firstRank};
    return number;
  }

  std::vector<Node> nodes_;
  std::vector<vtkBoundingBox> boxes_;
  const int axis_; ///< of all cuts; -1: of the longest side each
};

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

/// Sends each rank the particles of a list, and adds what comes from others to `parts`.
class Exchange
{
public:
  Exchange(vtkMultiProcessController* controller, std::vector<Points>& parts)
    : controller_(controller)
    , parts_(parts)
  {
  }

  /// All pairs of ranks in one order, so that none waits for one that waits for it.
  void run(vtkPolyData* from, const std::vector<std::vector<vtkIdType>>& idsOf) const
  {
    const int ranks = controller_->GetNumberOfProcesses(), mine = controller_->GetLocalProcessId();
    for (int other = 0; other < ranks; ++other)
      if (other < mine)
      {
        this->receive(other);
        this->send(from, idsOf[other], other);
      }
      else if (other > mine)
      {
        this->send(from, idsOf[other], other);
        this->receive(other);
      }
  }

private:
  void send(vtkPolyData* from, const std::vector<vtkIdType>& ids, int to) const
  {
    auto left = static_cast<vtkIdType>(ids.size());
    controller_->Send(&left, 1, to, countTag);
    for (const vtkIdType* next = ids.data(); left > 0;)
    {
      const vtkIdType count = std::min(left, particlesOfMessage);
      controller_->Send(mote::subsetOf(from, next, count).Get(), to, pointsTag);
      next += count;
      left -= count;
    }
  }

  void receive(int from) const
  {
    vtkIdType left = 0;
    controller_->Receive(&left, 1, from, countTag);
    while (left > 0)
    {
      auto part = Points::New();
      if (!controller_->Receive(part.Get(), from, pointsTag) || part->GetNumberOfPoints() == 0)
        return;
      left -= part->GetNumberOfPoints();
      parts_.push_back(part);
    }
  }

  vtkMultiProcessController* controller_;
  std::vector<Points>& parts_;
};

Points together(const std::vector<Points>& parts)
{
  return mote::collectPoints({parts.begin(), parts.end()});
}

/// All particles in the box of this rank, and the box where it is a slab.
std::pair<Points, vtkBoundingBox> redistribute(
  vtkMultiProcessController* controller, vtkPolyData* own)
{
  const int ranks = controller->GetNumberOfProcesses(), mine = controller->GetLocalProcessId();
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : mote::gatherBoxes(controller, mote::ownBoundsOf(own)))
    all.AddBox(box);
  const Boxes boxes(gatherPlaces(controller, own), all, ranks);
  std::vector<std::vector<vtkIdType>> ids(ranks);
  for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i)
  {
    double place[3];
    own->GetPoint(i, place);
    ids[boxes.rankOf(place)].push_back(i);
  }
  std::vector<Points> parts;
  if (!ids[mine].empty())
    parts.push_back(
      mote::subsetOf(own, ids[mine].data(), static_cast<vtkIdType>(ids[mine].size())));
  Exchange(controller, parts).run(own, ids);
  return {together(parts), boxes.areSlabs() ? boxes.boxOf(mine) : vtkBoundingBox()};
}

/// Whether any points of two boxes may be so near to each other.
bool areWithin(const vtkBoundingBox& a, vtkBoundingBox b, double distance)
{
  if (!a.IsValid() || !b.IsValid())
    return false;
  b.Inflate(distance);
  return a.Intersects(b) != 0;
}

/// The points that are so near to a box.
std::vector<vtkIdType> idsWithin(vtkPolyData* data, const vtkBoundingBox& box, double distance)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double place[3], sum = 0.0;
    data->GetPoint(i, place);
    for (int c = 0; c < 3; ++c)
    {
      const double low = box.GetMinPoint()[c] - place[c], high = place[c] - box.GetMaxPoint()[c];
      const double away = std::max({low, high, 0.0});
      sum += away * away;
    }
    if (sum <= distance * distance)
      ids.push_back(i);
  }
  return ids;
}

/// The particles of other ranks that are near to this one's.
Points ghostsOf(
  vtkMultiProcessController* controller, vtkPolyData* own, double distance, double spacing)
{
  const std::vector<vtkBoundingBox> boxes = mote::gatherBoxes(controller, mote::ownBoundsOf(own));
  if (distance <= 0.0)
  {
    vtkBoundingBox all;
    for (const vtkBoundingBox& box : boxes)
      all.AddBox(box);
    if (all.IsValid())
      distance = std::max(automaticShare * all.GetMaxLength(), automaticSpacings * spacing);
  }
  const int mine = controller->GetLocalProcessId();
  std::vector<std::vector<vtkIdType>> ids(boxes.size());
  for (int rank = 0; rank < controller->GetNumberOfProcesses(); ++rank)
    if (rank != mine && areWithin(boxes[mine], boxes[rank], distance))
      ids[rank] = idsWithin(own, boxes[rank], distance);
  std::vector<Points> parts;
  Exchange(controller, parts).run(own, ids);
  return together(parts);
}

/// The points of a rank, and behind them the ghosts, which an array tells apart.
Points withGhosts(vtkPolyData* own, vtkPolyData* ghosts)
{
  std::vector<Points> parts;
  for (vtkPolyData* part : {own, ghosts})
    if (part->GetNumberOfPoints() > 0)
      parts.emplace_back(part);
  Points all = together(parts);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(all->GetNumberOfPoints());
  std::fill_n(marks->GetPointer(0), own->GetNumberOfPoints(), static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(own->GetNumberOfPoints()), ghosts->GetNumberOfPoints(),
    static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT));
  all->GetPointData()->AddArray(marks);
  return all;
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
  Points points = mote::collectPoints(mote::pointSetsOf(input));
  vtkBoundingBox box;
  double spacing = 0.0;
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    points = mote::withoutGhosts(points);
    spacing = mote::commonSpacingOf(points);
    if (this->Redistribute)
      std::tie(points, box) = redistribute(controller, points);
    if (this->Ghosts)
      points = withGhosts(points, ghostsOf(controller, points, this->GhostDistance, spacing));
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(points);
  if (input)
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
  if (spacing > 0.0)
    mote::keepSpacing(spacing, output);
  if (box.IsValid())
    mote::keepBox(box, output);
  return 1;
}

void vtkMoteDistributeParticles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Redistribute: " << (this->Redistribute ? "On" : "Off") << "\n";
  os << indent << "Ghosts: " << (this->Ghosts ? "On" : "Off") << "\n";
  os << indent << "GhostDistance: " << this->GhostDistance << "\n";
}
