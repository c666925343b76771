// SPDX-License-Identifier: MIT
// Stages 1 and 2 of a bind: the caller's float mesh becomes a welded integer mesh in canonical order.
#ifndef SINEW_MESH_MESH_HPP
#define SINEW_MESH_MESH_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"
#include "core/fixed.hpp"

namespace sinew {

constexpr int kGridBits = 20;  // positions: longest side of the mesh = 2^20 units
constexpr int32_t kSide = 1 << kGridBits;
constexpr int kNormalBits = 14;  // unit vectors are Q14

// Positions and joints are on one integer grid, built from the box of all vertices (mesh/quantize.hpp), by exact
// integer arithmetic on the IEEE words: grid = round_half_up((value - origin) * 2^20 / side) per axis. x and z are
// centred on 0, y has its floor at 0 (after the up axis was turned to Y). Joints may lie outside the mesh: they are
// clamped to +-2^22.

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
  uint32_t* col_indices = nullptr;  // [E2 <= 6 T] neighbours ascending
  Vec3i* normals = nullptr;         // [U] normalised sum of the unit face normals, Q14; (0,0,0) when there is no
                                    //     face or they cancel
  uint64_t* areas = nullptr;  // [U] sum over its triangles of |cross| / 6, grid units squared (a third of the area);
                              //     at least 1 for a vertex with a triangle, 0 for one without
  // Q13, clamped to +-2: ((mean of the neighbours - vertex) . normal) / mean edge length, negative where the surface
  // bulges outward; and angle defect / pi, 0 at boundary vertices (an edge with one triangle) and without a triangle.
  int32_t* mean_curvature = nullptr;   // [U]
  int32_t* gauss_curvature = nullptr;  // [U]
  uint32_t* edge_length = nullptr;     // [U] mean one-ring edge length, grid units
  uint32_t component_count = 0;
  uint32_t* component = nullptr;        // [U] component id; 0 = most vertices, then falling size, ties by first vertex
  uint32_t* component_sizes = nullptr;  // [component_count <= U] vertices each
  uint32_t* component_offsets = nullptr;   // [component_count + 1] CSR into component_vertices
  uint32_t* component_vertices = nullptr;  // [U] vertices grouped by component, ascending

  // Allocates everything for the upper bounds (works with a measuring arena). The caller does this before build_mesh().
  // Returns arena.ok().
  bool allocate(Arena& arena, const Counts& counts);
};

// The skeleton on the same grid.
struct Skeleton {
  uint32_t joint_count = 0;
  Vec3i* positions = nullptr;       // [J] grid units
  int32_t* parents = nullptr;       // [J] -1 for roots
  uint32_t* order = nullptr;        // [J] topological: parents before children
  uint16_t* child_count = nullptr;  // [J]
  uint16_t* depth = nullptr;        // [J] 0 for roots
  uint8_t* usable = nullptr;        // [J] 0: must get no weight (flags), 1: may
  bool deform_known = false;        // the caller said which joints deform
  // Bones of the heat stage (engine/src/heat/README.md): one segment per joint, joint -> mean of its children; a leaf's
  // is half its parent bone (parent joint -> leaf) on in its direction, at most a tenth of the skeleton's size (longest
  // side of the joints' box). A lone joint has a point bone.
  Vec3i* bone_tail = nullptr;  // [J] end of the bone; the head is positions[j]
  uint8_t* source = nullptr;   // [J] 1: may be a heat source. 0: not usable, or a parentless joint in the lowest 3 % of
                               // the mesh's height with 1 to 4 children unless the caller said that it deforms
                               // (deform_known). If that would leave no source, every usable joint is one

  bool allocate(Arena& arena, const Counts& counts);
};

// Fills both, allocated beforehand, from the caller's views. Faces are checked (SINEW_ERROR_INDEX): every corner names
// a vertex, face_offsets start at 0, never fall and end at corner_count; without them corner_count is 3 face_count.
// Faces of two corners are legal and ignored, of fewer not. Scratch beyond the two structs is taken from `arena` and
// released. Returns SINEW_OK, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY, SINEW_ERROR_NO_JOINT or
// SINEW_ERROR_WORKSPACE. The counts were checked by the caller. A mesh of one point has side 1.
sinew_status build_mesh(const sinew_mesh& input, const sinew_skeleton& skeleton_input, uint32_t up_axis,
                        const Counts& counts, Arena& arena, Mesh* mesh, Skeleton* skeleton);

}  // namespace sinew
#endif
