// SPDX-License-Identifier: MIT
// A skeleton with fewer joints, see sinew/simplify.h.
#ifndef SINEW_SIMPLIFY_SIMPLIFY_HPP
#define SINEW_SIMPLIFY_SIMPLIFY_HPP

#include "core/arena.hpp"
#include "sinew/simplify.h"

namespace sinew::simplifying {

struct SimplifyPlan {
  sinew_skeleton skeleton = {};
  const float* areas = nullptr;      // or null
  const float* centroids = nullptr;  // or null
  const uint8_t* keep = nullptr;     // or null
  uint32_t joint_count = 0;
  uint32_t wanted = 0;                      // joints, 0 = as the limits say
  bool low = false;                         // the level
  bool as_drawn = false;                    // the conditions alone, whatever joints are
  double least_area = 0, least_length = 0;  // of joints that stay
  double crowd_area = 0, crowd_length = 0;  // of leaves that stay beside others
};

// Checks the options and makes a plan of them. SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_COUNT.
sinew_status plan_simplify(uint32_t joint_count, const sinew_simplify_options* options, SimplifyPlan* plan);
// into: [J]. With a measuring arena nothing but joint_count is read. SINEW_ERROR_WORKSPACE, SINEW_ERROR_NOT_FINITE,
// SINEW_ERROR_RANGE, SINEW_ERROR_INDEX, SINEW_ERROR_HIERARCHY.
sinew_status run_simplify(const SimplifyPlan& plan, Arena& arena, uint32_t* into);

}  // namespace sinew::simplifying
#endif
