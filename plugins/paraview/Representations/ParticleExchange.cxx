#include "ParticleExchange.h"

#include "DataParts.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mote
{

namespace
{

using Points = vtkSmartPointer<vtkPolyData>;

/// As many particles are sent at a time: messages stay small.
constexpr vtkIdType particlesOfMessage = 1 << 20;

constexpr int countTag = 71001, pointsTag = 71002;

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

/// What a rank has in the end.
struct Parts
{
  std::vector<Points> own, ghosts;
};

/// Sends all ranks their shares, in one order of pairs, so that none waits for one that waits for
/// it.
Parts exchange(
  vtkMultiProcessController* controller, vtkPolyData* from, const ParticleShares& shares)
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

/// The array of this name of all parts, one after another, which lose it: no more than one array is
/// there twice. Null where parts have different ones.
vtkSmartPointer<vtkAbstractArray> joinArray(const std::vector<Points>& parts, const char* name)
{
  const vtkSmartPointer<vtkAbstractArray> model =
    parts.front()->GetPointData()->GetAbstractArray(name);
  vtkIdType count = 0;
  for (const Points& part : parts)
  {
    vtkAbstractArray* array = part->GetPointData()->GetAbstractArray(name);
    if (!array || array->GetDataType() != model->GetDataType() ||
        array->GetNumberOfComponents() != model->GetNumberOfComponents())
      return nullptr;
    count += part->GetNumberOfPoints();
  }
  const auto joined = vtk::TakeSmartPointer(model->NewInstance());
  joined->SetName(name);
  joined->SetNumberOfComponents(model->GetNumberOfComponents());
  joined->SetNumberOfTuples(count);
  vtkIdType next = 0;
  for (const Points& part : parts)
  {
    vtkPointData* data = part->GetPointData();
    joined->InsertTuples(next, part->GetNumberOfPoints(), 0, data->GetAbstractArray(name));
    next += part->GetNumberOfPoints();
    data->RemoveArray(name);
  }
  return joined;
}

vtkSmartPointer<vtkPoints> joinPlaces(const std::vector<Points>& parts)
{
  vtkIdType count = 0;
  int type = VTK_FLOAT;
  for (const Points& part : parts)
  {
    count += part->GetNumberOfPoints();
    if (part->GetPoints()->GetDataType() != VTK_FLOAT)
      type = VTK_DOUBLE;
  }
  auto joined = vtkSmartPointer<vtkPoints>::New();
  joined->SetDataType(type);
  joined->SetNumberOfPoints(count);
  vtkIdType next = 0;
  for (const Points& part : parts)
  {
    joined->InsertPoints(next, part->GetNumberOfPoints(), 0, part->GetPoints());
    next += part->GetNumberOfPoints();
  }
  return joined;
}

/// Parts one after another, with the arrays that all have.
Points joinParts(const std::vector<Points>& parts)
{
  if (parts.size() == 1)
    return parts.front();
  auto joined = Points::New();
  if (parts.empty())
    return joined;
  vtkNew<vtkPointData> names;
  names->CopyStructure(parts.front()->GetPointData());
  for (int i = 0; i < names->GetNumberOfArrays(); ++i)
    if (const char* name = names->GetAbstractArray(i)->GetName())
      if (const auto array = joinArray(parts, name))
        joined->GetPointData()->AddArray(array);
  joined->SetPoints(joinPlaces(parts));
  return joined;
}

void markGhosts(vtkPolyData* points, vtkIdType own)
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(points->GetNumberOfPoints());
  std::fill_n(marks->GetPointer(0), own, static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(own), points->GetNumberOfPoints() - own,
    static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT));
  points->GetPointData()->AddArray(marks);
}

/// Messages do not tell what components are called.
void copyNames(vtkPointData* from, vtkPointData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = from->GetArray(i); array && array->GetName())
      if (vtkDataArray* copy = to->GetArray(array->GetName()))
        copy->CopyComponentNames(array);
}

} // namespace

vtkSmartPointer<vtkPolyData> exchangeParticles(vtkMultiProcessController* controller,
  vtkSmartPointer<vtkPolyData> from, ParticleShares shares, bool isMarked,
  const std::function<void()>& whenSent)
{
  vtkNew<vtkPointData> names;
  names->CopyStructure(from->GetPointData());
  Parts parts = exchange(controller, from, shares);
  from = nullptr;
  shares = ParticleShares(0);
  whenSent();
  vtkIdType own = 0;
  for (const Points& part : parts.own)
    own += part->GetNumberOfPoints();
  std::move(parts.ghosts.begin(), parts.ghosts.end(), std::back_inserter(parts.own));
  parts.ghosts.clear();
  Points points = joinParts(parts.own);
  if (isMarked)
    markGhosts(points, own);
  copyNames(names, points->GetPointData());
  return points;
}

} // namespace mote
