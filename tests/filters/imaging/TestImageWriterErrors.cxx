// What vtkMoteImageWriter says when it cannot write, and that it leaves nothing behind.

#include "ImagingTestTools.h"
#include "vtkMoteImageWriter.h"

#include <vtkErrorCode.h>
#include <vtkIntArray.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sys/resource.h>

namespace
{

class ImageWriterErrors : public ImagingTest
{
protected:
  /// Expects that writing fails with a sentence that has `reason` in it.
  void expectFailure(
    const std::string& file, vtkImageData* image, const std::string& reason, unsigned long code = 0)
  {
    const int before = this->countFiles();
    vtkNew<vtkMoteImageWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_NE(writer->GetErrorMessage().find(reason), std::string::npos)
      << writer->GetErrorMessage();
    EXPECT_NE(writer->GetErrorMessage().find("\"" + file + "\""), std::string::npos);
    EXPECT_EQ(writer->GetErrorMessage().back(), '.');
    EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    if (code != 0)
    {
      EXPECT_EQ(writer->GetErrorCode(), code);
    }
    EXPECT_NE(this->Messages->Text.find(writer->GetErrorMessage()), std::string::npos);
    EXPECT_EQ(this->countFiles(), before);
  }

  vtkSmartPointer<vtkImageData> Image = makeImage(64, 64, 4);
};

TEST_F(ImageWriterErrors, UnknownEnding)
{
  for (const char* name : {"a.bmp", "a", "a.png.txt", ".png"})
  {
    this->expectFailure(
      this->path(name), this->Image, "must end in", vtkErrorCode::UnrecognizedFileTypeError);
  }
  EXPECT_EQ(vtkMoteImageWriter::CanWriteFile("x/y.EXR"), 1);
  EXPECT_EQ(vtkMoteImageWriter::CanWriteFile("x/y.gif"), 0);
  EXPECT_EQ(vtkMoteImageWriter::CanWriteFile(nullptr), 0);
}

TEST_F(ImageWriterErrors, NoFileName)
{
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetInputData(this->Image);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
}

TEST_F(ImageWriterErrors, MissingFolder)
{
  this->expectFailure(this->path("none/a.png"), this->Image, "its folder does not exist",
    vtkErrorCode::CannotOpenFileError);
  std::ofstream(this->path("file")) << "x";
  this->expectFailure(this->path("file/a.png"), this->Image, "is a file");
}

TEST_F(ImageWriterErrors, FolderOfThatName)
{
  std::filesystem::create_directory(this->path("a.png"));
  this->expectFailure(this->path("a.png"), this->Image, "it is a folder");
}

TEST_F(ImageWriterErrors, TooLongName)
{
  this->expectFailure(
    this->path(std::string(300, 'a').append(".png")), this->Image, "the name is too long");
}

TEST_F(ImageWriterErrors, Device)
{
  std::filesystem::create_symlink("/dev/full", this->path("a.png"));
  this->expectFailure(this->path("a.png"), this->Image, "it is not a regular file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(ImageWriterErrors, NoPermission)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "Root may write everywhere.";
  std::ofstream(this->path("old.png")) << "x";
  std::filesystem::permissions(this->path("old.png"), std::filesystem::perms::owner_read);
  this->expectFailure(this->path("old.png"), this->Image, "the file is write-protected");
  std::filesystem::permissions(
    this->Folder, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  this->expectFailure(this->path("a.png"), this->Image, "no permission");
}

/// Lets files grow to `size` bytes, for as long as it lives.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t size)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Old);
    rlimit limit{size, this->Old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit()
  {
    setrlimit(RLIMIT_FSIZE, &this->Old);
    std::signal(SIGXFSZ, SIG_DFL);
  }

private:
  rlimit Old;
};

TEST_F(ImageWriterErrors, NoRoomLeavesTheOldFile)
{
  for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"})
  {
    std::ofstream(this->path(name)) << "old";
    {
      const FileSizeLimit limit(100); // in the middle of the first write
      this->expectFailure(
        this->path(name), this->Image, "limit", vtkErrorCode::OutOfDiskSpaceError);
    }
    std::string text;
    std::ifstream(this->path(name)) >> text;
    EXPECT_EQ(text, "old");
  }
}

TEST_F(ImageWriterErrors, FullDisk)
{
  // A full file system to write to, where there is one: mount -t tmpfs -o size=8k.
  const char* folder = std::getenv("MOTE_TEST_FULL_FOLDER");
  if (!folder)
    GTEST_SKIP() << "MOTE_TEST_FULL_FOLDER does not name a folder on a small file system.";
  auto large = makeImage(256, 256, 4);
  std::minstd_rand random; // noise, which does not compress
  for (vtkIdType i = 0; i < 256 * 256; ++i)
    large->GetPointData()->GetScalars()->SetComponent(i, 0, (random() % 1000) / 999.0);
  for (const char* name : {"/a.png", "/a.jpg", "/a.tif", "/a.exr"})
  {
    this->expectFailure(
      std::string(folder) + name, large, "the disk is full", vtkErrorCode::OutOfDiskSpaceError);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
  }
}

TEST_F(ImageWriterErrors, UnfitImages)
{
  vtkNew<vtkImageData> empty;
  this->expectFailure(this->path("a.png"), empty, "the image is empty");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 1);
  this->expectFailure(this->path("a.png"), bare, "has no colours");
  vtkNew<vtkImageData> deep;
  deep->SetDimensions(2, 2, 3);
  deep->AllocateScalars(VTK_FLOAT, 3);
  this->expectFailure(this->path("a.png"), deep, "has 3 slices");
  vtkNew<vtkImageData> wide;
  wide->SetDimensions(2, 2, 1);
  wide->AllocateScalars(VTK_FLOAT, 5);
  this->expectFailure(this->path("a.exr"), wide, "have 5 components");
  vtkNew<vtkImageData> wrong;
  wrong->SetDimensions(2, 2, 1);
  wrong->AllocateScalars(VTK_INT, 3);
  this->expectFailure(this->path("a.exr"), wrong, "of type int");
  this->expectFailure(this->path("a.jpg"), makeImage(70000, 1, 3), "at most 65500");
}

TEST_F(ImageWriterErrors, NoInput)
{
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(this->path("a.png").c_str());
  EXPECT_EQ(writer->CheckFileName(), 1);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorMessage().find("no image"), std::string::npos);
  writer->SetInputData(this->Image); // and an error does not stick
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

} // namespace
