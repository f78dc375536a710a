#pragma once

#include <exception>
#include <stdexcept>

namespace mote::app
{

/// What went wrong, as one sentence for the user; main() prints it and exits with 1.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The user stopped a long work with Ctrl-C or Escape.
class Interrupted : public std::exception
{
public:
  const char* what() const noexcept override { return "interrupted"; }
};

} // namespace mote::app
