// SPDX-License-Identifier: MIT
// The nearest bone of every node, and the bones beside it.
#include "deform/correction.hpp"

namespace sinew::deform {
namespace {

constexpr double kLeastSquaredCells = 1e-4;  // of a distance, cells

class NodeDistances {
 public:
  NodeDistances(DeformRest* rest, double* squares, uint8_t* weighted)
      : rest_(*rest), squares_(squares), weighted_(weighted) {}

  void run() {
    for (uint32_t j = 0; j < rest_.joint_count; ++j) weighted_[j] = 0;
    const size_t values = static_cast<size_t>(rest_.vertex_count) * rest_.influence_count;
    for (size_t i = 0; i < values; ++i) {
      if (rest_.weights[i] != 0) weighted_[rest_.joints[i]] = 1;
    }
    for (uint32_t n = 0; n < rest_.lattice.node_count; ++n) weigh(n);
  }

 private:
  // A joint's bones lead to its children; a leaf has a stub.
  void measure(Vec3d p) {
    const double per_cell = 1 / (rest_.unit * kCellUnits);
    for (uint32_t j = 0; j < rest_.joint_count; ++j) {
      const RestJoint& joint = rest_.skeleton[j];
      const double stub = joint.child_count == 0 ? joint.bone_length : 0;
      const Vec3d from = per_cell * (p - joint.position);
      squares_[j] = square_to_segment(from, {0, 0, 0}, (per_cell * stub) * joint.to_children);
    }
    for (uint32_t j = 0; j < rest_.joint_count; ++j) {
      const int32_t parent = rest_.skeleton[j].parent;
      if (parent < 0) continue;
      const Vec3d head = rest_.skeleton[parent].position;
      squares_[parent] = lesser(squares_[parent], square_to_segment(per_cell * (p - head), {0, 0, 0},
                                                                    per_cell * (rest_.skeleton[j].position - head)));
    }
  }

  // The nearest joint above that has weight, -1 for none.
  int32_t above(uint32_t j) const {
    int32_t parent = rest_.skeleton[j].parent;
    while (parent >= 0 && weighted_[parent] == 0) parent = rest_.skeleton[parent].parent;
    return parent;
  }

  // The largest first, the lower joint first where two are equal.
  void weigh(uint32_t n) {
    measure(rest_.node_position(n));
    uint32_t nearest = rest_.joint_count;
    for (uint32_t j = 0; j < rest_.joint_count; ++j) {
      if (weighted_[j] != 0 && (nearest == rest_.joint_count || squares_[j] < squares_[nearest])) nearest = j;
    }
    if (nearest == rest_.joint_count) return;
    const int32_t over = above(nearest);
    WeightRow row = {};
    double shares[kNodeSlots], sum = 0;
    uint32_t used = 0;
    for (uint32_t j = 0; j < rest_.joint_count; ++j) {
      const bool beside = j == nearest || static_cast<int32_t>(j) == over || above(j) == static_cast<int32_t>(nearest);
      if (weighted_[j] == 0 || !beside) continue;
      const double share = greater(squares_[nearest], kLeastSquaredCells) / greater(squares_[j], kLeastSquaredCells);
      uint32_t at = used < kNodeSlots ? used++ : kNodeSlots;
      for (; at > 0 && shares[at - 1] < share; --at) {
        if (at == kNodeSlots) continue;
        shares[at] = shares[at - 1];
        row.joints[at] = row.joints[at - 1];
      }
      if (at == kNodeSlots) continue;
      shares[at] = share;
      row.joints[at] = static_cast<uint16_t>(j);
    }
    for (uint32_t i = 0; i < used; ++i) sum += shares[i];
    int32_t left = 65535;
    for (uint32_t i = 0; i < used; ++i) {
      row.weights[i] = static_cast<uint16_t>(65535 * shares[i] / sum);
      if (row.weights[i] == 0) row.joints[i] = 0;
      left -= row.weights[i];
    }
    row.weights[0] = static_cast<uint16_t>(row.weights[0] + left);
    rest_.lattice.rows[n] = row;
  }

  DeformRest& rest_;
  double* const squares_;    // [J] from the node to a joint's bones, cells
  uint8_t* const weighted_;  // [J] 1: the skin has weight of it
};

}  // namespace

sinew_status weigh_nodes_by_distance(Arena& arena, DeformRest* rest) {
  const ArenaScope scope(arena);
  double* const squares = arena.alloc<double>(rest->joint_count);
  uint8_t* const weighted = arena.alloc<uint8_t>(rest->joint_count);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring()) NodeDistances(rest, squares, weighted).run();
  return SINEW_OK;
}

}  // namespace sinew::deform
