// SPDX-License-Identifier: MIT
// Checkpoint of a float network (cereal portable binary), written by the trainer and read by quant: everything needed
// to resume training.
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
      averages;  // the running average of the weights, then the initial weights; each only if enabled
  std::vector<std::vector<float>> adam_m;  // per parameter block: weights, then bias
  std::vector<std::vector<float>> adam_v;
  std::vector<uint64_t> rng;    // generator state
  std::vector<uint32_t> queue;  // remaining items of this epoch
  double best_score = 1e30;     // mean over families on val
  std::string config_json;      // the run's whole configuration
  std::string log_csv;          // the log so far
};

struct Checkpoint {
  FloatNetwork network;  // network to evaluate and quantize (the best or the averaged weights)
  FloatNetwork latest;   // weights to resume from
  TrainingState state;
};

// Throws Error with the file name if it is missing, truncated or of another version. Writing is atomic by rename.
Checkpoint read_checkpoint(const std::string& path);
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);
bool is_checkpoint(const std::string& path);

}  // namespace sinew
#endif
