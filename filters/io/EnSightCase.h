#ifndef MoteEnSightCase_h
#define MoteEnSightCase_h

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// What a case file of EnSight Gold names, looked at before VTK 9.1's readers read it: these trust
/// counts, and crash where files end too early. Free of VTK.
class EnSightCase
{
public:
  /// Reads the case file. Throws FileError for one that is damaged, of EnSight 6, or that asks for
  /// what is not read.
  explicit EnSightCase(const std::string& path);

  /// Goes through the files of the latest step at or before a time, or of the first one. Throws
  /// FileError for what is damaged in them.
  void checkAt(std::optional<double> time) const;
  /// Throws FileError where a file of the first step is a pipe or a device, or the model is not
  /// there.
  void requireFiles() const;

private:
  struct TimeSet
  {
    std::vector<double> times;
    std::vector<int> numbers; ///< of files; may be empty
  };
  /// A file of many steps, or several.
  struct FileSet
  {
    std::size_t steps = 0;
    bool isSpread = false;
  };
  /// A file, or one a step with * for the step's number.
  struct Pattern
  {
    std::string file;
    int timeSet = 0; ///< 0: none
    int fileSet = 0;
  };
  struct Variable
  {
    Pattern pattern;
    int components = 1;
    bool isOfNodes = true;
  };

  void parse();
  void parseLine(const std::string& section, const std::string& key, const std::string& value);
  void parseTime(const std::string& key, const std::string& value);
  void parseFileSet(const std::string& key, const std::string& value);
  void parseVariable(const std::string& key, const std::string& value);
  Pattern patternOf(std::vector<std::string> words, std::size_t after) const;
  void require() const;
  void requireSteps(const Pattern& pattern, const std::string& file, std::size_t found) const;
  std::string fileAt(const Pattern& pattern, std::optional<double> time) const;
  [[noreturn]] void fail(const std::string& sentence, bool isHere = true) const;

  std::string path_;
  std::size_t line_ = 0;
  Pattern geometry_;
  std::vector<Variable> variables_;
  std::map<int, TimeSet> timeSets_;
  std::map<int, std::size_t> counts_;         ///< of steps, as time sets say them
  std::map<int, std::pair<int, int>> starts_; ///< number of the first file, increment
  std::map<int, FileSet> fileSets_;
  int timeSet_ = 0, fileSet_ = 0; ///< whose lines come
  std::string listed_;            ///< whose numbers go on in the next lines
};

} // namespace mote

#endif
