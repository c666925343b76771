// SPDX-License-Identifier: MIT
// One rig's joints for another's: the stages of sinew_map().
#ifndef SINEW_MAPPING_MAP_HPP
#define SINEW_MAPPING_MAP_HPP

#include "core/arena.hpp"
#include "mapping/anatomy.hpp"
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

// SINEW_MAP_BRANCHES; the room `published` defines it. Without published methods it does nothing.
//   wanted   false: takes the memory alone, of which only the plan's counts are read
//   sources  [target joints] out, -1 = none; costs: [target joints] of each pair
//   cost     the mean of all pairs; untouched where rigs are not compared, because SINEW_MAP_AUTO would have to compare too many joints
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE, or SINEW_ERROR_COUNT where SINEW_MAP_BRANCHES was asked for and there are too many joints.
constexpr double kNotCompared = 1e30;
sinew_status map_branches(const MapPlan& plan, const Anatomy& target, const Anatomy& source, bool wanted, Arena& arena,
                          int32_t* sources, double* costs, double* cost);

// As sinew_limb_classes() in sinew/map.h, whose structs are read and pointers checked; source and sources are both null or none is. A
// measuring arena reads the counts alone.
sinew_status find_limb_classes(const sinew_skeleton& target, const sinew_skeleton* source, const int32_t* sources,
                               Arena& arena, uint8_t* classes);

}  // namespace sinew::mapping
#endif
