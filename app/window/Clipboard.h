#pragma once

#include <memory>
#include <string>

namespace mote::app
{

/// The clipboard of X11: whoever pastes asks the program that copied for the text, as long as it
/// runs.
class Clipboard
{
public:
  Clipboard();
  ~Clipboard();

  /// Offers a text from now on. Throws Failure where it is too long to be handed over at once.
  void set(const std::string& text);

private:
  class Owner;
  std::unique_ptr<Owner> owner_; ///< from the first text on
};

} // namespace mote::app
