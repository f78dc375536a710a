#pragma once

#include <string>

namespace mote
{

/// Whether a message has just begun to hold, so that it is told once and not every frame.
inline bool isNews(const std::string& message, std::string& last)
{
  const bool news = !message.empty() && message != last;
  last = message;
  return news;
}

} // namespace mote
