// SPDX-License-Identifier: MIT
// Heat sources (stage 4): for every vertex the nearest bones, whether they are visible, and how strongly they pull.
#ifndef SINEW_HEAT_SOURCES_HPP
#define SINEW_HEAT_SOURCES_HPP

#include "heat/heat.hpp"
#include "heat/visibility.hpp"

namespace sinew {

constexpr uint32_t kMaxTies =
    8;  // bones within 1e-4 of the nearest distance; more than that are left out, highest joint first
constexpr int kDistanceBits = 6;        // distances are grid units Q6
constexpr int64_t kMinDistance = 3355;  // 5e-5 of the side

// Nearest bone of each vertex, for two metrics: 0 = Euclid / (0.5 (cos + 1.001)), which the rule and the parts field
// use, and 1 = Euclid, which the soft field uses.
struct HeatSources {
  uint16_t* ties[2] = {};           // [U x kMaxTies] joints tied for nearest, ascending; unused = kNoJoint
  int64_t* distance[2] = {};        // [U] their distance, Q6 grid units
  uint16_t* nearest[2] = {};        // [U] joint of the smallest distance, visible or not
  uint8_t* mask[kFieldCount] = {};  // [U] bit t: ties[t] is a source of this field; 0 = the vertex is no source
  uint8_t* part_rule = nullptr;     // [part_count] 0 merged, 1 parts, 2 open

  bool allocate(Arena& arena, const Counts& counts);
  // The same, with nearest, mask and part_rule where the fields have nearest (of rule and soft), has_source and
  // part_rule.
  bool allocate_beside(Arena& arena, const Counts& counts, const HeatFields& fields);
  static int metric_of(uint32_t field) { return field == kFieldSoft ? 1 : 0; }
};

// Fills everything from the bones of source_joints [J]. For the soft field `ties` are the nearest visible bones where
// there is one. The same bytes with every `boxes_met`. Progress is reported from 0 to `permille_end`. Returns SINEW_OK,
// SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status find_sources(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints,
                          const Counts& counts, BoxKernel boxes_met, const Progress& progress, uint32_t permille_end,
                          Arena& arena, HeatSources* sources);

// A p H of one source bone: factor * area / d^2 with d at least kMinDistance; the factor is 4, or 0.7 for the soft
// field. Q40, 1 .. 2^62. The diagonal gets this once per tied bone (H = factor n / d^2 and p = 1 / n).
int64_t source_pull_q40(uint64_t area, int64_t distance, uint32_t field);

}  // namespace sinew
#endif
