// SPDX-License-Identifier: MIT
// The training task of skin weights; names of input channels that a network does without, and their weights.
#include "run/bind_task.hpp"

#include <algorithm>
#include <iterator>

#include "data/sample_index.hpp"
#include "features/channels.hpp"
#include "features/features.hpp"
#include "network/networks.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

BindTask::BindTask(const TrainConfig& config)
    : config_(parse_train_config(train_config_json(config), "configuration")),
      loss_{config.loss_kl, config.loss_l1, config.loss_regret, config.loss_part, config.loss_deformation},
      absent_(absent_channels(config.without, "configuration")) {}

FloatNetwork BindTask::make_network() const {
  const uint32_t flags = feature_flags(config_);
  return config_.architecture == "classic"
             ? make_classic(config_.field.candidates, config_.field.grid, config_.seed, flags, config_.block_layers)
             : make_field(config_.field, config_.seed, flags);
}

void BindTask::check(const FloatNetwork& network, const std::string& source) const {
  require_bind_network(network, source);
}

void BindTask::prepare(FloatNetwork* network) const { clear_weights(absent_, network); }

FloatNetwork BindTask::finished(const FloatNetwork& trained) const {
  return shrink_correction(trained, config_.correction, kPairLogRule);
}

DropoutOptions BindTask::channels() const {
  DropoutOptions dropout;
  dropout.kept.resize(2);
  if (config_.attributes == "own") dropout.kept[kPairInput] = {kPairLogRule, kPairLogParts};  // the heat prior
  dropout.absent.resize(2);
  dropout.absent[kVertexInput] = absent_.vertex;
  dropout.absent[kPairInput] = absent_.pair;
  return dropout;
}

std::vector<std::string> BindTask::loss_names() const { return {"loss", "l1", "kl", "regret", "part", "deformation"}; }

std::vector<double> BindTask::loss(const NetworkSample& sample, const std::vector<float>& outputs,
                                   std::vector<float>* d_outputs) const {
  const LossTerms terms = weight_loss(sample_as<Sample>(sample), loss_, outputs, d_outputs);
  return {terms.total, terms.l1, terms.kl, terms.regret, terms.part, terms.deformation};
}

double BindTask::score(const NetworkSample& sample, const std::vector<float>& outputs) const {
  return sample_l1(sample_as<Sample>(sample), softmax(sample_as<Sample>(sample), outputs), kKeptInfluences);
}

double BindTask::baseline_score(const NetworkSample& sample) const {
  return sample_l1(sample_as<Sample>(sample), sample_as<Sample>(sample).heat, kKeptInfluences);
}

std::string BindTask::config_text() const { return train_config_json(config_); }

std::string BindTask::normalized_config(const std::string& saved, const std::string& source) const {
  return train_config_json(parse_train_config(saved, source));
}

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
