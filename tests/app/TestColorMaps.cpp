// Colour maps by name and of files.

#include "base/Failure.h"
#include "stage/ColorMapFile.h"
#include "stage/ColorMaps.h"

#include <vtkLookupTable.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

using namespace mote::app;
namespace fs = std::filesystem;

namespace
{

/// As ParaView exports its presets.
constexpr const char* twoMaps = R"([
  {"Name": "Cool to warm", "ColorSpace": "RGB", "NanColor": [1, 1, 0], "Creator": "a test",
   "RGBPoints": [-2, 0, 0, 1, 0, 1, 1, 1, 6, 1, 0, 0]},
  {"Name": "Three", "IndexedColors": [1, 0, 0, 0, 1, 0, 0, 0, 1], "Annotations": ["a", "b", "c"]}
])";

class ColorMaps : public ::testing::Test
{
protected:
  ColorMaps()
  {
    std::string name = fs::temp_directory_path() / "mote-maps-XXXXXX";
    folder = mkdtemp(name.data());
  }
  ~ColorMaps() override { fs::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  static Color colorAt(const std::string& map, int index)
  {
    const double range[2] = {0.0, 1.0};
    double rgba[4];
    makeColorMap(map, range, false)->GetTableValue(index, rgba);
    return {rgba[0], rgba[1], rgba[2]};
  }
  /// Tables hold bytes.
  static void expectNear(const Color& color, const Color& expected, double slack = 0.501 / 255.0)
  {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(color[k], expected[k], slack) << k;
  }
  void expectError(const std::string& text, const std::string& sentence) const
  {
    try
    {
      readColorMapFile(this->write("wrong", text));
      FAIL() << "no error: " << text;
    }
    catch (const Failure& failure)
    {
      const std::string what = failure.what();
      EXPECT_NE(what.find(sentence), what.npos) << what;
      EXPECT_EQ(what.find('\n'), what.npos) << what;
    }
  }

  fs::path folder;
};

} // namespace

TEST_F(ColorMaps, NamesHaveColours)
{
  EXPECT_EQ(colorMapNames().front(), "viridis");
  EXPECT_EQ(colorMapNames().back(), "types");
  for (const std::string& name : colorMapNames())
    EXPECT_NE(colorAt(name, 0), colorAt(name, 100)) << name;
  expectNear(colorAt("turbo", 255), {0x7a / 255.0, 0x04 / 255.0, 0x03 / 255.0});
  EXPECT_EQ(colorAt("twilight", 0), colorAt("twilight", 255)); // goes round
  const double range[2] = {0.0, 1.0};
  EXPECT_THROW(makeColorMap("rainbow", range, false), Failure);
}

TEST_F(ColorMaps, LinesOfColours)
{
  for (const char* text : {"0 0 0\n1 0.5 0.25\n", "# a map\n\n0,0,0\r\n255;127.5;63.75\n",
         "0 0 0 1\n1 0.5 0.25 1 # opaque"})
  {
    const std::string file = this->write("map.txt", text);
    expectNear(colorAt(file, 0), {0.0, 0.0, 0.0});
    expectNear(colorAt(file, 255), {1.0, 0.5, 0.25});
    expectNear(colorAt(file, 51), {0.2, 0.1, 0.05});
    fs::remove(file);
  }
  const ColorMapFile map = readColorMapFile(this->write("hex.txt", "#ff0000\n# or\n#0f0\n"));
  EXPECT_EQ(map.colors, (std::vector<Color>{{1, 0, 0}, {0, 1, 0}}));
}

TEST_F(ColorMaps, ATableOf256IsTakenAsItIs)
{
  std::ostringstream text;
  text << std::setprecision(17);
  for (int i = 0; i < 256; ++i)
    text << i * i / 65025.0 << ' ' << std::abs(std::sin(i)) << ' ' << 1.0 - i / 255.0 << '\n';
  const std::string file = this->write("map.dat", text.str());
  for (int i = 0; i < 256; ++i)
    expectNear(colorAt(file, i), {i * i / 65025.0, std::abs(std::sin(i)), 1.0 - i / 255.0});
}

TEST_F(ColorMaps, ExportedByParaView)
{
  const std::string file = this->write("maps.json", twoMaps);
  expectNear(colorAt(file, 0), {0, 0, 1});
  expectNear(colorAt(file, 255), {1, 0, 0});
  expectNear(colorAt(file, 64), {1, 1, 1}, 0.01); // a quarter of the way from -2 to 6
  const double range[2] = {0.0, 1.0};
  const double* none = makeColorMap(file, range, false)->GetNanColor();
  expectNear({none[0], none[1], none[2]}, {1, 1, 0});
  for (int i = 0; i < 256; ++i)
  {
    Color expected = {0, 0, 0};
    expected[static_cast<std::size_t>(3 * i / 256)] = 1.0;
    EXPECT_EQ(colorAt(file + ":Three", i), expected) << i;
  }
  try
  {
    readColorMapFile(file + ":Four");
    FAIL();
  }
  catch (const Failure& failure)
  {
    EXPECT_EQ(failure.what(), file + " has no colour map Four; there are Cool to warm, Three");
  }
  const std::string alone =
    this->write("one.json", R"({"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "ColorSpace": "Step"})");
  for (int i = 0; i < 256; ++i)
    EXPECT_TRUE(colorAt(alone, i) == Color({0, 0, 0}) || colorAt(alone, i) == Color({1, 1, 1}))
      << i;
}

TEST_F(ColorMaps, ColoursAreMixedAsTheFileSays)
{
  const auto middle = [&](const std::string& space)
  {
    return colorAt(this->write(space + ".json", R"({"ColorSpace": ")" + space +
                                                  R"(", "RGBPoints": [0, 0, 0, 1, 1, 1, 0, 0]})"),
      128);
  };
  expectNear(middle("RGB"), {0.5, 0, 0.5}, 0.01);
  expectNear(middle("Diverging"), {1, 1, 1}, 0.15); // white between
  expectNear(middle("HSV"), {1, 0, 1}, 0.02);       // the shorter way round
  for (const char* space : {"Lab", "CIELAB", "CIEDE2000"})
    EXPECT_GT(middle(space)[0], 0.6) << space;
}

TEST_F(ColorMaps, AFileThatIsWrittenAgainIsReadAgain)
{
  const std::string file = this->write("map.txt", "0 0 0\n1 1 1\n");
  expectNear(colorAt(file, 255), {1, 1, 1});
  this->write("map.txt", "0 0 0\n1 0 0\n");
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
  expectNear(colorAt(file, 255), {1, 0, 0});
}

TEST_F(ColorMaps, WrongFiles)
{
  EXPECT_THROW(readColorMapFile(folder / "missing.json"), Failure);
  EXPECT_THROW(readColorMapFile(folder), Failure);
  expectError("", "two colours or more");
  expectError("1 1 1\n", "two colours or more");
  expectError("0 0 0\n1 1\n", "line 2: a colour has red, green and blue, not 2 numbers");
  expectError("0 0 0\n0.5 1 1 1 0.5\n", "not 5 numbers");
  expectError("0 0 0\n300 1 1\n", "line 2: 300 is no share of a colour");
  expectError("r g b\n0 0 0\n1 1 1\n", "line 1: r is no share of a colour");
  expectError("0 0 0\n-1 1 1\n", "-1 is no share of a colour");
  expectError("0 0 0\nnan 1 1\n", "nan is no share of a colour");
  expectError("0 0 0\n#ffffff\n", "some colours are numbers");
  expectError("[{\"RGBPoints\": [0, 0", "is no JSON, or is truncated");
  expectError(std::string(2'000'000, '[') + std::string(2'000'000, ']'), "too deeply");
  expectError("[]", "there is no colour map in this file");
  expectError("[1, 2]", "there is no colour map in this file");
  expectError("{\"mote-session\": 1}", "neither RGBPoints nor IndexedColors");
  expectError("{\"RGBPoints\": 1}", "must be a list of numbers");
  expectError("{\"RGBPoints\": [0, 0, 0, \"1\"]}", "must be a list of numbers");
  expectError("{\"RGBPoints\": [0, 0, 0, 1]}", "not 4 numbers");
  expectError("{\"RGBPoints\": [0, 0, 0, 1, 1]}", "not 5 numbers");
  expectError("{\"RGBPoints\": [0, 0, 0, 1, 0, 1, 1, 1]}", "have one value");
  expectError("{\"RGBPoints\": [0, 0, 0, 1, 1, 1, 1, 2]}", "2 is outside");
  expectError("{\"RGBPoints\": [-1e308, 0, 0, 1, 1e308, 1, 1, 1]}", "have one value");
  expectError("{\"RGBPoints\": [0, 0, 0, 1, 1, 1, 1, 1], \"ColorSpace\": \"x\"}", "called \"x\"");
  expectError(
    "{\"RGBPoints\": [0, 0, 0, 1, 1, 1, 1, 1], \"ColorSpace\": \"x\\ny\"}", "called \"x?y\"");
  expectError("{\"IndexedColors\": [0, 0, 0]}", "2 colours or more");
}

TEST_F(ColorMaps, CutAnywhere)
{
  const std::string texts[] = {
    twoMaps, "# a map\n0 0 0\n12 34 56\n255 255 255\n", "#ff0\n#00ff00\n"};
  int read = 0;
  for (const std::string& text : texts)
    for (std::size_t size = 0; size <= text.size(); ++size)
      try
      {
        EXPECT_GE(readColorMapFile(this->write("cut", text.substr(0, size))).colors.size(), 2u);
        ++read;
      }
      catch (const Failure&)
      {
      }
  EXPECT_GE(read, 3);
}
