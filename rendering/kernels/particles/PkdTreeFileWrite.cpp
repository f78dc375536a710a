// Writing a file of particles: rows and arrays are put in order a piece at a time, so that no
// second copy of anything is made.

#include "../core/Error.h"
#include "../core/detail/FileWriter.h"
#include "PkdTreeFile.h"
#include "detail/PkdTreeFileFormat.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace mote
{

namespace
{

constexpr std::size_t bucketsAPiece = 1 << 14;
constexpr std::size_t mostBucketsAPiece = 1 << 28;
constexpr std::size_t bucketsATask = 256;

void checkContents(
  const PkdTreeFileContents& contents, const ParticleStatistics& statistics, bool knowsInput)
{
  const std::size_t inputs = statistics.valid + statistics.badPositions + statistics.badRadii;
  checkArrays(contents.arrays, inputs, "particles", contents.indexArray);
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
    , file_(name, progress)
  {
  }

  bool write()
  {
    this->planTable();
    this->planHeader();
    file_.begin(packHeader(header_, table_), total_);
    if (!this->writeTree())
      return false;
    for (FileTableRow& row : table_)
      if (!this->writeArray(row))
        return false;
    header_.fileBytes = file_.place();
    file_.end(packHeader(header_, table_));
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
    { table_.push_back(rowFor(array, role, tuples)); };
    for (const NamedArray& array : contents_.arrays)
      add(array, PkdTreeFileHeader::ofParticles, tree_.count_);
    if (!contents_.indexArray.empty())
    {
      const auto type = tree_.indexWords_ == 1 ? ArrayView::Type::UInt32 : ArrayView::Type::UInt64;
      add({contents_.indexArray, ArrayView(nullptr, type, tree_.count_, 1), {}},
        PkdTreeFileHeader::ofParticles, tree_.count_);
    }
    for (const NamedArray& array : contents_.facts)
      if (bytesOf(array.values.type()) > 0)
        add(array, PkdTreeFileHeader::ofWhole, array.values.count());
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
    for (const FileTableRow& row : table_)
      total_ += row.entry.section.bytes;
  }

  bool writeTree()
  {
    const std::size_t nodeBytes = tree_.nodes_.size() * sizeof(PkdTree::Node);
    header_.nodes = file_.section(nodeBytes);
    if (nodeBytes > 0 && !file_.put(tree_.nodes_.data(), nodeBytes))
      return false;
    const std::size_t kept = header_.rowsABucket;
    header_.rows = file_.section(tree_.buckets() * kept * sizeof(Row));
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
        return file_.put(piece.data(), piece.size() * sizeof(Row));
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

  bool writeArray(FileTableRow& row)
  {
    if (row.entry.role == PkdTreeFileHeader::ofWhole)
      return file_.putArray(row);
    row.entry.section = file_.section(row.entry.section.bytes);
    Extremes found(row.array.values.components());
    const bool complete = this->writeInOrder(row.array.values, found);
    mote::complete(row, found);
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
        return file_.put(piece.data(), piece.size());
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
  FileWriter file_;
  PkdTreeFileHeader header_;
  FileTable table_;
  RawVector<Place> places_;
  std::uint64_t total_ = 0; ///< bytes that will be, without padding
};

bool writePkdTreeFile(const std::string& name, const PkdTree& tree,
  const PkdTreeFileContents& contents, const Progress& progress)
{
  checkContents(contents, tree.statistics(), tree.knowsInput());
  return PkdTreeFileWriter(name, tree, contents, progress).write();
}

} // namespace mote
