// Ctrl-C: none is lost, whenever it comes.

#include <base/Failure.h>
#include <base/ProgressRelay.h>

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>
#include <unistd.h>

using namespace mote::app;

TEST(ProgressRelay, AnInterruptionAmongManyShortWorksStopsTheWhole)
{
  using Clock = std::chrono::steady_clock;
  ProgressRelay progress;
  vtkNew<vtkObject> object;
  std::signal(SIGINT, [](int) {}); // not ignored, as it is for commands in a script's background
  for (int i = 0; i < 100; ++i)
  {
    ProgressRelay::Work whole(progress, "Whole", object);
    std::atomic<bool> isSent = false;
    std::thread sender(
      [&]
      {
        std::this_thread::sleep_for(std::chrono::microseconds(50 + 20 * i));
        kill(getpid(), SIGINT);
        isSent = true;
      });
    bool isStopped = false;
    for (auto sent = Clock::now(); !isStopped && Clock::now() - sent < std::chrono::seconds(2);)
      try
      {
        if (!isSent)
          sent = Clock::now();
        ProgressRelay::Work part(progress, "Part", object);
        part.finish();
      }
      catch (const Interrupted&)
      {
        isStopped = true;
      }
    sender.join();
    ASSERT_TRUE(isStopped) << i;
  }
  std::signal(SIGINT, SIG_DFL);
}
