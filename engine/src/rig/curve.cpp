// SPDX-License-Identifier: MIT
// Bands of path lengths through a body, their regions as a tree, joints along its branches.
#include "core/sort.hpp"
#include "core/union_find.hpp"
#include "core/vector_math.hpp"
#include "rig/folded_tree.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kMaxRegions = 4096;
constexpr uint32_t kBand = 3 * kDistanceUnits;         // three cells
constexpr uint32_t kLeastBranch = 4 * kDistanceUnits;  // shorter ones are bumps
constexpr int32_t kBend = side_share(250);             // how far a bone may lie from the line
constexpr int32_t kLongest = side_share(2500);         // bone
constexpr int32_t kLeastBone = side_share(300);        // to a bone end
constexpr uint32_t kMostNodes = kMaxFoldedJoints - 8;  // no more than can be read

struct CellRegion {
  Vec3l sum = {0, 0, 0};  // of its cells' centers
  uint32_t count = 0;
  uint32_t first = kNoIndex;  // its first cell on the path
  uint32_t parent = kNoIndex;
  uint16_t begin = kNoDistance, end = 0;  // path lengths of its first and last cell
  uint16_t far = 0;                       // of the last cell that is reached through it
  bool on_plane = false, kept = false;
  uint8_t branches = 0;  // number of kept child regions
  int16_t node = -1;     // of the tree, where it became one

  Vec3i middle() const { return round_div(sum, count); }
};

class Curve {
 public:
  Curve(const Interior& interior, bool folded, uint32_t* label, CellRegion* regions, uint16_t* order, FoldedTree* tree)
      : interior_(interior),
        grid_(interior.grid),
        folded_(folded),
        label_(label),
        regions_(regions),
        order_(order),
        tree_(*tree) {}

  SINEW_RARE void run() {
    join_cells();
    number_regions();
    if (count_ == 0) return put_root({0, 0, 0});
    for (uint32_t i = 0; i < count_; ++i) order_[i] = static_cast<uint16_t>(i);
    heap_sort(order_, count_, [&](uint16_t a, uint16_t b) { return comes_before(a, b); });
    for (uint32_t i = 1; i < count_; ++i) hang(order_[i]);
    for (uint32_t limit = kLeastBranch;; limit += limit / 2) {
      prune(limit);
      if (build()) return;
    }
  }

 private:
  bool used(uint32_t cell) const {
    return interior_.depth[cell] != 0 && interior_.distance[cell] != kNoDistance &&
           (!folded_ || grid_.center(cell).x >= 0);
  }
  uint32_t band(uint32_t cell) const { return interior_.distance[cell] / kBand; }
  bool comes_before(uint32_t a, uint32_t b) const {
    if (regions_[a].begin != regions_[b].begin) return regions_[a].begin < regions_[b].begin;
    return a < b;
  }

  SINEW_RARE void join_cells() {
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      label_[c] = used(c) ? c : kNoIndex;
      if (label_[c] == kNoIndex) continue;
      grid_.each_neighbor(c, [&](uint32_t other) {
        if (other > c || label_[other] == kNoIndex || band(other) != band(c)) return;
        join_sets(label_, other, c);
      });
    }
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      if (label_[c] != kNoIndex) label_[c] = find_root(label_, c);
    }
  }

  // From cells to numbers: a region's first cell holds its number, marked by what no cell is.
  SINEW_RARE void number_regions() {
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      const uint32_t root = label_[c];
      if (root == kNoIndex) continue;
      if (root == c) {
        if (count_ == kMaxRegions) {
          label_[c] = kNoIndex;
          continue;
        }
        regions_[count_] = CellRegion();
        label_[c] = kMark | count_++;
      } else {
        label_[c] = label_[root];  // of a cell before this one
        if (label_[c] == kNoIndex) continue;
      }
      CellRegion& region = regions_[label_[c] & ~kMark];
      const Vec3i center = grid_.center(c);
      region.sum = {region.sum.x + center.x, region.sum.y + center.y, region.sum.z + center.z};
      ++region.count;
      if (interior_.distance[c] < region.begin) {
        region.begin = interior_.distance[c];
        region.first = c;
      }
      if (interior_.distance[c] > region.end) region.end = interior_.distance[c];
      region.on_plane = region.on_plane || (folded_ && center.x <= grid_.cell_size);
    }
  }

  // The parent is the region before its first cell on the path; without one, that of the middle.
  SINEW_RARE void hang(uint32_t number) {
    CellRegion& region = regions_[number];
    region.parent = order_[0];
    for (uint32_t cell = region.first; interior_.distance[cell] != 0;) {
      uint32_t next = cell;
      grid_.each_neighbor(cell, [&](uint32_t other) {
        if (grid_.states[other] != kCellBorder && interior_.distance[other] < interior_.distance[next]) next = other;
      });
      if (next == cell) return;
      cell = next;
      Vec3i at = grid_.center(cell);
      if (folded_ && at.x < 0) at.x = -at.x;
      const uint32_t there = label_[grid_.cell_of(at)];
      if (there == kNoIndex) continue;
      const uint32_t other = there & ~kMark;
      if (other == number || !comes_before(other, number)) continue;
      region.parent = other;
      return;
    }
  }

  // Every region that stays hands its longest branch on, and others that are long enough.
  SINEW_RARE void prune(uint32_t limit) {
    for (uint32_t r = 0; r < count_; ++r) {
      regions_[r].far = regions_[r].end;
      regions_[r].kept = false;
      regions_[r].branches = 0;
      regions_[r].node = -1;
    }
    for (uint32_t i = count_; i-- > 1;) {
      const CellRegion& region = regions_[order_[i]];
      CellRegion& parent = regions_[region.parent];
      if (region.far > parent.far) parent.far = region.far;
    }
    regions_[order_[0]].kept = true;
    for (uint32_t i = 1; i < count_; ++i) {
      CellRegion& region = regions_[order_[i]];
      CellRegion& parent = regions_[region.parent];
      if (!parent.kept || region.far - region.begin < static_cast<int>(limit)) continue;
      region.kept = true;
      if (parent.branches < 255) ++parent.branches;
    }
  }

  Vec3i position(const CellRegion& region, bool beside) const {
    Vec3i at = region.middle();
    if (!folded_) return at;
    if (region.on_plane && !beside) at.x = 0;
    if (beside && at.x < grid_.cell_size) at.x = grid_.cell_size;
    return at;
  }
  SINEW_RARE void put_root(Vec3i at) {
    tree_ = {};
    tree_.mirrored = folded_;
    tree_.count = 1;
    if (folded_) at.x = 0;
    tree_.nodes[0].at = at;
    tree_.nodes[0].joint_class = kClassOther;
    tree_.nodes[0].parent_confidence = 32768;
  }
  // False where the tree is full.
  bool add(Vec3i at, int16_t parent, int16_t* number) {
    if (tree_.count >= kMostNodes) return false;
    FoldedNode& node = tree_.nodes[tree_.count];
    node = FoldedNode();
    node.at = at;
    node.parent = parent;
    node.joint_class = kClassOther;
    *number = static_cast<int16_t>(tree_.count++);
    return true;
  }

  // A node for the root, and for every region where branches meet or end a chain of nodes that leads there.
  SINEW_RARE bool build() {
    put_root(position(regions_[order_[0]], false));
    regions_[order_[0]].node = 0;
    for (uint32_t i = 1; i < count_; ++i) {
      const uint32_t r = order_[i];
      if (regions_[r].kept && regions_[r].branches != 1 && !add_chain(r)) return false;
    }
    return true;
  }

  SINEW_RARE bool add_chain(uint32_t last) {
    uint32_t chain[kMaxChain], length = 0, r = last;
    for (; regions_[r].node < 0; r = regions_[r].parent) {
      if (length < kMaxChain) chain[length++] = r;
    }
    int16_t above = regions_[r].node;
    Vec3i line[kMaxChain + 1];
    line[0] = tree_.nodes[above].at;
    bool beside = tree_.beside(static_cast<uint32_t>(above));
    for (uint32_t i = 0; i < length; ++i) {
      line[i + 1] = position(regions_[chain[length - 1 - i]], beside);
      beside = beside || (folded_ && line[i + 1].x > 0);
    }
    const bool leaf = regions_[last].branches == 0;
    // A branch beside others begins where it leaves them.
    uint32_t from = 0;
    if (length > 1 && regions_[r].branches > 1) {
      if (!add(line[1], above, &above)) return false;
      from = 1;
    }
    while (from < length) {
      const uint32_t to = bend_after(line, from, length);
      const int64_t distance = static_cast<int64_t>(sinew::length(line[to] - line[from]));
      const int64_t pieces = distance / kLongest + 1;
      for (int64_t piece = 1; piece <= pieces; ++piece) {
        const Vec3i step = line[to] - line[from];
        const Vec3i at = line[from] + round_div(Vec3l{step.x * piece, step.y * piece, step.z * piece}, pieces);
        if (to == length && piece == pieces && leaf) {
          if (distance < kLeastBone) return true;
          FoldedNode& node = tree_.nodes[above];
          if (node.has_end) return true;
          node.has_end = true;
          node.end = at;
          return true;
        }
        if (!add(at, above, &above)) return false;
      }
      from = to;
    }
    regions_[last].node = above;
    return true;
  }
  // The last point of a line, or the one before at which it bends most.
  static uint32_t bend_after(const Vec3i* line, uint32_t from, uint32_t last) {
    uint32_t to = last;
    for (;;) {
      int64_t most = square(kBend);
      uint32_t at = to;
      for (uint32_t i = from + 1; i < to; ++i) {
        const int64_t distance = segment_distance_square(line[i], line[from], line[to]);
        if (distance <= most) continue;
        most = distance;
        at = i;
      }
      if (at == to) return to;
      to = at;
    }
  }
  static int64_t segment_distance_square(Vec3i p, Vec3i a, Vec3i b) {
    const Vec3i along = b - a, distance = p - a;
    const int64_t whole = dot(along, along);
    int64_t t = dot(distance, along) / (whole / 1024 + 1);  // Q10
    t = t < 0 ? 0 : t > 1024 ? 1024 : t;
    const Vec3i nearest = {a.x + static_cast<int32_t>(along.x * t / 1024),
                           a.y + static_cast<int32_t>(along.y * t / 1024),
                           a.z + static_cast<int32_t>(along.z * t / 1024)};
    return square_distance(p, nearest);
  }

  static constexpr uint32_t kMark = 0x80000000u;
  static constexpr uint32_t kMaxChain = 256;

  const Interior& interior_;
  const VoxelGrid& grid_;
  const bool folded_;
  uint32_t* const label_;      // [cells] region of a cell, or kNoIndex
  CellRegion* const regions_;  // [kMaxRegions]
  uint16_t* const order_;      // [kMaxRegions] by their first cell's path length
  FoldedTree& tree_;
  uint32_t count_ = 0;
};

}  // namespace

SINEW_RARE sinew_status grow_curve(const Interior& interior, bool folded, Arena& arena, FoldedTree* tree) {
  const ArenaScope scope(arena);
  uint32_t* const label = arena.alloc<uint32_t>(Interior::max_cells());
  CellRegion* const regions = arena.alloc<CellRegion>(kMaxRegions);
  uint16_t* const order = arena.alloc<uint16_t>(kMaxRegions);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  Curve(interior, folded, label, regions, order, tree).run();
  return SINEW_OK;
}

}  // namespace sinew::rigging
