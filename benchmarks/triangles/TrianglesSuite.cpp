#include "TrianglesSuite.h"

#include "TriangleContest.h"

namespace mote::bench
{

namespace
{

Report run(const Options& asked)
{
  Options options = asked;
  if (options.wantsTables())
  {
    if (options.poe == std::vector<double>{0.0})
      options.poe = {0.0, 1.0, 2.0, 4.0, 8.0};
    if (options.methods.empty())
      options.methods = {"rlod", "embree"};
  }
  progress("making or reading %s", options.input.c_str());
  const TriangleInput input = makeTriangleInput(options.input);
  return TriangleContest(options, input).race();
}

} // namespace

Suite trianglesSuite()
{
  Suite suite;
  suite.name = "triangles";
  suite.summary = "primary, occlusion, shadow and mirrored rays through triangles";
  suite.inputs = triangleInputs();
  for (const TriangleMethodEntry& entry : triangleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : triangleViews())
    suite.views.emplace_back(view.name, view.summary);
  suite.tables = {{"speed", "speed, nodes and memory read against pixels of error"},
    {"errors", "error against time"}, {"frames", "frames with shadows and reflection"}};
  suite.tablesInput = "sphere:1000000";
  suite.cells = false;
  suite.lods = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
