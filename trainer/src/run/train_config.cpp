// SPDX-License-Identifier: MIT
// The configuration of a training run as JSON: every key optional, unknown keys and wrong types refused by name.
#include <cmath>

#include "features/features.hpp"
#include "run/bind_task.hpp"
#include "run/settings.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {
namespace {

// Calls visit(key, field) for every setting; one list for reading and writing.
template <class Config, class Visitor>
void visit_settings(Config& c, Visitor&& visit) {
  visit("architecture", c.architecture);
  visit("field.width", c.field.width);
  visit("field.vertex_width", c.field.vertex_width);
  visit("field.rounds", c.field.rounds);
  visit("field.candidates", c.field.candidates);
  visit("field.grid", c.field.grid);
  visit("spectral", c.spectral);
  visit("attributes", c.attributes);
  visit("block_layers", c.block_layers);
  visit("without", c.without);
  visit("leave_out", c.leave_out);
  visit("optimizer", c.optimizer);
  visit("learning_rate", c.learning_rate);
  visit("weight_decay", c.weight_decay);
  visit("momentum", c.momentum);
  visit("clip", c.clip);
  visit("dropout", c.dropout);
  visit("feature_dropout", c.feature_dropout);
  visit("loss_kl", c.loss_kl);
  visit("loss_l1", c.loss_l1);
  visit("loss_regret", c.loss_regret);
  visit("loss_part", c.loss_part);
  visit("loss_deformation", c.loss_deformation);
  visit("steps", c.steps);
  visit("batch", c.batch);
  visit("seed", c.seed);
  visit("average_decay", c.average_decay);
  visit("correction", c.correction);
  visit("init_share", c.init_share);
  visit("validate_every", c.validate_every);
  visit("patience", c.patience);
  visit("stop_below", c.stop_below);
  visit("variants", c.variants);
  visit("variant_share", c.variant_share);
  visit("vertex_limit", c.vertex_limit);
  visit("synthetic", c.synthetic);
  visit("family_power", c.family_power);
}

void check(const TrainConfig& c, const std::string& source) {
  const Requirement require{source};
  check_run_settings(c, require);
  require(c.architecture == "field" || c.architecture == "classic", "architecture", "\"field\" or \"classic\"");
  require(c.attributes == "own" || (c.attributes == "published" && c.architecture == "classic"), "attributes",
          "\"own\", or with the architecture \"classic\" \"published\"");
  require(c.block_layers >= 1 && c.block_layers <= 4, "block_layers", "1 to 4");
  require(c.without.empty() || c.architecture == "field", "without", "nothing unless architecture is \"field\"");
  absent_channels(c.without, source);
  require(c.field.width >= 1 && c.field.width <= 256, "field.width", "1 to 256");
  require(c.field.vertex_width >= 1 && c.field.vertex_width <= 256, "field.vertex_width", "1 to 256");
  require(c.field.rounds <= 8, "field.rounds", "0 to 8");
  require(c.field.candidates >= 1 && c.field.candidates <= 16, "field.candidates", "1 to 16");
  require(c.field.grid == 0 || (c.field.grid >= 16 && c.field.grid <= 128), "field.grid", "16 to 128, or 0");
  require(c.loss_kl >= 0 && c.loss_l1 >= 0 && c.loss_regret >= 0 && c.loss_part >= 0 &&
              c.loss_kl + c.loss_l1 + c.loss_regret + c.loss_part > 0,
          "loss_kl, loss_l1, loss_regret, loss_part", "0 or more and not all 0");
  require(c.loss_deformation >= 0, "loss_deformation", "0 or more");
  require(c.correction > 0 && c.correction <= 1, "correction", "above 0, at most 1");
  require(c.variants <= 64, "variants", "0 to 64");
  require(c.synthetic <= 1000, "synthetic", "0 to 1000");
}

}  // namespace

uint32_t feature_flags(const TrainConfig& config) {
  return (config.spectral ? kSpectralFlag : 0) | (config.attributes == "published" ? kAttributesFlag : 0);
}

TrainConfig parse_train_config(const std::string& json, const std::string& source) {
  TrainConfig config;
  read_settings(json, source, "field", [&](auto&& visit) { visit_settings(config, visit); });
  check(config, source);
  return config;
}

std::string train_config_json(const TrainConfig& config) {
  return write_settings("field", [&](auto&& visit) { visit_settings(config, visit); });
}

}  // namespace sinew
