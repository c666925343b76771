// SPDX-License-Identifier: MIT
// Samples of votes, slots and fronts on disk: a run that is killed before its first checkpoint has made them for the next one.
#ifndef SINEW_TRAINER_DATA_RIG_SAMPLE_CACHE_HPP
#define SINEW_TRAINER_DATA_RIG_SAMPLE_CACHE_HPP

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sinew_trainer/sample.hpp"

namespace sinew {

using RigSamples = std::vector<std::unique_ptr<const NetworkSample>>;  // of one character

// The samples of a file that write_rig_samples() wrote; nullopt when it is missing or damaged.
std::optional<RigSamples> read_rig_samples(const std::string& path);
// All of one kind: RigSample, SlotSample or FrontSample.
void write_rig_samples(const std::string& path, const RigSamples& samples);

}  // namespace sinew
#endif
