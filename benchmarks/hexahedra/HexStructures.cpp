#include "HexStructures.h"

#include "../Timing.h"

#include <kernels/core/Alternatives.h>
#include <kernels/core/Error.h>

namespace mote::bench
{

const std::vector<HexMethodEntry>& hexMethods()
{
  static const std::vector<HexMethodEntry> all = []
  {
    std::vector<HexMethodEntry> entries;
    for (std::size_t i = 0; i < std::variant_size_v<HexStructure>; ++i)
      withAlternative<HexStructure>(i,
        [&]<typename Structure>(std::type_identity<Structure>)
        {
          entries.push_back(
            {Structure::name(), Structure::summary(), static_cast<HexStructureKind>(i)});
        });
    return entries;
  }();
  return all;
}

const HexMethodEntry& hexMethodNamed(const std::string& name)
{
  for (const HexMethodEntry& entry : hexMethods())
    if (entry.name == name)
      return entry;
  throw Error("There is no structure " + name + ".");
}

const Named walkMethod = {"walk", "from cell to cell by shared faces, cell by cell"};

BuiltHexStructure buildWalk(const VolumeTask& task, std::shared_ptr<HexStructure> structure)
{
  BuiltHexStructure built;
  built.method = walkMethod.first;
  built.structure = std::move(structure);
  std::shared_ptr<const FaceAdjacency> adjacency;
  Race race;
  race.add(task.threads, [&] { adjacency = std::make_shared<FaceAdjacency>(*task.input.mesh); });
  race.add(task.threads,
    [&]
    {
      const HexField field(*task.input.mesh, task.input.hexScalar());
      built.walk = std::make_shared<WalkCells>(task.input.mesh, adjacency, field);
    });
  race.run(task.repeat);
  built.buildSeconds = race.seconds(0);
  built.frameChangeSeconds = race.seconds(1);
  built.megabytes = 1e-6 * static_cast<double>(built.walk->bytes());
  return built;
}

std::shared_ptr<HexStructure> makeStructure(
  const HexInput& input, const HexStructureRequest& request)
{
  HexStructureOptions options;
  options.kind = request.method->kind;
  options.grid.lambda2 = request.lambda2;
  options.grid.trimmed = request.trimmed;
  options.axis = input.axis;
  return makeHexStructure(input.mesh, options);
}

void describe(BuiltHexStructure& built)
{
  withStructure(*built.structure,
    [&](const auto& structure)
    {
      built.megabytes = 1e-6 * static_cast<double>(structure.bytes());
      built.references = structure.references();
      built.largestLeaf = structure.largestLeaf();
      built.shape = structure.shape();
    });
}

std::vector<BuiltHexStructure> buildStructures(
  const VolumeTask& task, const std::vector<HexStructureRequest>& requests)
{
  const HexInput& input = task.input;
  std::vector<BuiltHexStructure> all;
  for (const HexStructureRequest& request : requests)
    all.push_back(
      {request.method->name + (request.trimmed ? " trimmed" : ""), request.lambda2, {}, {}});
  Race race;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    race.addTimed(
      [&, i]
      {
        all[i].structure.reset();
        return timed(task.threads, [&] { all[i].structure = makeStructure(input, requests[i]); });
      });
    race.add(task.threads,
      [&, i] { setRanges(*all[i].structure, HexField(*input.mesh, input.hexScalar())); });
  }
  progress("building %zu structures, %d rounds", requests.size(), task.repeat);
  race.run(task.repeat);
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    BuiltHexStructure& built = all[i];
    built.buildSeconds = race.seconds(2 * i);
    built.frameChangeSeconds = race.seconds(2 * i + 1);
    describe(built);
  }
  return all;
}

} // namespace mote::bench
