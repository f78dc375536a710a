#include "DataView.h"

#include "MessageScope.h"

#include <Program.h>
#include <base/Failure.h>
#include <base/Messages.h>
#include <base/Text.h>
#include <stage/Advice.h>
#include <stage/Blocks.h>
#include <stage/KeptData.h>
#include <table/RowJson.h>
#include <window/Window.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace mote::app
{

namespace
{

/// The rows of pictures, and of the window where it is asked for.
std::vector<const Row*> rowsOf(bool window)
{
  std::vector<const Row*> rows;
  for (const Row& row : settingsTable())
    rows.push_back(&row);
  if (window)
    for (const Row& row : commandTable())
      if (row.command == "mote")
        rows.push_back(&row);
  return rows;
}

void requireTogether(const Row& row, const Json& values)
{
  if (!row.needs.empty() && !values.contains(row.needs))
    throw WrongSetting{row.name + " means nothing without " + row.needs};
  for (const std::string& other : row.excludes)
    if (values.contains(other))
      throw WrongSetting{row.name + " and " + other + " exclude each other"};
}

Settings settingsOf(const std::string& text, bool window)
{
  Settings settings;
  const Json values = Json::parse(text);
  const auto rows = rowsOf(window);
  for (const auto& [name, value] : values.items())
  {
    const auto row = std::find_if(
      rows.begin(), rows.end(), [&, &wanted = name](const Row* r) { return r->name == wanted; });
    if (row == rows.end())
      throw WrongSetting{"there is no setting " + name, true};
    requireTogether(**row, values);
    try
    {
      (*row)->set(settings, givenWords(**row, value));
    }
    catch (const WrongValue& wrong)
    {
      throw WrongSetting{name + ": " + wrong.sentence};
    }
  }
  return settings;
}

/// The data sets in all of them, as if each were a file's.
std::vector<NamedData> allDataSetsOf(const std::vector<GivenData>& data)
{
  std::vector<NamedData> all;
  for (const GivenData& one : data)
    for (NamedData& part : dataSetsOf(sharingCopy(one.data), one.name))
    {
      part.file = one.name;
      all.push_back(std::move(part));
    }
  return all;
}

} // namespace

DataView::DataView() = default;
DataView::~DataView() = default;

/// Has the stage show the data by the settings, and builds what is not built.
void DataView::show(const std::vector<GivenData>& data, const Settings& settings)
{
  std::vector<std::pair<vtkSmartPointer<vtkDataObject>, vtkMTimeType>> wanted;
  for (const GivenData& one : data)
    wanted.emplace_back(one.data, one.data->GetMTime());
  if (!stage_)
    stage_ = std::make_unique<Stage>(settings);
  else
    stage_->apply(settings);
  if (wanted != shown_)
  {
    shown_.clear();
    stage_->clear();
    stage_->setData(allDataSetsOf(data));
    shown_ = wanted;
  }
  ProgressRelay progress;
  stage_->build(progress);
  stage_->applyColors();
}

DrawnImage DataView::draw(
  const std::vector<GivenData>& data, const std::string& text, const std::string& output)
{
  const std::lock_guard lock(mutex_);
  const MessageScope messages;
  Settings settings = settingsOf(text, false);
  if (settings.picture.size[0] == 0)
    settings.picture.size = {1280, 960};
  ProgressRelay progress;
  const auto limit = limitThreads(settings.data.threads);
  DrawnImage drawn;
  try
  {
    this->show(data, settings);
    if (stage_->parts().empty())
      throw Failure("there is nothing to draw in the data");
    Picture picture(*stage_, settings.picture.size);
    if (!output.empty())
      picture.aim(output);
    stage_->look(picture.aspect(), picture.margins());
    drawn.contents = stage_->contents();
    const std::string caption = data.front().name + "   " + drawn.contents;
    drawn.image = inBytes(picture.draw(caption, progress));
    if (!output.empty())
      picture.save();
    drawn.traceTime = picture.traceTime();
    for (const std::string& sentence : adviceOn(*stage_))
      Messages::warn(sentence);
  }
  catch (...)
  {
    stage_.reset(); // of which half may be built
    shown_.clear();
    throw;
  }
  drawn.warnings = Messages::takeWarnings();
  return drawn;
}

DataFiles::DataFiles(const std::vector<std::string>& names, std::vector<std::string>& warnings)
{
  const MessageScope messages;
  ProgressRelay progress;
  input_ = std::make_unique<Input>(names);
  input_->open(progress);
  warnings = Messages::takeWarnings();
}

std::vector<GivenData> DataFiles::read(int step, std::vector<std::string>& warnings)
{
  const MessageScope messages;
  if (step < 0 || step >= input_->numberOfSteps())
    throw Failure(input_->name() + " has " + counted(input_->numberOfSteps(), "time step") +
                  ", from 0, so there is no step " + std::to_string(step));
  ProgressRelay progress;
  std::vector<GivenData> all;
  for (const NamedData& one : input_->read(step, progress))
    all.push_back({one.name, one.data});
  warnings = Messages::takeWarnings();
  return all;
}

void showData(const std::vector<GivenData>& data, const std::vector<std::string>& files,
  const std::string& text)
{
  const MessageScope messages(true);
  Settings settings = settingsOf(text, true);
  settings.data.files = files;
  KeptData kept;
  for (const GivenData& one : data)
    settings.data.files.push_back(kept.keep(one.name, one.data));
  showWindow(settings);
}

std::string settingsAsJson()
{
  static const char* const shapes[] = {"flag", "one", "optional", "many"};
  Json list = Json::array();
  for (const Row* row : rowsOf(true))
    list.push_back({{"group", row->group}, {"name", row->name}, {"command", row->command},
      {"value", row->value}, {"help", row->help}, {"values", row->values()},
      {"usual", row->usualText()}, {"shape", shapes[static_cast<int>(row->shape)]},
      {"numeric", row->numeric}, {"words", row->words}});
  return list.dump();
}

} // namespace mote::app
