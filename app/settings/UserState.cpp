#include "UserState.h"

#include "base/UserFiles.h"

#include <kernels/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t mostRecent = 12;

std::vector<std::string> textsOf(const Json& list)
{
  std::vector<std::string> texts;
  for (const Json& one : list)
    if (one.is_string())
      texts.push_back(one.get<std::string>());
  return texts;
}

} // namespace

UserState readUserState()
{
  UserState state;
  if (std::error_code error; !fs::is_regular_file(stateFile(), error))
    return state;
  std::ifstream file(stateFile());
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object())
    return state;
  if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
    for (const Json& files : *recent)
      if (std::vector<std::string> texts = textsOf(files); !texts.empty())
        state.recent.push_back(std::move(texts));
  if (const auto seen = json.find("hints-seen"); seen != json.end() && seen->is_number_integer())
    state.hintsSeen = std::max(0, seen->get<int>());
  if (const auto hints = json.find("hints"); hints != json.end() && hints->is_boolean())
    state.hints = hints->get<bool>();
  return state;
}

void changeUserState(const std::function<void(UserState&)>& change)
{
  const fs::path path = stateFile();
  if (path.empty())
    return;
  UserState state = readUserState(); // another window may have changed it
  change(state);
  Json json;
  json["recent"] = state.recent;
  json["hints-seen"] = state.hintsSeen;
  json["hints"] = state.hints;
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  try
  {
    AtomicFile file(path.string());
    file.write(text.data(), text.size());
    file.commit();
  }
  catch (const WriteError&)
  {
  }
}

void noteRecent(const std::vector<std::string>& files)
{
  if (files.empty())
    return;
  std::vector<std::string> named;
  for (const std::string& file : files)
  {
    std::error_code error;
    // What is generated, such as pump:0.02, is no file.
    named.push_back(
      fs::exists(file, error) ? fs::absolute(file, error).lexically_normal().string() : file);
  }
  changeUserState(
    [&](UserState& state)
    {
      std::erase(state.recent, named);
      state.recent.insert(state.recent.begin(), named);
      if (state.recent.size() > mostRecent)
        state.recent.resize(mostRecent);
    });
}

} // namespace mote::app
