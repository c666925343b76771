// SPDX-License-Identifier: MIT
// Which nodes of the lattice a pose may move.
#ifndef SINEW_DEFORM_PINS_HPP
#define SINEW_DEFORM_PINS_HPP

#include "deform/rest.hpp"

namespace sinew::deform {

constexpr uint16_t kRigidWeight = 64225;  // 0.98: nodes and vertices of one joint

constexpr uint32_t kRingsAroundStrain = 3;  // of nodes that move around those that are strained

// Grows a set of nodes over tetrahedra: one with a member makes members of all four. Bits `mask` of flags [n].
void grow_nodes(const Lattice& lattice, uint8_t mask, uint32_t rounds, uint8_t* flags);

// Fills rest->rigid, when vertices are embedded: a robot's arm or a sword is a part of its own and of one joint, and keeps its shape. A buckle or an
// eye, among skin that bends, goes with the skin. soft [n] is scratch.
void find_rigid_parts(const Mesh& mesh, uint8_t* soft, DeformRest* rest);

// Fills rest->node_flags: free are nodes whose largest weight is below 0.98, grown twice, but those at bones.
void find_pins(DeformRest* rest);

}  // namespace sinew::deform
#endif
