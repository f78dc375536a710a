#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

/// A file in memory that every run of a fuzzer writes anew.
class ScratchFile
{
public:
  explicit ScratchFile(const std::string& ending);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  void operator=(const ScratchFile&) = delete;

  void write(const std::uint8_t* bytes, std::size_t size);
  const std::string& path() const { return path_; }

private:
  std::string folder_, path_;
};

/// Reads the first and the last time step of a file. Aborts where there is neither data nor a
/// sentence, and where there are several lines of it.
void readAsUsersDo(const std::string& path);
