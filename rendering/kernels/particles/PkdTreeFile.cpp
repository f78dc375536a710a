// Opening a file of particles.

#include "PkdTreeFile.h"

#include "../core/Error.h"
#include "../core/MappedFile.h"
#include "detail/PkdTreeFileFormat.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace mote
{

namespace
{

using Header = PkdTreeFileHeader;

/// Of the data's size in units of its spacing; what is beyond this no computation bears.
constexpr double largestExtent = 0x1p50;

Box boxOf(const double v[6])
{
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

bool isGood(const Box& box)
{
  bool good = !box.empty();
  for (int k = 0; k < 3; ++k)
    good = good && std::isfinite(box.lower[k]) && std::isfinite(box.upper[k]);
  return good && std::isfinite(glm::length(box.size()));
}

/// Whether the numbers that rays are turned into the tree's with are any.
void checkNumbers(const std::string& name, const Header& h)
{
  const Box centers = boxOf(h.centers), bounds = boxOf(h.bounds);
  bool good = isGood(centers) && isGood(bounds);
  for (const double v : {h.unit, h.step, h.coarse, h.smallestRadius, h.largestRadius})
    good = good && std::isfinite(v) && v > 0.0;
  good = good && std::isfinite(h.radius) && h.radius >= 0.0;
  for (int k = 0; k < 3 && good; ++k)
    good = std::abs(h.origin[k] - centers.center()[k]) <= bounds.size()[k] + h.unit &&
           bounds.size()[k] / h.unit <= largestExtent;
  if (!good)
    failDamaged(name, "its numbers on places are none");
}

/// A tree's particles in its own order.
class ParticlesOfTree : public ParticleSource
{
public:
  explicit ParticlesOfTree(PkdTree tree)
    : tree_(std::move(tree))
  {
  }

  std::size_t count() const override { return tree_.size(); }
  void positions(std::size_t first, std::size_t last, Vec3d* positions) const override
  {
    for (std::size_t i = first; i < last; ++i)
      positions[i - first] = tree_.center(i);
  }
  bool hasRadii() const override
  {
    return tree_.statistics().smallestRadius != tree_.statistics().largestRadius;
  }
  void radii(std::size_t first, std::size_t last, double* radii) const override
  {
    for (std::size_t i = first; i < last; ++i)
      radii[i - first] = tree_.radius(i);
  }
  double radius() const override { return hasRadii() ? 1.0 : tree_.statistics().largestRadius; }

private:
  PkdTree tree_;
};

} // namespace

std::shared_ptr<const ParticleSource> PkdTreeFile::particles() const
{
  return std::make_shared<ParticlesOfTree>(tree_);
}

bool PkdTreeFile::recognises(std::string_view beginning)
{
  return beginning.starts_with(std::string_view(Header::theMagic.data(), Header::theMagic.size()));
}

PkdTreeFile::PkdTreeFile(const std::string& name)
  : file_(std::make_shared<const MappedFile>(name))
{
  FileTable table;
  const auto h = unpackHeader<Header>(name, file_->data(), file_->size(), table);
  checkSections(name, h, {h.nodes, h.rows}, table);
  if (h.nodeBytes != sizeof(PkdTree::Node) || h.rowBytes != sizeof(PkdTree::Row) ||
      h.fanout != PkdTree::fanout || h.bucketSize != PkdTree::bucketSize)
    throw Error(name + ": this file has nodes of another shape than is read here");
  // Below this no product that follows can overflow.
  if (h.count > file_->size() || h.ownRadii > 1 || h.rowsABucket < 1 + h.ownRadii ||
      h.rowsABucket > 3 + h.ownRadii)
    failDamaged(name, "its numbers of particles and rows are none");
  tree_.count_ = h.count;
  const std::size_t nodes = h.count > 0 ? PkdTree::planLevels(h.count, tree_.levels_) : 0;
  if (h.levels != tree_.levels_.size() || h.nodes.bytes != nodes * sizeof(PkdTree::Node) ||
      h.rows.bytes != tree_.buckets() * h.rowsABucket * sizeof(PkdTree::Row))
    failDamaged(name, "its tree has not the size that its particles ask for");
  for (FileTableRow& row : table.rows)
  {
    const FileEntry& e = row.entry;
    const bool ofParticles = e.role == Header::ofParticles;
    if (ofParticles && e.tuples != h.count)
      failDamaged(name, "an array in its table has not one tuple a particle");
    row.array.values = ArrayView(file_->data() + e.section.offset,
      static_cast<ArrayView::Type>(e.type), e.tuples, static_cast<int>(e.components));
    (ofParticles ? arrays_ : facts_).push_back(std::move(row.array));
  }
  time_ = h.hasTime ? std::optional(h.time) : std::nullopt;
  spacing_ = h.spacing;
  tree_.inOrder_ = true;
  if (h.count == 0)
    return;
  checkNumbers(name, h);
  tree_.statistics_ = {boxOf(h.centers), boxOf(h.bounds), h.largestRadius, h.smallestRadius,
    static_cast<std::size_t>(h.count), 0, 0};
  tree_.origin_ = {h.origin[0], h.origin[1], h.origin[2]};
  tree_.unit_ = h.unit;
  tree_.step_ = h.step;
  tree_.coarse_ = static_cast<float>(h.coarse);
  tree_.radius_ = static_cast<float>(h.radius);
  tree_.ownRadii_ = h.ownRadii != 0;
  tree_.rowsABucket_ = h.rowsABucket;
  tree_.placeRows_ = static_cast<int>(h.rowsABucket - h.ownRadii);
  tree_.nodes_.view(
    reinterpret_cast<const PkdTree::Node*>(file_->data() + h.nodes.offset), nodes, file_);
  tree_.rows_.view(reinterpret_cast<const PkdTree::Row*>(file_->data() + h.rows.offset),
    tree_.buckets() * h.rowsABucket, file_);
  this->checkEnds(name);
  this->takeLods(table);
  tree_.findRepeats();
}

/// Takes boxes that stand for particles, and means of arrays over these, where there are any.
void PkdTreeFile::takeLods(const FileTable& table)
{
  if (table.more.empty())
    return;
  if (table.more.size() != 1 + table.rows.size())
    failDamaged(file_->name(), "its levels of detail are not those of its arrays");
  const std::size_t nodes = tree_.nodes_.size(), places = nodes * PkdTree::fanout;
  const auto check = [&](const FileSection& section, std::size_t bytes)
  {
    if (section.bytes != 0 && section.bytes != bytes)
      failDamaged(file_->name(), "its levels of detail have not the size that its tree asks for");
    return section.bytes != 0;
  };
  const FileSection& boxes = table.more.front();
  if (check(boxes, nodes * sizeof(PkdTree::Lods)))
    tree_.lods_.view(
      reinterpret_cast<const PkdTree::Lods*>(file_->data() + boxes.offset), nodes, file_);
  const auto means = std::make_shared<StoredMeans>();
  std::size_t array = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k)
  {
    const FileEntry& e = table.rows[k].entry;
    const bool ofParticles = e.role == Header::ofParticles;
    const std::size_t rows = ofParticles ? StoredMeans::rowsOf(static_cast<ArrayView::Type>(e.type),
                                             static_cast<int>(e.components))
                                         : 0;
    const FileSection& section = table.more[1 + k];
    if (check(section, rows * places * sizeof(float)))
      means->add(arrays_[array].values,
        reinterpret_cast<const float*>(file_->data() + section.offset), places);
    array += ofParticles;
  }
  tree_.storedMeans_ = means;
}

void PkdTreeFile::checkEnds(const std::string& name) const
{
  // Which nodes and buckets there are follows from the number of particles; that a node has fewer
  // than 16 children its bounds say, and only the last node of a level may. So may only the last
  // bucket be short. With these good no other byte leads a ray outside of the file.
  const PkdTree& t = tree_;
  const Vec3d size = t.statistics_.bounds.size() / t.unit_;
  const double extent = std::max({size.x, size.y, size.z});
  std::size_t below = t.buckets();
  for (const PkdTree::Level& level : t.levels_)
  {
    const PkdTree::Node& node = t.nodes_[level.first + level.count - 1];
    const std::size_t children = below - PkdTree::fanout * (level.count - 1);
    for (std::size_t k = 0; k < 3; ++k)
    {
      // Bounds that turn must do so after rounding too: see setBounds() of the builder.
      const double reach = 255.0 * std::exp2(node.exponent[k] - 127.0);
      const auto axis = static_cast<int>(k);
      const double least = (t.statistics_.bounds.lower[axis] - t.origin_[axis]) / t.unit_;
      bool good = std::abs(node.lower[k] - least) <= 4.0 * extent + 1.0 &&
                  reach >= 0x1p-23 * extent && reach <= 4.0 * largestExtent;
      for (std::size_t c = children; c < PkdTree::fanout; ++c)
        good = good && node.low[k][c] == 255 && node.high[k][c] == 0;
      if (!good)
        failDamaged(name, "the end of its tree is not what was written");
    }
    below = level.count;
  }
  const PkdTree::Row* last = t.bucketOf(t.count_ - 1);
  for (std::size_t i = (t.count_ - 1) % PkdTree::bucketSize + 1; i < PkdTree::bucketSize; ++i)
    for (int k = 0; k < t.placeRows_; ++k)
      if (!std::isnan(std::bit_cast<float>(last[k].words[i])))
        failDamaged(name, "the end of its particles is not what was written");
}

const std::string& PkdTreeFile::name() const
{
  return file_->name();
}

std::uint64_t PkdTreeFile::bytes() const
{
  return file_->size();
}

} // namespace mote
