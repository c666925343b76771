// SPDX-License-Identifier: MIT
// Tables of a stage: what layers give whole parts or the whole mesh, one row for each part or joint of it.
#ifndef SINEW_NETWORK_TABLES_HPP
#define SINEW_NETWORK_TABLES_HPP

#include "network/run.hpp"

namespace sinew::network {

// Tables of the stage's global layers, or of its part layers for one part (vertices, count), in a lane's memory.
void make_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count, uint32_t lane);
// The same in the first lane's memory, on all lanes.
void share_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count);
// Multiplies the columns by_joint of the stage's linear layers with the means of one part: one product per joint that is a
// candidate in the part. The sums lie where the tables' scratch was. `met` has a bit for every such joint.
void multiply_part_means(const Run& run, uint32_t stage, const uint32_t* vertices, uint32_t count, uint32_t lane);

}  // namespace sinew::network
#endif
