// SPDX-License-Identifier: MIT
// Farthest points, growth, boxes, contacts, collapse, tree: each over all that the one before left.
#include <string.h>

#include "core/vector_math.hpp"
#include "published/oriented_box.hpp"
#include "rig/published.hpp"
#include "simplify/collapse_cost.hpp"

namespace sinew::rigging {
namespace {

using simplifying::collapse_cost;
using simplifying::EdgesAtNode;

constexpr uint32_t kMostSeeds = 96;
constexpr uint32_t kSamples = 64;               // points of a region that are compared with another's
constexpr int64_t kInContact = kSide / 50;      // points of regions in contact
constexpr double kLeastArea = 0.001;            // of the whole surface
constexpr double kShort = 0.03, kAround = 0.1;  // of the longest side; the second where two share a neighbor
constexpr uint32_t kMostEdges = 5;              // at the neighbor of a leaf that stays

int32_t nearest_integer(double a) { return static_cast<int32_t>(a < 0 ? a - 0.5 : a + 0.5); }

struct Node {
  Vec3d at;
  Vec3d sample;  // middle of the sampled surface
  double area = 0;
  double apart = 0;  // samples' distances over its edges, sides of the grid
  bool alive = true;
  EdgesAtNode edges;
};

class Regions {
 public:
  explicit Regions(const Mesh& mesh) : mesh_(mesh) {}

  bool allocate(Arena& arena, const Counts& counts) {
    label_ = arena.alloc<uint32_t>(counts.vertices);
    distance_ = arena.alloc<uint64_t>(counts.vertices);
    boxes_ = arena.alloc<OrientedBox>(kMostSeeds);
    nodes_ = arena.alloc<Node>(kMostSeeds);
    samples_ = arena.alloc<uint32_t>(size_t{kMostSeeds} * kSamples);
    near_ = arena.alloc<uint8_t>(size_t{kMostSeeds} * kMostSeeds);
    return arena.ok();
  }

  void run(FoldedTree* tree) {
    place_seeds();
    grow();
    build_boxes();
    find_contacts();
    collapse();
    write_tree(tree);
  }

 private:
  // Every next seed is the vertex farthest from all before; the first is farthest from the middle.
  void place_seeds() {
    Vec3l sum = {0, 0, 0};
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      const Vec3i p = mesh_.positions[v];
      sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
    }
    Vec3i from = round_div(sum, mesh_.welded_count);
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) distance_[v] = UINT64_MAX;
    for (count_ = 0; count_ < kMostSeeds; ++count_) {
      uint32_t farthest = 0;
      uint64_t most = 0;
      for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
        const Vec3i d = mesh_.positions[v] - from;
        const uint64_t own = static_cast<uint64_t>(dot(d, d));
        if (count_ == 0 || own < distance_[v]) distance_[v] = own;
        if (distance_[v] > most) {
          most = distance_[v];
          farthest = v;
        }
      }
      if (count_ > 0 && most == 0) break;  // as many as there are positions
      seeds_[count_] = farthest;
      from = mesh_.positions[farthest];
      if (count_ == 0)
        for (uint32_t v = 0; v < mesh_.welded_count; ++v) distance_[v] = UINT64_MAX;
    }
  }

  // Ways over edges from the nearest seed, by sweeps to and fro until nothing changes; a part without a seed goes to the
  // seed that is nearest through the air.
  void grow() {
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      label_[v] = kNoIndex;
      distance_[v] = UINT64_MAX;
    }
    for (uint32_t s = 0; s < count_; ++s) {
      label_[seeds_[s]] = s;
      distance_[seeds_[s]] = 0;
    }
    bool changed = true;
    for (uint32_t sweep = 0; changed; ++sweep) {
      changed = false;
      for (uint32_t i = 0; i < mesh_.welded_count; ++i) {
        const uint32_t v = sweep % 2 == 0 ? i : mesh_.welded_count - 1 - i;
        for (uint32_t e = mesh_.row_offsets[v]; e < mesh_.row_offsets[v + 1]; ++e) {
          const uint32_t u = mesh_.col_indices[e];
          if (label_[u] == kNoIndex) continue;
          const uint64_t distance = distance_[u] + sinew::length(mesh_.positions[u] - mesh_.positions[v]);
          if (distance > distance_[v] || (distance == distance_[v] && label_[u] >= label_[v])) continue;
          distance_[v] = distance;
          label_[v] = label_[u];
          changed = true;
        }
      }
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      if (label_[v] != kNoIndex) continue;
      uint64_t least = UINT64_MAX;
      for (uint32_t s = 0; s < count_; ++s) {
        const Vec3i d = mesh_.positions[v] - mesh_.positions[seeds_[s]];
        if (static_cast<uint64_t>(dot(d, d)) >= least) continue;
        least = static_cast<uint64_t>(dot(d, d));
        label_[v] = s;
      }
    }
  }

  void build_boxes() {
    uint32_t sizes[kMostSeeds] = {}, seen[kMostSeeds] = {};
    for (uint32_t s = 0; s < count_; ++s) {
      boxes_[s] = OrientedBox();
      nodes_[s] = Node();
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      const uint32_t s = label_[v];
      boxes_[s].add(to_double(mesh_.positions[v]));
      nodes_[s].area += static_cast<double>(mesh_.areas[v]);
      whole_ += static_cast<double>(mesh_.areas[v]);
      ++sizes[s];
    }
    for (uint32_t s = 0; s < count_; ++s) boxes_[s].turn();
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      const uint32_t s = label_[v];
      boxes_[s].hold(to_double(mesh_.positions[v]));
      // Sample k is vertex k * size / samples of the region.
      const uint32_t taken = sizes[s] < kSamples ? sizes[s] : kSamples;
      const uint32_t k = static_cast<uint32_t>(uint64_t{seen[s]} * taken / sizes[s]);
      samples_[s * kSamples + k] = v;
      ++seen[s];
    }
    for (uint32_t s = 0; s < count_; ++s) {
      sample_counts_[s] = sizes[s] < kSamples ? sizes[s] : kSamples;
      nodes_[s].at = boxes_[s].middle();
      for (uint32_t k = 0; k < sample_counts_[s]; ++k)
        nodes_[s].sample = nodes_[s].sample + to_double(mesh_.positions[samples_[s * kSamples + k]]);
      if (sample_counts_[s] > 0) nodes_[s].sample = (1.0 / sample_counts_[s]) * nodes_[s].sample;
    }
  }

  void find_contacts() {
    memset(near_, 0, size_t{kMostSeeds} * kMostSeeds);
    for (uint32_t a = 0; a < count_; ++a) {
      for (uint32_t b = 0; b < a; ++b) {
        if (boxes_[a].overlaps(boxes_[b], static_cast<double>(kInContact)) && come_near(a, b)) join(a, b, true);
      }
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {  // what an edge joins is near, however long the edge
      for (uint32_t e = mesh_.row_offsets[v]; e < mesh_.row_offsets[v + 1]; ++e)
        if (label_[v] != label_[mesh_.col_indices[e]]) join(label_[v], label_[mesh_.col_indices[e]], true);
    }
  }
  bool come_near(uint32_t a, uint32_t b) const {
    for (uint32_t i = 0; i < sample_counts_[a]; ++i) {
      for (uint32_t j = 0; j < sample_counts_[b]; ++j) {
        const Vec3i d = mesh_.positions[samples_[a * kSamples + i]] - mesh_.positions[samples_[b * kSamples + j]];
        if (dot(d, d) < kInContact * kInContact) return true;
      }
    }
    return false;
  }

  bool joined(uint32_t a, uint32_t b) const { return near_[a * kMostSeeds + b] != 0; }
  void join(uint32_t a, uint32_t b, bool on) {
    near_[a * kMostSeeds + b] = near_[b * kMostSeeds + a] = on && a != b ? 1 : 0;
  }
  uint32_t edges_at(uint32_t a) const {
    uint32_t count = 0;
    for (uint32_t b = 0; b < count_; ++b) count += joined(a, b) ? 1 : 0;
    return count;
  }
  void measure(uint32_t a) {
    nodes_[a].edges = EdgesAtNode();
    nodes_[a].apart = 0;
    for (uint32_t b = 0; b < count_; ++b) {
      if (!joined(a, b)) continue;
      nodes_[a].edges.add((1.0 / kSide) * (nodes_[b].at - nodes_[a].at));
      nodes_[a].apart += apart(a, b);
    }
  }
  double apart(uint32_t a, uint32_t b) const { return (1.0 / kSide) * length(nodes_[b].sample - nodes_[a].sample); }
  bool share_neighbor(uint32_t a, uint32_t b) const {
    for (uint32_t c = 0; c < count_; ++c) {
      if (joined(a, c) && joined(b, c)) return true;
    }
    return false;
  }
  // Whether the edge from a, which goes, to b may be collapsed.
  bool may_go(uint32_t a, uint32_t b, bool too_many) const {
    const double distance = length(nodes_[a].at - nodes_[b].at);
    if (too_many || distance < kShort * kSide || nodes_[a].area < kLeastArea * whole_) return true;
    return (distance < kAround * kSide && share_neighbor(a, b)) || (edges_at(a) == 1 && edges_at(b) > kMostEdges);
  }

  void collapse() {
    uint32_t left = count_;
    for (uint32_t a = 0; a < count_; ++a) measure(a);
    for (;;) {
      uint32_t from = kNoIndex, to = kNoIndex;
      double least = 0;
      for (uint32_t a = 0; a < count_; ++a) {
        for (uint32_t b = 0; b < count_; ++b) {
          if (!joined(a, b) || !may_go(a, b, left > kMaxFoldedJoints)) continue;
          const double cost =
              collapse_cost(nodes_[a].edges, nodes_[b].edges, (1.0 / kSide) * (nodes_[b].at - nodes_[a].at),
                            apart(a, b), nodes_[a].apart);
          if (from != kNoIndex && cost >= least) continue;
          least = cost;
          from = a;
          to = b;
        }
      }
      if (from == kNoIndex) return;
      merge(from, to);
      --left;
    }
  }
  // Into one node at the middle of both surfaces.
  void merge(uint32_t a, uint32_t b) {
    const double area = nodes_[a].area + nodes_[b].area;
    const double share = area > 0 ? nodes_[a].area / area : 0.5;
    nodes_[b].at = nodes_[b].at + share * (nodes_[a].at - nodes_[b].at);
    nodes_[b].sample = nodes_[b].sample + share * (nodes_[a].sample - nodes_[b].sample);
    nodes_[b].area = area;
    nodes_[a].alive = false;
    for (uint32_t c = 0; c < count_; ++c) {
      if (!joined(a, c)) continue;
      join(a, c, false);
      join(b, c, true);
    }
    measure(b);
    for (uint32_t c = 0; c < count_; ++c) {
      if (joined(b, c)) measure(c);
    }
  }

  // Prim's algorithm over contacts; a part that touches nothing is joined where it comes nearest.
  void write_tree(FoldedTree* tree) const {
    Vec3d middle;
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) middle = middle + to_double(mesh_.positions[v]);
    middle = (1.0 / mesh_.welded_count) * middle;
    uint32_t number[kMostSeeds] = {};
    uint32_t next = kNoIndex, parent = kNoIndex;
    for (uint32_t a = 0; a < count_; ++a) {
      number[a] = kNoIndex;
      if (!nodes_[a].alive) continue;
      if (next == kNoIndex || length(nodes_[a].at - middle) < length(nodes_[next].at - middle)) next = a;
    }
    *tree = {};
    while (next != kNoIndex && tree->count < kMaxFoldedJoints) {
      FoldedNode& node = tree->nodes[tree->count];
      const Vec3d& p = nodes_[next].at;
      node.at = {nearest_integer(p.x), nearest_integer(p.y), nearest_integer(p.z)};
      node.parent = parent == kNoIndex ? -1 : static_cast<int16_t>(number[parent]);
      node.joint_class = kClassOther;
      number[next] = tree->count++;
      double least = 0;
      next = parent = kNoIndex;
      for (uint32_t a = 0; a < count_; ++a) {
        if (!nodes_[a].alive || number[a] == kNoIndex) continue;
        for (uint32_t b = 0; b < count_; ++b) {
          if (!nodes_[b].alive || number[b] != kNoIndex) continue;
          const double distance = length(nodes_[a].at - nodes_[b].at) + (joined(a, b) ? 0 : 4.0 * kSide);
          if (next != kNoIndex && distance >= least) continue;
          least = distance;
          next = b;
          parent = a;
        }
      }
    }
  }

  const Mesh& mesh_;
  uint32_t count_ = 0;            // N regions
  uint32_t* label_ = nullptr;     // [U] region
  uint64_t* distance_ = nullptr;  // [U] from its seed, grid units
  OrientedBox* boxes_ = nullptr;  // [N]
  Node* nodes_ = nullptr;         // [N]
  uint32_t* samples_ = nullptr;   // [N x kSamples] vertices
  uint8_t* near_ = nullptr;       // [N x N] the graph
  double whole_ = 0;              // area
  uint32_t seeds_[kMostSeeds] = {}, sample_counts_[kMostSeeds] = {};
};

}  // namespace

SINEW_RARE sinew_status grow_regions(const Mesh& mesh, const Counts& counts, Arena& arena, FoldedTree* tree) {
  const ArenaScope scope(arena);
  Regions regions(mesh);
  if (!regions.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring()) regions.run(tree);
  return SINEW_OK;
}

}  // namespace sinew::rigging
