#include "TypedLetter.h"

#include <X11/Xlib.h>
#include <X11/keysym.h>

namespace mote::app
{

namespace
{

/// X11 has capital and small Greek letters in the order of Unicode, but for sigma.
unsigned greekOf(unsigned long key)
{
  if (key == XK_Greek_SIGMA)
    return 0x3a3;
  if (key == XK_Greek_sigma)
    return 0x3c3;
  if (key == XK_Greek_finalsmallsigma)
    return 0x3c2;
  if (key >= XK_Greek_ALPHA && key <= XK_Greek_OMEGA)
    return static_cast<unsigned>(0x391 + key - XK_Greek_ALPHA);
  if (key >= XK_Greek_alpha && key <= XK_Greek_omega)
    return static_cast<unsigned>(0x3b1 + key - XK_Greek_alpha);
  return 0;
}

} // namespace

unsigned letterOf(const char* symbol)
{
  constexpr unsigned long unicode = 0x01000000; // the keys of X11 from here on
  const unsigned long key = XStringToKeysym(symbol);
  if ((key >= 0x20 && key < 0x7f) || (key >= 0xa0 && key <= 0xff))
    return static_cast<unsigned>(key); // Latin-1
  if (key == XK_EuroSign)
    return 0x20ac;
  if (key > unicode && key <= unicode + 0xffff) // as many as ImGui knows
    return static_cast<unsigned>(key - unicode);
  return greekOf(key);
}

} // namespace mote::app
