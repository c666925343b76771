// SPDX-License-Identifier: MIT
// The float network on disk (cereal portable binary): where trainer and quant meet. Everything needed to go on
// training.
#ifndef SINEW_FORMATS_CHECKPOINT_HPP
#define SINEW_FORMATS_CHECKPOINT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/float_network.hpp"

namespace sinew {

struct TrainingState {
  uint64_t step = 0;
  double seconds = 0;  // wall time spent so far
  std::vector<FloatNetwork>
      averages;  // the running average of the weights, then those the run started from; each only when asked for
  std::vector<std::vector<float>> adam_m;  // per parameter block: weights then bias
  std::vector<std::vector<float>> adam_v;
  std::vector<uint64_t> rng;    // generator state
  std::vector<uint32_t> queue;  // items still to be drawn in this round
  double best_score = 1e30;     // mean over families on val
  std::string config_json;      // the run's whole configuration
  std::string log_csv;          // the log so far
};

struct Checkpoint {
  FloatNetwork network;  // what to evaluate and quantize (the best or the averaged weights)
  FloatNetwork latest;   // the weights to go on from
  TrainingState state;
};

// Throws Error naming the file when it is missing, truncated or of another version. Write goes through rename.
Checkpoint read_checkpoint(const std::string& path);
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);
bool is_checkpoint(const std::string& path);

}  // namespace sinew
#endif
