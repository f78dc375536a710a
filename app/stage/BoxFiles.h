#pragma once

#include <string>
#include <vector>

class vtkDataSet;

namespace mote::app
{

/// Without those that only hold the simulation box of another one of them: beside `dump100.vtk`
/// LAMMPS and LIGGGHTS write it as `dump100_boundingBox.vtk`, a single cell.
std::vector<std::string> withoutBoxFiles(const std::vector<std::string>& files);

/// Gives particles without a simulation box that of the file beside theirs, where there is one that
/// can be read: see simulationBoxOf().
void addBoxOfFile(vtkDataSet* particles, const std::string& file);

} // namespace mote::app
