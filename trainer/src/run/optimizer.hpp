// SPDX-License-Identifier: MIT
// Gradient steps: SGD with momentum, Adam, AdamW, the learning-rate schedule, clipping, and the running average of
// weights.
#ifndef SINEW_TRAINER_RUN_OPTIMIZER_HPP
#define SINEW_TRAINER_RUN_OPTIMIZER_HPP

#include <vector>

#include "network/layer_runner.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Scales the gradients so that their common Euclidean norm is at most `limit` (0 = off). Returns the norm before.
double clip_gradients(std::vector<LinearBlock<float>>* gradients, double limit);

// Factor on the learning rate at `progress` (0..1) of the run: a linear warm-up over the first 2 %, then half a cosine
// down to 1 % (Loshchilov and Hutter 2017, "SGDR").
double schedule(double progress);

// One step. state->step counts the steps done before (Adam's bias correction), state->adam_m and adam_v hold the
// moments (momentum of SGD in adam_m). Decay acts on weights only, never on biases: decoupled for "adamw", as a
// gradient otherwise.
void optimizer_step(const RunConfig& config, double learning_rate, const std::vector<LinearBlock<float>>& gradients,
                    FloatNetwork* network, TrainingState* state);

// average += (1 - d) (network - average), with d = decay but smaller in the first steps, so that the start is
// forgotten.
void update_average(const FloatNetwork& network, double decay, uint64_t step, FloatNetwork* average);
// Moves the weights of `to_network` by a share towards those of `from_network`; both have the same shapes.
void blend(const FloatNetwork& from_network, double share_of_from, FloatNetwork* to_network);

}  // namespace sinew
#endif
