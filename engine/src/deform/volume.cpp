// SPDX-License-Identifier: MIT
// Volume: dual quaternions, then the lattice near bends solved in integers and mapped back.
#include "core/vector_math.hpp"
#include "deform/contact_displacements.hpp"
#include "deform/correction.hpp"
#include "deform/half_spaces.hpp"
#include "deform/pins.hpp"
#include "deform/solver.hpp"

namespace sinew::deform {
namespace {

constexpr int kFadeBits = 14;

class VolumePose {
 public:
  VolumePose(const PosedJoints& posed, Vec3d* positions, PoseCounts* counts)
      : posed_(posed),
        rest_(*posed.rest),
        lattice_(rest_.lattice),
        positions_(positions),
        counts_(*counts),
        threads_(rest_.threads()) {}

  sinew_status run(Arena& arena) {
    const ArenaScope scope(arena);
    spaces_ = arena.alloc<HalfSpace>(rest_.vertex_count);
    BendPlane* const planes = arena.alloc<BendPlane>(rest_.joint_count);
    begin_ = arena.alloc<Vec3i>(lattice_.node_count);
    flags_ = arena.alloc<uint8_t>(lattice_.node_count);
    faded_ = arena.alloc<uint16_t>(2 * static_cast<size_t>(lattice_.node_count));
    if (!state_.allocate(arena, lattice_.node_count, lattice_.tetrahedron_count, lattice_.edge_count,
                         rest_.welded_count) ||
        (rest_.has_contact() &&
         !(contacts_.allocate(arena, rest_.vertex_count) && pressed_.allocate(arena, lattice_)))) {
      return SINEW_ERROR_WORKSPACE;
    }
    if (arena.measuring()) return SINEW_OK;
    skin_vertices();
    if ((rest_.options.without & SINEW_WITHOUT_CONTACTS) == 0) {
      find_half_spaces(posed_, threads_, planes, spaces_);
    } else {
      for (uint32_t v = 0; v < rest_.vertex_count; ++v) spaces_[v] = {{0, 0, 0}, 0};
    }
    if (posed_.overturned) fade();
    const bool solves = lattice_.tetrahedron_count > 0 && bends(posed_);
    if (solves) skin_nodes();
    if (solves && find_moving()) {
      list_constraints(lattice_, &state_);
      if ((rest_.options.without & SINEW_WITHOUT_CONTACTS) == 0) list_points();
      counts_.active_tetrahedra = state_.tetrahedron_count;
      solve(lattice_, rest_.options.round_count, rest_.options.softness, rest_.kernels, threads_, &state_);
      counts_.inverted_tetrahedra = count_inverted(state_);
      map_back();
    }
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      const double outside = outside_by(spaces_[v], positions_[v]);
      if (outside < 0) positions_[v] = positions_[v] - kept(v) * outside * spaces_[v].normal;
    }
    if (solves && rest_.has_contact()) keep_apart();
    return SINEW_OK;
  }

 private:
  bool is_rigid(uint32_t v) const { return lattice_.tetrahedron_count > 0 && rest_.rigid[rest_.welded[v]] != 0; }

  void skin_vertices() {
    const uint32_t n = rest_.influence_count;
    threads_.ranges(rest_.vertex_count, kPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t v = begin; v < end; ++v) {
        const size_t at = static_cast<size_t>(v) * n;
        if (is_rigid(v)) {  // and takes no part of a twist
          positions_[v] = move(posed_.joints[rest_.joints[at]].motion, rest_.position(v));
          continue;
        }
        positions_[v] = blend_dual(posed_, rest_.joints + at, rest_.weights + at, n, rest_.position(v));
      }
    });
  }

  // Parts of the body that are no neighbors, after the pose is solved.
  void keep_apart() {
    for (int pass = 0; pass < kContactPasses; ++pass) {
      if (!find_contacts({posed_, spaces_, positions_, state_.nodes, middle_}, &contacts_)) return;
      press_contacts(rest_, contacts_, &pressed_);
      for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
        positions_[v] = positions_[v] + kept(v) * contact_push(rest_, pressed_, v);
      }
      for (uint32_t n = 0; n < lattice_.node_count; ++n) {
        state_.nodes[n].position = state_.nodes[n].position + to_units(pressed_.displacements[n]);
      }
    }
  }

  // Around overturned joints nothing is corrected: a small motion there would turn the correction over.
  void fade() {
    const uint32_t count = lattice_.node_count;
    uint16_t* const next = faded_ + count;
    for (uint32_t n = 0; n < count; ++n) {
      const WeightRow& row = lattice_.rows[n];
      faded_[n] = static_cast<uint16_t>((1 << kFadeBits) * row_overturn(posed_, row.joints, row.weights, kNodeSlots));
    }
    for (uint32_t ring = 0; ring < kRingsAroundStrain; ++ring) {
      for (uint32_t n = 0; n < count; ++n) next[n] = faded_[n];
      for (uint32_t t = 0; t < lattice_.tetrahedron_count; ++t) {
        const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(t);
        uint16_t most = 0;
        for (int k = 0; k < 4; ++k) most = faded_[at[k]] > most ? faded_[at[k]] : most;
        for (int k = 0; k < 4 && most > 0; ++k) next[at[k]] = most > next[at[k]] ? most : next[at[k]];
      }
      for (uint32_t n = 0; n < count; ++n) faded_[n] = next[n];
    }
  }
  // Share of the correction that a vertex keeps.
  double kept(uint32_t v) const {
    if (is_rigid(v)) return 0;
    const Embedding& position = lattice_.vertices[rest_.welded[v]];
    if (!posed_.overturned || position.tetrahedron == kNoTetrahedron) return 1;
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    int64_t faded = 0;
    for (int k = 0; k < 4; ++k) faded += static_cast<int64_t>(position.shares[k]) * faded_[at[k]];
    return 1 - static_cast<double>(faded) / (1 << (kShareBits + kFadeBits));
  }

  static constexpr uint8_t kStrained = 1, kOutside = 2;

  // Free nodes near strained ones move, and those around vertices on the wrong side of a plane. False if none does.
  bool find_moving() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n)
      flags_[n] = is_strained(posed_, lattice_.rows[n]) ? kStrained : 0;
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      const uint32_t v = rest_.first[u], t = lattice_.vertices[u].tetrahedron;
      if (t == kNoTetrahedron || !(outside_by(spaces_[v], positions_[v]) < 0)) continue;
      for (size_t k = 0; k < 4; ++k) flags_[lattice_.tetrahedra[4 * static_cast<size_t>(t) + k]] |= kOutside;
    }
    grow_nodes(lattice_, kStrained, kRingsAroundStrain, flags_);
    grow_nodes(lattice_, kOutside, 1, flags_);
    bool any = false;
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      const bool free = (rest_.node_flags[n] & kNodeFree) != 0 && (flags_[n] & kStrained) != 0;
      const bool freed = (rest_.node_flags[n] & kNodeAtBone) == 0 && (flags_[n] & kOutside) != 0;
      state_.nodes[n].moves = free || freed ? -1 : 0;
      any = any || free || freed;
    }
    return any;
  }

  // Lattice units around the first vertex, wherever the character is.
  void skin_nodes() {
    middle_ = positions_[0];
    const double per_unit = 1 / rest_.unit;
    threads_.ranges(lattice_.node_count, kPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
      for (uint32_t n = begin; n < end; ++n) {
        const WeightRow& row = lattice_.rows[n];
        const Vec3d p =
            per_unit * (blend_dual(posed_, row.joints, row.weights, kNodeSlots, rest_.node_position(n)) - middle_);
        begin_[n] = to_units(p);
        state_.nodes[n].position = begin_[n];
      }
    });
  }

  void list_points() {
    state_.point_count = 0;
    const double per_unit = 1 / rest_.unit;
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      const HalfSpace& half = spaces_[rest_.first[u]];
      if (!half.set() || lattice_.vertices[u].tetrahedron == kNoTetrahedron) continue;
      const Vec3i normal = to_units(16384.0 * half.normal);
      const int32_t offset = to_units(per_unit * (half.offset - dot(half.normal, middle_)));
      add_point(lattice_, lattice_.vertices[u], normal, offset, &state_);
    }
  }

  // Where all is pinned a vertex keeps its skinned position exactly; where all moves it goes with the lattice, which smooths it.
  // Subtracts the error of the rounded shares at rest.
  void map_back() {
    threads_.ranges(rest_.vertex_count, kPiece, [&](uint32_t begin, uint32_t end, uint32_t) { map_back(begin, end); });
  }
  void map_back(uint32_t first, uint32_t last) {
    for (uint32_t v = first; v < last; ++v) {
      const Embedding& position = lattice_.vertices[rest_.welded[v]];
      if (position.tetrahedron == kNoTetrahedron) continue;
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
      int64_t moved[3] = {0, 0, 0}, start[3] = {0, 0, 0}, own[3] = {0, 0, 0}, moving = 0;
      for (int k = 0; k < 4; ++k) {
        const int64_t share = position.shares[k];
        const Vec3i before = begin_[at[k]], change = state_.nodes[at[k]].position - before,
                    still = lattice_.nodes[at[k]];
        if (state_.nodes[at[k]].moves != 0) moving += share;
        const int32_t changes[3] = {change.x, change.y, change.z}, befores[3] = {before.x, before.y, before.z},
                      stills[3] = {still.x, still.y, still.z};
        for (int axis = 0; axis < 3; ++axis) {
          moved[axis] += share * changes[axis];
          start[axis] += share * befores[axis];
          own[axis] += share * stills[axis];
        }
      }
      if (moving == 0) continue;
      constexpr double kOne = 1.0 / (1 << kShareBits);
      const double keep = kept(v);
      const double unit = rest_.unit * kOne, share = keep * static_cast<double>(moving) * kOne;
      const Vec3d correction =
          keep * unit *
          Vec3d{static_cast<double>(moved[0]), static_cast<double>(moved[1]), static_cast<double>(moved[2])};
      const Vec3d embedded = middle_ + unit * Vec3d{static_cast<double>(start[0]), static_cast<double>(start[1]),
                                                    static_cast<double>(start[2])};
      const Vec3d embedded_at_rest =
          rest_.corner +
          unit * Vec3d{static_cast<double>(own[0]), static_cast<double>(own[1]), static_cast<double>(own[2])};
      const Vec3d off = embedded_at_rest - rest_.position(v);
      positions_[v] = positions_[v] + correction + share * ((embedded - positions_[v]) - off);
    }
  }

  const PosedJoints& posed_;
  const DeformRest& rest_;
  const Lattice& lattice_;
  Vec3d* const positions_;
  PoseCounts& counts_;
  const Threads threads_;
  SolverState state_;
  HalfSpace* spaces_ = nullptr;  // [V] of bends
  ContactState contacts_;
  ContactDisplacements pressed_;
  Vec3i* begin_ = nullptr;
  uint8_t* flags_ = nullptr;
  uint16_t* faded_ = nullptr;  // [2 n] Q14, of overturned joints; the second half is scratch
  Vec3d middle_ = {0, 0, 0};
};

}  // namespace

sinew_status pose_volume(const PosedJoints& posed, Arena& arena, Vec3d* positions, PoseCounts* counts) {
  return VolumePose(posed, positions, counts).run(arena);
}

}  // namespace sinew::deform
