// SPDX-License-Identifier: MIT
// The crop's frame, its triangles, the parts that are the hand, the caps of its holes.
#include "details/hand_crop.hpp"

#include "core/union_find.hpp"
#include "core/vector_math.hpp"
#include "front/mirror_frame.hpp"

namespace sinew::rigging {
namespace {

constexpr int kAxisBits = 28, kFineBits = 8;
// The region that is cut out, percent of the hand's length.
constexpr int64_t kBefore = 20, kBeyond = 140, kAside = 80;
// Parts of the hand come that near to its axis.
constexpr int64_t kCoreBefore = 10, kCoreBeyond = 100, kCoreAside = 30;

Vec3i turned(Vec3i p, uint32_t quarters, bool right) {
  const Vec3i q = MirrorFrame::turn(p, quarters);
  return {right ? -q.x : q.x, q.y, q.z};
}

// The smallest rotation that brings `along` to +x: rows, Q28.
void set_axes(Vec3i along, Vec3i (&axes)[3]) {
  constexpr int32_t kOne = 1 << kAxisBits;
  const Vec3l wide = {along.x, along.y, along.z};
  const Vec3i a = unit_vector(wide, kAxisBits);
  if (a == Vec3i{0, 0, 0} || a.x < -kOne + (kOne >> 10)) {  // none, or straight back: 180 degrees about y
    const int32_t x = a.x < 0 ? -kOne : kOne;
    axes[0] = {x, 0, 0};
    axes[1] = {0, kOne, 0};
    axes[2] = {0, 0, x};
    return;
  }
  const int64_t directions = int64_t{kOne} + a.x;
  const auto part = [&](int32_t u, int32_t v) { return static_cast<int32_t>(round_div(int64_t{u} * v, directions)); };
  axes[0] = a;
  axes[1] = {-a.y, kOne - part(a.y, a.y), -part(a.y, a.z)};
  axes[2] = {-a.z, -part(a.y, a.z), kOne - part(a.z, a.z)};
}

// A loop has three vertices at least, but where triangles have no area.
uint32_t most_loops(uint32_t vertices) { return vertices / 2 + 1; }
struct Loop {
  Vec3l sum;     // of the ends of its edges
  int64_t ends;  // how many
};

struct CropScratch {
  uint8_t* states;    // [V]
  uint32_t* above;    // [V] of each vertex's set
  uint32_t* number;   // [V] in the crop
  uint32_t* loop_of;  // [V] of a set's root
  uint8_t* uses;      // [E2] triangles at an edge, from its lower vertex; 2: two or more
  Loop* loops;        // [most_loops(V)]
};

class Cutter {
 public:
  Cutter(const Mesh& mesh, const HandPosition& position, const CropScratch& scratch, uint32_t most_triangles,
         HandCrop* crop)
      : mesh_(mesh),
        position_(position),
        crop_(*crop),
        states_(scratch.states),
        above_(scratch.above),
        number_(scratch.number),
        loop_of_(scratch.loop_of),
        uses_(scratch.uses),
        loops_(scratch.loops),
        most_triangles_(most_triangles) {}

  SINEW_RARE void run() {
    crop_.surface_vertices = crop_.surface_triangles = 0;
    crop_.mesh.welded_count = crop_.mesh.triangle_count = 0;
    crop_.frame = HandFrame();
    crop_.frame.wrist = position_.wrist;
    crop_.frame.quarters = position_.quarters;
    crop_.frame.right = position_.right;
    set_axes(turned(position_.wrist - position_.elbow, position_.quarters, position_.right), crop_.frame.axes);
    mark_vertices();
    keep_triangles();
    if (crop_.surface_triangles == 0) return;
    place_box();
    close_holes();
  }

 private:
  enum : uint8_t { kOutside = 0, kInRegion = 1, kInCore = 2 };

  void mark_vertices() {
    const int64_t unit = (int64_t{position_.length} << kFineBits);  // 100 percent
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      const Vec3l r = crop_.frame.rotated(mesh_.positions[v]);
      const auto within = [&](int64_t before, int64_t beyond, int64_t aside) {
        return 100 * r.x >= -before * unit && 100 * r.x <= beyond * unit && 100 * abs64(r.y) <= aside * unit &&
               100 * abs64(r.z) <= aside * unit;
      };
      states_[v] = !within(kBefore, kBeyond, kAside)              ? kOutside
                   : within(kCoreBefore, kCoreBeyond, kCoreAside) ? kInCore
                                                                  : kInRegion;
      above_[v] = v;
      number_[v] = kNoIndex;
    }
  }

  bool in_region(const uint32_t* t) const {
    return states_[t[0]] != kOutside && states_[t[1]] != kOutside && states_[t[2]] != kOutside;
  }

  // Triangles of the region whose part has a vertex in the core.
  void keep_triangles() {
    for (uint32_t i = 0; i < mesh_.triangle_count; ++i) {
      const uint32_t* const t = mesh_.triangles + size_t{3} * i;
      if (!in_region(t)) continue;
      join_sets(above_, t[0], t[1]);
      join_sets(above_, t[0], t[2]);
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      if (states_[v] == kInCore)
        states_[find_root(above_, v)] = kInCore;  // roots come first: their own state is not lost
    }
    for (uint32_t i = 0; i < mesh_.triangle_count; ++i) {
      const uint32_t* const t = mesh_.triangles + size_t{3} * i;
      if (!in_region(t) || states_[find_root(above_, t[0])] != kInCore) continue;
      for (int c = 0; c < 3; ++c) number_[t[c]] = 0;
      uint32_t* const kept = crop_.mesh.triangles + size_t{3} * crop_.surface_triangles++;
      for (int c = 0; c < 3; ++c) kept[c] = t[c];
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      if (number_[v] == kNoIndex) continue;
      crop_.source[crop_.surface_vertices] = v;
      number_[v] = crop_.surface_vertices++;
    }
    crop_.mesh.triangle_count = crop_.surface_triangles;
    crop_.mesh.welded_count = crop_.surface_vertices;
  }

  void place_box() {
    Vec3l low = crop_.frame.rotated(mesh_.positions[crop_.source[0]]), high = low;
    for (uint32_t v = 1; v < crop_.surface_vertices; ++v) {
      const Vec3l r = crop_.frame.rotated(mesh_.positions[crop_.source[v]]);
      low = {r.x < low.x ? r.x : low.x, r.y < low.y ? r.y : low.y, r.z < low.z ? r.z : low.z};
      high = {r.x > high.x ? r.x : high.x, r.y > high.y ? r.y : high.y, r.z > high.z ? r.z : high.z};
    }
    const int64_t sides[3] = {high.x - low.x, high.y - low.y, high.z - low.z};
    int64_t side = 1;
    for (const int64_t s : sides) side = s > side ? s : side;
    crop_.frame.zero = {low.x, floor_div(low.y + high.y, 2), floor_div(low.z + high.z, 2)};
    crop_.frame.side = side;
    for (uint32_t v = 0; v < crop_.surface_vertices; ++v)
      crop_.mesh.positions[v] = crop_.frame.to(mesh_.positions[crop_.source[v]]);
  }

  // Where `b` stands among a's neighbors in the whole mesh's one-rings.
  uint32_t edge(uint32_t a, uint32_t b) const {
    uint32_t low = mesh_.row_offsets[a], high = mesh_.row_offsets[a + 1];
    while (low + 1 < high) {
      const uint32_t middle = low + (high - low) / 2;
      (mesh_.col_indices[middle] <= b ? low : high) = middle;
    }
    return low;
  }

  template <class Visit>
  void each_border(Visit visit) {
    for (uint32_t i = 0; i < crop_.surface_triangles; ++i) {
      const uint32_t* const t = crop_.mesh.triangles + size_t{3} * i;
      for (int c = 0; c < 3; ++c) {
        const uint32_t a = t[c], b = t[(c + 1) % 3];
        if (uses_[a < b ? edge(a, b) : edge(b, a)] == 1) visit(a, b);
      }
    }
  }

  // Triangles have numbers of the whole mesh until the end, and a loop's middle one behind these.
  void close_holes() {
    for (uint32_t e = 0; e < mesh_.row_offsets[mesh_.welded_count]; ++e) uses_[e] = 0;
    for (uint32_t i = 0; i < crop_.surface_triangles; ++i) {
      const uint32_t* const t = crop_.mesh.triangles + size_t{3} * i;
      for (int c = 0; c < 3; ++c) {
        const uint32_t a = t[c], b = t[(c + 1) % 3];
        uint8_t& uses = uses_[a < b ? edge(a, b) : edge(b, a)];
        uses = static_cast<uint8_t>(uses < 2 ? uses + 1 : 2);
      }
    }
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      above_[v] = v;
      loop_of_[v] = kNoIndex;
    }
    each_border([&](uint32_t a, uint32_t b) { join_sets(above_, a, b); });
    uint32_t count = 0;
    each_border([&](uint32_t a, uint32_t b) {
      uint32_t& number = loop_of_[find_root(above_, a)];
      if (number == kNoIndex) {
        if (count == most_loops(mesh_.welded_count)) return;
        number = count;
        loops_[count++] = {{0, 0, 0}, 0};
      }
      const Vec3i p = crop_.mesh.positions[number_[a]], q = crop_.mesh.positions[number_[b]];
      Loop& loop = loops_[number];
      loop.sum = {loop.sum.x + p.x + q.x, loop.sum.y + p.y + q.y, loop.sum.z + p.z + q.z};
      loop.ends += 2;
    });
    for (uint32_t l = 0; l < count; ++l)
      crop_.mesh.positions[crop_.surface_vertices + l] = round_div(loops_[l].sum, loops_[l].ends);
    crop_.mesh.welded_count = crop_.surface_vertices + count;
    each_border([&](uint32_t a, uint32_t b) {
      const uint32_t number = loop_of_[find_root(above_, a)];
      if (number == kNoIndex || crop_.mesh.triangle_count == most_triangles_) return;
      uint32_t* const cap = crop_.mesh.triangles + size_t{3} * crop_.mesh.triangle_count++;
      cap[0] = b;  // in the opposite direction of the triangle with the edge
      cap[1] = a;
      cap[2] = mesh_.welded_count + crop_.surface_vertices + number;
    });
    for (uint32_t i = 0; i < 3 * crop_.mesh.triangle_count; ++i) {
      uint32_t& corner = crop_.mesh.triangles[i];
      corner = corner < mesh_.welded_count ? number_[corner] : corner - mesh_.welded_count;
    }
  }

  const Mesh& mesh_;
  const HandPosition& position_;
  HandCrop& crop_;
  uint8_t* const states_;
  uint32_t* const above_;
  uint32_t* const number_;
  uint32_t* const loop_of_;
  uint8_t* const uses_;
  Loop* const loops_;
  const uint32_t most_triangles_;
};

uint32_t most_vertices(const Counts& counts) { return counts.vertices + most_loops(counts.vertices); }
uint32_t most_triangles(const Counts& counts) { return 2 * counts.triangles() + 1; }

}  // namespace

Vec3l HandFrame::rotated(Vec3i p) const {
  const Vec3i q = turned(p - wrist, quarters, right);
  constexpr int kShift = kAxisBits - kFineBits;  // terms below 2^24 x 2^28
  return {round_shift(dot(axes[0], q), kShift), round_shift(dot(axes[1], q), kShift),
          round_shift(dot(axes[2], q), kShift)};
}

Vec3i HandFrame::to(Vec3i p) const {
  const Vec3l r = rotated(p);  // below 2^34
  return round_div(Vec3l{(r.x - zero.x) * kSide, (r.y - zero.y) * kSide, (r.z - zero.z) * kSide}, side);
}

Vec3i HandFrame::from(Vec3i p) const {
  // Back to Q8 grid units, then by the columns; p is below 2^24 in size.
  const auto back = [&](int32_t v, int64_t origin) { return round_div(v * side, kSide) + origin; };
  const int64_t x = back(p.x, zero.x), y = back(p.y, zero.y), z = back(p.z, zero.z);
  const auto column = [&](int32_t a, int32_t b, int32_t c) {
    return static_cast<int32_t>(
        round_shift(round_shift(a * x, 8) + round_shift(b * y, 8) + round_shift(c * z, 8), kAxisBits + kFineBits - 8));
  };
  const Vec3i q = {column(axes[0].x, axes[1].x, axes[2].x), column(axes[0].y, axes[1].y, axes[2].y),
                   column(axes[0].z, axes[1].z, axes[2].z)};
  return MirrorFrame::turn({right ? -q.x : q.x, q.y, q.z}, 4 - quarters) + wrist;
}

bool HandCrop::allocate(Arena& arena, const Counts& counts) {
  mesh.positions = arena.alloc<Vec3i>(most_vertices(counts));
  mesh.triangles = arena.alloc<uint32_t>(size_t{3} * most_triangles(counts));
  source = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

bool crop_hand(const Mesh& mesh, const HandPosition& position, const Counts& counts, Arena& arena, HandCrop* crop) {
  const ArenaScope scope(arena);
  CropScratch scratch;
  scratch.states = arena.alloc<uint8_t>(counts.vertices);
  scratch.above = arena.alloc<uint32_t>(counts.vertices);
  scratch.number = arena.alloc<uint32_t>(counts.vertices);
  scratch.loop_of = arena.alloc<uint32_t>(counts.vertices);
  scratch.uses = arena.alloc<uint8_t>(size_t{6} * counts.triangles());
  scratch.loops = arena.alloc<Loop>(most_loops(counts.vertices));
  if (!arena.ok()) return false;
  if (arena.measuring()) return true;
  Cutter(mesh, position, scratch, most_triangles(counts), crop).run();
  return true;
}

}  // namespace sinew::rigging
