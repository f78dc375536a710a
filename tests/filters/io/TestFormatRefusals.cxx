// What is wrong with a damaged glTF or legacy file is said in the words of the format, and forms of
// them that are seldom seen pass.
#include "MeshSamples.h"
#include "TableTest.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

using Json = nlohmann::json;

class TestFormatRefusals : public TableTest
{
protected:
  vtkIdType cellsOf(const std::string& file)
  {
    EXPECT_EQ(errorOf(file), "");
    auto* blocks = vtkCompositeDataSet::SafeDownCast(m_data);
    auto* set = vtkDataSet::SafeDownCast(m_data);
    return blocks ? blocks->GetNumberOfCells() : set ? set->GetNumberOfCells() : -1;
  }
};

/// A triangle, with its numbers in one buffer, which is left out where it is a chunk of its own.
Json triangle(bool hasBuffer = true)
{
  Json model = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "buffers": [{"byteLength": 42}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3,
                   "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 3}]})");
  if (hasBuffer)
    model["buffers"][0]["uri"] = "data:application/octet-stream;base64,"
                                 "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA";
  return model;
}

std::string word(std::size_t number)
{
  const auto bits = static_cast<std::uint32_t>(number);
  return {reinterpret_cast<const char*>(&bits), sizeof bits};
}

/// The same as one binary file.
std::string binaryTriangle(std::size_t saysMore = 0)
{
  std::string text = triangle(false).dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string bytes(44, '\0');
  const float one = 1;
  std::memcpy(bytes.data() + 12, &one, sizeof one);
  std::memcpy(bytes.data() + 28, &one, sizeof one);
  bytes[38] = 1;
  bytes[40] = 2;
  return "glTF" + word(2) + word(12 + 8 + text.size() + 8 + bytes.size()) + word(text.size()) +
         "JSON" + text + word(bytes.size() + saysMore) + std::string("BIN\0", 4) + bytes;
}

std::string repeated(const std::string& text, std::size_t times)
{
  std::string all;
  for (std::size_t i = 0; i < times; ++i)
    all += text;
  return all;
}

/// An XML file of a point, with more in one of its elements.
std::string pointWith(const std::string& more)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece "
         "NumberOfPoints=\"1\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
         "NumberOfPolys=\"0\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"ascii\">1 2 3</DataArray></Points>" +
         more + "</Piece></PolyData></VTKFile>";
}

TEST_F(TestFormatRefusals, ElementsThatLieInOneAnotherTooDeeply)
{
  const std::string wrong = "lie in one another too deeply";
  const auto nested = [](const std::string& begin, std::size_t depth)
  { return repeated(begin, depth) + repeated("</a>", depth); };
  EXPECT_EQ(errorOf(write("a.vtp", pointWith(nested("<a>", 50)))), "");
  constexpr std::size_t depth = 500000;
  expectError(write("b.vtp", pointWith(nested("<a>", depth))), wrong);
  // What looks like an end is none.
  expectError(write("c.vtp", pointWith(nested("<a><!-- </a> -->", depth))), wrong);
  expectError(write("d.vtp", pointWith(nested("<a><![CDATA[</a>]]>", depth))), wrong);
  expectError(write("e.vtp", pointWith(nested("<a b='/>'>", depth))), wrong);
  expectError(write("f.vtp", pointWith(nested("<a b=\"></a>\">", depth))), wrong);
  expectError(write("g.vtp", "<!DOCTYPE a [<!ENTITY b '<c></c>'>]>" + pointWith("&b;")),
    "declarations of XML are not read");
  for (const char* type : {"UnstructuredGrid", "ImageData", "RectilinearGrid", "StructuredGrid"})
    expectError(
      write(std::string("h.vt") + char(std::tolower(type[0])),
        "<VTKFile type=\"" + std::string(type) + "\">" + nested("<a>", depth) + "</VTKFile>"),
      wrong);
  expectError(write("i.vtm", "<VTKFile type=\"vtkMultiBlockDataSet\"><vtkMultiBlockDataSet>" +
                               nested("<a>", depth) + "</vtkMultiBlockDataSet></VTKFile>"),
    wrong);
  expectError(write("j.pvd", "<VTKFile type=\"Collection\"><Collection>" + nested("<a>", depth) +
                               "</Collection></VTKFile>"),
    wrong);
  std::filesystem::create_directory(path("k.uda"));
  write("k.uda/index.xml", "<Uintah_DataArchive>" + nested("<a>", depth) + "</Uintah_DataArchive>");
  expectError(path("k.uda"), wrong);
}

TEST_F(TestFormatRefusals, EntriesOfOpenFOAMThatLieInOneAnotherTooDeeply)
{
  constexpr std::size_t depth = 500000;
  const auto nested = [&](const std::string& begin, const std::string& end)
  { return " x " + repeated(begin, depth) + repeated(end, depth) + "; "; };
  const auto refused = [&](const std::string& file, const std::string& before,
                         const std::string& more, bool isBinary = false)
  {
    SCOPED_TRACE(file + " at " + before + more.substr(0, 12));
    const std::string folder = path("deep");
    std::filesystem::remove_all(folder);
    const std::string foam = samples::writeFoam(folder, {isBinary});
    std::string text = textOf("deep/" + file);
    const std::size_t at = text.find(before);
    ASSERT_NE(at, text.npos);
    text.insert(at + before.size(), more);
    write("deep/" + file, text);
    expectError(foam, "lie in one another too deeply");
    packFoam("deep");
    expectError(foam, "lie in one another too deeply");
  };
  refused("0/p", "boundaryField\n{", nested("{ x ", "}"));
  refused("0/p", "boundaryField\n{", nested("{ x ", "}"), true);
  refused("0/p", "boundaryField\n{", nested("{ x\x80 ", "}"), true);
  refused("0/p", "boundaryField\n{", nested("(", ")"));
  refused("0/p", "boundaryField\n{", nested("{ // }\n", "}"));
  refused("0/p", "boundaryField\n{", nested("{ /* } */ x ", "}"));
  refused("0/p", "boundaryField\n{", nested("{ x \"}\\\"}\"; y ", "}"));
  refused("0/p", "FoamFile\n{", nested("{ x ", "}"));
  refused("constant/polyMesh/boundary", "FoamFile\n{", nested("{ x ", "}"));
  refused("constant/polyMesh/boundary", "inlet\n    {", nested("{ x ", "}"));
  refused("constant/polyMesh/points", "FoamFile\n{", nested("{ x ", "}"));
}

/// What makes a text of a number from 0 to below `count`, one behind the other.
template <class Text>
std::string numbered(std::size_t count, const Text& text)
{
  std::string all;
  for (std::size_t i = 0; i < count; ++i)
    all += text(std::to_string(i));
  return all;
}

TEST_F(TestFormatRefusals, MoreArraysThanDataSetsCanLookThrough)
{
  constexpr std::size_t few = 2000, many = 200000;
  const std::string wrong = "more than 10000 ";
  const auto csv = [](std::size_t n)
  {
    return "x,y,z" + numbered(n, [](const std::string& i) { return ",c" + i; }) + "\n1,2,3" +
           repeated(",1", n) + "\n";
  };
  const auto dump = [](std::size_t n)
  {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 "
           "1\nITEM: ATOMS id x y z" +
           numbered(n, [](const std::string& i) { return " c" + i; }) + "\n1 0 0 0" +
           repeated(" 1", n) + "\n";
  };
  const auto xyz = [](std::size_t n)
  {
    return "1\nProperties=species:S:1:pos:R:3" +
           numbered(n, [](const std::string& i) { return ":c" + i + ":R:1"; }) + "\nAr 0 0 0" +
           repeated(" 1", n) + "\n";
  };
  const auto legacy = [](std::size_t n)
  {
    return "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 "
           "0\nVERTICES 1 2\n1 0\nPOINT_DATA 1\n" +
           numbered(n, [](const std::string& i)
             { return "SCALARS c" + i + " float\nLOOKUP_TABLE default\n1\n"; });
  };
  const auto xml = [](std::size_t n)
  {
    return pointWith(
      "<PointData>" +
      numbered(n, [](const std::string& i)
        { return "<DataArray type=\"Int8\" Name=\"" + i + "\" format=\"ascii\">1</DataArray>"; }) +
      "</PointData>");
  };
  EXPECT_EQ(errorOf(write("a.csv", csv(few))), "");
  EXPECT_EQ(errorOf(write("a.dump", dump(few))), "");
  EXPECT_EQ(errorOf(write("a.xyz", xyz(few))), "");
  EXPECT_EQ(errorOf(write("a.vtk", legacy(few))), "");
  EXPECT_EQ(errorOf(write("a.vtp", xml(few))), "");
  expectError(write("b.csv", csv(many)), wrong + "columns");
  expectError(write("b.dump", dump(many)), wrong + "columns");
  expectError(write("b.xyz", xyz(many)), wrong + "properties");
  expectError(write("b.vtk", legacy(many)), wrong + "arrays");
  expectError(write("b.vtp", xml(many)), wrong + "arrays");
  const std::string begin = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                            "float y\nproperty float z\n",
                    end = "end_header\n0 0 0\n";
  const auto line = [](const std::string& i) { return "property float c" + i + "\n"; };
  expectError(write("a.ply", begin + numbered(many, line) + end), wrong + "properties");
  const auto element = [](const std::string& i)
  { return "element e" + i + " 1\nproperty float a\n"; };
  expectError(write("b.ply", begin + numbered(many, element) + end), wrong + "elements");
}

TEST_F(TestFormatRefusals, NodesOfGLTFThatLieBelowOneAnother)
{
  const auto chain = [](std::size_t length)
  {
    Json model = triangle();
    model["nodes"] = Json::array();
    for (std::size_t i = 1; i < length; ++i)
      model["nodes"].push_back({{"children", {i}}});
    model["nodes"].push_back({{"mesh", 0}});
    return model.dump();
  };
  EXPECT_EQ(cellsOf(write("a.gltf", chain(900))), 1);
  expectError(write("b.gltf", chain(100000)), "more nodes below one another");
  std::string deep = triangle().dump();
  deep.insert(
    1, "\"materials\": [" + repeated("{\"a\": ", 500000) + "1" + repeated("}", 500000) + "], ");
  expectError(write("c.gltf", deep), "lie in one another too deeply");
}

TEST_F(TestFormatRefusals, BinaryGLTF)
{
  EXPECT_EQ(cellsOf(write("a.glb", binaryTriangle())), 1);
  expectError(write("b.glb", binaryTriangle(4)), "ends too early");
  expectError(write("c.glb", binaryTriangle().substr(0, 200)), "ends too early");
}

TEST_F(TestFormatRefusals, GLTFThatNamesWhatItLacks)
{
  EXPECT_EQ(cellsOf(write("a.gltf", triangle().dump())), 1);
  const auto refused =
    [&](const std::string& place, const std::string& value, const std::string& words)
  {
    Json model = triangle();
    model[Json::json_pointer(place)] = Json::parse(value);
    SCOPED_TRACE(place + " = " + value);
    expectError(write("a.gltf", model.dump()), words);
  };
  refused("/scene", "1", "asks for scenes that it lacks");
  refused("/scenes/0/nodes", "[0, 7]", "asks for nodes that it lacks");
  refused("/nodes/0/mesh", "-1", "asks for meshes that it lacks");
  refused("/nodes/0/skin", "0", "asks for skins that it lacks");
  refused("/nodes/0/camera", "0", "asks for cameras that it lacks");
  refused("/nodes/0/children", "[0]", "a node below itself");
  refused("/nodes", R"([{"children": [1, 1]}, {"mesh": 0}])", "a node twice");
  refused("/nodes", R"([{"children": [3]}, {"mesh": 0}])", "asks for nodes that it lacks");
  refused("/meshes/0/primitives/0/indices", "2", "asks for accessors that it lacks");
  refused("/meshes/0/primitives/0/material", "0", "asks for materials that it lacks");
  refused("/meshes/0/primitives/0/attributes", "{}", "values for POSITION");
  refused("/meshes/0/primitives/0/attributes/POSITION", "1", "the right type for POSITION");
  refused("/meshes/0/primitives/0/indices", "0", "the right type for indices");
  refused("/meshes/0/primitives/0/targets", R"([{"POSITION": 9}])", "asks for accessors");
  refused("/accessors/0/sparse", R"({"count": 1})", "sparse values are not read");
  refused("/textures", R"([{"source": 0}])", "asks for images that it lacks");
  refused("/textures", R"([{"sampler": 0}])", "asks for samplers that it lacks");
  refused("/images", R"([{"bufferView": 2}])", "asks for bufferViews that it lacks");
  refused("/materials", R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 3}}}])",
    "asks for textures that it lacks");
  refused("/skins", R"([{"joints": [1]}])", "asks for nodes that it lacks");
  refused("/skins", R"([{"joints": [0], "skeleton": 4}])", "asks for nodes that it lacks");
  refused("/skins", R"([{"joints": [], "inverseBindMatrices": 2}])", "asks for accessors");
  refused("/animations", R"([{"channels": [{"sampler": 0, "target": {}}]}])", "asks for samplers");
  refused("/animations",
    R"([{"channels": [{"sampler": 0, "target": {"node": 1}}], "samplers": [{"input": 0, "output": 1}]}])",
    "asks for nodes that it lacks");
  refused("/animations", R"([{"samplers": [{"input": 0}]}])", "asks for accessors that it lacks");
  refused("/extensionsRequired", R"(["KHR_mesh_quantization"])", "needs KHR_mesh_quantization");
  refused("/bufferViews/1/byteLength", "7", "its views ask for more");
  refused("/bufferViews/1/buffer", "1", "its views ask for more");
  refused("/accessors/1/componentType", "5124", "its accessors ask for more");
  refused("/accessors/0/type", "\"VEC9\"", "its accessors ask for more");
  refused("/buffers/0/byteLength", "43", "shorter than they say");
}

const std::string head = "# vtk DataFile Version 3.0\na test\nASCII\n";
const std::string points = "DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
const std::string polygon = "POLYGONS 1 4\n3 0 1 2\n";

TEST_F(TestFormatRefusals, LegacyAttributesOfAllKindsPass)
{
  const std::string attributes =
    "POINT_DATA 3\n"
    "SCALARS s float 2\nLOOKUP_TABLE colours\n1 2 3 4 5 6\n"
    "LOOKUP_TABLE colours 2\n0 0 0 1 1 1 1 1\n"
    "TEXTURE_COORDINATES t 2 float\n0 0 1 0 0 1\n"
    "VECTORS v float\n1 0 0 0 1 0 0 0 1\n"
    "NORMALS n float\n0 0 1 0 0 1 0 0 1\n"
    "TENSORS e float\n1 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1\n"
    "FIELD more 2\nNULL_ARRAY\na 1 3 int\n4 5 6\n"
    "METADATA\nINFORMATION 0\n\n";
  ASSERT_EQ(cellsOf(write("a.vtk", head + points + polygon + attributes)), 1);
  vtkPointData* data = vtkDataSet::SafeDownCast(m_data)->GetPointData();
  for (const char* name : {"s", "t", "v", "n", "e", "a"})
    EXPECT_TRUE(data->GetAbstractArray(name)) << name;
  ASSERT_EQ(cellsOf(write("b.vtk",
              head + points + polygon + "POINT_DATA 3\nCOLOR_SCALARS c 3\n0 0 0 1 0 0 0 1 0\n")),
    1);
  data = vtkDataSet::SafeDownCast(m_data)->GetPointData();
  auto* colors = vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray("c"));
  ASSERT_TRUE(colors);
  EXPECT_EQ(colors->GetTypedComponent(1, 0), 255);
}

/// Cells of binary files are walked through, too.
TEST_F(TestFormatRefusals, LegacyBinaryCells)
{
  const auto words = [](std::initializer_list<int> numbers)
  {
    std::string bytes;
    for (const int number : numbers)
      bytes += std::string(3, number < 0 ? '\xff' : '\0') + static_cast<char>(number);
    return bytes;
  };
  const std::string binary = "# vtk DataFile Version 3.0\na test\nBINARY\nDATASET POLYDATA\n"
                             "POINTS 3 int\n" +
                             words({0, 0, 0, 1, 0, 0, 0, 1, 0}) + "\nPOLYGONS 1 4\n";
  EXPECT_EQ(cellsOf(write("a.vtk", binary + words({3, 0, 1, 2}) + "\n")), 1);
  expectError(write("a.vtk", binary + words({2, 0, 1, 2}) + "\n"), "1 numbers too many");
  expectError(write("a.vtk", binary + words({-1, 0, 1, 2}) + "\n"), "do not fill the list");
  expectError(write("a.vtk", binary + words({3, 0, 1, 2}) + "x\n"), "not followed by a line's end");
  expectError(write("a.vtk", binary + words({3, 0, 1})), "truncated");
}

TEST_F(TestFormatRefusals, LegacyWordsInTheWrongPlace)
{
  const std::string data = head + points + polygon + "POINT_DATA 3\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"# vtk DataFile Version 3.0\n" + std::string(256, 'a') + "\nASCII\n" + points, "its title"},
    {"# vtk DataFile Version 3.0\na\nASCI\n" + points, "expected ASCII or BINARY, found 'ASCI'"},
    {head + "DATASETS POLYDATA\n", "expected DATASET, found 'datasets'"},
    {head + "DATASET MULTIBLOCK\nCHILDREN 99999\n", "no room for 99999 blocks"},
    {head + points + "POLYGONS x 4\n3 0 1 2\n", "'x' stands where the number of cells"},
    {head + points + "POLYGONS 1 " + std::string(300, '1') + "\n3 0 1 2\n", "a word of 300 bytes"},
    {data + "SCALARS s float 2\n1 2 3 4 5 6\n", "expected LOOKUP_TABLE"},
    {data + "SCALARS s float 0\nLOOKUP_TABLE default\n", "no scalars of 0 components"},
    {data + "COLOR_SCALARS c 100001\n", "no 100001 colours or components"},
    {data + "FIELD f 1\na 100001 1 int\n1\n", "no array of 100001 components"},
    {"# vtk DataFile Version 5.1\na\nASCII\n" + points + "POLYGONS 2 3\nOFFSET vtktypeint64\n0 3\n",
      "expected OFFSETS"},
    {"# vtk DataFile Version 5.1\na\nASCII\n" + points +
        "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTION vtktypeint64\n0 1 2\n",
      "expected CONNECTIVITY"}};
  for (const auto& [text, words] : cases)
  {
    SCOPED_TRACE(words);
    expectError(write("a.vtk", text), words);
  }
}

TEST_F(TestFormatRefusals, PLYHeaders)
{
  const std::string vertices =
    "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string begin = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(cellsOf(write("a.ply", begin + vertices + "end_header\n0 0 0\n")), 0);
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"ply\nformat text 1.0\n" + vertices + "end_header\n0 0 0\n", "expected 'format ascii 1.0'"},
    {begin + "property float x\nend_header\n", "before the first element"},
    {begin + "element vertex 1\nproperty float\nend_header\n", "expected 'property TYPE NAME'"},
    {begin + "element vertex 1\nend_header\n", "'vertex' has no properties"},
    {begin + "\n" + vertices + "end_header\n0 0 0\n", "this line of the header is empty"},
    {begin + "comment \x01\n" + vertices + "end_header\n0 0 0\n", "control characters"},
    {begin + "comment " + std::string(5000, 'a') + "\n" + vertices + "end_header\n0 0 0\n",
      "is longer than"}};
  for (const auto& [text, words] : cases)
  {
    SCOPED_TRACE(words);
    expectError(write("a.ply", text), words);
  }
  expectError(writeGzip("b.ply", begin + vertices + "end_header\n0 0 0\n"), "gunzip");
}

} // namespace
