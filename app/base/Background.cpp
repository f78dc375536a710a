#include "Background.h"

#include <tbb/task_arena.h>

#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

namespace mote::app
{

void inBackground(const std::function<void()>& work)
{
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 5);
  tbb::task_arena arena(tbb::task_arena::automatic, 1, tbb::task_arena::priority::low);
  arena.execute([&] { work(); });
}

void giveBackMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace mote::app
