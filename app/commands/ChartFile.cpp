#include "ChartFile.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"

#include <vtkBase64Utilities.h>
#include <vtkFloatArray.h>
#include <vtkMoteImageWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace mote::app
{

namespace
{

bool isSvg(const std::string& file)
{
  return lowerCase(std::filesystem::path(file).extension().string()) == ".svg";
}

/// The pixels of a frame as a PNG in letters.
std::string pngOf(vtkImageData* image, const std::array<int, 4>& frame)
{
  const int* size = image->GetDimensions();
  auto* colors = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  vtkNew<vtkImageData> part;
  part->SetDimensions(frame[1] - frame[0] + 1, frame[3] - frame[2] + 1, 1);
  part->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(part->GetPointData()->GetScalars());
  vtkIdType next = 0;
  for (int y = frame[2]; y <= frame[3]; ++y)
    for (int x = frame[0]; x <= frame[1]; ++x)
      for (int k = 0; k < 3; ++k)
        bytes->SetValue(next++,
          static_cast<unsigned char>(std::lround(
            255.0F *
            std::clamp(colors->GetTypedComponent(vtkIdType(y) * size[0] + x, k), 0.0F, 1.0F))));
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(part);
  writer->Write();
  vtkUnsignedCharArray* file = writer->GetResult();
  const auto length = static_cast<unsigned long>(file->GetNumberOfValues());
  std::vector<unsigned char> letters(2 * length + 8);
  const unsigned long count =
    vtkBase64Utilities::Encode(file->GetPointer(0), length, letters.data());
  return {letters.begin(), letters.begin() + static_cast<std::ptrdiff_t>(count)};
}

} // namespace

bool isChartFile(const std::string& file)
{
  return isSvg(file) || vtkMoteImageWriter::CanWriteFile(file.c_str());
}

ChartPaper::ChartPaper(int width, int height)
  : image_(vtkSmartPointer<vtkImageData>::New())
{
  image_->SetDimensions(width, height, 1);
  vtkNew<vtkFloatArray> pixels;
  pixels->SetName("color");
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(image_->GetNumberOfPoints());
  pixels->Fill(1.0);
  image_->GetPointData()->SetScalars(pixels);
}

void ChartPaper::keepPixels(const std::array<int, 4>& frame)
{
  const auto entry = [](const char* name, int value)
  { return std::string(" ") + name + "=\"" + std::to_string(value) + '"'; };
  elements_ += "<image" + entry("x", frame[0]) +
               entry("y", image_->GetDimensions()[1] - frame[3] - 1) +
               entry("width", frame[1] - frame[0] + 1) + entry("height", frame[3] - frame[2] + 1) +
               " preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\""
               " href=\"data:image/png;base64," +
               pngOf(image_, frame) + "\"/>\n";
}

std::string ChartPaper::svg() const
{
  const int* size = image_->GetDimensions();
  const std::string width = std::to_string(size[0]), height = std::to_string(size[1]);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + ' ' + height +
         "\" font-family=\"DejaVu Sans, sans-serif\">\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
         elements_ + "</svg>\n";
}

void ChartPaper::write(const std::string& file)
{
  if (isSvg(file))
  {
    writeText(file, svg());
    return;
  }
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image_);
  Messages::takeError();
  if (!writer->Write())
    throw Failure(writer->GetErrorMessage());
}

} // namespace mote::app
