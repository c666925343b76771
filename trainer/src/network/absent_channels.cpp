// SPDX-License-Identifier: MIT
// Names of input channels to their indices; weights of channels that a network does without.
#include "network/absent_channels.hpp"

#include <algorithm>
#include <iterator>

#include "data/sample_index.hpp"
#include "features/channels.hpp"
#include "features/features.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

#define SINEW_CHANNEL(name) #name,
constexpr const char* kVertexNames[] = {SINEW_VERTEX_CHANNELS(SINEW_CHANNEL)};
constexpr const char* kPairNames[] = {SINEW_PAIR_CHANNELS(SINEW_CHANNEL)};
#undef SINEW_CHANNEL

bool fits(const std::string& pattern, const std::string& name) {
  if (pattern.empty() || pattern.back() != '*') return pattern == name;
  return name.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0;
}

// Channels of `prefix`NAME that some pattern fits; marks those patterns as used.
template <size_t N>
std::vector<uint32_t> find(const char* const (&names)[N], const std::string& prefix,
                           const std::vector<std::string>& patterns, std::vector<bool>* used) {
  std::vector<uint32_t> found;
  for (uint32_t c = 0; c < N; ++c) {
    for (size_t i = 0; i < patterns.size(); ++i) {
      if (!fits(patterns[i], prefix + names[c])) continue;
      if (found.empty() || found.back() != c) found.push_back(c);
      (*used)[i] = true;
    }
  }
  return found;
}

}  // namespace

AbsentChannels absent_channels(const std::vector<std::string>& names, const std::string& source) {
  std::vector<bool> used(names.size(), false);
  AbsentChannels absent{find(kVertexNames, "vertex.", names, &used), find(kPairNames, "pair.", names, &used)};
  for (size_t i = 0; i < names.size(); ++i) {
    if (!used[i]) {
      throw Error(source + ": without: no channel is called \"" + names[i] +
                  "\"; expected vertex.NAME or pair.NAME of engine/src/features/channels.hpp");
    }
  }
  if (std::binary_search(absent.pair.begin(), absent.pair.end(), kPairLogRule))
    throw Error(source + ": without: pair.rule_log is the heat prior, which every network starts from; leave it in");
  return absent;
}

void clear_weights(const AbsentChannels& absent, FloatNetwork* network) {
  for (const Layer& layer : network->layers) {
    if (!has_weights(layer.kind) || (layer.in.buffer != kVertexInput && layer.in.buffer != kPairInput)) continue;
    LinearParameters& linear = network->parameters[layer.parameters];
    for (const uint32_t channel : layer.in.buffer == kVertexInput ? absent.vertex : absent.pair) {
      for (uint32_t out = 0; out < linear.out; ++out)
        linear.weights[size_t{out} * linear.in + channel - layer.in.offset] = 0;
    }
  }
}

}  // namespace sinew
