#include "RankExchange.h"

#include "DataParts.h"
#include "PolygonCutter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace mote
{

namespace
{

using Part = vtkSmartPointer<vtkPolyData>;

/// As many particles are sent at a time: messages stay small.
constexpr vtkIdType particlesOfMessage = 1 << 20;

constexpr int countTag = 71001, dataTag = 71002;

/// Particles or cells by their numbers, for one rank.
using Ids = std::vector<vtkIdType>;

vtkSmartPointer<vtkIdList> listOf(const vtkIdType* ids, vtkIdType count)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  list->SetNumberOfIds(count);
  std::copy_n(ids, count, list->GetPointer(0));
  return list;
}

Part particlesOf(vtkPolyData* all, const Ids& ids, vtkIdType begin, vtkIdType count)
{
  return mote::pointsOf(all, listOf(ids.data() + begin, count));
}

/// Whether all arrays are of numbers.
bool areNumbers(vtkDataSetAttributes* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    if (!data->GetArray(i))
      return false;
  return true;
}

/// `attribute` is what the array is to the data; -1: nothing of its own.
void addArray(vtkDataSetAttributes* data, vtkAbstractArray* array, int attribute)
{
  const int index = data->AddArray(array);
  if (attribute >= 0)
    data->SetActiveAttribute(index, attribute);
}

/// Parts of one rank for another, array by array. Where some arrays are strings, which such
/// messages cannot hold, the whole goes as one data set: that is written to a stream first.
class Messages
{
public:
  explicit Messages(vtkMultiProcessController* controller)
    : controller_(controller)
  {
  }

  void sendCount(vtkIdType parts, int to) const { controller_->Send(&parts, 1, to, countTag); }

  vtkIdType receiveCount(int from) const
  {
    vtkIdType parts = 0;
    controller_->Receive(&parts, 1, from, countTag);
    return parts;
  }

  void send(vtkPolyData* part, int to) const
  {
    const bool areAll = areNumbers(part->GetPointData()) && areNumbers(part->GetCellData());
    const int head[] = {areAll, part->GetNumberOfPolys() > 0,
      part->GetPointData()->GetNumberOfArrays(), part->GetCellData()->GetNumberOfArrays()};
    controller_->Send(head, 4, to, countTag);
    if (!areAll)
    {
      controller_->Send(part, to, dataTag);
      return;
    }
    this->send(part->GetPoints()->GetData(), to);
    if (part->GetNumberOfPolys() > 0)
    {
      this->send(part->GetPolys()->GetOffsetsArray(), to);
      this->send(part->GetPolys()->GetConnectivityArray(), to);
    }
    this->sendArrays(part->GetPointData(), to);
    this->sendArrays(part->GetCellData(), to);
  }

  Part receive(int from) const
  {
    auto part = Part::New();
    int head[4] = {0, 0, 0, 0};
    controller_->Receive(head, 4, from, countTag);
    if (head[0] == 0)
    {
      controller_->Receive(part.Get(), from, dataTag);
      return part;
    }
    vtkNew<vtkPoints> points;
    points->SetData(this->receiveArray(from));
    part->SetPoints(points);
    if (head[1] != 0)
    {
      const auto offsets = this->receiveArray(from), corners = this->receiveArray(from);
      vtkNew<vtkCellArray> polygons;
      polygons->SetData(offsets, corners);
      part->SetPolys(polygons);
    }
    this->receiveArrays(head[2], part->GetPointData(), from);
    this->receiveArrays(head[3], part->GetCellData(), from);
    return part;
  }

private:
  /// Each with what it is to the data, such as their normals.
  void sendArrays(vtkDataSetAttributes* data, int to) const
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const int attribute = data->IsArrayAnAttribute(i);
      controller_->Send(&attribute, 1, to, countTag);
      this->send(data->GetArray(i), to);
    }
  }

  void receiveArrays(int count, vtkDataSetAttributes* data, int from) const
  {
    for (int i = 0; i < count; ++i)
    {
      int attribute = -1;
      controller_->Receive(&attribute, 1, from, countTag);
      addArray(data, this->receiveArray(from), attribute);
    }
  }

  void send(vtkDataArray* array, int to) const
  {
    const int type = array->GetDataType();
    controller_->Send(&type, 1, to, countTag);
    controller_->Send(array, to, dataTag);
  }

  vtkSmartPointer<vtkDataArray> receiveArray(int from) const
  {
    int type = VTK_FLOAT;
    controller_->Receive(&type, 1, from, countTag);
    const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    controller_->Receive(array.Get(), from, dataTag);
    return array;
  }

  vtkMultiProcessController* controller_;
};

using Parts = std::vector<Part>;

/// How many parts a rank gets, and each of them.
struct Cut
{
  std::function<vtkIdType(int rank)> count;
  std::function<Part(int rank, vtkIdType number)> part;
};

/// Sends all ranks their parts, in one order of pairs, so that none waits for one that waits for
/// it.
Parts exchange(vtkMultiProcessController* controller, const Cut& cut)
{
  const int ranks = controller->GetNumberOfProcesses(), mine = controller->GetLocalProcessId();
  const Messages messages(controller);
  Parts parts;
  const auto send = [&](int to)
  {
    const vtkIdType count = cut.count(to);
    messages.sendCount(count, to);
    for (vtkIdType i = 0; i < count; ++i)
      messages.send(cut.part(to, i), to);
  };
  const auto receive = [&](int from)
  {
    // Nothing where the connection has failed, which the controller has said.
    for (vtkIdType left = messages.receiveCount(from); left > 0; --left)
      if (const Part part = messages.receive(from); part->GetNumberOfPoints() > 0)
        parts.push_back(part);
      else
        return;
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
      for (vtkIdType i = 0; i < cut.count(mine); ++i)
        parts.push_back(cut.part(mine, i));
  return parts;
}

using AttributesOf = std::function<vtkDataSetAttributes*(vtkPolyData*)>;

vtkDataSetAttributes* ofPoints(vtkPolyData* part)
{
  return part->GetPointData();
}

vtkDataSetAttributes* ofCells(vtkPolyData* part)
{
  return part->GetCellData();
}

/// The array of this name of all parts, one after another, which lose it: no more than one array is
/// there twice. Null where parts have different ones.
vtkSmartPointer<vtkAbstractArray> joinArray(
  const Parts& parts, const AttributesOf& attributesOf, const char* name)
{
  const vtkSmartPointer<vtkAbstractArray> model =
    attributesOf(parts.front())->GetAbstractArray(name);
  vtkIdType count = 0;
  for (const Part& part : parts)
  {
    vtkAbstractArray* array = attributesOf(part)->GetAbstractArray(name);
    if (!array || array->GetDataType() != model->GetDataType() ||
        array->GetNumberOfComponents() != model->GetNumberOfComponents())
      return nullptr;
    count += array->GetNumberOfTuples();
  }
  const auto joined = vtk::TakeSmartPointer(model->NewInstance());
  joined->SetName(name);
  joined->SetNumberOfComponents(model->GetNumberOfComponents());
  joined->SetNumberOfTuples(count);
  vtkIdType next = 0;
  for (const Part& part : parts)
  {
    const vtkSmartPointer<vtkAbstractArray> array = attributesOf(part)->GetAbstractArray(name);
    joined->InsertTuples(next, array->GetNumberOfTuples(), 0, array);
    next += array->GetNumberOfTuples();
    attributesOf(part)->RemoveArray(name);
  }
  return joined;
}

/// The arrays that all parts have, which lose them.
void joinArrays(const Parts& parts, const AttributesOf& attributesOf, vtkPolyData* joined)
{
  vtkDataSetAttributes* model = attributesOf(parts.front());
  std::vector<std::pair<std::string, int>> arrays; ///< with their attributes
  for (int i = 0; i < model->GetNumberOfArrays(); ++i)
    if (const char* name = model->GetAbstractArray(i)->GetName())
      arrays.emplace_back(name, model->IsArrayAnAttribute(i));
  for (const auto& [name, attribute] : arrays)
    if (const auto array = joinArray(parts, attributesOf, name.c_str()))
      addArray(attributesOf(joined), array, attribute);
}

vtkSmartPointer<vtkPoints> joinPlaces(const Parts& parts)
{
  vtkIdType count = 0;
  int type = VTK_FLOAT;
  for (const Part& part : parts)
  {
    count += part->GetNumberOfPoints();
    if (part->GetPoints()->GetDataType() != VTK_FLOAT)
      type = VTK_DOUBLE;
  }
  auto joined = vtkSmartPointer<vtkPoints>::New();
  joined->SetDataType(type);
  joined->SetNumberOfPoints(count);
  vtkIdType next = 0;
  for (const Part& part : parts)
  {
    joined->InsertPoints(next, part->GetNumberOfPoints(), 0, part->GetPoints());
    next += part->GetNumberOfPoints();
  }
  return joined;
}

vtkSmartPointer<vtkCellArray> joinPolygons(const Parts& parts)
{
  auto joined = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType next = 0;
  for (const Part& part : parts)
  {
    joined->Append(part->GetPolys(), next);
    next += part->GetNumberOfPoints();
  }
  return joined;
}

void mark(vtkDataSetAttributes* data, vtkIdType own, vtkIdType ghosts)
{
  static_assert(
    int(vtkDataSetAttributes::DUPLICATEPOINT) == int(vtkDataSetAttributes::DUPLICATECELL));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(own + ghosts);
  std::fill_n(marks->GetPointer(0), own, static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(own), ghosts,
    static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT));
  data->AddArray(marks);
}

/// Messages do not tell what components are called.
void copyNames(vtkFieldData* from, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = from->GetArray(i); array && array->GetName())
      if (vtkDataArray* copy = to->GetArray(array->GetName()))
        copy->CopyComponentNames(array);
}

Cut cutParticles(vtkPolyData* from, const RankShares& shares, bool isMarked)
{
  const auto messagesOf = [](const Ids& ids)
  { return (static_cast<vtkIdType>(ids.size()) + particlesOfMessage - 1) / particlesOfMessage; };
  const auto part = [=, &shares](int rank, vtkIdType number)
  {
    const vtkIdType ofOwn = messagesOf(shares.own[rank]);
    const bool isOwn = number < ofOwn;
    const Ids& ids = isOwn ? shares.own[rank] : shares.ghosts[rank];
    const vtkIdType begin = particlesOfMessage * (isOwn ? number : number - ofOwn);
    const vtkIdType count =
      std::min(particlesOfMessage, static_cast<vtkIdType>(ids.size()) - begin);
    const Part cut = particlesOf(from, ids, begin, count);
    if (isMarked)
      mark(cut->GetPointData(), isOwn ? count : 0, isOwn ? 0 : count);
    return cut;
  };
  const auto count = [=, &shares](int rank)
  { return messagesOf(shares.own[rank]) + messagesOf(shares.ghosts[rank]); };
  return {count, part};
}

/// One part for each rank, so that its cells have the points in common that they had.
Cut cutPolygons(vtkPolyData* from, const RankShares& shares, bool isMarked)
{
  const auto cutter = std::make_shared<PolygonCutter>(from);
  const auto part = [=, &shares](int rank, vtkIdType)
  {
    const Ids &own = shares.own[rank], &ghosts = shares.ghosts[rank];
    Ids ids = own;
    ids.insert(ids.end(), ghosts.begin(), ghosts.end());
    Part cut = cutter->part(ids);
    if (isMarked)
      mark(cut->GetCellData(), static_cast<vtkIdType>(own.size()),
        static_cast<vtkIdType>(ghosts.size()));
    return cut;
  };
  const auto count = [&](int rank) -> vtkIdType
  { return shares.own[rank].empty() && shares.ghosts[rank].empty() ? 0 : 1; };
  return {count, part};
}

} // namespace

vtkSmartPointer<vtkPolyData> joined(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  if (parts.size() == 1)
    return parts.front();
  auto whole = Part::New();
  if (parts.empty())
    return whole;
  joinArrays(parts, ofPoints, whole);
  joinArrays(parts, ofCells, whole);
  whole->SetPoints(joinPlaces(parts));
  if (std::any_of(
        parts.begin(), parts.end(), [](const Part& part) { return part->GetNumberOfPolys() > 0; }))
    whole->SetPolys(joinPolygons(parts));
  return whole;
}

vtkSmartPointer<vtkPolyData> exchange(vtkMultiProcessController* controller,
  vtkSmartPointer<vtkPolyData> from, RankShares shares, bool isMarked,
  const std::function<void()>& whenSent)
{
  vtkNew<vtkPointData> points;
  vtkNew<vtkCellData> cells;
  points->CopyStructure(from->GetPointData());
  cells->CopyStructure(from->GetCellData());
  const Parts parts = exchange(controller,
    shares.ofCells ? cutPolygons(from, shares, isMarked) : cutParticles(from, shares, isMarked));
  from = nullptr;
  shares = RankShares(0, shares.ofCells);
  whenSent();
  const Part all = joined(parts);
  copyNames(points, all->GetPointData());
  copyNames(cells, all->GetCellData());
  return all;
}

} // namespace mote
