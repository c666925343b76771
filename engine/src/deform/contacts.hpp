// SPDX-License-Identifier: MIT
// Contact between parts of the body that are no neighbors: an arm on the torso, a thigh on the belly, one thigh on the other.
#ifndef SINEW_DEFORM_CONTACTS_HPP
#define SINEW_DEFORM_CONTACTS_HPP

#include "deform/half_spaces.hpp"

namespace sinew::deform {

// U welded vertices, B buckets.
struct ContactState {
  struct Bucket {
    Vec3i low, high;  // box around its vertices at rest, lattice units
    uint32_t joint;   // the strongest of all of them, kMixed for several
  };
  static constexpr uint32_t kMixed = 0xFFFFFFFFu;

  // Posed vertices, sorted by a hash of the cell that they lie in.
  Vec3i* positions = nullptr;   // [U] lattice units
  uint32_t* members = nullptr;  // [U] by bucket
  Vec3i* sorted = nullptr;      // [U] their positions, in that order
  uint32_t* offsets = nullptr;  // [B + 1]
  Bucket* buckets = nullptr;    // [B]
  uint32_t bucket_bits = 0;     // B = 2^bits
  // Contacts by vertex.
  double* pushes = nullptr;     // [U] how far a vertex is to go, lattice units; 0 for one that touches nothing
  Vec3d* directions = nullptr;  // [U] where to: unit vectors
  double* borne = nullptr;      // [U] scratch

  bool allocate(Arena& arena, uint32_t vertices);
};

// A corrected pose.
struct ContactInput {
  const PosedJoints& posed;
  const HalfSpace* bends;   // [V] of find_half_spaces(): what these keep apart is none of ours
  const Vec3d* positions;   // [V] posed vertices
  const SolverNode* nodes;  // [n] posed, around `middle`
  Vec3d middle;             // the caller's units
};

// Fills pushes and directions: a vertex that lies in a tetrahedron of another part of the body, and the surface that it came through, are to meet half
// way, or nearer to what gives way less. Its depth is measured at rest, at its position in the tetrahedron: A.
// McAdams et al., "Efficient elasticity for character skinning with contact and collisions", ACM TOG 30(4), 2011.
// Returns whether anything touches.
bool find_contacts(const ContactInput& input, ContactState* state);

}  // namespace sinew::deform
#endif
