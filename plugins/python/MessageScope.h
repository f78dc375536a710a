#pragma once

namespace mote::app
{

/// While one lives, VTK's and Mote's messages are the program's; after the last one those of VTK go
/// where they went. Without `prints` warnings are kept alone, for Messages::takeWarnings(). Several
/// may live at a time, in threads of their own.
class MessageScope
{
public:
  explicit MessageScope(bool prints = false);
  ~MessageScope();
  MessageScope(const MessageScope&) = delete;
  MessageScope& operator=(const MessageScope&) = delete;
};

} // namespace mote::app
