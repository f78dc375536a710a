#pragma once

#include "../Contest.h"

#include <string>
#include <vector>

namespace mote::bench
{

/// What the tables of one run share.
struct TableRun
{
  const Options& options;
  const ParticleInput& input;
  int threads; ///< that may be used
  std::vector<View> views;
  std::string name; ///< of the present table
  ReferenceImages references{};
  Report report{};

  Contest contest(int width, int height) const { return {views, width, height, options.repeat}; }
  Contest contest() const { return contest(options.width, options.height); }
  MethodOptions methodOptions() const { return {threads, options.lambda, options.packet}; }

  /// A measurement of the table's input that says nothing yet.
  Measurement measurement(const std::string& method, const std::string& mode) const;
  /// Adds a record of the present table.
  void record(Measurement measurement);
  /// Adds records of all that took part in a contest.
  void record(Contest& contest);
};

/// One table of --tables: a row of the list in Tables.cpp.
struct TableEntry
{
  std::string name;
  std::string title;
  Section (*make)(TableRun& run); ///< the title is added afterwards
};

/// All of them, in the order in which they are printed.
const std::vector<TableEntry>& tables();

/// Makes the tables that the options ask for.
Report makeTables(const Options& options);

/// The method of that name.
const ParticleMethodEntry& methodNamed(const std::string& name);

Section packetTable(TableRun& run);
Section resolutionTable(TableRun& run);
Section referenceGridTable(TableRun& run);
Section cullingTable(TableRun& run);
Section cullingSpeedTable(TableRun& run);
Section rangeTable(TableRun& run);
Section shadowTable(TableRun& run);
Section methodTable(TableRun& run);
Section radiiTable(TableRun& run);
Section buildTable(TableRun& run);
Section lambdaTable(TableRun& run);

} // namespace mote::bench
