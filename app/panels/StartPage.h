#pragma once

#include "OpenDialog.h"

#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

/// What stands in a window that has nothing to show: what the program does, the simulations that
/// come with it, and the files that were opened last.
class StartPage
{
public:
  StartPage();

  /// Draws it within a window of ImGui. Returns what the user chose; the button that opens the
  /// dialog sets `wantsDialog`.
  std::optional<OpenChoice> draw(bool& wantsDialog) const;

private:
  struct Offer
  {
    std::string title, about;
    std::vector<std::string> files;
  };
  static std::optional<OpenChoice> drawOffers(
    const char* heading, const std::vector<Offer>& offers);

  std::vector<Offer> demos_, recent_;
};

} // namespace mote::app
