// SPDX-License-Identifier: MIT
#ifndef SINEW_TRAINER_RUN_SAMPLE_AS_HPP
#define SINEW_TRAINER_RUN_SAMPLE_AS_HPP

#include "sinew_trainer/network_sample.hpp"

namespace sinew {

// A task is asked about samples that it made itself, so their type is known.
template <class S>
const S& sample_as(const NetworkSample& sample) {
  return static_cast<const S&>(sample);
}

}  // namespace sinew
#endif
