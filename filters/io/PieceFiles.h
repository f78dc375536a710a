#ifndef MotePieceFiles_h
#define MotePieceFiles_h

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

class vtkDataSet;
class vtkMoteFileWriter;

namespace mote
{

/// The files that an index NAME.* names: NAME/NAME_0.*, NAME/NAME_1.* ... Used by writers of these.
/// All are written, as NAME_0.new.*, before the first takes the place of what is there.
class PieceFiles
{
public:
  /// Makes the folder. Throws Error where it cannot be made, or is that of another index.
  explicit PieceFiles(const std::string& index);
  ~PieceFiles(); ///< removes those that have not taken their places
  PieceFiles(const PieceFiles&) = delete;
  PieceFiles& operator=(const PieceFiles&) = delete;

  /// Writes the next piece by vtkMoteDataWriter, `share` of the work of `writer`, of which `done`
  /// is behind. False where that was stopped; throws WriteError.
  bool write(vtkMoteFileWriter* writer, vtkDataSet* piece, const std::string& ending, double done,
    double share);

  /// Gives them their names. The index comes after that. Throws WriteError.
  void commit();
  const std::vector<std::string>& names() const { return names_; } ///< as the index has them

private:
  std::string written(std::size_t piece) const; ///< its file before it takes its place

  std::filesystem::path parent_, stem_;
  std::vector<std::string> names_;
  std::size_t inPlace_ = 0; ///< of them
};

} // namespace mote

#endif
