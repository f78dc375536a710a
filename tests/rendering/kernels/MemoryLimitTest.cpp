// The limits of control groups, as containers and batch systems set them.
#include <kernels/core/MemoryLimit.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

using namespace mote;

namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

/// A place like /sys/fs/cgroup.
class MemoryLimit : public testing::Test
{
protected:
  void SetUp() override { fs::create_directories(root_); }
  void TearDown() override { fs::remove_all(root_); }

  void write(const fs::path& file, const char* text)
  {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text << "\n";
  }

  const fs::path root_ = fs::temp_directory_path() / ("mote-groups-" + std::to_string(::getpid()));
};

} // namespace

TEST_F(MemoryLimit, IsTheLeastOfAllGroupsAbove)
{
  write("memory.max", "9000000000");
  write("slurm/memory.max", "2000000000");
  write("slurm/job/memory.max", "3000000000");
  write("slurm/job/step/memory.max", "max");
  EXPECT_EQ(groupMemoryIn("0::/slurm/job/step\n", root_), 2000000000U);
  EXPECT_EQ(groupMemoryIn("0::/other\n", root_), 9000000000U) << "of the root, as in containers";
  EXPECT_EQ(groupMemoryIn("0::/\n", root_), 9000000000U);
}

TEST_F(MemoryLimit, IsThatOfTheMemoryControllerInVersion1)
{
  write("memory/memory.limit_in_bytes", "9223372036854771712"); // none
  write("memory/docker/abc/memory.limit_in_bytes", "500000000");
  write("cpu/docker/abc/memory.limit_in_bytes", "1");
  const std::string groups = "9:name=systemd:/docker/abc\n4:cpu,cpuacct:/docker/abc\n"
                             "3:blkio,memory:/docker/abc\n0::/docker/abc\n";
  EXPECT_EQ(groupMemoryIn(groups, root_), 500000000U);
  EXPECT_GT(groupMemoryIn("4:memory:/elsewhere\n", root_), std::uint64_t(1) << 60);
}

TEST_F(MemoryLimit, IsNoneWhereNothingTells)
{
  EXPECT_EQ(groupMemoryIn("", root_), none);
  EXPECT_EQ(groupMemoryIn("nothing\n4:memory\n0::/a\n", root_), none);
  write("a/memory.max", "max");
  EXPECT_EQ(groupMemoryIn("0::/a\n", root_), none);
  write("a/memory.max", "0");
  EXPECT_EQ(groupMemoryIn("0::/a\n", root_), none);
  EXPECT_LE(physicalMemory(), machineMemory());
  EXPECT_LE(physicalMemory(), groupMemory());
}
