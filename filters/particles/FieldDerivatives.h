#pragma once

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace mote
{

/// A derivative in space of an array, which an expression speaks of.
struct FieldDerivative
{
  std::string kind;  ///< "gradient", "vorticity", "divergence" or "q_criterion"
  std::string array; ///< that it is of
  std::string name;  ///< that it has as an array: KIND(ARRAY)
};

/// The expression with names of arrays, in quotes, in place of gradient(NAME), vorticity(NAME),
/// divergence(NAME) and q_criterion(NAME); adds those to `found`. Throws Error where a bracket has
/// no end.
std::string withoutDerivatives(const std::string& expression, std::vector<FieldDerivative>& found);

/// A data set of its own with arrays of these derivatives, of points or of cells as what they are
/// of, by vtkGradientFilter. Throws Error where an array is missing or has not three components,
/// of which all but gradients are, and where there are no cells.
vtkSmartPointer<vtkDataSet> withArraysOf(
  vtkDataSet* data, const std::vector<FieldDerivative>& derivatives);

} // namespace mote
