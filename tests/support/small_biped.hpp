// SPDX-License-Identifier: MIT
// A synthetic person without clothes, bound: what rigs are damaged and checked on.
#ifndef SINEW_TESTS_SUPPORT_SMALL_BIPED_HPP
#define SINEW_TESTS_SUPPORT_SMALL_BIPED_HPP

#include "sinew_data_sets/synthesize.hpp"

namespace sinew_test {

inline sinew::Character small_biped(int resolution = 32) {
  sinew::SynthesizeOptions options;
  options.plan = sinew::BodyPlan::kBiped;
  options.seed = 3;
  options.resolution = resolution;
  options.clothing = false;
  return sinew::synthesize(options);
}

}  // namespace sinew_test
#endif
