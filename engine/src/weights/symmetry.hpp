// SPDX-License-Identifier: MIT
// Left and right (stage 9): finds the mirror plane, pairs joints and vertices across it, and makes rows of pairs mirror
// images of each other.
#ifndef SINEW_WEIGHTS_SYMMETRY_HPP
#define SINEW_WEIGHTS_SYMMETRY_HPP

#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"
#include "weights/rows.hpp"

namespace sinew {

constexpr uint32_t kNoPartner = 0xFFFFFFFFu;

// Which joints and vertices mirror each other. The mirror plane is x = plane / 2 in grid units. It is the middle of the
// mesh's box or, when more vertices have a mirror image then, the middle joint's x.
//
// A position is mirrored across the plane. What is nearest to the mirrored position is the partner, if it is within 1/512 of
// the mesh's longest side and the two choose each other.
//   vertices  all of them count
//   joints    only those count whose parents are partners, too, and that have as many children and are as usable
// A vertex or joint on the plane is its own partner. The character counts as symmetric when at least half of its
// vertices and half of its joints have a partner.
struct Symmetry {
  bool symmetric = false;
  int32_t plane = 0;
  uint32_t paired_count = 0;   // welded vertices with a partner, themselves included
  uint16_t* joint = nullptr;   // [J] partner or kNoJoint
  uint32_t* vertex = nullptr;  // [U] partner or kNoPartner

  bool allocate(Arena& arena, const Counts& counts);
};

// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_symmetry(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, Arena& arena,
                           Symmetry* out);

// Where one of two partners has a given row and the other has none, the other is given the mirror image.
void mirror_given_rows(const Mesh& mesh, const Symmetry& symmetry, GivenRows* given);
// Makes the rows of partners mirror images: both become the mean of one and the other's mirror image.
// Given rows are restored. Weight of joints without a partner is dropped. Vertices
// that have no other weight, or of which one has a given row, are no partners any more: kNoPartner in `symmetry`. A
// vertex that is its own partner keeps at most `influence_count` joints; of joints that are partners it keeps both or
// none.
void mirror_rows(const Mesh& mesh, const GivenRows& given, uint32_t influence_count, Rows* rows, Symmetry* symmetry);
// Replaces the joints of a finished row by their partners and sorts it again: descending weight, ties by lower joint.
void mirror_influences(const Symmetry& symmetry, uint32_t influence_count, uint16_t* joints, uint16_t* weights);

}  // namespace sinew
#endif
