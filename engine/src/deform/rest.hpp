// SPDX-License-Identifier: MIT
// A deformer's data of a character at rest: all inputs of poses, in the caller's memory.
#ifndef SINEW_DEFORM_REST_HPP
#define SINEW_DEFORM_REST_HPP

#include "core/threads.hpp"
#include "core/vec3d.hpp"
#include "deform/lattice.hpp"
#include "deform/skin_surface.hpp"
#include "sinew/sinew.h"

namespace sinew::deform {

constexpr uint8_t kNodeFree = 1;    // may move: near a blend of weights, and not at a bone
constexpr uint8_t kNodeAtBone = 2;  // never moves

// A joint between its parent and its children.
struct RestJoint {
  Vec3d position;     // the caller's units
  int32_t parent;     // -1 for a root
  uint32_t rank;      // in an order in which parents come before their children
  uint32_t next;      // the joint of the next rank, J behind the last
  Vec3d to_parent;    // unit vector, (0, 0, 0) without a parent
  Vec3d to_children;  // unit vector along the bone; a leaf's leads away from its parent
  double parent_length, bone_length;
  uint32_t child_count;
  uint32_t bound;  // 1: it has weight, or a joint below it has
  uint32_t hinge;  // 1: parent and bone lead apart, so that its bends may be held apart by a plane
};

// V vertices, U welded ones, J joints, N influences, T triangles.
struct DeformRest {
  sinew_deform_options options = {};  // defaults filled in
  uint32_t vertex_count = 0, joint_count = 0, influence_count = 0, welded_count = 0, triangle_count = 0;
  uint32_t first_joint = 0;       // of the order, see RestJoint::next
  double size = 0;                // longest side, the caller's units
  Vec3d corner = {0, 0, 0};       // the grid's, the caller's units
  double unit = 0;                // a lattice unit in the caller's
  float* positions = nullptr;     // [V x 3]
  uint16_t* joints = nullptr;     // [V x N]
  uint16_t* weights = nullptr;    // [V x N]
  RestJoint* skeleton = nullptr;  // [J]
  uint32_t* welded = nullptr;     // [V] welded vertex
  uint32_t* first = nullptr;      // [U] the caller's first vertex at a position
  // For a volume or published pose.
  Lattice lattice;
  uint8_t* node_flags = nullptr;  // [n]
  uint8_t* rigid = nullptr;       // [U] 1: of a part that belongs to one joint and has no soft skin around it
  // For a pose with contact of the whole body.
  SkinSurface surface;
  // For smoothing, as in Mesh, and whether a vertex has an edge of one triangle.
  uint32_t *triangles = nullptr, *row_offsets = nullptr, *col_indices = nullptr;
  uint8_t* border = nullptr;  // [U]
  Vec3d* smooth = nullptr;    // [U] delta mush: the smoothed rest pose
  ConstraintKernels kernels;  // of the processor at hand

  Threads threads() const {
    return {options.thread_count != 0 ? options.thread_count : 1, options.parallel_for, options.parallel_user};
  }
  bool has_lattice() const { return options.method != SINEW_DEFORM_DELTA_MUSH; }
  bool has_contact() const { return has_lattice() && options.body_contact != 0; }
  bool has_surface() const { return options.method != SINEW_DEFORM_VOLUME; }
  Vec3d position(uint32_t vertex) const {
    const float* const p = positions + 3 * static_cast<size_t>(vertex);
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
  Vec3d node_position(uint32_t node) const { return corner + unit * to_double(lattice.nodes[node]); }
};

struct RestInput {
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  sinew_skin skin = {};
  sinew_deform_options options = {};  // defaults filled in
};

// Takes the caller's options and fills in the defaults. Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_VERSION.
sinew_status read_deform_options(const sinew_deform_options* given, sinew_deform_options* options);

// Checks the input and makes everything. With a measuring arena the skeleton and the weights are not read, but for their
// counts. Errors are those of sinew_deform_create().
sinew_status build_rest(const RestInput& input, Arena& arena, DeformRest* rest);

// As in sinew/deform.h; pointers were checked for null. With a measuring arena the deformer is not written.
sinew_status create_deformer(const RestInput& input, Arena& arena, sinew_deformer* deformer);
sinew_status pose_deformer(const DeformRest& rest, const float* palette, Arena& arena, sinew_deform_outputs* outputs);

// Uniform Laplacian smoothing of the surface, for delta mush and for the end of the published method.
// Fills rest->border: vertices of edges with one triangle. edge_triangles [6 T] is scratch.
void find_borders(uint8_t* edge_triangles, DeformRest* rest);
// Moves vertices halfway to the mean of their neighbors, all at once; border vertices go to border neighbors alone.
// mask [U]: vertices that move, null = all. scratch [U].
void smooth(const DeformRest& rest, uint32_t rounds, const uint8_t* mask, Vec3d* scratch, Vec3d* positions);
// Fills rest->smooth from the rest pose; its second half is scratch.
void smooth_rest(DeformRest* rest);

}  // namespace sinew::deform
#endif
