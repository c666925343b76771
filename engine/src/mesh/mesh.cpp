// SPDX-License-Identifier: MIT
// Stage 2 of a bind: weld, Morton order, triangles, one-ring and parts. Every order is an order of values, never
// of the caller's numbering, so renumbered input gives the same mesh.
#include "mesh/mesh.hpp"

#include "core/vector_math.hpp"
#include "mesh/morton.hpp"
#include "mesh/shape.hpp"
#include "mesh/topology.hpp"

namespace sinew {
namespace {

void weld(const sinew_mesh& input, const GridQuantizer& quantizer, const MortonScratch& scratch, Mesh* mesh) {
  const uint32_t count = input.vertex_count;
  for (uint32_t v = 0; v < count; ++v) {
    scratch.keys[v] = morton_key(quantize_point(quantizer, input.positions + 3 * static_cast<size_t>(v)));
    scratch.order[v] = v;
  }
  mesh->welded_count = weld_keys(scratch, count, mesh->positions, mesh->vertex_to_welded);
  mesh->vertex_count = count;
}

// Walks the fan triangles of a polygon mesh in welded indices, smallest first, degenerate ones left out. A face that is
// read backwards has its fan around its last corner, as in a file with every face in opposite order.
class FanWalk {
 public:
  // inward [parts]: faces of which parts are read backwards; without, `backwards` holds for all.
  FanWalk(const sinew_mesh& input, const Mesh& mesh, const uint8_t* inward, bool backwards)
      : input_(input), mesh_(mesh), inward_(inward), backwards_(backwards) {
    open_face();
  }

  // False at the end. triangle [3] out.
  bool next(uint32_t* triangle) {
    while (face_ < input_.face_count) {
      if (corner_ + 2 > last_) {  // corner_ + 1 is the triangle's last corner
        ++face_;
        open_face();
        continue;
      }
      const uint32_t a = welded(first_), b = welded(corner_), c = welded(corner_ + 1);
      ++corner_;
      if (!has_area(mesh_.positions, a, b, c)) continue;  // a repeated vertex too
      turn_smallest_first(a, b, c, triangle);
      return true;
    }
    return false;
  }

 private:
  void open_face() {
    if (face_ >= input_.face_count) return;
    first_ = input_.face_offsets != nullptr ? input_.face_offsets[face_] : face_ * 3;
    last_ = input_.face_offsets != nullptr ? input_.face_offsets[face_ + 1] : first_ + 3;
    corner_ = first_ + 1;
    if (inward_ != nullptr) {
      backwards_ = false;
      backwards_ = inward_[mesh_.part[welded(first_)]] != 0;
    }
  }
  uint32_t welded(uint32_t corner) const {
    return mesh_.vertex_to_welded[input_.face_vertices[backwards_ ? first_ + last_ - 1 - corner : corner]];
  }

  const sinew_mesh& input_;
  const Mesh& mesh_;
  const uint8_t* const inward_;
  bool backwards_;
  uint32_t face_ = 0;
  uint32_t first_ = 0, last_ = 0, corner_ = 0;  // below 2^27
};

// A sum of 64-bit numbers as high * 2^32 + low; this is the sum's floor over 2^32, which has its sign.
int64_t high_of(Vec3l sum) { return sum.x + (sum.y >> 32); }
int64_t size_of(int64_t v) { return v ^ (v >> 63); }

// Finds the parts whose faces are rotated inwards, true when there is one. volumes [parts]: scratch. The answer for a
// mesh with every face in opposite order has the opposite one: the sums have every face's fan in both orders.
bool find_inward(const sinew_mesh& input, const Mesh& mesh, Vec3l* volumes, uint8_t* inward) {
  // A cavity inside of a robot's link is rotated inwards on purpose. The largest of 490 characters has a 200,000th of the
  // whole's volume, and a mirrored glove a 500th.
  constexpr int kLeastShareBits = 14;
  constexpr Vec3i kLine = {1048573, 999983, 941083};
  for (uint32_t p = 0; p < mesh.part_count; ++p) volumes[p] = {0, 0, 0};
  for (uint32_t side = 0; side < 2; ++side) {
    uint32_t t[3];
    for (FanWalk walk(input, mesh, nullptr, side != 0); walk.next(t);) {
      const Vec3i pa = mesh.positions[t[0]], pb = mesh.positions[t[1 + side]], pc = mesh.positions[t[2 - side]];
      // Six times the volume over the middle of the floor: below 2^62, as no coordinate passes 2^20. The middle of the
      // floor because what is open at the bottom, as a robe, has no volume missing there.
      const int64_t volume = dot(cross(pa, pb), pc);
      Vec3l& sum = volumes[mesh.part[t[0]]];
      sum.x += volume >> 32;
      sum.y += volume & 0xFFFFFFFF;
      // The vector area along a line that hardly a surface lies along, modulo 2^64: 0 where the surface is closed.
      const int64_t area = dot(cross(pb - pa, pc - pa), kLine);
      sum.z = static_cast<int64_t>(static_cast<uint64_t>(sum.z) + static_cast<uint64_t>(area));
    }
  }
  Vec3l sum = {0, 0, 0};
  for (uint32_t p = 0; p < mesh.part_count; ++p) {
    sum.x += volumes[p].x;
    sum.y += volumes[p].y;
  }
  const int64_t whole = high_of(sum);
  bool any = false;
  for (uint32_t p = 0; p < mesh.part_count; ++p) {
    const int64_t own = high_of(volumes[p]);
    const bool unlike = volumes[p].z == 0 && (own ^ whole) < 0 && size_of(own) > size_of(whole) >> kLeastShareBits;
    const bool turned = (whole < 0) != unlike;
    inward[p] = turned ? 1 : 0;
    any = any || turned;
  }
  return any;
}

}  // namespace

sinew_status check_faces(const sinew_mesh& input) {
  if (input.face_offsets == nullptr) {
    if (static_cast<uint64_t>(input.face_count) * 3 != input.corner_count) return SINEW_ERROR_INDEX;
  } else if (input.face_count > 0) {
    if (input.face_offsets[0] != 0 || input.face_offsets[input.face_count] != input.corner_count)
      return SINEW_ERROR_INDEX;
    for (uint32_t f = 0; f < input.face_count; ++f) {
      if (input.face_offsets[f] > input.face_offsets[f + 1]) return SINEW_ERROR_INDEX;
      if (input.face_offsets[f + 1] - input.face_offsets[f] < 2) return SINEW_ERROR_INDEX;
    }
  } else if (input.corner_count != 0) {
    return SINEW_ERROR_INDEX;
  }
  for (uint32_t c = 0; c < input.corner_count; ++c) {
    if (input.face_vertices[c] >= input.vertex_count) return SINEW_ERROR_INDEX;
  }
  return SINEW_OK;
}

bool Mesh::allocate(Arena& arena, const Counts& counts) {
  const size_t v = counts.vertices, t = counts.triangles();
  vertex_to_welded = arena.alloc<uint32_t>(v);
  positions = arena.alloc<Vec3i>(v);
  triangles = arena.alloc<uint32_t>(3 * t);
  row_offsets = arena.alloc<uint32_t>(v + 1);
  col_indices = arena.alloc<uint32_t>(6 * t);
  normals = arena.alloc<Vec3i>(v);
  areas = arena.alloc<uint64_t>(v);
  mean_curvature = arena.alloc<int32_t>(v);
  gauss_curvature = arena.alloc<int32_t>(v);
  edge_length = arena.alloc<uint32_t>(v);
  part = arena.alloc<uint32_t>(v);
  part_sizes = arena.alloc<uint32_t>(v);
  part_offsets = arena.alloc<uint32_t>(v + 1);
  part_vertices = arena.alloc<uint32_t>(v);
  return arena.ok();
}

sinew_status build_mesh(const sinew_mesh& input, const GridQuantizer& quantizer, const Counts& counts, Arena& arena,
                        Mesh* mesh) {
  if (!arena.measuring()) {
    const sinew_status status = check_faces(input);
    if (status != SINEW_OK) return status;
  }
  // The scratch of the three phases does not overlap in time, so each starts at the same offset.
  {
    const ArenaScope scope(arena);
    MortonScratch scratch;
    if (!scratch.allocate(arena, counts.vertices)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) weld(input, quantizer, scratch, mesh);
  }
  const ArenaScope scope(arena);
  uint8_t* const inward = arena.alloc<uint8_t>(counts.vertices);
  for (bool turned = false;; turned = true) {  // at most twice
    {
      const ArenaScope scope_of_pass(arena);
      TriangleScratch scratch;
      if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
      if (!arena.measuring()) collect_triangles(FanWalk(input, *mesh, turned ? inward : nullptr, false), scratch, mesh);
    }
    const ArenaScope scope_of_pass(arena);
    TopologyScratch scratch;
    if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
    if (arena.measuring()) return SINEW_OK;
    connect(nullptr, 0, scratch, mesh);
    label_parts(scratch, mesh);
    if (!turned && find_inward(input, *mesh, scratch.shape.normal_sums, inward)) continue;
    find_shape(scratch.shape, counts.threads, mesh);
    return SINEW_OK;
  }
}

}  // namespace sinew
