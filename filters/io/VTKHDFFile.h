#ifndef MoteVTKHDFFile_h
#define MoteVTKHDFFile_h

#include "HDF5File.h"
#include "Piece.h"
#include "TextCursor.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkImageData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace mote
{

/// A VTKHDF file of an unstructured grid, of polygonal data or of an image, in parts, and with time
/// steps or without: versions 1 and 2 of the format, of which VTK 9.1 itself reads the first
/// without steps. All counts and offsets are compared with what the arrays have. Throws FileError.
class VTKHDFFile
{
public:
  explicit VTKHDFFile(const std::string& path);

  /// VTK_UNSTRUCTURED_GRID, VTK_POLY_DATA or VTK_IMAGE_DATA.
  int dataType() const { return m_type; }
  /// Of an image, as VTK's WHOLE_EXTENT.
  std::array<int, 6> extent() const;
  /// In the order of the file; none where it has no steps.
  const std::vector<double>& times() const { return m_times; }
  /// A step, or all of a file without; of several pieces those parts that come in turn.
  vtkSmartPointer<vtkDataSet> read(
    std::size_t step, const Piece& piece, const Progress& progress) const;

private:
  /// Where the values of a step begin, and its parts.
  struct Step
  {
    std::uint64_t number = 0; ///< among the steps
    std::uint64_t firstPart = 0, parts = 0, points = 0;
    std::array<std::uint64_t, 4> cells{}, corners{}; ///< of each topology
  };
  /// Rows of an array.
  struct Rows
  {
    std::uint64_t first = 0, count = 0;
  };
  struct Topology;

  Step stepAt(std::size_t step) const;
  std::vector<std::uint64_t> counts(const std::string& name, const Step& step) const;
  std::uint64_t offsetAt(const std::string& table, const Step& step, std::size_t column = 0) const;
  std::vector<std::size_t> partsOf(const Step& step, const Piece& piece) const;
  Topology topology(const std::string& group, std::size_t number, const Step& step,
    const std::vector<std::uint64_t>& points, const std::vector<std::size_t>& parts) const;
  vtkSmartPointer<vtkDataArray> rows(const std::string& name, const std::vector<Rows>& all) const;
  void addArrays(const std::string& group, const Step& step, std::uint64_t start,
    const std::vector<Rows>& rows, vtkDataSetAttributes* to, const Progress& progress) const;
  vtkSmartPointer<vtkDataSet> readCells(
    const Step& step, const Piece& piece, const Progress& progress) const;
  std::vector<double> numbers(const std::string& attribute, std::size_t count) const;
  vtkSmartPointer<vtkDataSet> readImage(const Step& step, const Progress& progress) const;
  void addImageArrays(const std::string& group, const Step& step, std::uint64_t tuples,
    vtkDataSetAttributes* to) const;
  void addFields(vtkDataSet* to) const;
  [[noreturn]] void fail(const std::string& sentence) const;

  HDF5File m_file;
  int m_type = 0;
  std::vector<double> m_times;
};

/// Whether an HDF5 file is one of VTK; false for what cannot be opened.
bool isVTKHDF(const std::string& path);

} // namespace mote

#endif
