#ifndef MoteXYZText_h
#define MoteXYZText_h

#include "vtkType.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkPointSet;

namespace mote
{

/// Points and their arrays as a frame of an extended XYZ file. Numbers have as many digits as tell
/// them from all others of their type. It looks at the data, which must outlive it.
class XYZText
{
public:
  explicit XYZText(vtkPointSet* data, std::optional<double> time = {});

  /// The first two lines: how many points, and the comment, which tells the columns, the box and
  /// the time.
  const std::string& head() const { return head_; }
  /// Appends the lines of points from one to another, not included; from any thread.
  void append(std::string& text, vtkIdType begin, vtkIdType end) const;
  /// Arrays that no column can hold, with commas between; empty where there are none.
  const std::string& leftOut() const { return leftOut_; }

private:
  /// Appends the values of a point, with a blank after each.
  using Column = std::function<void(std::string& text, vtkIdType point)>;

  std::vector<Column> columns_;
  std::string head_, leftOut_;
};

} // namespace mote

#endif
