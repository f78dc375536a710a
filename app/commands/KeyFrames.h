#pragma once

#include "settings/Settings.h"

#include <vector>

namespace mote::app
{

/// The settings at a share, from 0 to 1, of the way through the keys, of which there is at least
/// one. Cameras go along a smooth curve through all of them, turning about what they look at.
/// Settings that are numbers go in straight lines from key to key, where both have as many of them;
/// all others change where the next key is reached. Keys have a camera of their own each, and the
/// same projection throughout.
Settings between(const std::vector<Settings>& keys, double share);

} // namespace mote::app
