// SPDX-License-Identifier: MIT
// Options, the skeleton in the caller's units, copies of the mesh and its weights, then the lattice or the surface.
#include "deform/rest.hpp"

#include <stddef.h>
#include <string.h>

#include "bind/pipeline.hpp"
#include "core/build.hpp"
#include "core/struct_size.hpp"
#include "deform/correction.hpp"
#include "deform/dual_quaternion.hpp"
#include "deform/pins.hpp"
#include "deform/solver.hpp"
#include "grid/caller_units.hpp"
#include "sinew/published.h"

namespace sinew::deform {
namespace {

constexpr uint32_t kFirstOptionsSize = offsetof(sinew_deform_options, body_contact) + sizeof(uint32_t);
constexpr uint32_t kWithout = SINEW_WITHOUT_TWIST_SPREAD | SINEW_WITHOUT_CONTACTS | SINEW_WITHOUT_SMOOTHING;
constexpr double kHingeCosine =
    -0.5;  // cosine between the directions to the parent and along the bone: hinges are below

sinew_status check_input(const RestInput& input, Counts* counts) {
  const sinew_mesh& mesh = input.mesh;
  const uint32_t corners = mesh.face_offsets == nullptr ? 3 * mesh.face_count : mesh.corner_count;
  const sinew_status status =
      make_counts(mesh.vertex_count, mesh.face_count, corners, input.skeleton.joint_count, 1, 0, counts);
  if (status != SINEW_OK) return status;
  return input.skin.influence_count == 0 || input.skin.influence_count > SINEW_MAX_INFLUENCES ? SINEW_ERROR_ARGUMENT
                                                                                              : SINEW_OK;
}

Vec3d position_of(const float* p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

// Links the joints so that parents come before their children. queue [J]: scratch.
sinew_status order_joints(const sinew_skeleton& skeleton, uint32_t* queue, DeformRest* rest) {
  const uint32_t count = skeleton.joint_count;
  uint32_t tail = 0;
  for (uint32_t j = 0; j < count; ++j) {
    if (skeleton.parents[j] >= static_cast<int32_t>(count) || skeleton.parents[j] < -1) return SINEW_ERROR_INDEX;
    if (!is_finite_point(skeleton.positions + 3 * static_cast<size_t>(j))) return SINEW_ERROR_NOT_FINITE;
    if (skeleton.parents[j] < 0) queue[tail++] = j;
  }
  for (uint32_t head = 0; head < tail; ++head) {
    for (uint32_t j = 0; j < count; ++j) {
      if (skeleton.parents[j] == static_cast<int32_t>(queue[head])) queue[tail++] = j;
    }
  }
  if (tail != count) return SINEW_ERROR_HIERARCHY;
  rest->first_joint = queue[0];
  for (uint32_t i = 0; i < count; ++i) {
    rest->skeleton[queue[i]].rank = i;
    rest->skeleton[queue[i]].next = i + 1 < count ? queue[i + 1] : count;
  }
  return SINEW_OK;
}

void measure_joints(const sinew_skeleton& skeleton, DeformRest* rest) {
  const uint32_t count = rest->joint_count;
  for (uint32_t j = 0; j < count; ++j) {
    RestJoint& joint = rest->skeleton[j];
    joint.position = position_of(skeleton.positions + 3 * static_cast<size_t>(j));
    joint.parent = skeleton.parents[j];
    joint.to_children = {0, 0, 0};
    joint.child_count = 0;
  }
  for (uint32_t j = 0; j < count; ++j) {
    const int32_t parent = rest->skeleton[j].parent;
    if (parent < 0) continue;
    RestJoint& above = rest->skeleton[parent];
    above.to_children = above.to_children + (rest->skeleton[j].position - above.position);
    ++above.child_count;
  }
  for (uint32_t j = 0; j < count; ++j) {
    RestJoint& joint = rest->skeleton[j];
    const Vec3d up = joint.parent >= 0 ? rest->skeleton[joint.parent].position - joint.position : Vec3d{0, 0, 0};
    joint.parent_length = length(up);
    joint.to_parent = unit(up);
    const bool leaf = joint.child_count == 0;
    const Vec3d bone = leaf ? Vec3d{0, 0, 0} : (1.0 / joint.child_count) * joint.to_children;
    joint.bone_length = leaf ? 0.5 * joint.parent_length : length(bone);
    const bool short_bone = !(length(bone) > 1e-6 * rest->size);
    joint.to_children = short_bone ? -1.0 * joint.to_parent : unit(bone);
    joint.hinge = joint.parent_length >= 1e-3 * rest->size && dot(joint.to_parent, joint.to_children) <= kHingeCosine;
  }
}

void copy_input(const RestInput& input, DeformRest* rest) {
  const size_t vertices = rest->vertex_count, values = vertices * rest->influence_count;
  memcpy(rest->positions, input.mesh.positions, 3 * vertices * sizeof(float));
  memcpy(rest->joints, input.skin.joint_indices, values * sizeof(uint16_t));
  memcpy(rest->weights, input.skin.weights, values * sizeof(uint16_t));
}

void copy_surface(const Mesh& mesh, DeformRest* rest) {
  rest->welded_count = mesh.welded_count;
  rest->triangle_count = mesh.triangle_count;
  memcpy(rest->triangles, mesh.triangles, 3 * sizeof(uint32_t) * static_cast<size_t>(mesh.triangle_count));
  memcpy(rest->row_offsets, mesh.row_offsets, sizeof(uint32_t) * (static_cast<size_t>(mesh.welded_count) + 1));
  memcpy(rest->col_indices, mesh.col_indices, sizeof(uint32_t) * mesh.row_offsets[mesh.welded_count]);
}

// An end marker may rotate freely: it has no children.
void find_bound_joints(DeformRest* rest) {
  for (uint32_t j = 0; j < rest->joint_count; ++j) rest->skeleton[j].bound = 0;
  const size_t values = static_cast<size_t>(rest->vertex_count) * rest->influence_count;
  for (size_t i = 0; i < values; ++i) {
    if (rest->weights[i] == 0) continue;
    for (int32_t j = rest->joints[i]; j >= 0 && rest->skeleton[j].bound == 0; j = rest->skeleton[j].parent) {
      rest->skeleton[j].bound = 1;
    }
  }
}

// Fills the arrays from the input.
struct Builder {
  const RestInput& input;
  const Counts counts;
  const GridQuantizer& quantizer;
  DeformRest& rest;

  sinew_status mesh_and_lattice(const LatticeBounds& bounds, const VoxelGrid& grid, Arena& arena) {
    const ArenaScope scope(arena);
    Mesh mesh;
    if (!mesh.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status = build_mesh(input.mesh, quantizer, counts, arena, &mesh);
    if (status != SINEW_OK) return status;
    if (!arena.measuring()) {
      rest.welded_count = mesh.welded_count;
      for (uint32_t u = 0; u < mesh.welded_count; ++u) rest.first[u] = rest.vertex_count;
      for (uint32_t v = rest.vertex_count; v-- > 0;) {
        rest.welded[v] = mesh.vertex_to_welded[v];
        rest.first[rest.welded[v]] = v;
      }
    }
    if (rest.has_surface()) {
      uint8_t* const edge_triangles = arena.alloc<uint8_t>(size_t{6} * counts.triangles());
      if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
      if (!arena.measuring()) {
        copy_surface(mesh, &rest);
        find_borders(edge_triangles, &rest);
      }
    }
    if (!rest.has_lattice() || bounds.pairs == 0) return SINEW_OK;
    const sinew_status built =
        build_lattice({&mesh, rest.first, rest.joints, rest.weights}, bounds, grid, arena, &rest.lattice);
    if (built != SINEW_OK || arena.measuring()) return built;
    find_rigid_parts(mesh, rest.node_flags, &rest);
    if (!rest.has_contact()) return SINEW_OK;
    for (uint32_t u = 0; u < mesh.welded_count; ++u) {
      rest.surface.positions[u] = to_units((1 / rest.unit) * (rest.position(rest.first[u]) - rest.corner));
    }
    fill_surface(mesh, rest.lattice, &rest.surface);
    return SINEW_OK;
  }
};

}  // namespace

sinew_status read_deform_options(const sinew_deform_options* given, sinew_deform_options* options) {
  *options = SINEW_INIT(sinew_deform_options);
  if (given != nullptr) {
    const sinew_status status = read_struct(given, kFirstOptionsSize, sizeof *options, options);
    if (status != SINEW_OK) return status;
  }
  sinew_deform_options& o = *options;
  if (o.body_contact > 1 || o.as_drawn > 1 || o.reserved != 0 || o.tet_weights > SINEW_TET_WEIGHTS_DISTANCE ||
      o.energy > SINEW_MAX_DEFORM_ENERGY) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (o.method > SINEW_DEFORM_DELTA_MUSH || o.round_count > SINEW_MAX_DEFORM_ROUNDS || o.softness > 65535 ||
      (o.cell_count != 0 && (o.cell_count < 8 || o.cell_count > SINEW_MAX_DEFORM_CELLS)) ||
      (o.without & ~kWithout) != 0 || o.thread_count > SINEW_MAX_THREADS) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (o.cell_count == 0) o.cell_count = 32;
  if (o.method == SINEW_DEFORM_XPBD && !has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  if (o.round_count == 0)
    o.round_count = o.method == SINEW_DEFORM_DELTA_MUSH ? 5 : o.method == SINEW_DEFORM_VOLUME ? 20 : 60;
  if (o.softness == 0) o.softness = 5 * 256;
  if (o.energy == 0) o.energy = 200;
  if (o.as_drawn != 0 && o.method != SINEW_DEFORM_XPBD) return SINEW_ERROR_ARGUMENT;
  if (o.as_drawn != 0) {
    o.body_contact = 1;
    o.tet_weights = SINEW_TET_WEIGHTS_DISTANCE;
  }
  return SINEW_OK;
}

sinew_status build_rest(const RestInput& input, Arena& arena, DeformRest* rest) {
  Counts counts;
  sinew_status status = check_input(input, &counts);
  if (status != SINEW_OK) return status;
  rest->options = input.options;
  rest->vertex_count = input.mesh.vertex_count;
  rest->joint_count = input.skeleton.joint_count;
  rest->influence_count = input.skin.influence_count;
  GridQuantizer quantizer;
  status = make_grid_quantizer(input.mesh.positions, counts.vertices, 0, &quantizer);
  if (status != SINEW_OK) return status;
  LatticeBounds bounds;
  VoxelGrid grid;
  status =
      find_lattice_bounds(input.mesh, quantizer, rest->has_lattice() ? rest->options.cell_count : 1, &bounds, &grid);
  if (status != SINEW_OK) return status;
  bounds.influences = rest->influence_count;
  bounds.joints = rest->joint_count;
  const size_t vertices = counts.vertices, values = vertices * rest->influence_count;
  rest->positions = arena.alloc<float>(3 * vertices);
  rest->joints = arena.alloc<uint16_t>(values);
  rest->weights = arena.alloc<uint16_t>(values);
  rest->skeleton = arena.alloc<RestJoint>(counts.joints);
  rest->welded = arena.alloc<uint32_t>(vertices);
  rest->first = arena.alloc<uint32_t>(vertices);
  if (rest->has_lattice()) {
    rest->lattice.allocate(arena, bounds);
    rest->node_flags = arena.alloc<uint8_t>(bounds.nodes);
    rest->rigid = arena.alloc<uint8_t>(vertices);
    if (rest->has_contact()) rest->surface.allocate(arena, vertices, counts.triangles(), bounds.nodes);
  }
  if (rest->has_surface()) {
    const size_t triangles = counts.triangles();
    rest->triangles = arena.alloc<uint32_t>(3 * triangles);
    rest->row_offsets = arena.alloc<uint32_t>(vertices + 1);
    rest->col_indices = arena.alloc<uint32_t>(6 * triangles);
    rest->border = arena.alloc<uint8_t>(vertices);
    rest->smooth = arena.alloc<Vec3d>(2 * vertices);  // the second half is scratch
  }
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  {
    const ArenaScope scope(arena);
    uint32_t* const queue = arena.alloc<uint32_t>(counts.joints);
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) {
      for (size_t i = 0; i < values; ++i) {
        if (input.skin.joint_indices[i] >= rest->joint_count) return SINEW_ERROR_RANGE;
      }
      status = order_joints(input.skeleton, queue, rest);
      if (status != SINEW_OK) return status;
      copy_input(input, rest);
      const Units units(input.mesh, 0);
      rest->size = units.side;
      rest->unit = units.length(1) * grid.cell_size / kCellUnits;
      rest->corner = {units.zero(0) + units.length(grid.low.x), units.zero(1) + units.length(grid.low.y),
                      units.zero(2) + units.length(grid.low.z)};
      measure_joints(input.skeleton, rest);
      find_bound_joints(rest);
    }
  }
  status = Builder{input, counts, quantizer, *rest}.mesh_and_lattice(bounds, grid, arena);
  if (status == SINEW_OK && rest->options.method == SINEW_DEFORM_XPBD &&
      rest->options.tet_weights == SINEW_TET_WEIGHTS_DISTANCE) {
    status = weigh_nodes_by_distance(arena, rest);
  }
  if (status != SINEW_OK || arena.measuring()) return status;
  if (rest->has_lattice()) {
    if (bounds.pairs == 0) {
      for (uint32_t v = 0; v < rest->vertex_count; ++v) rest->lattice.vertices[v] = {kNoTetrahedron, {0, 0, 0, 0}};
    }
    find_pins(rest);
    if (rest->has_contact() && bounds.pairs > 0) {
      fill_yields(rest->lattice, rest->node_flags, kNodeAtBone, rest->rigid, rest->welded_count, &rest->surface);
    }
  }
  if (rest->options.method == SINEW_DEFORM_DELTA_MUSH) smooth_rest(rest);
  return SINEW_OK;
}

}  // namespace sinew::deform
