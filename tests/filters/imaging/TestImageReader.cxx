// What vtkMoteImageWriter writes comes back, other programs' channels are found, and files that are
// no images are refused in a sentence.

#include "ImagingTestTools.h"

#include <vtkMoteImageReader.h>
#include <vtkMoteImageWriter.h>

#include <OpenImageIO/imageio.h>

#include <vtkErrorCode.h>
#include <vtkIntArray.h>
#include <vtkTypeInt64Array.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

vtkSmartPointer<vtkMoteImageReader> readerOf(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkMoteImageReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

void write(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  ASSERT_TRUE(writer->Write()) << writer->GetErrorMessage();
}

template <typename Array>
vtkSmartPointer<Array> addArray(vtkImageData* image, const char* name, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
  return array;
}

/// An image with everything that a traced one has. Colours are premultiplied.
vtkSmartPointer<vtkImageData> tracedImage(int width, int height, std::int64_t largestId)
{
  auto image = makeImage(width, height, 4);
  auto* colors = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  auto depth = addArray<vtkFloatArray>(image, "depth", 1);
  auto normal = addArray<vtkFloatArray>(image, "normal", 3);
  auto object = addArray<vtkIntArray>(image, "object", 1);
  auto particle = addArray<vtkTypeInt64Array>(image, "particle", 1);
  auto flow = addArray<vtkFloatArray>(image, "flow", 5);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const float share = static_cast<float>(i % 17) / 16.0f;
    const float alpha = i % 3 == 0 ? 0.0f : 0.25f + 0.75f * share;
    const float color[4] = {alpha * share, alpha * (1.0f - share), alpha * 0.3f, alpha};
    colors->SetTypedTuple(i, color);
    depth->SetValue(i, i % 3 == 0 ? std::numeric_limits<float>::infinity() : 1e3f / (i + 1));
    const float n[3] = {share, -share, 1.0f - share};
    normal->SetTypedTuple(i, n);
    object->SetValue(i, i % 3 == 0 ? -1 : static_cast<int>(i % 5));
    particle->SetValue(i, i % 3 == 0 ? -1 : largestId - i);
    for (int c = 0; c < 5; ++c)
      flow->SetTypedComponent(i, c, static_cast<float>(i) + 0.125f * static_cast<float>(c));
  }
  return image;
}

void expectEqual(vtkImageData* is, vtkImageData* should, const char* name, double tolerance)
{
  vtkDataArray* a = is->GetPointData()->GetArray(name);
  vtkDataArray* b = should->GetPointData()->GetArray(name);
  ASSERT_TRUE(a) << name;
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents()) << name;
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      const double x = a->GetComponent(i, c), y = b->GetComponent(i, c);
      ASSERT_TRUE(x == y || std::abs(x - y) <= tolerance)
        << name << " " << i << " " << c << ": " << x << " " << y;
    }
  }
}

/// A file of another program's, all floats.
void writeChannels(const std::string& path, const std::vector<std::string>& names, int width,
  int height, OIIO::TypeDesc type = OIIO::TypeFloat)
{
  OIIO::ImageSpec spec(width, height, static_cast<int>(names.size()), type);
  spec.channelnames = names;
  spec.alpha_channel = spec.z_channel = -1;
  std::vector<float> pixels(spec.image_pixels() * names.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<float>(i % names.size()) + 0.001f * static_cast<float>(i);
  auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output && output->open(path, spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, pixels.data()));
  ASSERT_TRUE(output->close());
}

/// Names and components, sorted.
std::string arraysOf(vtkImageData* image)
{
  std::set<std::string> names;
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(i);
    names.insert(
      std::string(array->GetName()) + ":" + std::to_string(array->GetNumberOfComponents()));
  }
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : " ") + name;
  return all;
}

} // namespace

class ImageReader : public ImagingTest
{
};

TEST_F(ImageReader, WhatIsWrittenComesBack)
{
  const std::int64_t large = 0x123456789abcLL;
  for (const std::int64_t largestId : {std::int64_t(70000), large})
  {
    const auto image = tracedImage(33, 21, largestId);
    write(image, this->path("a.exr"));
    const auto reader = readerOf(this->path("a.exr"));
    ASSERT_EQ(reader->GetErrorMessage(), "");
    vtkImageData* back = reader->GetOutput();
    EXPECT_EQ(back->GetDimensions()[0], 33);
    EXPECT_EQ(back->GetDimensions()[1], 21);
    EXPECT_EQ(arraysOf(back), "color:4 depth:1 flow:5 normal:3 object:1 particle:1");
    EXPECT_STREQ(back->GetPointData()->GetScalars()->GetName(), "color");
    for (const char* exact : {"depth", "object", "particle", "flow"})
      expectEqual(back, image, exact, 0.0);
    // Halves have eleven bits.
    expectEqual(back, image, "normal", 1e-3);
    expectEqual(back, image, "color", 1e-3);
  }
}

TEST_F(ImageReader, BytesComeBackExactly)
{
  const auto image = tracedImage(19, 12, 1);
  auto* colors = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    const float v = static_cast<float>(i) / 255.0f;
    const float color[4] = {v, 1.0f - v, 0.2f, 1.0f};
    colors->SetTypedTuple(i, color);
  }
  for (const char* name : {"a.png", "a.tif"})
  {
    write(image, this->path(name));
    const auto reader = readerOf(this->path(name));
    ASSERT_EQ(reader->GetErrorMessage(), "");
    EXPECT_EQ(arraysOf(reader->GetOutput()), "color:3");
    vtkDataArray* back = reader->GetOutput()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(back->GetComponent(i, c), colors->GetComponent(i, c), 1e-6) << name << " " << i;
  }
}

TEST_F(ImageReader, TransparentColorsAreMultipliedByAlpha)
{
  const auto image = makeImage(4, 4, 4);
  auto* colors = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < 16; ++i)
  {
    const float alpha = static_cast<float>(i) / 15.0f;
    const float color[4] = {alpha, 0.6f * alpha, 0.0f, alpha};
    colors->SetTypedTuple(i, color);
  }
  for (const char* name : {"a.png", "a.tif"})
  {
    write(image, this->path(name));
    expectEqual(readerOf(this->path(name))->GetOutput(), image, "color", 0.003);
  }
}

TEST_F(ImageReader, ChannelsOfOtherProgramsAreGrouped)
{
  const std::vector<std::pair<std::vector<std::string>, std::string>> files = {
    {{"Z"}, "depth:1"},
    {{"Y"}, "depth:1"},
    {{"Depth.V"}, "depth:1"},
    {{"R", "G", "B", "depth.Z"}, "color:3 depth:1"},
    {{"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B",
       "ViewLayer.Combined.A", "ViewLayer.Depth.Z", "ViewLayer.Normal.X", "ViewLayer.Normal.Y",
       "ViewLayer.Normal.Z"},
      "ViewLayer.Normal:3 color:4 depth:1"},
    {{"P.X", "P.Y", "P.Z", "a"}, "P:3 a:1"},
    {{"N.X", "N.Y", "N.Z", "Z"}, "depth:1 normal:3"},
    {{"m.0", "m.1", "m.2", "m.3", "lone.Y"}, "lone.Y:1 m:4"},
    {{"glow.R", "glow.G", "glow.B", "R", "G", "B", "A"}, "color:4 glow:3"},
  };
  for (const auto& [names, arrays] : files)
  {
    writeChannels(this->path("b.exr"), names, 5, 3);
    const auto reader = readerOf(this->path("b.exr"));
    ASSERT_EQ(reader->GetErrorMessage(), "");
    EXPECT_EQ(arraysOf(reader->GetOutput()), arrays);
  }
}

TEST_F(ImageReader, RowsRunFromBelow)
{
  writeChannels(this->path("c.exr"), {"Z"}, 3, 2);
  const auto reader = readerOf(this->path("c.exr"));
  vtkDataArray* depth = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_STREQ(depth->GetName(), "depth");
  EXPECT_FLOAT_EQ(depth->GetComponent(0, 0), 0.003f);
  EXPECT_FLOAT_EQ(depth->GetComponent(3, 0), 0.0f);
}

TEST_F(ImageReader, WhatIsNoImageIsRefusedInASentence)
{
  const auto image = tracedImage(64, 64, 1);
  write(image, this->path("good.exr"));
  write(image, this->path("good.png"));
  for (const char* ending : {"exr", "png"})
  {
    std::ifstream good(this->path(std::string("good.") + ending), std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(good)), std::istreambuf_iterator<char>());
    std::ofstream(this->path(std::string("short.") + ending), std::ios::binary)
      << bytes.substr(0, bytes.size() / 2);
  }
  std::ofstream(this->path("text.exr")) << "This is no image.";
  std::ofstream(this->path("empty.png"));
  const std::string folder = this->Folder.string();
  std::vector<std::string> paths = {this->path("none.exr"), folder, this->path("text.exr"),
    this->path("empty.png"), this->path("short.exr"), this->path("short.png"), std::string()};
  // For these the libraries took gigabytes; fuzzing found them.
  for (const char* kind : {"exr", "png"})
    for (const auto& found :
      std::filesystem::directory_iterator(MOTE_SOURCE_DIR "/fuzz/found/" + std::string(kind)))
      paths.push_back(found.path().string());
  ASSERT_GE(paths.size(), 10u);
  for (const std::string& path : paths)
  {
    this->Messages->Text.clear();
    const auto reader = readerOf(path);
    const std::string sentence = reader->GetErrorMessage();
    EXPECT_EQ(sentence.rfind("Cannot read \"" + path + "\": ", 0), 0u) << sentence;
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_NE(this->Messages->Text.find(sentence), std::string::npos);
    EXPECT_NE(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << path;
  }
  EXPECT_TRUE(vtkMoteImageReader::CanReadFile(this->path("good.exr").c_str()));
  EXPECT_FALSE(vtkMoteImageReader::CanReadFile(this->path("text.exr").c_str()));
  EXPECT_FALSE(vtkMoteImageReader::CanReadFile(nullptr));
}
