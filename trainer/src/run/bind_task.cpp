// SPDX-License-Identifier: MIT
// What a training run asks about skin weights.
#include "run/bind_task.hpp"

#include "features/features.hpp"
#include "network/networks.hpp"

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

std::string BindTask::normalised_config(const std::string& saved, const std::string& source) const {
  return train_config_json(parse_train_config(saved, source));
}

}  // namespace sinew
