// Writing a file of particles: rows and arrays are put in order a piece at a time, so that no
// second copy of anything is made.

#include "../core/AtomicFile.h"
#include "../core/Error.h"
#include "detail/PkdTreeFileFormat.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>

namespace mote
{

namespace
{

constexpr std::size_t bucketsAPiece = 1 << 14;
constexpr std::size_t mostBucketsAPiece = 1 << 28;
constexpr std::size_t bucketsATask = 256;

/// The extremes of an array's finite values.
struct Extremes
{
  std::vector<PkdTreeFile::Range> ranges; ///< of each component, then of the magnitude
  bool finite = true;

  explicit Extremes(int components)
    : ranges(static_cast<std::size_t>(components) + 1,
        {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
  {
  }
  void add(const ArrayView& values, std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < ranges.size(); ++k)
      {
        const bool whole = k + 1 == ranges.size();
        const double v = values.value(i, whole ? ArrayView::magnitude : static_cast<int>(k));
        if (std::isfinite(v))
          ranges[k] = {std::min(ranges[k][0], v), std::max(ranges[k][1], v)};
        finite = finite && std::isfinite(v);
      }
  }
  void add(const Extremes& other)
  {
    for (std::size_t k = 0; k < ranges.size(); ++k)
      ranges[k] = {
        std::min(ranges[k][0], other.ranges[k][0]), std::max(ranges[k][1], other.ranges[k][1])};
    finite = finite && other.finite;
  }
};

Extremes extremesOf(const ArrayView& values)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, values.count(), 16 * bucketsATask),
    Extremes(values.components()),
    [&](const tbb::blocked_range<std::size_t>& range, Extremes found)
    {
      found.add(values, range.begin(), range.end());
      return found;
    },
    [](Extremes a, const Extremes& b)
    {
      a.add(b);
      return a;
    });
}

/// Copies whole tuples: the size of one is known to the compiler where it is a usual one.
void copyTuple(unsigned char* to, const unsigned char* from, std::size_t size)
{
  if (size == 4)
    std::memcpy(to, from, 4);
  else if (size == 8)
    std::memcpy(to, from, 8);
  else
    std::memcpy(to, from, size);
}

void checkContents(
  const PkdTreeFileContents& contents, const ParticleStatistics& statistics, bool knowsInput)
{
  const std::size_t inputs = statistics.valid + statistics.badPositions + statistics.badRadii;
  std::set<std::string> names;
  for (const NamedArray& array : contents.arrays)
  {
    const std::string quoted = "\"" + array.name + "\"";
    if (array.name.empty())
      throw Error("An array needs a name to be written.");
    if (!names.insert(array.name).second || array.name == contents.indexArray)
      throw Error("Two arrays are named " + quoted + ".");
    if (array.values.count() != inputs || bytesOf(array.values.type()) == 0)
      throw Error("The array " + quoted + " has " + std::to_string(array.values.count()) +
                  " values for " + std::to_string(inputs) + " particles.");
  }
  if (!knowsInput && statistics.valid > 0 &&
      !(contents.arrays.empty() && contents.indexArray.empty()))
    throw Error("Arrays need a tree that keeps the particles' input indices.");
}

} // namespace

/// One file that is written.
class PkdTreeFileWriter
{
public:
  PkdTreeFileWriter(const std::string& name, const PkdTree& tree,
    const PkdTreeFileContents& contents, const Progress& progress)
    : tree_(tree)
    , contents_(contents)
    , progress_(progress)
    , file_(name)
  {
  }

  bool write()
  {
    this->planTable();
    this->planHeader();
    const std::vector<unsigned char> header = packHeader(header_, table_);
    file_.write(header.data(), header.size());
    place_ = header.size();
    if (!this->writeTree())
      return false;
    for (std::size_t k = 0; k < table_.size(); ++k)
      if (!this->writeArray(k))
        return false;
    header_.fileBytes = place_;
    const std::vector<unsigned char> final = packHeader(header_, table_);
    file_.rewrite(0, final.data(), final.size());
    file_.commit();
    return true;
  }

private:
  using Row = PkdTree::Row;

  /// Which particle of a bucket comes first, second ...: the order of the input.
  std::array<std::uint8_t, PkdTree::bucketSize> orderIn(std::size_t bucket, std::size_t count) const
  {
    std::array<std::uint8_t, PkdTree::bucketSize> order;
    std::array<std::uint64_t, PkdTree::bucketSize> inputs;
    std::iota(order.begin(), order.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < count; ++i)
    {
      inputs[i] = tree_.inputIndex(bucket * PkdTree::bucketSize + i);
      for (std::size_t k = i; k > 0 && inputs[order[k - 1]] > inputs[order[k]]; --k)
        std::swap(order[k - 1], order[k]);
    }
    return order;
  }

  std::size_t countIn(std::size_t bucket) const
  {
    return std::min<std::size_t>(PkdTree::bucketSize, tree_.count_ - bucket * PkdTree::bucketSize);
  }

  void planTable()
  {
    const auto add = [&](const NamedArray& array, std::uint32_t role, std::uint64_t tuples)
    {
      PkdTreeFileTableRow row{};
      static_cast<NamedArray&>(row.array) = array;
      const auto components = static_cast<std::size_t>(array.values.components());
      if (row.array.components.size() != components)
        row.array.components.clear();
      row.entry = {{0, tuples * components * bytesOf(array.values.type())}, tuples, role,
        static_cast<std::uint32_t>(array.values.type()), static_cast<std::uint32_t>(components), 1,
        static_cast<std::uint32_t>(row.array.components.size()), 0};
      row.array.ranges.resize(components + 1);
      table_.push_back(std::move(row));
    };
    for (const NamedArray& array : contents_.arrays)
      add(array, PkdTreeFileEntry::ofParticles, tree_.count_);
    if (!contents_.indexArray.empty())
    {
      const auto type = tree_.indexWords_ == 1 ? ArrayView::Type::UInt32 : ArrayView::Type::UInt64;
      add({contents_.indexArray, ArrayView(nullptr, type, tree_.count_, 1), {}},
        PkdTreeFileEntry::ofParticles, tree_.count_);
    }
    for (const NamedArray& array : contents_.facts)
      if (bytesOf(array.values.type()) > 0)
        add(array, PkdTreeFileEntry::ofWhole, array.values.count());
  }

  void planHeader()
  {
    PkdTreeFileHeader& h = header_;
    const PkdTree& t = tree_;
    h.nodeBytes = sizeof(PkdTree::Node);
    h.rowBytes = sizeof(Row);
    h.fanout = PkdTree::fanout;
    h.bucketSize = PkdTree::bucketSize;
    h.count = t.count_;
    h.levels = static_cast<std::uint32_t>(t.levels());
    h.ownRadii = t.ownRadii_;
    h.rowsABucket = static_cast<std::uint32_t>(t.placeRows_) + h.ownRadii;
    h.hasTime = contents_.time.has_value();
    h.time = contents_.time.value_or(0.0);
    h.spacing = contents_.spacing;
    h.unit = t.unit_;
    h.step = t.step_;
    h.coarse = t.coarse_;
    h.radius = t.radius_;
    h.smallestRadius = t.statistics_.smallestRadius;
    h.largestRadius = t.statistics_.largestRadius;
    for (int k = 0; k < 3; ++k)
    {
      h.origin[k] = t.origin_[k];
      h.centers[k] = t.statistics_.centers.lower[k];
      h.centers[3 + k] = t.statistics_.centers.upper[k];
      h.bounds[k] = t.statistics_.bounds.lower[k];
      h.bounds[3 + k] = t.statistics_.bounds.upper[k];
    }
    total_ = t.nodes_.size() * sizeof(PkdTree::Node) + t.buckets() * h.rowsABucket * sizeof(Row);
    for (const PkdTreeFileTableRow& row : table_)
      total_ += row.entry.section.bytes;
  }

  bool put(const void* data, std::size_t size)
  {
    file_.write(data, size);
    place_ += size;
    return !progress_ ||
           progress_(std::min(1.0, double(place_) / double(total_ + sizeof(header_))));
  }

  /// Fills up to the next page, where a section begins.
  PkdTreeFileHeader::Section begin(std::uint64_t bytes)
  {
    static constexpr std::array<unsigned char, PkdTreeFileHeader::alignment> nothing{};
    const std::uint64_t over = place_ % PkdTreeFileHeader::alignment;
    if (over > 0)
      this->put(nothing.data(), PkdTreeFileHeader::alignment - over);
    return {place_, bytes};
  }

  bool writeTree()
  {
    const std::size_t nodeBytes = tree_.nodes_.size() * sizeof(PkdTree::Node);
    header_.nodes = this->begin(nodeBytes);
    if (nodeBytes > 0 && !this->put(tree_.nodes_.data(), nodeBytes))
      return false;
    const std::size_t kept = header_.rowsABucket;
    header_.rows = this->begin(tree_.buckets() * kept * sizeof(Row));
    RawVector<Row> piece;
    return this->byPieces(bucketsAPiece,
      [&](std::size_t first, std::size_t last)
      {
        piece.resize((last - first) * kept);
        this->forBuckets(first, last,
          [&](std::size_t bucket, const auto& order)
          {
            const Row* from = tree_.bucketOf(bucket * PkdTree::bucketSize);
            Row* to = &piece[(bucket - first) * kept];
            for (std::size_t k = 0; k < kept; ++k)
              for (std::size_t i = 0; i < PkdTree::bucketSize; ++i)
                to[k].words[i] = from[k].words[order[i]];
          });
        return this->put(piece.data(), piece.size() * sizeof(Row));
      });
  }

  template <typename Write>
  bool byPieces(std::size_t size, const Write& write) const
  {
    const std::size_t buckets = tree_.buckets();
    for (std::size_t first = 0; first < buckets; first += size)
      if (!write(first, std::min(buckets, first + size)))
        return false;
    return true;
  }

  template <typename Visit>
  void forBuckets(std::size_t first, std::size_t last, const Visit& visit) const
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, bucketsATask),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t bucket = range.begin(); bucket != range.end(); ++bucket)
          visit(bucket, this->orderIn(bucket, this->countIn(bucket)));
      });
  }

  bool writeArray(std::size_t k)
  {
    PkdTreeFileEntry& entry = table_[k].entry;
    PkdTreeFile::Array& array = table_[k].array;
    const ArrayView values = array.values;
    entry.section = this->begin(entry.section.bytes);
    Extremes found(values.components());
    bool complete = true;
    if (entry.role == PkdTreeFileEntry::ofWhole)
    {
      found.add(extremesOf(values));
      complete = entry.section.bytes == 0 || this->put(values.data(), entry.section.bytes);
    }
    else
      complete = this->writeInOrder(values, found);
    array.ranges = found.ranges;
    array.finite = found.finite;
    entry.finite = found.finite;
    return complete;
  }

  bool writeInOrder(const ArrayView& values, Extremes& found)
  {
    const std::size_t tuple =
      bytesOf(values.type()) * static_cast<std::size_t>(values.components());
    // Without data the values are the indices themselves.
    const bool farther = contents_.workBytes > 0 && values.data() != nullptr;
    const std::size_t bucketBytes = PkdTree::bucketSize * (tuple + (farther ? sizeof(Place) : 0));
    const std::size_t size =
      farther ? std::clamp<std::size_t>(contents_.workBytes / bucketBytes, 1, mostBucketsAPiece)
              : bucketsAPiece;
    RawVector<unsigned char> piece;
    return this->byPieces(size,
      [&](std::size_t first, std::size_t last)
      {
        const std::size_t firstSlot = first * PkdTree::bucketSize;
        const std::size_t count = std::min(tree_.count_, last * PkdTree::bucketSize) - firstSlot;
        piece.resize(count * tuple);
        if (farther)
          this->gatherAscending(values, first, last, piece);
        else
          this->gather(values, first, last, piece);
        found.add(extremesOf(ArrayView(piece.data(), values.type(), count, values.components())));
        return this->put(piece.data(), piece.size());
      });
  }

  /// Calls visit(place in the piece, index in the input) for the particles of some buckets.
  template <typename Visit>
  void forPlaces(std::size_t first, std::size_t last, const Visit& visit) const
  {
    this->forBuckets(first, last,
      [&](std::size_t bucket, const auto& order)
      {
        const std::size_t slot = bucket * PkdTree::bucketSize;
        for (std::size_t i = 0; i < this->countIn(bucket); ++i)
          visit(slot + i - first * PkdTree::bucketSize, tree_.inputIndex(slot + order[i]));
      });
  }

  void gather(const ArrayView& values, std::size_t first, std::size_t last,
    RawVector<unsigned char>& piece) const
  {
    const std::size_t tuple =
      bytesOf(values.type()) * static_cast<std::size_t>(values.components());
    const auto* data = static_cast<const unsigned char*>(values.data());
    this->forPlaces(first, last,
      [&](std::size_t place, std::uint64_t input)
      {
        unsigned char* to = &piece[place * tuple];
        if (data != nullptr)
          copyTuple(to, data + input * tuple, tuple);
        else if (const auto narrow = static_cast<std::uint32_t>(input); tuple == 4)
          std::memcpy(to, &narrow, 4);
        else
          std::memcpy(to, &input, 8);
      });
  }

  /// Where in a piece a value of the input belongs.
  struct Place
  {
    std::uint64_t input;
    std::uint64_t place;
  };

  /// The same in the order of the input: pages of a file are then read one after another.
  void gatherAscending(
    const ArrayView& values, std::size_t first, std::size_t last, RawVector<unsigned char>& piece)
  {
    const std::size_t tuple =
      bytesOf(values.type()) * static_cast<std::size_t>(values.components());
    const auto* data = static_cast<const unsigned char*>(values.data());
    places_.resize(piece.size() / tuple);
    this->forPlaces(first, last,
      [&](std::size_t place, std::uint64_t input) {
        places_[place] = {input, place};
      });
    tbb::parallel_sort(places_.begin(), places_.end(),
      [](const Place& a, const Place& b) { return a.input < b.input; });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places_.size(), 16 * bucketsATask),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          copyTuple(&piece[places_[i].place * tuple], data + places_[i].input * tuple, tuple);
      });
  }

  const PkdTree& tree_;
  const PkdTreeFileContents& contents_;
  const Progress& progress_;
  AtomicFile file_;
  PkdTreeFileHeader header_;
  std::vector<PkdTreeFileTableRow> table_;
  RawVector<Place> places_;
  std::uint64_t place_ = 0; ///< bytes written
  std::uint64_t total_ = 0; ///< bytes that will be, without padding
};

bool writePkdTreeFile(const std::string& name, const PkdTree& tree,
  const PkdTreeFileContents& contents, const Progress& progress)
{
  checkContents(contents, tree.statistics(), tree.knowsInput());
  return PkdTreeFileWriter(name, tree, contents, progress).write();
}

} // namespace mote
