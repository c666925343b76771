// SPDX-License-Identifier: MIT
// Fills rows of weights where nothing was found, smoothly from where something was (Abdrashitov and others 2023, "Robust skin
// weights transfer via weight inpainting").
#ifndef SINEW_TRANSFER_INPAINT_HPP
#define SINEW_TRANSFER_INPAINT_HPP

#include "transfer/thin_plate.hpp"
#include "weights/rows.hpp"

namespace sinew::transferring {

// Minimizes w^T (L + L A^-1 L) w in every part that has a known vertex, joint by joint, with the rows of the known ones held.
// Negative weights become 0, rows are normalized. Parts without a known vertex keep their rows, and so do parts whose equations
// would not fit: those of more than about 32,768 unknown vertices.
//   known   [U] 1: the row is held
//   joints  of the target
//   rows    in/out [U]; unknown rows come with a guess
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status inpaint(const Mesh& mesh, const uint8_t* known, uint32_t joints, const Counts& counts, Arena& arena,
                     Rows* rows);

}  // namespace sinew::transferring
#endif
