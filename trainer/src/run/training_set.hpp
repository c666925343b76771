// SPDX-License-Identifier: MIT
// Where a run's samples come from and which of them can be used.
#ifndef SINEW_TRAINER_RUN_TRAINING_SET_HPP
#define SINEW_TRAINER_RUN_TRAINING_SET_HPP

#include <vector>

#include "data/sample_cache.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Takes out samples none of whose vertices has reference weights, and names them on stderr unless `silent`.
void drop_unlabelled(std::vector<Sample>* samples, bool silent);
// Cache, feature settings and threads of a run.
SampleSource sample_source(const TrainConfig& config, const TrainOptions& options);

}  // namespace sinew
#endif
