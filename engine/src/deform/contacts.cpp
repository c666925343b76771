// SPDX-License-Identifier: MIT
// Posed vertices in posed tetrahedra of other parts of the body.
#include "deform/contacts.hpp"

#include "core/vector_math.hpp"
#include "deform/solver.hpp"

namespace sinew::deform {
namespace {

constexpr double kCell = kCellUnits;
constexpr int32_t kNeighbors =
    3 * kCellUnits / 2;               // joints that follow each other touch only farther apart than this at rest
constexpr double kApart = 3 * kCell;  // and from here on in full
constexpr double kOtherRow = 1,
                 kFarRow = 1.5;  // distance of weights, 0 to 2, from which other joints touch however near they are
constexpr double kLeastFacing = 0.2, kFacing = 0.6;    // negative cosine of the normals of two surfaces that touch
constexpr double kLongestPush = 0.35 * kCell;          // of a vertex
constexpr double kDeep = kCell, kTooDeep = 2 * kCell;  // what lies deeper did not come in by touching
constexpr double kShallow = 0.05 * kCell,
                 kSteep = 0.2 * kCell;            // between these the way out begins to tell its direction
constexpr double kAcross = 0.3, kStraight = 0.8;  // cosine of the direction out and the surface's normal
constexpr double kBorne = 0.08;  // share of a push that neighbors have too, from which it counts in full
constexpr double kLeastYield = 0.05 * (1 << kShareBits);  // of both sides together: bones cannot yield
constexpr int32_t kLongestCells = 6;                      // of a stretched tetrahedron
constexpr double kLeastVolume = 0.1;                      // of a tetrahedron, against its volume at rest
constexpr double kOnePlane = -0.99;                       // cosine of two half spaces of one bend

class ContactFinder {
 public:
  ContactFinder(const ContactInput& input, ContactState* state)
      : input_(input),
        posed_(input.posed),
        rest_(*input.posed.rest),
        lattice_(rest_.lattice),
        surface_(rest_.surface),
        state_(*state) {}

  bool run() {
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      state_.pushes[u] = 0;
      state_.directions[u] = {0, 0, 0};
    }
    sort_vertices();
    for (uint32_t t = 0; t < lattice_.tetrahedron_count; ++t) look_into(t);
    if (found_) finish_pushes();
    return found_;
  }

 private:
  uint32_t bucket_of(Vec3i cell) const {
    const uint32_t hash = static_cast<uint32_t>(cell.x) * 73856093u ^ static_cast<uint32_t>(cell.y) * 19349663u ^
                          static_cast<uint32_t>(cell.z) * 83492791u;
    return (hash * 0x9E3779B1u) >> (32 - state_.bucket_bits);
  }
  static Vec3i cell_of(Vec3i p) { return {p.x >> kCellBits, p.y >> kCellBits, p.z >> kCellBits}; }
  uint32_t joint_of(uint32_t welded) const {
    return rest_.joints[static_cast<size_t>(rest_.first[welded]) * rest_.influence_count];
  }

  // Buckets are filled by counting. Vertices without a triangle are in none.
  void sort_vertices() {
    const uint32_t count = uint32_t{1} << state_.bucket_bits;
    const double per_unit = 1 / rest_.unit;
    for (uint32_t b = 0; b <= count; ++b) state_.offsets[b] = 0;
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      state_.positions[u] = to_units(per_unit * (input_.positions[rest_.first[u]] - input_.middle));
      if (lattice_.vertices[u].tetrahedron == kNoTetrahedron) continue;
      const uint32_t b = bucket_of(cell_of(state_.positions[u]));
      ContactState::Bucket& bucket = state_.buckets[b];
      if (state_.offsets[b]++ == 0) {
        bucket = {surface_.positions[u], surface_.positions[u], joint_of(u)};
      } else {
        grow(surface_.positions[u], &bucket.low, &bucket.high);
        if (bucket.joint != joint_of(u)) bucket.joint = ContactState::kMixed;
      }
    }
    uint32_t total = 0;
    for (uint32_t b = 0; b <= count; ++b) {
      total += state_.offsets[b];
      state_.offsets[b] = total;
    }
    for (uint32_t u = rest_.welded_count; u-- > 0;) {
      if (lattice_.vertices[u].tetrahedron == kNoTetrahedron) continue;
      const uint32_t m = --state_.offsets[bucket_of(cell_of(state_.positions[u]))];
      state_.members[m] = u;
      state_.sorted[m] = state_.positions[u];
    }
  }

  // The same joint, or one is the other's parent or grandparent.
  bool follow(uint32_t a, uint32_t b) const {
    const auto below = [this](uint32_t low, uint32_t high) {
      int32_t j = rest_.skeleton[low].parent;
      for (int step = 0; step < 2 && j >= 0; ++step, j = rest_.skeleton[j].parent) {
        if (j == static_cast<int32_t>(high)) return true;
      }
      return false;
    };
    return a == b || below(a, b) || below(b, a);
  }

  struct Posed {
    uint32_t number;
    const uint32_t* nodes;
    Vec3i low, high, rest_low, rest_high;  // boxes
    Vec3i origin;
    uint32_t joint;      // of its first node
    bool one_joint;      // of all nodes
    bool yields;         // one of its nodes lies at no bone
    Vec3d gradients[3];  // of the last three barycentric coordinates
  };

  // False for one that is rotated over or nearly flat.
  bool measure(Posed* t) const {
    const auto from_origin = [&](int k) { return to_double(input_.nodes[t->nodes[k]].position - t->origin); };
    const Vec3d b = from_origin(1), c = from_origin(2), d = from_origin(3);
    const double volume = dot(b, cross(c, d));
    if (!(volume > kLeastVolume * kCell * static_cast<double>(rest_volume(t->number % 5 == 4 ? kLargeVolume : 0))))
      return false;
    const double inverse = 1 / volume;
    t->gradients[0] = inverse * cross(c, d);
    t->gradients[1] = inverse * cross(d, b);
    t->gradients[2] = inverse * cross(b, c);
    return true;
  }

  void look_into(uint32_t number) {
    Posed t = {};
    t.number = number;
    t.nodes = lattice_.tetrahedra + 4 * static_cast<size_t>(number);
    t.origin = t.low = t.high = input_.nodes[t.nodes[0]].position;
    t.rest_low = t.rest_high = lattice_.nodes[t.nodes[0]];
    t.joint = lattice_.rows[t.nodes[0]].joints[0];
    t.one_joint = true;
    for (int k = 1; k < 4; ++k) {
      grow(input_.nodes[t.nodes[k]].position, &t.low, &t.high);
      grow(lattice_.nodes[t.nodes[k]], &t.rest_low, &t.rest_high);
      t.one_joint = t.one_joint && lattice_.rows[t.nodes[k]].joints[0] == t.joint;
    }
    for (int k = 0; k < 4; ++k) t.yields = t.yields || (rest_.node_flags[t.nodes[k]] & kNodeAtBone) == 0;
    if (extent(t.high - t.low) > kLongestCells * kCellUnits) return;
    const Vec3i first = cell_of(t.low), last = cell_of(t.high);
    bool measured = false;
    for (int32_t z = first.z; z <= last.z; ++z) {
      for (int32_t y = first.y; y <= last.y; ++y) {
        for (int32_t x = first.x; x <= last.x; ++x) {
          const uint32_t b = bucket_of({x, y, z}), begin = state_.offsets[b], end = state_.offsets[b + 1];
          if (begin == end || own_part(state_.buckets[b], t)) continue;
          if (!measured && !measure(&t)) return;
          measured = true;
          for (uint32_t m = begin; m < end; ++m) {
            const Vec3i p = state_.sorted[m];
            if (p.x >= t.low.x && p.y >= t.low.y && p.z >= t.low.z && p.x <= t.high.x && p.y <= t.high.y &&
                p.z <= t.high.z) {
              try_vertex(state_.members[m], t);
            }
          }
        }
      }
    }
  }

  // Whether all vertices of a bucket move with a tetrahedron, or are its neighbors at rest: most are.
  bool own_part(const ContactState::Bucket& bucket, const Posed& t) const {
    if (bucket.joint == ContactState::kMixed) return false;
    if (go_together(bucket.joint, t)) return true;
    return follow(bucket.joint, t.joint) && extent(bucket.high - t.rest_low) < kNeighbors &&
           extent(t.rest_high - bucket.low) < kNeighbors;
  }

  bool go_together(uint32_t joint, const Posed& t) const {
    return t.one_joint && posed_.joints[joint].group == posed_.joints[t.joint].group;
  }

  void try_vertex(uint32_t u, const Posed& t) {
    const Vec3i p = state_.positions[u];
    if (lattice_.vertices[u].tetrahedron / 5 == t.number / 5 || go_together(joint_of(u), t)) return;
    if (!t.yields && surface_.yields[u] == 0) return;
    if (extent(surface_.positions[u] - t.rest_low) < kNeighbors && follow(joint_of(u), t.joint)) return;
    const Vec3d from = to_double(p - t.origin);
    double shares[4] = {1, 0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      shares[k + 1] = dot(t.gradients[k], from);
      shares[0] -= shares[k + 1];
      if (shares[k + 1] < 0) return;
    }
    if (shares[0] < 0) return;
    Vec3d inside = {0, 0, 0};
    uint32_t strongest = 0;
    for (uint32_t k = 0; k < 4; ++k) {
      inside = inside + shares[k] * to_double(lattice_.nodes[t.nodes[k]]);
      if (shares[k] > shares[strongest]) strongest = k;
    }
    const double share = apart(u, t, inside);
    const uint32_t start = surface_.nearest[t.nodes[strongest]];
    if (share > 0 && start < rest_.welded_count) meet(u, share, inside, surface_.find_nearest(start, inside));
  }

  // How much a vertex and where it came to are apart, 0 to 1: far at rest, or of joints that do not follow each other.
  double apart(uint32_t u, const Posed& t, Vec3d inside) const {
    const double by_position = ramp(length(to_double(surface_.positions[u]) - inside), kNeighbors, kApart);
    if (by_position >= 1 || follow(joint_of(u), t.joint)) return by_position;
    const size_t n = rest_.influence_count, row = rest_.first[u] * n;
    double nearest = 2;
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t common = common_weight(lattice_.rows[t.nodes[k]], rest_.joints + row, rest_.weights + row, n);
      nearest = lesser(nearest, 2 - common / 32767.5);
    }
    return greater(by_position, ramp(nearest, kOtherRow, kFarRow));
  }

  Vec3d normal_of(uint32_t u) const {
    Vec3d sum = {0, 0, 0};
    for (uint32_t c = surface_.corner_offsets[u]; c < surface_.corners_end(u); ++c) {
      const uint32_t* const at = surface_.triangles + 3 * static_cast<size_t>(surface_.corner_triangles[c]);
      const Vec3i a = state_.positions[at[0]];
      sum = sum + cross(to_double(state_.positions[at[1]] - a), to_double(state_.positions[at[2]] - a));
    }
    return unit(sum);
  }

  // A vertex and the surface through which it came, at rest `inside` and `point`.
  void meet(uint32_t u, double share, Vec3d inside, const SurfacePoint& point) {
    if (dot(inside - point.position, point.outward) >= 0) return;  // in the lattice, but outside of the skin
    const uint32_t* const at = surface_.triangles + 3 * static_cast<size_t>(point.triangle);
    uint32_t nearest = 0;
    double others = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      if (hold_together(u, at[k])) return;
      if (point.shares[k] > point.shares[nearest]) nearest = k;
      others += point.shares[k] * surface_.yields[at[k]];
    }
    const double own = surface_.yields[u];
    if (own + others < kLeastYield) return;
    if (dot(input_.bends[rest_.first[u]].normal, input_.bends[rest_.first[at[nearest]]].normal) < kOnePlane) return;
    Vec3d out = {0, 0, 0}, on = {0, 0, 0};
    for (uint32_t k = 0; k < 3; ++k) {
      out = out + point.shares[k] * normal_of(at[k]);
      on = on + point.shares[k] * to_double(state_.positions[at[k]]);
    }
    out = unit(out);
    share *= ramp(-dot(out, normal_of(u)), kLeastFacing, kFacing);
    if (share <= 0) return;
    const Vec3d p = to_double(state_.positions[u]), direction = on - p;
    const Vec3d normal = unit(direction + (0.25 * kCell) * out);
    // Vertices inside at rest, such as skin under a shirt, may stay so.
    const Vec3d at_rest = to_double(surface_.positions[u]) - point.position;
    const double rest_depth = dot(at_rest, at_rest) < kApart * kApart ? -dot(at_rest, unit(point.outward)) : 0;
    const double depth = dot(direction, normal) - greater(rest_depth, 0);
    if (depth <= 0) return;
    share *= 1 - ramp(depth, kDeep, kTooDeep);
    const double normal_length = length(direction);
    if (normal_length > kShallow)
      share *= 1 - ramp(normal_length, kShallow, kSteep) *
                       (1 - ramp(dot(direction, out) / normal_length, kAcross, kStraight));
    const double whole = share * lesser(depth, 2 * kLongestPush), own_push = whole * own / (own + others);
    push(u, normal, own_push);
    for (uint32_t k = 0; k < 3; ++k) {
      if (surface_.yields[at[k]] == 0) continue;
      const double nearer = dot(normal, to_double(state_.positions[at[k]]) - on);
      push(at[k], -normal, lesser(whole - own_push + nearer, kLongestPush));
    }
  }

  // Whether two vertices lie in tetrahedra that have a node in common: these cannot part.
  bool hold_together(uint32_t u, uint32_t other) const {
    const uint32_t* const a = lattice_.tetrahedra + 4 * static_cast<size_t>(lattice_.vertices[u].tetrahedron);
    const uint32_t* const b = lattice_.tetrahedra + 4 * static_cast<size_t>(lattice_.vertices[other].tetrahedron);
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) {
        if (a[i] == b[k]) return true;
      }
    }
    return false;
  }

  // Means, less where the neighbors do not touch as well: a lonely one is a mistake more often than a touch.
  void finish_pushes() {
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      if (state_.pushes[u] <= 0) continue;
      const Vec3d direction = (1 / state_.pushes[u]) * state_.directions[u];
      state_.pushes[u] = length(direction);
      state_.directions[u] = unit(direction);
    }
    for (uint32_t u = 0; u < rest_.welded_count; ++u) {
      state_.borne[u] = 0;
      const double own = state_.pushes[u];
      if (own <= 0) continue;
      double sum = 0;
      const uint32_t begin = surface_.corner_offsets[u], end = surface_.corners_end(u);
      for (uint32_t c = begin; c < end; ++c) {
        const uint32_t* const at = surface_.triangles + 3 * static_cast<size_t>(surface_.corner_triangles[c]);
        for (int k = 0; k < 3; ++k) {
          if (at[k] != u) sum += lesser(state_.pushes[at[k]], own);
        }
      }
      state_.borne[u] = own * ramp(sum / (2.0 * (end - begin) * own), 0, kBorne);
    }
    for (uint32_t u = 0; u < rest_.welded_count; ++u) state_.pushes[u] = state_.borne[u];
  }

  // The mean of a vertex's pushes, by their squares: none comes or goes at once. Sums, until all are known.
  void push(uint32_t u, Vec3d direction, double length) {
    if (length <= 0) return;
    state_.pushes[u] += length * length;
    state_.directions[u] = state_.directions[u] + (length * length * length) * direction;
    found_ = true;
  }

  const ContactInput& input_;
  const PosedJoints& posed_;
  const DeformRest& rest_;
  const Lattice& lattice_;
  const SkinSurface& surface_;
  ContactState& state_;
  bool found_ = false;
};

}  // namespace

bool ContactState::allocate(Arena& arena, uint32_t vertices) {
  bucket_bits = 4;
  while (bucket_bits < 24 && (uint32_t{1} << bucket_bits) < vertices) ++bucket_bits;
  const size_t bucket_count = size_t{1} << bucket_bits;
  positions = arena.alloc<Vec3i>(vertices);
  members = arena.alloc<uint32_t>(vertices);
  sorted = arena.alloc<Vec3i>(vertices);
  offsets = arena.alloc<uint32_t>(bucket_count + 1);
  buckets = arena.alloc<Bucket>(bucket_count);
  pushes = arena.alloc<double>(vertices);
  directions = arena.alloc<Vec3d>(vertices);
  borne = arena.alloc<double>(vertices);
  return arena.ok();
}

bool find_contacts(const ContactInput& input, ContactState* state) { return ContactFinder(input, state).run(); }

}  // namespace sinew::deform
