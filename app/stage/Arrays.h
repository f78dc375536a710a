#pragma once

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;

namespace mote::app
{

/// An array of a data set and the component that is meant.
struct ArrayChoice
{
  static constexpr int magnitude = -1;

  std::string name; ///< empty: no array
  int component = 0;
  bool ofCells = false;

  explicit operator bool() const { return !name.empty(); }
  bool operator==(const ArrayChoice&) const = default;
};

/// The array that is meant by NAME, NAME:COMPONENT or NAME:magnitude, or by a component's name
/// alone, of points before cells; with "point:" or "cell:" before it of these alone. No array where
/// the data set has none of that name. Throws Failure for a component that the array lacks.
ArrayChoice findArray(vtkDataSet* data, const std::string& text);

/// A text that findArray() takes for this choice; "none" for no array.
std::string asText(vtkDataSet* data, const ArrayChoice& choice);

/// Gives the data set an array of its points' x, y or z where `text` names one of these and no
/// array.
void addCoordinate(vtkDataSet* data, const std::string& text);

/// What may colour this data set, the most telling first: numbers that vary, magnitudes of vectors,
/// integers, types. No ids, radii, positions; those with one value everywhere come last.
std::vector<ArrayChoice> rankedArrays(vtkDataSet* data);

/// The rest of the numbers, as far as they have a name: ids, radii, masses and so on, each in its
/// place among the data.
std::vector<ArrayChoice> otherArrays(vtkDataSet* data);

/// An array's name; empty where it has none, as in files of VTK it may.
std::string nameOf(vtkAbstractArray* array);

/// The array itself, or null.
vtkDataArray* arrayOf(vtkDataSet* data, const ArrayChoice& choice);

/// What a component is called: its own name, or x, y and z of three without, or its number.
std::string componentName(vtkAbstractArray* array, int component);

/// "c_1", "v magnitude", "v: vx", "v: z".
std::string describe(vtkDataSet* data, const ArrayChoice& choice);

/// What the values of an array are measured in, as the file says ("UNITS_LABEL" of VTK's XML
/// files); empty where it does not. The other is that of the points' places.
std::string unitOf(vtkDataSet* data, const std::string& array);
std::string lengthUnitOf(vtkDataSet* data);

/// The names of all arrays that could be meant, "a, b, c"; for messages.
std::string listArrays(vtkDataSet* data);

/// Whether the data have an array of that name which holds words instead of numbers.
bool isText(vtkDataSet* data, const std::string& name);

/// The value of a tuple: of a component, or the magnitude.
double valueOf(vtkDataArray* array, int component, vtkIdType tuple);

/// Least and greatest finite value; false where there is none.
bool finiteRange(vtkDataArray* array, int component, double range[2]);

/// The values at two percentiles, from 0 to 100, of the finite values: of arrays of more than
/// 200,000 of so many, in equal steps. The least and the greatest where both are one value, and
/// where their steps miss all others. False where there is none.
bool percentileRange(
  vtkDataArray* array, int component, const std::vector<double>& percentiles, double range[2]);

/// How many values lie in the range, its ends included.
std::int64_t countInRange(vtkDataArray* array, int component, const double range[2]);

/// The least value above zero; 0 where there is none.
double leastPositive(vtkDataArray* array, int component);

/// Whether an array whose integers name kinds, such as atom types.
bool isTypes(vtkDataSet* data, const ArrayChoice& choice);

/// Adds the values that are not among `types` yet, in ascending order. False, with an incomplete
/// list, where there are others than integers, more than `limit` in all, or less than `span` does
/// not reach from the least to the greatest.
bool collectTypes(
  vtkDataArray* array, int component, std::size_t limit, int span, std::vector<int>& types);

/// Whether the array holds colours (bytes, three or four of them) rather than values.
bool isColors(vtkDataArray* array);

} // namespace mote::app
