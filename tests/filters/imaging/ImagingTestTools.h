/**
 * Images to write and to draw on, a folder of one's own, and VTK's messages as text.
 */

#ifndef ImagingTestTools_h
#define ImagingTestTools_h

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <unistd.h>

/// An image of float colours without pixels set.
inline vtkSmartPointer<vtkImageData> makeImage(int width, int height, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkFloatArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  colors->Fill(1.0);
  image->GetPointData()->SetScalars(colors);
  return image;
}

/// Keeps VTK's messages, and keeps them from the terminal.
class MessageKeeper : public vtkOutputWindow
{
public:
  static MessageKeeper* New() { VTK_STANDARD_NEW_BODY(MessageKeeper); }
  vtkTypeMacro(MessageKeeper, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }
  std::string Text;
};

/// A new empty folder, removed at the end.
class ImagingTest : public testing::Test
{
protected:
  void SetUp() override
  {
    static int count = 0;
    this->Folder = std::filesystem::temp_directory_path() /
                   ("mote-imaging-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(this->Folder);
    vtkOutputWindow::SetInstance(this->Messages);
  }
  void TearDown() override
  {
    vtkOutputWindow::SetInstance(nullptr);
    std::filesystem::permissions(this->Folder, std::filesystem::perms::owner_all);
    std::filesystem::remove_all(this->Folder);
  }
  std::string path(const std::string& name) const { return (this->Folder / name).string(); }
  int countFiles() const
  {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(this->Folder))
      ++count;
    return count;
  }

  std::filesystem::path Folder;
  vtkNew<MessageKeeper> Messages;
};

#endif
