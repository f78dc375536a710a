#ifndef MoteStepSource_h
#define MoteStepSource_h

#include "PointRows.h"
#include "StoreNumber.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace mote
{

/// What is read of a step.
struct SourceRequest
{
  std::size_t step = 0; ///< a place in times()
  Piece piece;
  std::shared_ptr<ScratchSpace> space; ///< see PointRows
  Progress progress;
};

/// A file of particles, of whatever format: its steps, and how each is read.
class StepSource
{
public:
  StepSource() = default;
  virtual ~StepSource() = default;
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  /// Ascending; never empty.
  virtual std::vector<double> times() const = 0;
  /// Makes points, arrays and fields. Throws FileError, and then `output` must be dropped.
  virtual void read(const SourceRequest& request, vtkPolyData* output) = 0;
  /// What a user should know of the file, as a sentence; or empty.
  virtual std::string warning() const { return {}; }
};

/// The layout of rows while it is put together.
class RowLayout
{
public:
  explicit RowLayout(std::uint64_t particles) { m_rows.rows = particles; }

  /// The columns of the positions.
  void addPositions();
  /// An array of so many columns; its first column.
  std::size_t add(const std::string& name, ColumnType type, std::size_t components = 1);
  const PointRows& rows() const { return m_rows; }
  /// The rows as a request wants them.
  PointRows rowsFor(const SourceRequest& request) const;

private:
  PointRows m_rows;
};

/// Stores a text: as it is, or as the number of the word.
void storeText(const TextColumn& column, std::uint64_t row, std::string_view text);

/// The periodic box at the origin of rows of three numbers each, a, b and c, as "box" and
/// "box_origin".
void addBox(const std::array<double, 9>& cell, const std::array<double, 3>& origin,
  const std::string& boundary, vtkPolyData* output);

/// "2=stars" and so on as "type_names".
void addTypeNames(const std::map<int, std::string>& names, vtkPolyData* output);

/// Opens a file of one of the formats of vtkMoteParticleFormatsReader, told by its content. Throws
/// FileError.
std::unique_ptr<StepSource> openStepSource(const std::string& path, const Progress& progress);

} // namespace mote

#endif
