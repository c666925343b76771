// SPDX-License-Identifier: MIT
// The two networks of a file for SINEW_RIG_SLOTS.
#ifndef SINEW_RIG_SLOTS_MODEL_HPP
#define SINEW_RIG_SLOTS_MODEL_HPP

#include "model/reader.hpp"

namespace sinew::rigging {

// Proves the second network of a file whose first one open_model() gave. Returns what read_header() and open_model() do;
// SINEW_ERROR_MODEL_LAYOUT where there is none.
sinew_status prove_connections(const sinew_model& model);

// It, of a file that was proved so.
sinew_model connections_of(const sinew_model& model);

}  // namespace sinew::rigging
#endif
