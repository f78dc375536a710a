#include "MeshFileSuite.h"

#include "../PageCache.h"
#include "../Timing.h"
#include "../particles/HitImage.h"
#include "../particles/Views.h"
#include "TreePicture.h"
#include "TriangleInput.h"
#include "TrianglesSuite.h"

#include <kernels/meshes/RlodTreeFile.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>

#include <sys/mman.h>
#include <unistd.h>

namespace mote::bench
{

namespace
{

using Order = RlodTreeFileContents::Order;

struct OrderEntry
{
  const char* name;
  const char* summary;
  Order order;
};

constexpr OrderEntry orders[] = {
  {"by-error", "nodes that err by more first, as files have them; not for FILE.mote",
    Order::ByError},
  {"depth-first", "nodes as the tree has them; not for FILE.mote", Order::DepthFirst},
  {"by-area", "nodes with a larger surface first, in steps of two; not for FILE.mote",
    Order::ByArea},
  {"blocks", "blocks of a page with the likeliest nodes by surface; not for FILE.mote",
    Order::Blocks}};

using Pages = std::map<std::string, std::int64_t>; ///< of each part of the file

/// One view at one error, each time from a file of which nothing is in memory.
struct Cold
{
  std::string order, file;
  View view;
  double poe;
  std::vector<double> opened{}, looked{}, again{}; ///< seconds
  Pages afterOpening{}, afterLooking{};
  double read = 0.0; ///< bytes from the disk, the last time
};

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Where the file lies in memory.
unsigned char* beginOf(const RlodTreeFile& file)
{
  const auto part = std::find_if(file.parts().begin(), file.parts().end(),
    [](const RlodTreeFile::Part& p) { return std::string(p.name) == "corners"; });
  const auto* corners = reinterpret_cast<const unsigned char*>(file.corners()->data());
  return const_cast<unsigned char*>(corners) - part->offset; // for mincore(), which writes nothing
}

/// Pages of each part that the system holds in memory.
Pages residentPages(const RlodTreeFile& file)
{
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> resident((file.bytes() + page - 1) / page);
  Pages pages;
  if (::mincore(beginOf(file), file.bytes(), resident.data()) != 0)
    return pages;
  for (const RlodTreeFile::Part& part : file.parts())
    for (std::uint64_t k = part.offset / page; k * page < part.offset + part.bytes; ++k)
      pages[part.name] += resident[k] & 1;
  return pages;
}

/// A file that is written for the measurement, in the present folder, and goes with it.
class ScratchFile
{
public:
  ScratchFile(const TriangleInput& input, Order order)
    : name_("mesh-file-" + std::to_string(::getpid()) + "-" +
            std::to_string(static_cast<int>(order)) + ".mote")
  {
    const TriangleMesh mesh = input.mesh();
    RlodTree tree;
    tree.build(mesh);
    tree.makeLods();
    RlodTreeFileContents contents;
    contents.places = ArrayView(&input.points[0].x, input.pointCount(), 3);
    contents.order = order;
    const double start = now();
    writeRlodTreeFile(name_, tree, mesh, contents);
    progress("%s written in %.1f s", name_.c_str(), now() - start);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() { std::filesystem::remove(name_); }

  const std::string& name() const { return name_; }

private:
  std::string name_;
};

double cast(const RlodTreeFile& file, const Cold& cold, const Options& options, int threads)
{
  const auto tree = file.tree();
  const CameraRays rays(cameraOf(cold.view, tree->bounds()), options.width, options.height);
  TriangleImage image(options.width, options.height);
  return timed(threads,
    [&]
    {
      forBlocks(options.width, options.height, 16,
        [&](int x0, int y0)
        {
          RayBundle bundle;
          rays.fillBundle(bundle, 16, x0, y0, 0.0, 0.0);
          tree->cast(bundle, 0, cold.poe);
          keepHits(*tree, bundle, 16, x0, y0, image);
        });
    });
}

/// Opens the file and looks twice. Pages come one by one, as from a file that is larger than
/// memory.
void look(Cold& cold, const Options& options, int threads, std::string& forgetting)
{
  forgetting = forgetPages(cold.file);
  const double before = bytesReadFromDisk(), start = now();
  const RlodTreeFile file(cold.file, MappedFile::Paging::Single);
  cold.opened.push_back(now() - start);
  cold.afterOpening = residentPages(file);
  cold.looked.push_back(cast(file, cold, options, threads));
  cold.afterLooking = residentPages(file);
  cold.read = bytesReadFromDisk() - before;
  cold.again.push_back(cast(file, cold, options, threads));
}

std::vector<std::string> rowOf(const Cold& cold, double exact)
{
  const auto pages = [&](const char* part)
  {
    const auto found = cold.afterLooking.find(part);
    return std::to_string(found == cold.afterLooking.end() ? 0 : found->second);
  };
  const double looked = median(cold.looked);
  return {cold.order, cold.view.name, format("%g", cold.poe),
    format("%.1f", 1e3 * median(cold.opened)), format("%.1f", 1e3 * looked),
    exact > 0.0 ? format("%.1f", exact / looked) : "", format("%.1f", 1e3 * median(cold.again)),
    pages("nodes"), pages("words"), pages("planes"), pages("clusters"),
    format("%.1f", 1e-6 * cold.read)};
}

Record toRecord(const Cold& cold, const RlodTreeFile& file, const Options& options, int threads)
{
  Record record = {{"suite", std::string("mesh-file")}, {"input", options.input},
    {"triangles", static_cast<std::int64_t>(file.size())},
    {"file_bytes", static_cast<std::int64_t>(file.bytes())}, {"method", cold.order},
    {"view", cold.view.name}, {"poe", cold.poe}, {"width", std::int64_t{options.width}},
    {"height", std::int64_t{options.height}}, {"threads", std::int64_t{threads}},
    {"repeat", static_cast<std::int64_t>(cold.looked.size())}, {"open_s", median(cold.opened)},
    {"first_picture_s", median(cold.looked)}, {"next_picture_s", median(cold.again)},
    {"read_bytes", cold.read}};
  for (const auto& [part, count] : cold.afterLooking)
    record.push_back({"pages_" + part, count});
  return record;
}

/// The file that is asked for, or those that are written of other input.
class Files
{
public:
  explicit Files(const Options& options)
  {
    if (options.input.ends_with(".mote"))
    {
      names_.emplace_back("file", options.input);
      return;
    }
    const TriangleInput input = makeTriangleInput(options.input);
    for (const OrderEntry& entry : orders)
      if (options.methods.empty() ||
          std::count(options.methods.begin(), options.methods.end(), entry.name) > 0)
      {
        written_.push_back(std::make_unique<ScratchFile>(input, entry.order));
        names_.emplace_back(entry.name, written_.back()->name());
      }
  }

  const std::vector<Named>& names() const { return names_; }

private:
  std::vector<std::unique_ptr<ScratchFile>> written_;
  std::vector<Named> names_;
};

Report run(const Options& options)
{
  const int threads = threadCount(options.threads);
  const Files files(options);
  std::vector<Cold> all;
  for (const auto& [order, file] : files.names())
    for (const View& view : triangleViews())
      if (options.views.empty() ||
          std::find(options.views.begin(), options.views.end(), view.name) != options.views.end())
        for (const double poe : options.poe)
          all.push_back({order, file, view, poe});
  std::string forgetting;
  for (int round = 0; round < options.repeat; ++round)
    for (Cold& cold : all)
    {
      look(cold, options, threads, forgetting);
      progress("%s, %s, %g pixels of error: opened in %.1f ms, picture after %.1f ms more",
        cold.order.c_str(), cold.view.name.c_str(), cold.poe, 1e3 * cold.opened.back(),
        1e3 * cold.looked.back());
    }
  Report report;
  Section section{"", Table(3)};
  section.table.add({"order", "view", "PoE", "open ms", "first ms", "times", "next ms", "nodes",
    "words", "planes", "clusters", "read MB"});
  const RlodTreeFile file(all.front().file);
  for (const Cold& cold : all)
  {
    const auto exact = std::find_if(all.begin(), all.end(),
      [&](const Cold& c)
      { return c.order == cold.order && c.view.name == cold.view.name && c.poe == 0.0; });
    section.table.add(rowOf(cold, exact == all.end() ? 0.0 : median(exact->looked)));
    report.records.push_back(toRecord(cold, file, options, threads));
  }
  section.notes = {
    format("%zu triangles in %.3f GB (%s), %dx%d rays a picture, %d threads, medians of %d.",
      file.size(), 1e-9 * static_cast<double>(file.bytes()), options.input.c_str(), options.width,
      options.height, threads, options.repeat),
    format("Each time after %s: opening, which reads all nodes; a first picture, whose pages come "
           "one by one; the next. Times: how much sooner than without error.",
      forgetting.c_str()),
    "Nodes to clusters: pages of the file in memory after the first picture."};
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite meshFileSuite()
{
  Suite suite;
  suite.name = "mesh-file";
  suite.summary = "opening and drawing a .mote file of triangles that is not in memory";
  suite.inputs = triangleInputs();
  suite.inputs.emplace_back("FILE.mote", "a file of triangles as it is; mote convert writes them");
  for (const OrderEntry& entry : orders)
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : triangleViews())
    suite.views.emplace_back(view.name, view.summary);
  suite.lods = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
