// Files that once crashed a reader, took memory without bound, or gave a message of two lines, as
// scripts/fuzz found them: each holds data, or there is one sentence that names it.
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace
{

std::vector<std::string> foundFiles()
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(MOTE_FOUND_FILES))
    if (entry.is_regular_file())
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class TestFoundFiles : public testing::TestWithParam<std::string>
{
};

TEST_P(TestFoundFiles, HoldsDataOrGivesOneSentence)
{
  testing::internal::CaptureStderr();
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(GetParam(), error);
  const auto data = reader ? vtkMoteReaderTable::Read(reader, error) : nullptr;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(data == nullptr, !error.empty());
  EXPECT_TRUE(data || error.find(GetParam()) != std::string::npos) << error;
  EXPECT_TRUE(std::none_of(error.begin(), error.end(),
    [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }));
  std::cout << "  " << error << "\n";
}

std::string nameOf(const testing::TestParamInfo<std::string>& info)
{
  const std::filesystem::path path(info.param);
  std::string name = path.stem().string() + "-" + path.extension().string().substr(1);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, TestFoundFiles, testing::ValuesIn(foundFiles()), nameOf);

TEST(TestFoundFiles, ThereAreSome)
{
  EXPECT_GE(foundFiles().size(), 12u);
}

} // namespace
