// SPDX-License-Identifier: MIT
// The two networks of a file for SINEW_RIG_SLOTS.
#ifndef SINEW_RIG_SLOTS_MODEL_HPP
#define SINEW_RIG_SLOTS_MODEL_HPP

#include "model/reader.hpp"

namespace sinew {

// The second network of a file whose first one is `model`. Returns what read_header() and open_model() do;
// SINEW_ERROR_MODEL_LAYOUT where there is none.
sinew_status open_connections(const sinew_model& model, sinew_model* connections);
// The same where it is known that it begins at `second`, 0 for none: of open_model().
sinew_status open_connections(const sinew_model& model, size_t second, sinew_model* connections);

}  // namespace sinew
#endif
