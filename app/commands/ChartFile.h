#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkAlgorithm;
class vtkImageData;

namespace mote::app
{

/// A white image with the array `color`, to draw on.
vtkSmartPointer<vtkImageData> whitePaper(int width, int height);

/// "p (Pa)"; without a unit the name alone.
std::string withUnit(const std::string& name, const std::string& unit);

/// Writes what the filter makes as a picture. Throws Failure.
void writeChart(vtkAlgorithm* source, const std::string& file);

} // namespace mote::app
