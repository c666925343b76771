// SPDX-License-Identifier: MIT
// The published correction: linear blending of the mesh and of its tetrahedra, stretch, energy, volume and contact by extended
// position-based dynamics, the barycentric map back and smoothing of the bends. In doubles of one order of operations.
#include "deform/contact_displacements.hpp"
#include "deform/correction.hpp"
#include "deform/half_spaces.hpp"
#include "deform/pins.hpp"
#include "deform/solver.hpp"
#include "published/bend_smoothing.hpp"
#include "published/xpbd_solver.hpp"

namespace sinew::deform {
namespace {

class PublishedPose {
 public:
  PublishedPose(const PosedJoints& posed, Vec3d* positions, PoseCounts* counts)
      : posed_(posed),
        rest_(*posed.rest),
        lattice_(rest_.lattice),
        positions_(positions),
        counts_(*counts),
        cell_(rest_.unit * kCellUnits) {}

  sinew_status run(Arena& arena) {
    const ArenaScope scope(arena);
    spaces_ = arena.alloc<HalfSpace>(rest_.vertex_count);
    BendPlane* const planes = arena.alloc<BendPlane>(rest_.joint_count);
    begin_ = arena.alloc<Vec3d>(lattice_.node_count);
    SmoothedVertex* const smoothed = arena.alloc<SmoothedVertex>(rest_.welded_count);
    moved_ = arena.alloc<uint8_t>(rest_.welded_count);
    BendVolume* const volumes = arena.alloc<BendVolume>(rest_.joint_count);
    if (!state_.allocate(arena, lattice_, rest_.welded_count)) return SINEW_ERROR_WORKSPACE;
    if (as_drawn()) held_ = arena.alloc<HalfSpace>(rest_.welded_count);
    if (rest_.has_contact()) {
      contact_nodes_ = arena.alloc<SolverNode>(lattice_.node_count);
      if (!(contacts_.allocate(arena, rest_.vertex_count) && pressed_.allocate(arena, lattice_))) {
        return SINEW_ERROR_WORKSPACE;
      }
    }
    if (arena.measuring()) return SINEW_OK;
    skin();
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) spaces_[v] = {{0, 0, 0}, 0};
    if (lattice_.tetrahedron_count == 0 || !bends(posed_)) return SINEW_OK;
    if ((rest_.options.without & SINEW_WITHOUT_CONTACTS) == 0)
      find_half_spaces(posed_, rest_.threads(), planes, spaces_);
    skin_nodes();
    find_moving();
    correct();
    const bool smooths = (rest_.options.without & SINEW_WITHOUT_SMOOTHING) == 0;
    if (as_drawn()) {
      collide();
    } else if (rest_.has_contact()) {
      keep_apart();  // while the surface is where the lattice has it
    }
    if (smooths) smooth_bends(posed_, moved_, smoothed, volumes, positions_);
    if (as_drawn()) return SINEW_OK;
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      if (is_rigid(v)) continue;
      positions_[v] = positions_[v] - outside_by(spaces_[v], positions_[v]) * spaces_[v].normal;
    }
    return SINEW_OK;
  }

 private:
  bool as_drawn() const { return rest_.options.as_drawn != 0; }

  void skin() {
    const uint32_t n = rest_.influence_count;
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      const size_t at = static_cast<size_t>(v) * n;
      positions_[v] = blend_linear(posed_, rest_.joints + at, rest_.weights + at, n, rest_.position(v));
    }
  }

  bool is_rigid(uint32_t v) const { return rest_.rigid[rest_.welded[v]] != 0; }

  // Cells around the first vertex, wherever the character is.
  void skin_nodes() {
    middle_ = positions_[0];
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      const WeightRow& row = lattice_.rows[n];
      const Vec3d p = blend_linear(posed_, row.joints, row.weights, kNodeSlots, rest_.node_position(n));
      begin_[n] = (1 / cell_) * (p - middle_);
      state_.nodes[n] = begin_[n];
    }
  }

  // Nodes near strained ones. Pinned are those of one joint that lie at its bone, and those around which all has one joint.
  void find_moving() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) state_.moves[n] = is_strained(posed_, lattice_.rows[n]) ? 1 : 0;
    grow_nodes(lattice_, 1, kRingsAroundStrain, state_.moves);
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      const uint8_t flags = rest_.node_flags[n];
      const bool blended = (flags & kNodeAtBone) != 0 && lattice_.rows[n].weights[0] < kRigidWeight;
      if ((flags & kNodeFree) == 0 && !blended) state_.moves[n] = 0;
    }
  }

  void correct() {
    list_xpbd_constraints(lattice_, &state_);
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      const HalfSpace& half = spaces_[rest_.first[u]];
      if (!half.set() || lattice_.vertices[u].tetrahedron == kNoTetrahedron) continue;
      const double offset = (1 / cell_) * (half.offset - dot(half.normal, middle_));
      add_xpbd_point(lattice_, u, {half.normal, offset}, &state_);
    }
    solve();
  }

  void solve() {
    XpbdSettings settings;
    settings.rounds = rest_.options.round_count;
    settings.edge_compliance = rest_.options.softness / 256.0;
    settings.spring_compliance = 1000.0 / rest_.options.energy;
    solve_xpbd(lattice_, settings, &state_);
    counts_.active_tetrahedra = state_.tetrahedron_count;
    counts_.inverted_tetrahedra = count_inverted_xpbd(lattice_, state_);
    map_back();
  }

  // Where all is pinned a vertex keeps its skinned position exactly; where all moves it goes with the lattice.
  void map_back() {
    for (uint32_t u = 0; u < rest_.welded_count; ++u) moved_[u] = 0;
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      const Embedding& position = lattice_.vertices[rest_.welded[v]];
      if (position.tetrahedron == kNoTetrahedron || is_rigid(v)) continue;
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
      double moving = 0;
      Vec3d own = {0, 0, 0};
      for (int k = 0; k < 4; ++k) {
        own = own + share_of(position, k) * rest_.node_position(at[k]);
        if (state_.moves[at[k]] != 0) moving += share_of(position, k);
      }
      if (!(moving > 0)) continue;
      moved_[rest_.welded[v]] = 1;
      const Vec3d start = middle_ + cell_ * embedded(lattice_, position, begin_);
      const Vec3d end = middle_ + cell_ * embedded(lattice_, position, state_.nodes);
      const Vec3d off = own - rest_.position(v);
      positions_[v] = positions_[v] + ((end - start) + moving * ((start - positions_[v]) - off));
    }
  }

  void find_contact_nodes() {
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      contact_nodes_[n].position = to_units(static_cast<double>(kCellUnits) * state_.nodes[n]);
      contact_nodes_[n].moves = state_.moves[n] != 0 ? -1 : 0;
    }
  }

  // As drawn, parts of the body that are no neighbors: what touches gets a half space, and the solver goes on from where it was.
  void collide() {
    const uint32_t bends = state_.point_count;
    for (uint32_t u = 0; u < rest_.welded_count; ++u) held_[u] = {{0, 0, 0}, 0};
    for (int pass = 0; pass < kContactPasses; ++pass) {
      find_contact_nodes();
      if (!find_contacts({posed_, spaces_, positions_, contact_nodes_, middle_}, &contacts_)) return;
      state_.point_count = bends;
      for (uint32_t u = 0; u < rest_.welded_count; ++u) {
        const Embedding& position = lattice_.vertices[u];
        if (spaces_[rest_.first[u]].set() || position.tetrahedron == kNoTetrahedron) continue;
        if (contacts_.pushes[u] > 0) {
          const Vec3d out = contacts_.directions[u];
          held_[u] = {out, dot(out, embedded(lattice_, position, state_.nodes)) + contacts_.pushes[u] / kCellUnits};
        }
        if (held_[u].set()) add_xpbd_point(lattice_, u, held_[u], &state_);
      }
      skin();
      solve();
    }
  }

  // Parts of the body that are no neighbors.
  void keep_apart() {
    find_contact_nodes();
    for (int pass = 0; pass < kContactPasses; ++pass) {
      if (!find_contacts({posed_, spaces_, positions_, contact_nodes_, middle_}, &contacts_)) return;
      press_contacts(rest_, contacts_, &pressed_);
      for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
        if (!is_rigid(v)) positions_[v] = positions_[v] + contact_push(rest_, pressed_, v);
      }
      for (uint32_t n = 0; n < lattice_.node_count; ++n) {
        contact_nodes_[n].position = contact_nodes_[n].position + to_units(pressed_.displacements[n]);
      }
    }
  }

  const PosedJoints& posed_;
  const DeformRest& rest_;
  const Lattice& lattice_;
  Vec3d* const positions_;
  PoseCounts& counts_;
  const double cell_;  // the caller's units
  XpbdState state_;
  ContactState contacts_;
  ContactDisplacements pressed_;
  SolverNode* contact_nodes_ = nullptr;  // [n] lattice units
  uint8_t* moved_ = nullptr;             // [U] 1: a vertex that goes with the lattice
  HalfSpace* spaces_ = nullptr;          // [V] of bends
  HalfSpace* held_ = nullptr;            // [U] of what touches, in cells; as drawn
  Vec3d* begin_ = nullptr;               // [n] blended nodes, cells
  Vec3d middle_ = {0, 0, 0};
};

}  // namespace

sinew_status pose_published(const PosedJoints& posed, Arena& arena, Vec3d* positions, PoseCounts* counts) {
  return PublishedPose(posed, positions, counts).run(arena);
}

}  // namespace sinew::deform
