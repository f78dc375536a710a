#pragma once

#include "../Suite.h"

namespace mote::bench
{

/// When there is a first picture, by previews of several sizes, and when the exact one.
Suite previewSuite();

} // namespace mote::bench
