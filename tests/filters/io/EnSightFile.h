#ifndef MoteEnSightFile_h
#define MoteEnSightFile_h

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace samples
{

/// Writes EnSight Gold as text or bytes.
class EnSightFile
{
public:
  EnSightFile(const std::filesystem::path& path, bool isBinary)
    : file_(path, std::ios::binary)
    , isBinary_(isBinary)
  {
  }

  void text(std::string line)
  {
    if (!isBinary_)
      file_ << line << "\n";
    else
    {
      line.resize(80, ' ');
      file_ << line;
    }
  }
  void whole(int value)
  {
    if (!isBinary_)
      file_ << "         " << value << "\n";
    else
      this->raw(static_cast<std::int32_t>(value));
  }
  void whole(const std::vector<int>& values)
  {
    for (const int value : values)
      if (isBinary_)
        this->raw(static_cast<std::int32_t>(value));
      else
        file_ << " " << value;
    if (!isBinary_)
      file_ << "\n";
  }
  void reals(const std::vector<double>& values)
  {
    for (const double value : values)
      this->real(value);
  }
  void real(double value)
  {
    if (!isBinary_)
      file_ << " " << value << "\n";
    else
      this->raw(static_cast<float>(value));
  }

  void close() { file_.close(); }

private:
  template <class T>
  void raw(T value)
  {
    file_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::ofstream file_;
  bool isBinary_;
};

} // namespace samples

#endif
