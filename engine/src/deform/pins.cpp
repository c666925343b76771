// SPDX-License-Identifier: MIT
// Free nodes by weights, pinned ones by bones.
#include "deform/pins.hpp"

#include "deform/dual_quaternion.hpp"

namespace sinew::deform {
namespace {

constexpr uint16_t kBoneWeight = 32768;  // a node goes with a bone that has more than half of it
constexpr double kBoneReach = 0.6;       // cells

}  // namespace

void grow_nodes(const Lattice& lattice, uint8_t mask, uint32_t rounds, uint8_t* flags) {
  // A second bit keeps this round's members from being seen in it.
  constexpr uint8_t kNew = 128;
  for (uint32_t round = 0; round < rounds; ++round) {
    for (uint32_t t = 0; t < lattice.tetrahedron_count; ++t) {
      const uint32_t* const at = lattice.tetrahedra + 4 * static_cast<size_t>(t);
      if (((flags[at[0]] | flags[at[1]] | flags[at[2]] | flags[at[3]]) & mask) == 0) continue;
      for (int k = 0; k < 4; ++k) flags[at[k]] |= kNew;
    }
    for (uint32_t n = 0; n < lattice.node_count; ++n) {
      if ((flags[n] & kNew) != 0) flags[n] = static_cast<uint8_t>((flags[n] & ~kNew) | mask);
    }
  }
}

void find_rigid_parts(const Mesh& mesh, uint8_t* soft, DeformRest* rest) {
  const Lattice& lattice = rest->lattice;
  const auto row = [&](uint32_t u) { return static_cast<size_t>(rest->first[u]) * rest->influence_count; };
  const auto nodes_of = [&](uint32_t u, const auto& visit) {
    const uint32_t t = lattice.vertices[u].tetrahedron;
    for (size_t k = 0; k < 4 && t != kNoTetrahedron; ++k) visit(lattice.tetrahedra[4 * static_cast<size_t>(t) + k]);
  };
  for (uint32_t n = 0; n < lattice.node_count; ++n) soft[n] = 0;
  const auto each_part = [&](const auto& visit) {
    for (uint32_t p = 0; p < mesh.part_count; ++p)
      visit(mesh.part_vertices + mesh.part_offsets[p], mesh.part_offsets[p + 1] - mesh.part_offsets[p]);
  };
  each_part([&](const uint32_t* vertices, uint32_t count) {
    bool rigid = true;
    for (uint32_t i = 0; i < count && rigid; ++i) {
      rigid = rest->weights[row(vertices[i])] >= kRigidWeight &&
              rest->joints[row(vertices[i])] == rest->joints[row(vertices[0])];
    }
    for (uint32_t i = 0; i < count; ++i) {
      rest->rigid[vertices[i]] = rigid ? 1 : 0;
      if (!rigid) nodes_of(vertices[i], [soft](uint32_t n) { soft[n] = 1; });
    }
  });
  each_part([&](const uint32_t* vertices, uint32_t count) {
    bool alone = true;
    for (uint32_t i = 0; i < count && alone; ++i)
      nodes_of(vertices[i], [&](uint32_t n) { alone = alone && soft[n] == 0; });
    for (uint32_t i = 0; i < count && !alone; ++i) rest->rigid[vertices[i]] = 0;
  });
}

void find_pins(DeformRest* rest) {
  const Lattice& lattice = rest->lattice;
  for (uint32_t n = 0; n < lattice.node_count; ++n) {
    rest->node_flags[n] = lattice.rows[n].weights[0] < kRigidWeight ? kNodeFree : 0;
  }
  grow_nodes(lattice, kNodeFree, 2, rest->node_flags);
  const double reach = kBoneReach * kCellUnits * rest->unit;
  // The bones of the joint that has more than half: its stretches to its children.
  for (uint32_t n = 0; n < lattice.node_count; ++n) {
    const WeightRow& row = lattice.rows[n];
    if (row.weights[0] < kBoneWeight) continue;
    const Vec3d position = rest->node_position(n);
    const RestJoint& joint = rest->skeleton[row.joints[0]];
    bool near = false;
    if (joint.child_count == 0) {
      const double stub = joint.parent >= 0 ? 0.5 * joint.parent_length : 0;
      const Vec3d away = joint.position - stub * joint.to_parent;
      near = square_to_segment(position, joint.position, away) < reach * reach;
    } else {
      for (uint32_t j = 0; j < rest->joint_count && !near; ++j) {
        if (rest->skeleton[j].parent != static_cast<int32_t>(row.joints[0])) continue;
        near = square_to_segment(position, joint.position, rest->skeleton[j].position) < reach * reach;
      }
    }
    if (near) rest->node_flags[n] = kNodeAtBone;
  }
}

}  // namespace sinew::deform
