#ifndef MotePDBCheck_h
#define MotePDBCheck_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mote
{

/// A model of a Protein Data Bank file: the atoms of one time, or of one of several conformations.
struct PDBModel
{
  std::size_t begin = 0, end = 0; ///< bytes
  std::optional<double> time;     ///< as GROMACS writes it into the title, "t= 10.0"
  /// The vectors a, b and c of the simulation's box, in angstroms, as CRYST1 of the space group P 1
  /// tells it: cells of crystals are of other groups, and their atoms are a part of what is in
  /// them.
  std::optional<std::array<double, 9>> box = {};
};

/// The models of a Protein Data Bank file.
struct PDBModels
{
  /// What stands before the first MODEL holds for all, such as where helices are. 0 where models
  /// end with END alone, as in trajectories of VMD.
  std::size_t head = 0;
  std::vector<PDBModel> models;

  /// The text of one of them for a reader. `text` is the file's.
  std::string textOf(std::string_view text, std::size_t model) const;
};

/// Goes through the text of a Protein Data Bank file at `path`. Throws FileError where it has been
/// cut short or has an atom without coordinates, of which vtkPDBReader says nothing.
///
/// END itself is not asked for: many programs leave it out. A file cut exactly at a line's end is
/// therefore only noticed if it has fewer atoms than its MASTER record counts.
PDBModels checkPDB(std::string_view text, const std::string& path);

/// Throws FileError where atoms of a model, which checkPDB() has been through, lie so close
/// together that the bonds between them would fill the memory.
void requireFewBonds(std::string_view model, const std::string& path);

} // namespace mote

#endif
