// Writing a file of particles: rows and arrays are put in order a piece at a time, so that no
// second copy of anything is made.

#include "../core/Error.h"
#include "../core/ScratchSpace.h"
#include "../core/detail/FileWriter.h"
#include "PkdTreeFile.h"
#include "detail/PkdTreeFileFormat.h"
#include "detail/PkdTreeMeans.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
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
    for (std::size_t k = 0; k < table_.rows.size(); ++k)
      if (!this->writeArray(table_.rows[k], table_.more.empty() ? nullptr : &table_.more[1 + k]))
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
    { table_.rows.push_back(rowFor(array, role, tuples)); };
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
    if (!tree_.hasLods())
      return;
    table_.more.push_back({0, tree_.lods_.size() * sizeof(PkdTree::Lods)});
    for (const FileTableRow& row : table_.rows)
      table_.more.push_back({0, meanRowsOf(row) * this->places() * sizeof(float)});
  }

  std::size_t places() const { return tree_.nodes_.size() * PkdTree::fanout; }

  /// Rows of means of an array; what may be indices has none.
  static std::size_t meanRowsOf(const FileTableRow& row)
  {
    const ArrayView& values = row.array.values;
    const bool mayBeIndex =
      values.type() == ArrayView::Type::UInt32 || values.type() == ArrayView::Type::UInt64;
    return row.entry.role == PkdTreeFileHeader::ofParticles && !mayBeIndex
             ? StoredMeans::rowsOf(values.type(), values.components())
             : 0;
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
    for (const FileTableRow& row : table_.rows)
      total_ += row.entry.section.bytes;
    for (const FileSection& section : table_.more)
      total_ += section.bytes;
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
             }) &&
           (table_.more.empty() || this->writeSection(table_.more.front(), tree_.lods_.data()));
  }

  bool writeSection(FileSection& section, const void* data)
  {
    if (section.bytes == 0)
      return true;
    section = file_.section(section.bytes);
    return file_.put(data, section.bytes);
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

  /// Writes an array and, where asked for, its means.
  bool writeArray(FileTableRow& row, FileSection* meansSection)
  {
    if (row.entry.role == PkdTreeFileHeader::ofWhole)
      return file_.putArray(row);
    row.entry.section = file_.section(row.entry.section.bytes);
    Extremes found(row.array.values.components());
    Means means(*this, meansSection != nullptr ? meanRowsOf(row) : 0);
    const bool complete = this->writeInOrder(row.array.values, found, means);
    mote::complete(row, found);
    if (!complete || meansSection == nullptr)
      return complete;
    return this->writeSection(*meansSection, means.finish());
  }

  /// Means of an array's rows over what boxes stand for, from its values in the file's order.
  class Means
  {
  public:
    Means(const PkdTreeFileWriter& writer, std::size_t rows)
      : writer_(writer)
      , rows_(rows)
    {
      const std::size_t places = writer.places(), bytes = rows * places * sizeof(float);
      const auto& space = writer.contents_.space;
      means_.resize(rows * places, space && bytes > 0 ? space->allocate(bytes) : nullptr);
      std::fill_n(means_.own(), means_.size(), std::numeric_limits<float>::quiet_NaN());
      for (std::size_t first = 0; first < rows; first += WeightedSum::most)
        parts_.emplace_back(
          writer.tree_, this->numbersFrom(first), means_.own() + first * places, 1, places);
    }

    /// Values of some buckets, the first of `values` being the first's.
    void add(std::size_t first, std::size_t last, const ArrayView& values)
    {
      for (std::size_t k = 0; k < parts_.size(); ++k)
        parts_[k].add(
          first, last, [&](std::size_t bucket) { return this->sumOf(bucket, first, values, k); });
    }

    const float* finish()
    {
      for (PkdTreeMeans& part : parts_)
        part.finish();
      return means_.data();
    }

  private:
    int numbersFrom(std::size_t row) const
    {
      return static_cast<int>(std::min<std::size_t>(WeightedSum::most, rows_ - row));
    }

    WeightedSum sumOf(
      std::size_t bucket, std::size_t first, const ArrayView& values, std::size_t part) const
    {
      const std::size_t row = part * WeightedSum::most, count = writer_.countIn(bucket);
      const auto order = writer_.tree_.ownRadii_ ? writer_.orderIn(bucket, count)
                                                 : std::array<std::uint8_t, PkdTree::bucketSize>{};
      const int numbers = this->numbersFrom(row);
      WeightedSum sum;
      for (std::size_t i = 0; i < count; ++i)
      {
        double numbersOf[WeightedSum::most];
        for (int c = 0; c < numbers; ++c)
          numbersOf[c] = values.value((bucket - first) * PkdTree::bucketSize + i,
            StoredMeans::componentOf(row + static_cast<std::size_t>(c), values.components()));
        const std::size_t slot = bucket * PkdTree::bucketSize + order[i];
        sum.add(numbersOf, std::pow(double(writer_.tree_.storedRadius(slot)), 2), numbers);
      }
      return sum;
    }

    const PkdTreeFileWriter& writer_;
    std::size_t rows_;
    StoredArray<float> means_;
    std::vector<PkdTreeMeans> parts_;
  };

  bool writeInOrder(const ArrayView& values, Extremes& found, Means& means)
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
        const ArrayView ordered(piece.data(), values.type(), count, values.components());
        found.add(extremesOf(ordered));
        means.add(first, last, ordered);
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
