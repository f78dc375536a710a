#include "ChildProcess.h"

#include <cerrno>
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef MOTE_COVERAGE
extern "C" void __gcov_dump(); // a process that leaves by _exit() would not tell what it did
#endif

namespace mote
{
namespace
{

/// Signals are those of a program that has just begun, and nothing is said or left of a death.
[[noreturn]] void beChild(unsigned seconds, const std::function<void()>& work)
{
  const rlimit none{};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGPIPE})
    std::signal(number, SIG_DFL);
  ::close(STDERR_FILENO);
  ::alarm(seconds);
  work();
#ifdef MOTE_COVERAGE
  __gcov_dump();
#endif
  ::_exit(0);
}

} // namespace

ChildEnd inChildProcess(unsigned seconds, const std::function<void()>& work)
{
  const pid_t child = ::fork();
  if (child == 0)
    beChild(seconds, work);
  int status = 0;
  pid_t ended = -1;
  while (child > 0 && (ended = ::waitpid(child, &status, 0)) < 0 && errno == EINTR)
    ;
  // No process can be made, or another part of the program waits for all.
  if (ended != child || (!WIFSIGNALED(status) && WEXITSTATUS(status) == 0))
    return ChildEnd::Well;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? ChildEnd::Late : ChildEnd::Died;
}

} // namespace mote
