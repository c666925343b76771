// SPDX-License-Identifier: MIT
// Where a run's samples come from and which of them can be used.
#ifndef SINEW_TRAINER_RUN_TRAINING_SET_HPP
#define SINEW_TRAINER_RUN_TRAINING_SET_HPP

#include <map>
#include <string>
#include <vector>

#include "data/sample_cache.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Takes out samples none of whose vertices has reference weights, and names them on stderr unless `silent`.
void drop_unlabelled(std::vector<Sample>* samples, bool silent);
// Whether a configuration's list of characters that are not trained on has the name; a * at an entry's end stands for any rest.
bool is_left_out(const std::map<std::string, std::string>& leave_out, const std::string& name);
// Cache, feature settings and threads of a run.
SampleSource sample_source(const TrainConfig& config, const TrainOptions& options);

}  // namespace sinew
#endif
