#include "ForeignMemory.h"

#include "vtkDataArray.h"

#include <map>
#include <mutex>

namespace mote
{
namespace
{

using Keeper = std::shared_ptr<const void>;

/// What keeps the memory of arrays. VTK tells, when it is done with an array's memory, nothing but
/// where that was.
struct Keepers
{
  std::mutex mutex;
  std::multimap<const void*, Keeper> all;

  static Keepers& instance()
  {
    static auto* const keepers = new Keepers; // arrays may outlive static objects
    return *keepers;
  }
};

void release(void* memory)
{
  Keepers& keepers = Keepers::instance();
  Keeper last; // let go of when the lock is gone
  const std::lock_guard lock(keepers.mutex);
  if (const auto found = keepers.all.find(memory); found != keepers.all.end())
  {
    last = std::move(found->second);
    keepers.all.erase(found);
  }
}

} // namespace

void viewMemory(vtkDataArray* array, void* memory, vtkIdType values, Keeper keeper)
{
  {
    Keepers& keepers = Keepers::instance();
    const std::lock_guard lock(keepers.mutex);
    keepers.all.emplace(memory, std::move(keeper));
  }
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(release);
}

} // namespace mote
