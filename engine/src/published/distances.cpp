// SPDX-License-Identifier: MIT
// The nearest bone of every vertex, and the bones beside it.
#include "core/build.hpp"
#include "core/vec3d.hpp"
#include "heat/heat.hpp"

namespace sinew {
namespace {

constexpr uint32_t kPiece = 256;            // vertices that a thread takes at once
constexpr int32_t kLeastWeight = 8;         // 2^-12, as in all fields
constexpr double kLeastSquaredUnits = 1.0;  // of a distance, grid units

class DistanceWeights {
 public:
  DistanceWeights(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* sources, int32_t* above, HeatField* field)
      : mesh_(mesh), skeleton_(skeleton), sources_(sources), above_(above), field_(*field) {}

  void run(const Threads& threads) {
    for (uint32_t i = 0; i < skeleton_.joint_count; ++i) {  // parents first
      const uint32_t j = skeleton_.order[i];
      const int32_t parent = skeleton_.parents[j];
      above_[j] = parent < 0 || sources_[parent] != 0 ? parent : above_[parent];
    }
    threads.ranges(mesh_.welded_count, kPiece, [this](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t u = begin; u < end; ++u) weigh(u);
    });
  }

 private:
  double square_to(Vec3d p, uint32_t joint) const {
    const Vec3d head = to_double(skeleton_.positions[joint]), along = to_double(skeleton_.bone_tail[joint]) - head;
    const double whole = dot(along, along);
    const double share = whole > 0 ? clamped(dot(p - head, along) / whole, 0, 1) : 0;
    const Vec3d off = p - (head + share * along);
    return greater(dot(off, off), kLeastSquaredUnits);
  }

  void weigh(uint32_t u) {
    const Vec3d p = to_double(mesh_.positions[u]);
    uint32_t nearest = skeleton_.joint_count;
    double least = 0;
    for (uint32_t j = 0; j < skeleton_.joint_count; ++j) {
      if (sources_[j] == 0) continue;
      const double square = square_to(p, j);
      if (nearest != skeleton_.joint_count && square >= least) continue;
      nearest = j;
      least = square;
    }
    // The largest first, the lower joint first where two are equal.
    double shares[kHeatSlots], sum = 0;
    uint16_t* const joints = field_.joints + static_cast<size_t>(u) * kHeatSlots;
    uint16_t* const weights = field_.weights + static_cast<size_t>(u) * kHeatSlots;
    uint32_t used = 0;
    for (uint32_t j = 0; j < skeleton_.joint_count; ++j) {
      const bool beside =
          j == nearest || static_cast<int32_t>(j) == above_[nearest] || above_[j] == static_cast<int32_t>(nearest);
      if (sources_[j] == 0 || !beside) continue;
      const double share = least / square_to(p, j);
      uint32_t at = used < kHeatSlots ? used++ : kHeatSlots;
      for (; at > 0 && shares[at - 1] < share; --at) {
        if (at == kHeatSlots) continue;
        shares[at] = shares[at - 1];
        joints[at] = joints[at - 1];
      }
      if (at == kHeatSlots) continue;
      shares[at] = share;
      joints[at] = static_cast<uint16_t>(j);
    }
    for (uint32_t i = 0; i < used; ++i) sum += shares[i];
    int32_t rest = 32768;
    for (uint32_t i = 0; i < kHeatSlots; ++i) {
      const int32_t weight = i < used ? static_cast<int32_t>(32768 * shares[i] / sum) : 0;
      weights[i] = static_cast<uint16_t>(weight < kLeastWeight ? 0 : weight);
      if (weights[i] == 0) joints[i] = kNoJoint;
      rest -= weights[i];
    }
    weights[0] = static_cast<uint16_t>(weights[0] + rest);
    field_.nearest[u] = static_cast<uint16_t>(nearest);
    field_.has_source[u] = 1;
  }

  const Mesh& mesh_;
  const Skeleton& skeleton_;
  const uint8_t* const sources_;
  int32_t* const above_;  // [J] the nearest joint above that may have weight
  HeatField& field_;
};

}  // namespace

bool has_published_methods() { return true; }

sinew_status weigh_by_distance(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints,
                               const Counts& counts, Arena& arena, HeatFields* fields) {
  const ArenaScope scope(arena);
  int32_t* const above = arena.alloc<int32_t>(counts.joints);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  DistanceWeights(mesh, skeleton, source_joints, above, &fields->field[kFieldRule]).run(counts.threads);
  return SINEW_OK;
}

}  // namespace sinew
