#include "GLTFCheck.h"

#include "FileError.h"

#include "kernels/core/JsonDepth.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <vector>

namespace mote
{

namespace
{

using Json = nlohmann::json;
using Size = std::uint64_t;

constexpr Size most = Size{1} << 48;

/// The description, and how many bytes a binary file holds beside it.
struct Model
{
  Json json;
  Size binary = 0;
};

std::uint32_t wordAt(const std::string& bytes, std::size_t at)
{
  std::uint32_t word = 0;
  if (at + sizeof word <= bytes.size())
    std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

Model modelOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw FileError(FileError::Kind::CannotOpen, path, "cannot be read");
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  Model model;
  std::string text = bytes;
  if (bytes.starts_with("glTF"))
  {
    // A header of 12 bytes, then chunks of a length, a type and as many bytes.
    const Size length = wordAt(bytes, 12);
    if (20 + length > bytes.size())
      throw FileError(FileError::Kind::Truncated, path, "the file ends too early");
    text = bytes.substr(20, length);
    const Size next = 20 + length;
    model.binary = wordAt(bytes, next);
    if (next < bytes.size() && next + 8 + model.binary > bytes.size())
      throw FileError(FileError::Kind::Truncated, path, "the file ends too early");
  }
  if (isDeepJson(text))
    throw FileError(
      FileError::Kind::Malformed, path, "lists of JSON lie in one another too deeply");
  model.json = Json::parse(text, nullptr, false);
  if (!model.json.is_object() || !model.json.contains("asset"))
    throw FileError(FileError::Kind::OtherFormat, path, "is no glTF file");
  return model;
}

Size numberOf(const Json& object, const char* name, Size usual = 0)
{
  const auto found = object.find(name);
  const Size value =
    found != object.end() && found->is_number_unsigned() ? found->get<Size>() : usual;
  return std::min(value, most); // sums of such stay numbers
}

/// The bytes that a buffer has, whatever it says.
Size bytesOf(const std::string& path, const Json& buffer, Size binary)
{
  const std::string uri = buffer.value("uri", "");
  if (uri.empty())
    return binary;
  if (uri.starts_with("data:"))
  {
    const std::size_t comma = uri.find(',');
    const Size digits = comma == std::string::npos ? 0 : uri.size() - comma - 1;
    const Size filling = uri.ends_with("==") ? 2 : uri.ends_with("=") ? 1 : 0;
    return digits / 4 * 3 - (digits >= 4 ? filling : 0);
  }
  std::error_code error;
  const auto beside = std::filesystem::path(path).parent_path() / uri;
  const Size size = std::filesystem::file_size(beside, error);
  if (error)
    throw FileError(
      FileError::Kind::NotFound, path, "there is no file '" + uri + "', which holds its points");
  return size;
}

void checkAccessor(const std::string& path, const Json& accessor, const Json& views)
{
  static const std::map<std::string, Size> numbers = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  static const std::map<Size, Size> sizes = {
    {5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
  // VTK 9.1's reader takes what memory held before for offsets that are left out, and does not look
  // where such values belong.
  if (accessor.contains("sparse"))
    throw FileError(
      FileError::Kind::OtherFormat, path, "accessors with sparse values are not read");
  if (!accessor.contains("bufferView"))
    return; // zeros
  const Size view = numberOf(accessor, "bufferView");
  const auto type = numbers.find(accessor.value("type", ""));
  const auto size = sizes.find(numberOf(accessor, "componentType"));
  const bool known = type != numbers.end() && size != sizes.end() && view < views.size();
  const Size one = known ? type->second * size->second : 0;
  const Size count = numberOf(accessor, "count");
  const Size stride = known ? numberOf(views[view], "byteStride", one) : 0;
  if (!known || stride > 255 ||
      (count > 0 && numberOf(accessor, "byteOffset") + stride * (count - 1) + one >
                      numberOf(views[view], "byteLength")))
    throw FileError(
      FileError::Kind::Malformed, path, "its accessors ask for more than its buffers hold");
}

const Json& listOf(const Json& model, const char* name)
{
  static const Json none = Json::array();
  const auto found = model.find(name);
  return found != model.end() && found->is_array() ? *found : none;
}

/// Everything that one part of a model calls by its number in a list has to be in it.
class References
{
public:
  References(const std::string& path, const Json& model)
    : path_(path)
    , model_(model)
  {
  }

  void check() const
  {
    this->named(model_, "scene", "scenes");
    for (const Json& scene : listOf(model_, "scenes"))
      this->each(scene, "nodes", "nodes");
    this->checkNodes();
    for (const Json& mesh : listOf(model_, "meshes"))
      for (const Json& primitive : listOf(mesh, "primitives"))
        this->checkPrimitive(primitive);
    for (const Json& texture : listOf(model_, "textures"))
    {
      this->named(texture, "source", "images");
      this->named(texture, "sampler", "samplers");
    }
    for (const Json& image : listOf(model_, "images"))
      this->named(image, "bufferView", "bufferViews");
    for (const Json& material : listOf(model_, "materials"))
      this->checkTextures(material);
    for (const Json& skin : listOf(model_, "skins"))
    {
      this->each(skin, "joints", "nodes");
      this->named(skin, "skeleton", "nodes");
      this->named(skin, "inverseBindMatrices", "accessors");
    }
    for (const Json& animation : listOf(model_, "animations"))
      this->checkAnimation(animation);
  }

private:
  [[noreturn]] void fail(const std::string& list) const
  {
    throw FileError(FileError::Kind::Malformed, path_, "it asks for " + list + " that it lacks");
  }

  void number(const Json& number, const char* list, std::size_t count) const
  {
    if (!number.is_number_unsigned() || number.get<Size>() >= count)
      this->fail(list);
  }

  void number(const Json& number, const char* list) const
  {
    this->number(number, list, listOf(model_, list).size());
  }

  void named(const Json& object, const char* name, const char* list) const
  {
    if (object.contains(name))
      this->number(object[name], list);
  }

  void each(const Json& object, const char* name, const char* list) const
  {
    for (const Json& number : listOf(object, name))
      this->number(number, list);
  }

  /// Also that no node is below itself, nor below two others, which is walked through without end;
  /// nor far below others, which is walked through by functions that call themselves.
  void checkNodes() const
  {
    const Json& nodes = listOf(model_, "nodes");
    std::vector<std::size_t> above(nodes.size(), nodes.size());
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      this->named(nodes[node], "mesh", "meshes");
      this->named(nodes[node], "skin", "skins");
      this->named(nodes[node], "camera", "cameras");
      for (const Json& child : listOf(nodes[node], "children"))
      {
        this->number(child, "nodes");
        if (above[child.get<Size>()] != nodes.size())
          this->fail("a node twice, or nodes");
        above[child.get<Size>()] = node;
      }
    }
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      std::size_t steps = 0;
      for (std::size_t up = node; up != nodes.size(); up = above[up])
        if (++steps > std::min(nodes.size(), mostDepth))
          this->fail(steps > mostDepth ? "more nodes below one another than are read, or nodes"
                                       : "a node below itself, or nodes");
    }
  }

  void checkPrimitive(const Json& primitive) const
  {
    this->named(primitive, "indices", "accessors");
    this->named(primitive, "material", "materials");
    const Json attributes = primitive.value("attributes", Json::object());
    for (const Json& accessor : attributes)
      this->number(accessor, "accessors");
    this->form(attributes, "POSITION", "VEC3", {5126});
    if (primitive.contains("indices"))
      this->form(primitive, "indices", "SCALAR", {5121, 5123, 5125});
    for (const Json& target : listOf(primitive, "targets"))
      for (const Json& accessor : target)
        this->number(accessor, "accessors");
  }

  /// The values of the accessor that is called so, which are in a buffer.
  void form(const Json& object, const char* name, const char* type,
    std::initializer_list<Size> componentTypes) const
  {
    if (!object.contains(name))
      this->fail(std::string("values for ") + name);
    const Json& accessor = listOf(model_, "accessors")[object[name].get<std::size_t>()];
    const Size componentType = numberOf(accessor, "componentType");
    if (!accessor.contains("bufferView") || accessor.value("type", "") != type ||
        std::find(componentTypes.begin(), componentTypes.end(), componentType) ==
          componentTypes.end())
      this->fail(std::string("values of the right type for ") + name);
  }

  /// Textures of a material, wherever they are in it.
  void checkTextures(const Json& part) const
  {
    for (const auto& [name, value] : part.items())
    {
      if (!value.is_object())
        continue;
      if (name.ends_with("Texture"))
        this->named(value, "index", "textures");
      this->checkTextures(value);
    }
  }

  void checkAnimation(const Json& animation) const
  {
    const std::size_t samplers = listOf(animation, "samplers").size();
    for (const Json& channel : listOf(animation, "channels"))
    {
      this->number(channel.value("sampler", Json()), "samplers", samplers);
      this->named(channel.value("target", Json::object()), "node", "nodes");
    }
    for (const Json& sampler : listOf(animation, "samplers"))
    {
      this->number(sampler.value("input", Json()), "accessors");
      this->number(sampler.value("output", Json()), "accessors");
    }
  }

  static constexpr std::size_t mostDepth = 1000;

  const std::string& path_;
  const Json& model_;
};

} // namespace

bool checkGLTF(const std::string& path)
{
  try
  {
    const Model model = modelOf(path);
    for (const Json& extension : listOf(model.json, "extensionsRequired"))
      if (const auto name = extension.get<std::string>(); name.find("mesh") != std::string::npos)
        throw FileError(
          FileError::Kind::OtherFormat, path, "needs " + name + ", which cannot be read");
    const Json &buffers = listOf(model.json, "buffers"), &views = listOf(model.json, "bufferViews");
    for (const Json& buffer : buffers)
      if (bytesOf(path, buffer, model.binary) < numberOf(buffer, "byteLength"))
        throw FileError(FileError::Kind::Truncated, path, "its buffers are shorter than they say");
    for (const Json& view : views)
    {
      const Size buffer = numberOf(view, "buffer");
      if (buffer >= buffers.size() || numberOf(view, "byteOffset") + numberOf(view, "byteLength") >
                                        numberOf(buffers[buffer], "byteLength"))
        throw FileError(
          FileError::Kind::Malformed, path, "its views ask for more than its buffers hold");
    }
    for (const Json& accessor : listOf(model.json, "accessors"))
      checkAccessor(path, accessor, views);
    References(path, model.json).check();
    return !listOf(model.json, "images").empty();
  }
  catch (const Json::exception&)
  {
    throw FileError(FileError::Kind::Malformed, path, "breaks the rules of glTF");
  }
}

} // namespace mote
