// SPDX-License-Identifier: MIT
// Stage 2 of a bind: the caller's float mesh becomes a welded integer mesh in canonical order.
#ifndef SINEW_MESH_MESH_HPP
#define SINEW_MESH_MESH_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"
#include "core/fixed.hpp"
#include "grid/grid_quantizer.hpp"

namespace sinew {

constexpr int kNormalBits = 14;  // unit vectors are Q14

// The welded mesh. Vertices with the same grid position are one welded vertex. Welded vertices are in Morton order of
// their grid position, so nothing after this stage depends on the caller's numbering. U = welded_count.
struct Mesh {
  bool reduced = false;                  // made by reduce_mesh(): edges may have any number of triangles, even none
  uint32_t vertex_count = 0;             // V, the caller's
  uint32_t welded_count = 0;             // U <= V
  uint32_t* vertex_to_welded = nullptr;  // [V]
  Vec3i* positions = nullptr;            // [U] grid units
  uint32_t triangle_count = 0;      // T: fan triangles, degenerate (repeated vertex or zero area) and duplicate (same
  uint32_t* triangles = nullptr;    // [T x 3] vertex set) removed; smallest index first, orientation kept; sorted
  uint32_t* row_offsets = nullptr;  // [U + 1] CSR one-ring over edges of triangles
  uint32_t* col_indices = nullptr;  // [E2 <= 6 T] neighbors ascending
  Vec3i* normals = nullptr;         // [U] normalized sum of the unit face normals, Q14; (0,0,0) when there is no
                                    //     face or they cancel
  uint64_t* areas = nullptr;  // [U] sum over its triangles of |cross| / 6, grid units squared (a third of the area);
                              //     at least 1 for a vertex with a triangle, 0 for one without
  // Q13, clamped to +-2: ((mean of the neighbors - vertex) . normal) / mean edge length, negative where the surface
  // bulges outward; and angle defect / pi, 0 at boundary vertices (an edge with one triangle) and without a triangle.
  int32_t* mean_curvature = nullptr;   // [U]
  int32_t* gauss_curvature = nullptr;  // [U]
  uint32_t* edge_length = nullptr;     // [U] mean one-ring edge length, grid units
  uint32_t part_count = 0;
  uint32_t* part = nullptr;           // [U] part id; 0 = most vertices, then descending size, ties by first vertex
  uint32_t* part_sizes = nullptr;     // [part_count <= U] vertices each
  uint32_t* part_offsets = nullptr;   // [part_count + 1] CSR into part_vertices
  uint32_t* part_vertices = nullptr;  // [U] vertices grouped by part, ascending

  // Allocates everything for the upper bounds (works with a measuring arena). The caller does this before build_mesh().
  // Returns arena.ok().
  bool allocate(Arena& arena, const Counts& counts);
};

// Whether the faces obey the rules of build_mesh(). Returns SINEW_OK or SINEW_ERROR_INDEX.
sinew_status check_faces(const sinew_mesh& input);

// Fills a mesh, allocated beforehand, from the caller's view. The quantizer was made from all of its vertices. Faces
// are checked: every corner names a vertex, face_offsets start at 0, never fall and end at corner_count; without them
// corner_count is 3 face_count. Faces of two corners are legal and ignored, of fewer not. Parts whose faces are rotated
// inwards are read backwards, so that the mesh whose every face has its corners in reverse order is the same: the
// sign of the exact volume over the middle of the floor decides for all parts, and a closed part (one whose vector area
// is 0) of at least a 16384th of that goes by its own. Where the whole's volume is 0, faces stay as they are.
// Scratch beyond the struct is taken from `arena` and released. The counts were checked by the caller.
// Returns SINEW_OK, SINEW_ERROR_INDEX for a face that breaks these rules, or SINEW_ERROR_WORKSPACE.
sinew_status build_mesh(const sinew_mesh& input, const GridQuantizer& quantizer, const Counts& counts, Arena& arena,
                        Mesh* mesh);

}  // namespace sinew
#endif
