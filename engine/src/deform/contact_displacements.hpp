// SPDX-License-Identifier: MIT
// Smooth displacements of the lattice's nodes away from contacts.
#ifndef SINEW_DEFORM_CONTACT_DISPLACEMENTS_HPP
#define SINEW_DEFORM_CONTACT_DISPLACEMENTS_HPP

#include "deform/contacts.hpp"

namespace sinew::deform {

// Passes of find_contacts() and press_contacts() over one pose: what one pass leaves inside, the next one finds nearer to the surface.
constexpr int kContactPasses = 3;

// n nodes, e edges.
struct ContactDisplacements {
  Vec3d* displacements = nullptr;  // [n] how far its nodes go, lattice units
  Vec3d* sums = nullptr;           // [n] scratch
  uint8_t* reached = nullptr;      // [n] 1: near something that touches
  uint32_t* edges = nullptr;       // [e] those between such nodes
  uint32_t* counts = nullptr;      // [n] how many of these a node has
  uint32_t edge_count = 0;

  bool allocate(Arena& arena, const Lattice& lattice);
};

// Smooth, and as long as the pushes where there are some. They fall to 0 with them, so that nothing jumps when a touch begins.
void press_contacts(const DeformRest& rest, const ContactState& state, ContactDisplacements* out);

// How far a caller's vertex goes with them, the caller's units.
Vec3d contact_push(const DeformRest& rest, const ContactDisplacements& moved, uint32_t vertex);

}  // namespace sinew::deform
#endif
