#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace mote::bench
{

/// What the command line says; every suite reads the part that concerns it.
struct Options
{
  std::string input;
  std::vector<std::string> methods; ///< empty: all of the suite
  std::vector<std::string> views;   ///< empty: all of the suite
  int threads = 0;                  ///< 0: as many as the machine has
  int repeat = 5;
  int width = 1024;
  int height = 1024;
  std::vector<int> sizes = {512, 1024, 2048}; ///< sides of square images, where a suite takes many
  std::string json;                           ///< file for the records, or empty
  bool allTables = false;          ///< print all of the suite's tables instead of one measurement
  std::vector<std::string> tables; ///< or these
  double lambda = 1.0;             ///< cells of a grid a particle, in [0.2, 5]
  int packet = 0;                  ///< side of the bundles of rays, 0: the structure's own choice
  int rays = 1;                    ///< from every hit of a primary ray
  std::vector<double> poe = {0.0}; ///< pixels of error that levels of detail may make
  double cloudTolerance = 0.0;     ///< between pixels of a volume; 0: all are traced
  bool singleRays = false; ///< structures of volumes take rays one at a time, never in bundles
  double step = 0.0;       ///< between samples of a volume; 0: the volume's own choice
  double tolerance = 1e-3; ///< of integration cell by cell
  std::string integrator = "trilinear";
  double lambda2 = 4.0; ///< leaves per reference of a macro cell of a two-level grid

  std::string structure = "auto"; ///< over the particles
  int frameWidth = 1024;          ///< of frames whose speed is compared, not their picture
  int frameHeight = 1024;
  int referenceRays = 4096;   ///< a hit of a reference picture
  int samples = 49;           ///< rays a texel of a map
  double reach = 0.0;         ///< of the rays of ambient occlusion; 0: a tenth of the longest side
  std::string baked = "auto"; ///< which particles: auto, seen or all

  bool wantsTables() const { return allTables || !tables.empty(); }
  bool wantsTable(const std::string& name) const
  {
    return allTables || std::find(tables.begin(), tables.end(), name) != tables.end();
  }
};

} // namespace mote::bench
