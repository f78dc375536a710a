#pragma once

namespace mote
{

/// Builds a structure anew: clear() leaves it empty, build() fills it and answers false where it
/// was stopped. Where it was, and where it throws, nothing is left of what it did.
template <typename Clear, typename Build>
void buildOrClear(const Clear& clear, const Build& build)
{
  clear();
  bool complete = false;
  try
  {
    complete = build();
  }
  catch (...)
  {
    clear();
    throw;
  }
  if (!complete)
    clear();
}

} // namespace mote
