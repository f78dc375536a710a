// Files that the window writes of what it shows.

#include "Window.h"

#include "base/OutputFile.h"
#include "base/Text.h"
#include "commands/PlotFile.h"
#include "stage/PickedTable.h"
#include "stage/Picture.h"
#include "stage/ShownData.h"

#include <vtkDataSet.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace mote::app
{

std::string Window::unusedName(const std::string& ending) const
{
  const std::string& first = this->settings().data.files.front();
  std::string stem = std::filesystem::path(first).stem().stem().string();
  if (first.find(':') != std::string::npos && !std::filesystem::exists(first))
  {
    stem = first; // pump:0.1, which is made: the point begins no extension
    std::replace(stem.begin(), stem.end(), ':', '-');
  }
  for (int i = 1;; ++i)
  {
    char number[16];
    std::snprintf(number, sizeof number, "-%03d", i);
    if (const std::string file = stem + number + ending; !std::filesystem::exists(file))
      return file;
  }
}

void Window::copyPicked()
{
  const PickedTable table(stage_.parts(), picked_);
  std::string text;
  table.appendNames(text, '\t');
  for (std::size_t row = 0; row < table.rows(); ++row)
    table.appendLine(text, row, '\t');
  clipboard_.set(text);
  this->say("Copied " + counted(static_cast<std::int64_t>(table.rows()), "line"));
}

void Window::savePicked(const char* ending)
{
  const std::string file = this->unusedName(ending);
  writePicked(PickedTable(stage_.parts(), picked_), file);
  this->say("Saved " + file);
}

/// What the panel plots, as a picture or as its counts.
void Window::savePlot(const std::string& ending)
{
  const PlotPanel& shown = panel_.plotNow(picked_);
  if (shown.plot().isEmpty())
    return this->say("Nothing is plotted");
  const std::string file = this->unusedName(ending);
  const bool done = this->perform(
    [&]
    {
      if (ending != "-plot.csv")
        writePlotPicture(shown.plot(), shown.plotted(), this->settings().plot.logarithmic,
          captionOf(input_, step_, stage_.contents()), file);
      else
        writeText(file, plotText(shown.plot(), shown.plotted()));
    });
  if (done)
    this->say("Saved " + file);
}

void Window::savePicture()
{
  const std::string file = this->unusedName(".png");
  // A preview is for looking; what is kept is exact.
  if (previewed_ && !this->perform([&] { stage_.finishBuild(progress_); }))
    return;
  // As mote render makes it, so that the printed command gives the same.
  const bool done = this->perform(
    [&]
    {
      Picture picture(stage_, this->savedSize());
      picture.setLineScale(this->savedScale());
      picture.aim(file);
      paths_.follow(this->settings(), input_, cache_);
      if (paths_.isShown())
        paths_.paths()->finish(progress_);
      picture.setPaths(paths_.paths());
      picture.setPicked(picked_.words(stage_.parts()));
      picture.write(captionOf(input_, step_, stage_.contents()), progress_);
    });
  if (done)
    this->say("Saved " + file);
}

/// What each part shows, or what is picked of it, as data that other programs read: a file each.
void Window::saveData(
  const std::function<std::vector<unsigned char>(std::size_t part)>& marks, const char* what)
{
  std::vector<std::string> files;
  const bool done = this->perform(
    [&]
    {
      stage_.finishBuild(progress_); // a preview is for looking
      for (std::size_t i = 0; i < stage_.parts().size(); ++i)
      {
        const Part& part = *stage_.parts()[i];
        const std::vector<unsigned char> marked = marks(i);
        if (std::count(marked.begin(), marked.end(), 1) == 0)
          continue;
        const auto data = markedData(part, marked, givesRadii(this->settings().particles));
        const std::string ending = data->IsA("vtkPolyData") ? ".vtp" : ".vtu";
        files.push_back(this->unusedName(std::string("-") + what + ending));
        writeData(data, files.back(), progress_);
      }
    });
  if (done)
    this->say(files.empty() ? "Nothing is shown" : "Saved " + joined(files, ", "));
}

void Window::saveShown()
{
  this->saveData(
    [this](std::size_t part)
    {
      const Part& one = *stage_.parts()[part];
      return one.isHidden() ? std::vector<unsigned char>() : shownMarks(one, this->settings());
    },
    "shown");
}

void Window::savePickedData()
{
  this->saveData(
    [this](std::size_t part)
    {
      vtkDataSet* data = stage_.parts()[part]->data();
      const bool areCells = kindOfPicks(*stage_.parts()[part]) == Picked::Kind::Cell;
      std::vector<unsigned char> marks(
        static_cast<std::size_t>(areCells ? data->GetNumberOfCells() : data->GetNumberOfPoints()));
      for (const Picked& one : picked_.items())
        if (static_cast<std::size_t>(one.part) == part)
          marks[static_cast<std::size_t>(one.id)] = 1;
      return marks;
    },
    "picked");
}

} // namespace mote::app
