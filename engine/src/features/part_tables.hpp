// SPDX-License-Identifier: MIT
// Features of each joint for one part as a whole: the part's heat, its host's, subtrees, boxes; and the channels that
// all of its vertices share.
#ifndef SINEW_FEATURES_PART_TABLES_HPP
#define SINEW_FEATURES_PART_TABLES_HPP

#include "features/channel_values.hpp"
#include "features/parts.hpp"

namespace sinew::features {

constexpr uint32_t kSmallPart = 256;  // vertices: parts below it are a lane's work each, larger ones all lanes'

// Features of each joint for one part, refilled part by part. One per lane lies in the workspace, whose size must not
// depend on the host's pointers: aligned to a multiple that both kinds fill.
struct alignas(64) PartTables {
  int64_t* own = nullptr;      // [J] sum of rule weights over the part's vertices, Q15
  int64_t* subtree = nullptr;  // [J] the same summed over the joint's subtree
  int64_t* host = nullptr;     // [J] sum of rule weights over the host vertices
  int64_t* host_subtree = nullptr;
  uint8_t* in_box = nullptr;   // [J]
  uint8_t* topmost = nullptr;  // [J] in the box, and no ancestor is
  uint8_t* covered = nullptr;  // [J] in the box or below one that is
  uint8_t* deepest = nullptr;  // [J] subtree holds 90 % of the part, no child's does
  int16_t* pair = nullptr;     // [J x kPartChannels] channels of a pair that all vertices of the part share
  uint8_t* paired = nullptr;   // [J] whether it was written
  int16_t* vertex = nullptr;   // [kVertexFeatureCount] channels of a vertex that all of the part share, the others 0
  int64_t host_total = 0;
  uint16_t own_top = kNoJoint, host_top = kNoJoint, box_top = kNoJoint;
  Vec3i center = {0, 0, 0};
  int32_t extent = 1, thickness = 1;
  uint32_t contact = 0;  // mean distance of the closest quarter to the host

  bool allocate(Arena& arena, uint32_t joints) {
    own = arena.alloc<int64_t>(joints);
    subtree = arena.alloc<int64_t>(joints);
    host = arena.alloc<int64_t>(joints);
    host_subtree = arena.alloc<int64_t>(joints);
    in_box = arena.alloc<uint8_t>(joints);
    topmost = arena.alloc<uint8_t>(joints);
    covered = arena.alloc<uint8_t>(joints);
    deepest = arena.alloc<uint8_t>(joints);
    pair = arena.alloc<int16_t>(static_cast<size_t>(joints) * kPartChannels);
    paired = arena.alloc<uint8_t>(joints);
    vertex = arena.alloc<int16_t>(kVertexFeatureCount);
    return arena.ok();
  }
};

static_assert(sizeof(PartTables) == 128, "the workspace would have another size on this host");

// Fills one part's tables. `keys` has room for the part's vertices.
class PartTableBuilder {
 public:
  PartTableBuilder(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates, const HeatFields& heat,
                   const Parts& parts, PartTables& tables, uint64_t* keys)
      : mesh_(mesh),
        skeleton_(skeleton),
        candidates_(candidates),
        heat_(heat),
        parts_(parts),
        t_(tables),
        keys_(keys) {}

  void fill(uint32_t c);
  // The channels from kFirstPartChannel on of a pair of joint j and the filled part c. Written when the part's first vertex
  // with this candidate asks; before its vertices where many lanes ask.
  const int16_t* channels(uint32_t j, uint32_t c) {
    if (t_.paired[j] == 0) make_channels(j, c);
    return t_.pair + static_cast<size_t>(j) * kPartChannels;
  }

 private:
  uint16_t argmax(const int64_t* table) const;
  void add_rule_row(uint32_t vertex, int64_t* table);
  void sum_subtrees(const int64_t* own, int64_t* subtree) const;
  void sum_rule_rows(uint32_t c);
  void find_box(uint32_t c);
  void mark_joints(uint32_t c);
  void write_part_row(uint32_t c);
  void make_channels(uint32_t j, uint32_t c);

  const Mesh& mesh_;
  const Skeleton& skeleton_;
  const Candidates& candidates_;
  const HeatFields& heat_;
  const Parts& parts_;
  PartTables& t_;
  uint64_t* keys_;
};

}  // namespace sinew::features
#endif
