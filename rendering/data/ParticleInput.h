#pragma once

#include "DataArrayView.h"
#include "MoteRenderingDataModule.h" // For export macro

#include "kernels/core/ScratchSpace.h"
#include "kernels/core/StoredArray.h"
#include "kernels/particles/ParticleSet.h"
#include "kernels/particles/ParticleStructure.h"

#include "vtkIndent.h"

#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPointData;
class vtkPointSet;

namespace mote
{

class PkdTreeFile;

/// Where radii come from: RadiusModes of vtkMoteParticleMapper and of whatever else has them.
enum class RadiusMode
{
  Automatic,
  Constant,
  ByArray,
  ByType,
  FromSpacing
};

/// How a mapper or filter was asked to choose radii.
struct RadiusChoice
{
  RadiusMode mode = RadiusMode::Automatic;
  double radius = 0.5;
  double scale = 1.0;
  std::string radiusArray;
  std::string typeArray;
  std::map<int, double> typeRadii;
};

/// A vtkPointSet as the kernels see it. The views hold while this object lives.
struct ParticleInput
{
  ParticleSet set;
  DataArrayView positions;
  DataArrayView radii;
  StoredArray<double> ownRadii; ///< a particle each, where no array holds them
  double commonRadius = 0.0;    ///< 0 where radii differ
  double enlargement = 1.0;     ///< what the structure's radii are times those of `set`
};

/// Takes the properties of an algorithm that has those of vtkMoteParticleMapper by these names; the
/// table of types stays as it is.
template <typename Algorithm>
void takeRadiusProperties(Algorithm* from, RadiusChoice& choice)
{
  const auto text = [](const char* name) { return name ? name : ""; };
  choice.mode = static_cast<RadiusMode>(from->GetRadiusMode());
  choice.radius = from->GetRadius();
  choice.scale = from->GetRadiusScale();
  choice.radiusArray = text(from->GetRadiusArrayName());
  choice.typeArray = text(from->GetTypeArrayName());
}

/// Prints them as PrintSelf() does.
MOTERENDERINGDATA_EXPORT void printRadii(
  const RadiusChoice& choice, std::ostream& os, vtkIndent indent);

/// What values of an array make radii by its name, such as "Radius" or "Particle Diameter (m)": 1
/// times they, half of them, or 0 for none.
MOTERENDERINGDATA_EXPORT double radiusFactor(const std::string& name);

/// The first array of one component that makes radii so, or else diameters; or null.
MOTERENDERINGDATA_EXPORT vtkDataArray* namedRadii(vtkPointData* data);

/// The point array of that name. Throws Error, which says what it was wanted for, where there is
/// none, or not one tuple a point.
MOTERENDERINGDATA_EXPORT vtkDataArray* requirePointArray(
  vtkPointSet* points, const std::string& name, const char* purpose);

/// The file that the points stay in (vtkMoteParticleFilePoints), or null.
std::shared_ptr<const PkdTreeFile> fileOf(vtkPointSet* points);

/// The structure that a mapper or filter was asked for.
struct StructureChoice
{
  ParticleStructureKind kind = ParticleStructureKind::Automatic;
  std::optional<PkdTreeOptions::Form> form; ///< none: as a file has it, else exact
};

/// What these names mean; empty ones mean the first of their kind. Throws Error where there
/// is no such structure or form, or where the structure does not come in forms.
StructureChoice structureOf(const std::string& name, const std::string& form);

/// Names of forms for messages and options: "auto", then all.
MOTERENDERINGDATA_EXPORT std::vector<std::string> structureFormNames();

/// Whether what is to be drawn is the very tree of that file.
bool drawsFile(vtkPointSet* points, const RadiusChoice& choice, const StructureChoice& structure);

/// The typical distance between neighbours; of points in a file what that says. With parts that of
/// the points of all processes, 0 where these are less than two.
MOTERENDERINGDATA_EXPORT double spacingOf(
  vtkPointSet* points, const ParticleParts* parts = nullptr);

/// Looks up radii as `choice` says, and puts those that are in no array into `space`, or on the
/// heap where that is null. Throws Error where the choice names an array that is missing or unfit.
ParticleInput makeParticleInput(
  vtkPointSet* points, const RadiusChoice& choice, ScratchSpace* space = nullptr);

/// What a structure was built from: equal keys, equal structures.
using InputKey = std::vector<double>;

/// MTimes are one counter over all VTK objects: an array is known by its own. They stay far below
/// 2^53, where doubles would stop telling integers apart.
MOTERENDERINGDATA_EXPORT void addArray(InputKey& key, vtkDataArray* array);

/// All that the particles of makeParticleInput() depend on. Throws Error as that does.
InputKey keyOf(vtkPointSet* points, const RadiusChoice& choice);

/// Builds the structure that `options` name over the particles; into `structure`, whose memory is
/// then used again, where it is of that kind and nobody else holds it. What is left is null where
/// `progress` stopped the build. Throws Error for malformed sets.
void buildStructure(std::shared_ptr<ParticleStructure>& structure, const ParticleSet& particles,
  const ParticleStructureOptions& options, const Progress& progress);

} // namespace mote
