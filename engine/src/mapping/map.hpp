// SPDX-License-Identifier: MIT
// One rig's joints for another's: the stages of sinew_map().
#ifndef SINEW_MAPPING_MAP_HPP
#define SINEW_MAPPING_MAP_HPP

#include "core/arena.hpp"
#include "sinew/map.h"

namespace sinew::mapping {

// Structs as this library knows them, checked.
struct MapPlan {
  sinew_skeleton target, source;
  sinew_map_options options;
};

// Reads the caller's structs and checks counts, pointers, options and pins. Errors are those of sinew_map().
sinew_status plan_map(const sinew_skeleton* target, const sinew_skeleton* source, const sinew_map_options* options,
                      MapPlan* plan);

// Runs everything; the caller's arrays in `outputs` are written at the end. With a measuring arena only the plan's counts
// are read.
sinew_status run_map(const MapPlan& plan, Arena& arena, sinew_map_outputs* outputs);

}  // namespace sinew::mapping
#endif
