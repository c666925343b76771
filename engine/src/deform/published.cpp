// SPDX-License-Identifier: MIT
// The published correction as drawn: linear blending of the mesh and of its tetrahedra, stretch, energy and volume constraints with
// contact, the barycentric map back and Laplacian smoothing of the bends. In doubles of one order of operations.
#include "deform/correction.hpp"
#include "deform/dual_quaternion.hpp"
#include "deform/half_spaces.hpp"
#include "deform/pins.hpp"
#include "deform/smoothing.hpp"

namespace sinew::deform {
namespace {

constexpr double kEnergy = 0.2;           // stiffness of the springs from the centroid to the corners
constexpr uint16_t kRigidWeight = 64225;  // 0.98: nodes of one joint are pinned
constexpr uint32_t kSmoothRounds = 2;
constexpr uint32_t kRingsAroundStrain = 3;

class PublishedPose {
 public:
  PublishedPose(const PosedJoints& posed, Vec3d* positions, PoseCounts* counts)
      : posed_(posed), rest_(*posed.rest), lattice_(rest_.lattice), positions_(positions), counts_(*counts) {}

  sinew_status run(Arena& arena) {
    const ArenaScope scope(arena);
    spaces_ = arena.alloc<HalfSpace>(rest_.vertex_count);
    BendPlane* const planes = arena.alloc<BendPlane>(rest_.joint_count);
    nodes_ = arena.alloc<Vec3d>(lattice_.node_count);
    moves_ = arena.alloc<uint8_t>(lattice_.node_count);
    Vec3d* const scratch = arena.alloc<Vec3d>(2 * static_cast<size_t>(rest_.welded_count));
    uint8_t* const mask = arena.alloc<uint8_t>(rest_.welded_count);
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    if (arena.measuring()) return SINEW_OK;
    const uint32_t n = rest_.influence_count;
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      const size_t at = static_cast<size_t>(v) * n;
      positions_[v] = blend_linear(posed_, rest_.joints + at, rest_.weights + at, n, rest_.position(v));
      spaces_[v] = {{0, 0, 0}, 0};
    }
    if (lattice_.tetrahedron_count == 0 || !find_moving()) return SINEW_OK;
    if (rest_.options.no_contact == 0) find_half_spaces(posed_, rest_.threads(), planes, spaces_);
    cell_ = rest_.unit * kCellUnits;
    solve();
    map_back(mask);
    if (rest_.options.no_smoothing == 0) smooth_bends(mask, scratch);
    return SINEW_OK;
  }

 private:
  bool find_moving() {
    bool any = false;
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      const WeightRow& row = lattice_.rows[n];
      nodes_[n] = blend_linear(posed_, row.joints, row.weights, kNodeSlots, rest_.node_position(n));
      moves_[n] = is_strained(posed_, row) ? 1 : 0;
      any = any || moves_[n] != 0;
    }
    grow_nodes(lattice_, 1, kRingsAroundStrain, moves_);
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      if (lattice_.rows[n].weights[0] >= kRigidWeight) moves_[n] = 0;
    }
    return any;
  }

  void solve() {
    for (uint32_t t = 0; t < lattice_.tetrahedron_count; ++t) counts_.active_tetrahedra += moving(t) > 0 ? 1u : 0u;
    for (uint32_t round = 0; round < rest_.options.round_count; ++round) {
      for (uint32_t e = 0; e < lattice_.edge_count; ++e) stretch(lattice_.edges[e].a, lattice_.edges[e].b);
      for (uint32_t t = 0; t < lattice_.tetrahedron_count; ++t) {
        if (moving(t) == 0) continue;
        energy(lattice_.tetrahedra + 4 * static_cast<size_t>(t));
        volume(t);
      }
      if (rest_.options.no_contact == 0) {
        for (uint32_t u = 0; u < rest_.welded_count; ++u) contact(u);
      }
    }
    for (uint32_t t = 0; t < lattice_.tetrahedron_count; ++t) {
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(t);
      const Vec3d a = nodes_[at[0]];
      if (moving(t) != 0 && dot(nodes_[at[1]] - a, cross(nodes_[at[2]] - a, nodes_[at[3]] - a)) < 0) {
        ++counts_.inverted_tetrahedra;
      }
    }
  }
  int moving(uint32_t t) const {
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(t);
    return moves_[at[0]] + moves_[at[1]] + moves_[at[2]] + moves_[at[3]];
  }
  double rest_length(uint32_t a, uint32_t b) const {
    return rest_.unit * length(to_double(lattice_.nodes[a] - lattice_.nodes[b]));
  }

  void stretch(uint32_t a, uint32_t b) {
    const double ends = moves_[a] + moves_[b];
    if (!(ends > 0)) return;
    const Vec3d d = nodes_[a] - nodes_[b];
    const double now = length(d);
    if (now < 1e-12 * cell_) return;
    const Vec3d step = ((rest_length(a, b) - now) / (ends * now)) * d;
    if (moves_[a] != 0) nodes_[a] = nodes_[a] + step;
    if (moves_[b] != 0) nodes_[b] = nodes_[b] - step;
  }

  void energy(const uint32_t* at) {
    Vec3d now_middle = {0, 0, 0}, rest_middle = {0, 0, 0};
    for (int k = 0; k < 4; ++k) {
      now_middle = now_middle + 0.25 * nodes_[at[k]];
      rest_middle = rest_middle + 0.25 * to_double(lattice_.nodes[at[k]]);
    }
    Vec3d gradient[4], sum = {0, 0, 0};
    double stored = 0, square = 0;
    for (int k = 0; k < 4; ++k) {
      const Vec3d d = nodes_[at[k]] - now_middle;
      const double now = length(d), off = now - rest_.unit * length(to_double(lattice_.nodes[at[k]]) - rest_middle);
      stored += 0.5 * kEnergy * off * off;
      gradient[k] = now > 1e-12 * cell_ ? (kEnergy * off / now) * d : Vec3d{0, 0, 0};
      sum = sum + gradient[k];
    }
    for (int k = 0; k < 4; ++k) {
      gradient[k] = gradient[k] - 0.25 * sum;
      if (moves_[at[k]] != 0) square += dot(gradient[k], gradient[k]);
    }
    if (square < 1e-18 * cell_ * cell_) return;
    for (int k = 0; k < 4; ++k) {
      if (moves_[at[k]] != 0) nodes_[at[k]] = nodes_[at[k]] - (stored / square) * gradient[k];
    }
  }

  void volume(uint32_t t) {
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(t);
    const Vec3d a = nodes_[at[0]], b = nodes_[at[1]] - a, c = nodes_[at[2]] - a, d = nodes_[at[3]] - a;
    Vec3d gradient[4];  // six times
    gradient[1] = cross(c, d);
    gradient[2] = cross(d, b);
    gradient[3] = cross(b, c);
    gradient[0] = -1.0 * (gradient[1] + gradient[2] + gradient[3]);
    const double cube = cell_ * cell_ * cell_;
    const double off = dot(b, gradient[1]) - (t % 5 == 4 ? 2 * cube : cube);
    double square = 0, largest = 0;
    for (int k = 0; k < 4; ++k) {
      if (moves_[at[k]] == 0) continue;
      const double own = dot(gradient[k], gradient[k]);
      square += own;
      largest = own > largest ? own : largest;
    }
    if (square < 1e-7 * cube * cell_) return;
    double step = -off / square;
    const double moved = (step < 0 ? -step : step) * root(largest);
    if (moved > 0.5 * cell_) step = step * (0.5 * cell_) / moved;
    for (int k = 0; k < 4; ++k) {
      if (moves_[at[k]] != 0) nodes_[at[k]] = nodes_[at[k]] + step * gradient[k];
    }
  }

  void contact(uint32_t u) {
    const HalfSpace& half = spaces_[rest_.first[u]];
    const Embedding& position = lattice_.vertices[u];
    if (!half.set() || position.tetrahedron == kNoTetrahedron) return;
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    double square = 0;
    for (int k = 0; k < 4; ++k) {
      if (moves_[at[k]] != 0) square += share(position, k) * share(position, k);
    }
    const double outside = outside_by(half, embedded(position, nodes_));
    if (!(outside < 0) || square < 0.02) return;
    for (int k = 0; k < 4; ++k) {
      if (moves_[at[k]] != 0) nodes_[at[k]] = nodes_[at[k]] - (outside * share(position, k) / square) * half.normal;
    }
  }
  static double share(const Embedding& position, int k) { return position.shares[k] * (1.0 / (1 << kShareBits)); }
  Vec3d embedded(const Embedding& position, const Vec3d* nodes) const {
    const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
    Vec3d sum = {0, 0, 0};
    for (int k = 0; k < 4; ++k) sum = sum + share(position, k) * nodes[at[k]];
    return sum;
  }

  // Everything embedded goes with the lattice. mask: vertices of which more than half moves.
  void map_back(uint8_t* mask) {
    for (uint32_t u = 0; u < rest_.welded_count; ++u) mask[u] = 0;
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      const uint32_t u = rest_.welded[v];
      const Embedding& position = lattice_.vertices[u];
      if (position.tetrahedron == kNoTetrahedron) continue;
      const uint32_t* const at = lattice_.tetrahedra + 4 * static_cast<size_t>(position.tetrahedron);
      double moving = 0;
      Vec3d own = {0, 0, 0};
      for (int k = 0; k < 4; ++k) {
        own = own + share(position, k) * rest_.node_position(at[k]);
        if (moves_[at[k]] != 0) moving += share(position, k);
      }
      if (!(moving > 0)) continue;
      if (moving > 0.5) mask[u] = 1;
      positions_[v] = rest_.position(v) + (embedded(position, nodes_) - own);
    }
  }

  void smooth_bends(const uint8_t* mask, Vec3d* scratch) {
    Vec3d* const smoothed = scratch + rest_.welded_count;
    for (uint32_t u = 0; u < rest_.welded_count; ++u) smoothed[u] = positions_[rest_.first[u]];
    smooth(rest_, kSmoothRounds, mask, scratch, smoothed);
    for (uint32_t v = 0; v < rest_.vertex_count; ++v) {
      if (mask[rest_.welded[v]] != 0) positions_[v] = smoothed[rest_.welded[v]];
    }
  }

  const PosedJoints& posed_;
  const DeformRest& rest_;
  const Lattice& lattice_;
  Vec3d* const positions_;
  PoseCounts& counts_;
  HalfSpace* spaces_ = nullptr;
  Vec3d* nodes_ = nullptr;
  uint8_t* moves_ = nullptr;
  double cell_ = 0;
};

}  // namespace

sinew_status pose_published(const PosedJoints& posed, Arena& arena, Vec3d* positions, PoseCounts* counts) {
  return PublishedPose(posed, positions, counts).run(arena);
}

}  // namespace sinew::deform
