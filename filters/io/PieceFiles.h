#ifndef MotePieceFiles_h
#define MotePieceFiles_h

#include <string>
#include <vector>

class vtkDataSet;
class vtkMoteFileWriter;

namespace mote
{

/// The files that an index NAME.* names: NAME/NAME_0.*, NAME/NAME_1.* ... Used by writers of these.
class PieceFiles
{
public:
  /// Makes the folder. Throws Error where it cannot be made.
  explicit PieceFiles(const std::string& index);

  /// Writes the next piece by vtkMoteDataWriter, `share` of the work of `writer`, of which `done`
  /// is behind. False where that was stopped; throws WriteError.
  bool write(vtkMoteFileWriter* writer, vtkDataSet* piece, const std::string& ending, double done,
    double share);

  const std::vector<std::string>& names() const { return names_; } ///< as the index has them

private:
  std::string parent_, stem_;
  std::vector<std::string> names_;
};

} // namespace mote

#endif
