#pragma once

#include <stdexcept>

namespace mote
{

/// What the kernels throw: a sentence that a user can act on.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace mote
