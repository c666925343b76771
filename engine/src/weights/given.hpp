// SPDX-License-Identifier: MIT
// Rows of weights that the caller gave (locked vertices and hints) come in here: any weight format to Q16, caller's
// vertices to welded ones (stage 9).
#ifndef SINEW_WEIGHTS_GIVEN_HPP
#define SINEW_WEIGHTS_GIVEN_HPP

#include "mesh/mesh.hpp"
#include "weights/rows.hpp"

namespace sinew {

// `count` weights from index `first` on, in the format's own integer steps; floats in steps of 2^-16, at most 1 counts.
// False when one is negative or NaN, or all are 0.
bool read_row(const void* weights, uint32_t format, size_t first, uint32_t count, uint32_t* out);

// Gathers the given rows of the caller's vertices (rows of `influence_count` slots, checked beforehand) on welded
// vertices: the mean of what was given to the vertices welded there, hints alone where there is one. Locked rows
// without weight count as free.
void gather_given_rows(const Mesh& mesh, const uint8_t* locked, const uint8_t* hints, const uint16_t* joints,
                       const void* weights, uint32_t format, uint32_t influence_count, GivenRows* out);

}  // namespace sinew
#endif
