// What vtkMoteImageWriter writes, read back through OpenImageIO.

#include "ImagingTestTools.h"
#include "vtkMoteImageWriter.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include <vtkIntArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

class ImageWriter : public ImagingTest
{
protected:
  /// Writes and expects success and nothing else in the folder.
  std::string write(vtkImageData* image, const std::string& name)
  {
    vtkNew<vtkMoteImageWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->path(name).c_str());
    writer->AddAttribute("Description", "two views");
    EXPECT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
    EXPECT_EQ(writer->GetErrorMessage(), "");
    EXPECT_EQ(this->countFiles(), 1);
    return this->path(name);
  }
};

/// 8-bit pixels as they are in the file, row 0 at the top.
std::vector<std::uint8_t> readBytes(const std::string& file, OIIO::ImageSpec& spec)
{
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file, &config);
  EXPECT_TRUE(input) << OIIO::geterror();
  if (!input)
    return {};
  spec = input->spec();
  std::vector<std::uint8_t> bytes(spec.image_pixels() * spec.nchannels);
  EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, bytes.data()));
  return bytes;
}

template <typename T>
std::vector<T> readChannel(const std::string& file, const std::string& name, OIIO::TypeDesc stored)
{
  auto input = OIIO::ImageInput::open(file);
  EXPECT_TRUE(input) << OIIO::geterror();
  const int channel = input->spec().channelindex(name);
  EXPECT_GE(channel, 0) << name;
  if (channel < 0)
    return {};
  EXPECT_EQ(input->spec().channelformat(channel), stored) << name;
  std::vector<T> values(input->spec().image_pixels());
  EXPECT_TRUE(
    input->read_image(0, 0, channel, channel + 1, OIIO::BaseTypeFromC<T>::value, values.data()));
  return values;
}

float& at(vtkImageData* image, const char* array, int x, int y, int component)
{
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(array));
  const int width = image->GetDimensions()[0];
  return *values->GetPointer(
    (static_cast<vtkIdType>(y) * width + x) * values->GetNumberOfComponents() + component);
}

TEST_F(ImageWriter, PngKeepsAllByteValuesAndTurnsRows)
{
  auto image = makeImage(256, 2, 4);
  for (int x = 0; x < 256; ++x)
  {
    at(image, "color", x, 0, 0) = x / 255.0f; // the bottom row
    at(image, "color", x, 0, 1) = 1.0f - x / 255.0f;
    at(image, "color", x, 1, 2) = x / 255.0f; // the top row
  }
  OIIO::ImageSpec spec;
  const std::vector<std::uint8_t> bytes = readBytes(this->write(image, "a.png"), spec);
  ASSERT_EQ(spec.nchannels, 3); // all opaque: no alpha channel
  ASSERT_EQ(bytes.size(), 256u * 2 * 3);
  for (int x = 0; x < 256; ++x)
  {
    EXPECT_EQ(bytes[x * 3 + 2], x);
    EXPECT_EQ(bytes[(256 + x) * 3], x);
    EXPECT_EQ(bytes[(256 + x) * 3 + 1], 255 - x);
  }
  EXPECT_EQ(spec.get_string_attribute("Software").substr(0, 5), "Mote ");
}

TEST_F(ImageWriter, PngHasStraightAlpha)
{
  auto image = makeImage(3, 1, 4);
  const float pixels[3][4] = {{0.25f, 0.5f, 0.0f, 0.5f}, {0, 0, 0, 0}, {1, 1, 1, 1}};
  for (int x = 0; x < 3; ++x)
    for (int c = 0; c < 4; ++c)
      at(image, "color", x, 0, c) = pixels[x][c];
  OIIO::ImageSpec spec;
  const std::vector<std::uint8_t> bytes = readBytes(this->write(image, "a.png"), spec);
  const std::vector<std::uint8_t> expected{128, 255, 0, 128, 0, 0, 0, 0, 255, 255, 255, 255};
  EXPECT_EQ(bytes, expected);
}

TEST_F(ImageWriter, JpegIsOverWhiteAndCloseToTheImage)
{
  auto image = makeImage(64, 64, 4);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const float alpha = y < 32 ? 1.0f : 0.0f; // the top half is transparent
      at(image, "color", x, y, 0) = 0.2f * alpha;
      at(image, "color", x, y, 1) = 0.6f * alpha;
      at(image, "color", x, y, 2) = 0.8f * alpha;
      at(image, "color", x, y, 3) = alpha;
    }
  }
  OIIO::ImageSpec spec;
  const std::vector<std::uint8_t> bytes = readBytes(this->write(image, "a.JPG"), spec);
  ASSERT_EQ(spec.nchannels, 3);
  EXPECT_NEAR(bytes[0], 255, 3);
  EXPECT_NEAR(bytes[(63 * 64 + 5) * 3], 51, 4);
  EXPECT_NEAR(bytes[(63 * 64 + 5) * 3 + 2], 204, 4);
}

TEST_F(ImageWriter, TiffKeepsEightBitColorsAndGrey)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* grey = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 256; ++i)
    grey[i] = static_cast<unsigned char>(i);
  OIIO::ImageSpec spec;
  const std::vector<std::uint8_t> bytes = readBytes(this->write(image, "a.tif"), spec);
  ASSERT_EQ(spec.nchannels, 1);
  for (int i = 0; i < 256; ++i)
    EXPECT_EQ(bytes[(15 - i / 16) * 16 + i % 16], i);
}

TEST_F(ImageWriter, TiffHasPremultipliedAlpha)
{
  auto image = makeImage(2, 1, 4);
  at(image, "color", 0, 0, 0) = 0.25f;
  at(image, "color", 0, 0, 1) = at(image, "color", 0, 0, 2) = 0.5f;
  at(image, "color", 0, 0, 3) = 0.5f;
  auto input = OIIO::ImageInput::open(this->write(image, "a.tiff"));
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().get_int_attribute("oiio:UnassociatedAlpha", 0), 0);
  std::uint8_t bytes[8];
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeUInt8, bytes));
  EXPECT_EQ(bytes[0], 64);
  EXPECT_EQ(bytes[1], 128);
  EXPECT_EQ(bytes[3], 128);
}

TEST_F(ImageWriter, EightBitAlphaStaysInPng)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  const std::vector<std::uint8_t> expected{200, 100, 50, 77};
  std::copy(expected.begin(), expected.end(), pixel);
  OIIO::ImageSpec spec;
  EXPECT_EQ(readBytes(this->write(image, "a.png"), spec), expected);
}

void addDepth(vtkImageData* image, int count)
{
  vtkNew<vtkFloatArray> depth;
  depth->SetName("depth");
  depth->SetNumberOfTuples(count);
  for (int i = 0; i < count; ++i)
    depth->SetValue(i, i == 0 ? std::numeric_limits<float>::infinity() : 100.0f + i / 1024.0f);
  image->GetPointData()->AddArray(depth);
  vtkNew<vtkFloatArray> normal;
  normal->SetName("normal");
  normal->SetNumberOfComponents(3);
  normal->SetNumberOfTuples(count);
  normal->FillComponent(0, 0.5);
  normal->FillComponent(1, -0.25);
  normal->FillComponent(2, 0.0);
  image->GetPointData()->AddArray(normal);
  vtkNew<vtkFloatArray> variance;
  variance->SetName("variance");
  variance->SetNumberOfTuples(count);
  variance->Fill(1.0f / 3.0f);
  image->GetPointData()->AddArray(variance);
}

void addIds(vtkImageData* image, const std::vector<std::int64_t>& ids)
{
  vtkNew<vtkTypeInt64Array> particle;
  particle->SetName("particle");
  vtkNew<vtkIntArray> object;
  object->SetName("object");
  for (const std::int64_t id : ids)
  {
    particle->InsertNextValue(id);
    object->InsertNextValue(id < 0 ? -1 : 3);
  }
  image->GetPointData()->AddArray(particle);
  image->GetPointData()->AddArray(object);
}

/// What an EXR holds of a colour: light, by the definition of sRGB.
double light(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}
constexpr double halfStep = 1.0 / 2048; // relative rounding of half floats

TEST_F(ImageWriter, ExrHasAllLayers)
{
  auto image = makeImage(2, 2, 4);
  at(image, "color", 1, 0, 0) = 0.125f;
  addDepth(image, 4);
  addIds(image, {-1, 0, 4294967294, 7});
  const std::string file = this->write(image, "a.exr");
  // In the file the rows are turned: pixels 2, 3, 0, 1.
  const auto red = readChannel<float>(file, "R", OIIO::TypeHalf);
  EXPECT_EQ(std::vector<float>(red.begin(), red.begin() + 3), std::vector<float>(3, 1.0f));
  EXPECT_NEAR(red[3], light(0.125), halfStep * light(0.125));
  const auto z = readChannel<float>(file, "Z", OIIO::TypeFloat);
  EXPECT_EQ(z, (std::vector<float>{100.0f + 2 / 1024.0f, 100.0f + 3 / 1024.0f,
                 std::numeric_limits<float>::infinity(), 100.0f + 1 / 1024.0f}));
  EXPECT_EQ(readChannel<float>(file, "N.X", OIIO::TypeHalf)[0], 0.5f);
  EXPECT_EQ(readChannel<float>(file, "N.Y", OIIO::TypeHalf)[0], -0.25f);
  EXPECT_EQ(readChannel<float>(file, "variance", OIIO::TypeFloat)[3], 1.0f / 3.0f);
  const auto particle = readChannel<std::uint32_t>(file, "particle", OIIO::TypeUInt32);
  EXPECT_EQ(particle, (std::vector<std::uint32_t>{4294967294u, 7, 0xffffffffu, 0}));
  const auto object = readChannel<std::uint32_t>(file, "object", OIIO::TypeUInt32);
  EXPECT_EQ(object, (std::vector<std::uint32_t>{3, 3, 0xffffffffu, 3}));
  auto input = OIIO::ImageInput::open(file);
  EXPECT_EQ(input->spec().channelindex("A"), -1);
  EXPECT_EQ(input->spec().get_string_attribute("compression"), "zip");
  EXPECT_EQ(input->spec().get_string_attribute("ImageDescription"), "two views");
}

TEST_F(ImageWriter, ExrSplitsLargeIds)
{
  const std::vector<std::int64_t> ids{-1, 4294967295, 9007199254740993, 5};
  auto image = makeImage(4, 1, 4);
  at(image, "color", 0, 0, 3) = 0.5f;
  addIds(image, ids);
  const std::string file = this->write(image, "a.exr");
  const auto high = readChannel<std::uint32_t>(file, "particle.high", OIIO::TypeUInt32);
  const auto low = readChannel<std::uint32_t>(file, "particle.low", OIIO::TypeUInt32);
  ASSERT_EQ(high.size(), 4u);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(static_cast<std::int64_t>((std::uint64_t(high[i]) << 32) | low[i]), ids[i]);
  EXPECT_EQ(readChannel<float>(file, "A", OIIO::TypeHalf)[0], 0.5f);
}

TEST_F(ImageWriter, ExrOfManyRowsIsWhole)
{
  auto image = makeImage(3, 1000, 3);
  for (int y = 0; y < 1000; ++y)
    at(image, "color", 1, y, 1) = y / 1024.0f;
  const auto green = readChannel<float>(this->write(image, "a.exr"), "G", OIIO::TypeHalf);
  for (int y = 0; y < 1000; ++y)
  {
    const double wanted = light(y / 1024.0);
    EXPECT_NEAR(green[(999 - y) * 3 + 1], wanted, halfStep * wanted + 1e-7);
  }
}

TEST_F(ImageWriter, ExrBringsColoursToLightBeforeAlpha)
{
  auto image = makeImage(1, 1, 4);
  at(image, "color", 0, 0, 0) = 0.25f; // 0.5 seen through an alpha of one half
  at(image, "color", 0, 0, 3) = 0.5f;
  const std::string file = this->write(image, "a.exr");
  EXPECT_NEAR(readChannel<float>(file, "R", OIIO::TypeHalf)[0], 0.5 * 0.21404114, 1e-4);
  EXPECT_EQ(readChannel<float>(file, "A", OIIO::TypeHalf)[0], 0.5f);
}

TEST_F(ImageWriter, ArraysOfTakenNamesAreReported)
{
  auto image = makeImage(2, 2, 3);
  vtkNew<vtkFloatArray> other;
  other->SetName("R");
  other->SetNumberOfTuples(4);
  other->Fill(0.0);
  image->GetPointData()->AddArray(other);
  this->write(image, "a.exr");
  EXPECT_NE(this->Messages->Text.find("without the array \"R\""), std::string::npos);
}

TEST_F(ImageWriter, ReplacesAFileAndItsLinkStays)
{
  auto image = makeImage(2, 2, 3);
  this->write(image, "a.png");
  std::filesystem::create_symlink("a.png", this->path("link.png"));
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetInputData(makeImage(5, 5, 3));
  writer->SetFileName(this->path("link.png").c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_TRUE(std::filesystem::is_symlink(this->path("link.png")));
  OIIO::ImageSpec spec;
  readBytes(this->path("a.png"), spec);
  EXPECT_EQ(spec.width, 5);
  EXPECT_EQ(this->countFiles(), 2);
}

TEST_F(ImageWriter, PngKeepsTextsInAnyLanguage)
{
  vtkNew<vtkMoteImageWriter> writer;
  auto image = makeImage(3, 70, 1);
  writer->SetInputData(image);
  writer->SetFileName(this->path("a.png").c_str());
  const std::pair<const char*, const char*> texts[] = {{"Description", "Kr\u00e4fte, \u00b5N"},
    {"Artist", "A. Nobody"}, {"Camera", "from above"}, {"Software", "own"}};
  for (const auto& [name, value] : texts)
    writer->AddAttribute(name, value);
  ASSERT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
  const auto input = OIIO::ImageInput::open(this->path("a.png"));
  const OIIO::ImageSpec& spec = input->spec();
  EXPECT_EQ(spec.get_string_attribute("ImageDescription"), texts[0].second);
  EXPECT_EQ(spec.get_string_attribute("Artist"), texts[1].second);
  EXPECT_EQ(spec.get_string_attribute("Camera"), texts[2].second);
  EXPECT_EQ(spec.get_string_attribute("Software"), texts[3].second);
  EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
}

TEST_F(ImageWriter, RefusesAttributesThatFormatsNeed)
{
  vtkNew<vtkMoteImageWriter> writer;
  for (const char* name : {"", "Compression", "oiio:ColorSpace", "dataWindow", " x", "caf\u00e9"})
    writer->AddAttribute(name, "v");
  EXPECT_EQ(writer->GetNumberOfAttributes(), 0);
  writer->AddAttribute("Camera", "1");
  writer->AddAttribute("camera", "2");
  EXPECT_EQ(writer->GetNumberOfAttributes(), 1);
}

} // namespace
