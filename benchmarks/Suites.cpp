#include "Suite.h"

#include "ambient/AmbientSuite.h"
#include "hexahedra/HexSuite.h"
#include "imaging/SilhouetteSuite.h"
#include "particles/BuildSuite.h"
#include "particles/FileSuite.h"
#include "particles/GrowthSuite.h"
#include "particles/OcclusionSuite.h"
#include "particles/ParticlesSuite.h"
#include "particles/PreviewSuite.h"
#include "triangles/MeshFileSuite.h"
#include "triangles/TrianglesSuite.h"

namespace mote::bench
{

const std::vector<Suite>& suites()
{
  static const std::vector<Suite> all = {particlesSuite(), occlusionSuite(), buildSuite(),
    previewSuite(), growthSuite(), fileSuite(), silhouetteSuite(), ambientSuite(), hexahedraSuite(),
    trianglesSuite(), meshFileSuite()};
  return all;
}

std::string describe(const Suite& suite)
{
  std::string out = suite.name + ": " + suite.summary + "\n";
  const auto list = [&](const char* title, const std::vector<Named>& entries)
  {
    out += format("  %s\n", title);
    for (const auto& [name, summary] : entries)
      out += format("    %-16s %s\n", name.c_str(), summary.c_str());
  };
  list("inputs (--input)", suite.inputs);
  if (!suite.methods.empty())
    list("methods (--methods)", suite.methods);
  if (!suite.views.empty())
    list("views (--view)", suite.views);
  if (!suite.tables.empty())
    list(("tables (--tables), on " + suite.tablesInput + " unless told otherwise").c_str(),
      suite.tables);
  return out;
}

} // namespace mote::bench
