#pragma once

#include "FolderList.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mote::app
{

/// Files to open, beside those that are open or in their place.
struct OpenChoice
{
  std::vector<std::string> files;
  bool isAdded = false;
};

/// The list of folders and files from which the user opens some, one or several at once.
class OpenDialog
{
public:
  /// The next draw() opens it, on this folder.
  void show(const std::filesystem::path& folder);

  /// Draws it where it is open, and returns what was chosen. Within a window of ImGui. `canAdd`
  /// says whether there is something to add to.
  std::optional<OpenChoice> draw(bool canAdd);

  /// Whether it is open, or about to be.
  bool isOpen() const { return isOpen_; }
  /// Whether keys are for its field: not while a list in it has them.
  bool awaitsKeys() const { return isOpen_ && !isListing_; }

private:
  void list(const std::filesystem::path& folder);
  void goTo(const std::filesystem::path& folder);
  void find();
  void drawPlaces();
  void drawRecent();
  bool drawFilter();
  bool drawList();
  bool drawLine(std::size_t line) const;
  void scrollToCursor();
  void click(std::size_t line);
  std::filesystem::path typedPath() const;
  bool enter();
  void toggle(std::size_t line);
  std::vector<std::string> chosen() const;

  bool isOpen_ = false, toOpen_ = false;
  std::filesystem::path folder_;
  std::vector<FolderEntry> entries_;
  std::vector<std::size_t> lines_; ///< of the entries that the filter leaves
  std::set<std::size_t> marked_;   ///< of the entries
  std::size_t cursor_ = 0;         ///< of the lines
  std::string filter_, problem_;
  std::vector<std::vector<std::string>> recent_; ///< files that were opened together
  std::optional<OpenChoice> chosenRecent_;
  bool isListing_ = false; ///< those stand in a list that has the keys
  bool toCursor_ = false;  ///< the list is to show the cursor's line
};

} // namespace mote::app
