// SPDX-License-Identifier: MIT
// The configuration of a training run as JSON: every key optional, unknown keys and wrong types refused by name.
#include <cmath>
#include <nlohmann/json.hpp>

#include "features/features.hpp"
#include "network/absent_channels.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

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
  visit("variants", c.variants);
  visit("variant_share", c.variant_share);
  visit("vertex_limit", c.vertex_limit);
  visit("synthetic", c.synthetic);
  visit("family_power", c.family_power);
}

void read_value(const Json& value, const std::string& where, std::string* out) {
  if (!value.is_string()) throw Error(where + ": expected a text, found " + value.dump());
  *out = value.get<std::string>();
}
void read_value(const Json& value, const std::string& where, bool* out) {
  if (!value.is_boolean()) throw Error(where + ": expected true or false, found " + value.dump());
  *out = value.get<bool>();
}
void read_value(const Json& value, const std::string& where, double* out) {
  if (!value.is_number()) throw Error(where + ": expected a number, found " + value.dump());
  *out = value.get<double>();
}
void read_value(const Json& value, const std::string& where, std::vector<std::string>* out) {
  if (!value.is_array()) throw Error(where + ": expected a list of texts, found " + value.dump());
  out->clear();
  for (const Json& one : value) read_value(one, where, &out->emplace_back());
}
void read_value(const Json& value, const std::string& where, std::map<std::string, std::string>* out) {
  if (!value.is_object()) throw Error(where + ": expected an object, name to reason, found " + value.dump());
  out->clear();
  for (const auto& [name, reason] : value.items()) read_value(reason, where + ": " + name, &(*out)[name]);
}
void read_value(const Json& value, const std::string& where, uint64_t* out) {
  if (!value.is_number_unsigned()) throw Error(where + ": expected a whole number from 0, found " + value.dump());
  *out = value.get<uint64_t>();
}
void read_value(const Json& value, const std::string& where, uint32_t* out) {
  uint64_t wide = 0;
  read_value(value, where, &wide);
  if (wide > UINT32_MAX) throw Error(where + ": " + value.dump() + " is too large");
  *out = static_cast<uint32_t>(wide);
}

void check(const TrainConfig& c, const std::string& source) {
  const auto require = [&](bool good, const char* key, const char* expected) {
    if (!good) throw Error(source + ": " + key + ": expected " + expected);
  };
  require(c.architecture == "field" || c.architecture == "classic", "architecture", "\"field\" or \"classic\"");
  require(c.without.empty() || c.architecture == "field", "without", "nothing unless architecture is \"field\"");
  absent_channels(c.without, source);
  require(c.optimizer == "adamw" || c.optimizer == "adam" || c.optimizer == "sgd", "optimizer",
          "\"adamw\", \"adam\" or \"sgd\"");
  require(c.field.width >= 1 && c.field.width <= 256, "field.width", "1 to 256");
  require(c.field.vertex_width >= 1 && c.field.vertex_width <= 256, "field.vertex_width", "1 to 256");
  require(c.field.rounds <= 8, "field.rounds", "0 to 8");
  require(c.field.candidates >= 1 && c.field.candidates <= 16, "field.candidates", "1 to 16");
  require(c.field.grid == 0 || (c.field.grid >= 16 && c.field.grid <= 128), "field.grid", "16 to 128, or 0");
  require(c.learning_rate > 0 && std::isfinite(c.learning_rate), "learning_rate", "a number above 0");
  require(c.weight_decay >= 0, "weight_decay", "0 or more");
  require(c.momentum >= 0 && c.momentum < 1, "momentum", "0 or more and below 1");
  require(c.clip >= 0, "clip", "0 (off) or more");
  require(c.dropout >= 0 && c.dropout < 1, "dropout", "0 or more and below 1");
  require(c.feature_dropout >= 0 && c.feature_dropout < 1, "feature_dropout", "0 or more and below 1");
  require(c.loss_kl >= 0 && c.loss_l1 >= 0 && c.loss_regret >= 0 && c.loss_part >= 0 &&
              c.loss_kl + c.loss_l1 + c.loss_regret + c.loss_part > 0,
          "loss_kl, loss_l1, loss_regret, loss_part", "0 or more and not all 0");
  require(c.loss_deformation >= 0, "loss_deformation", "0 or more");
  require(c.steps >= 1, "steps", "1 or more");
  require(c.batch >= 1 && c.batch <= 64, "batch", "1 to 64");
  require(c.average_decay >= 0 && c.average_decay < 1, "average_decay", "0 (off) or more and below 1");
  require(c.correction > 0 && c.correction <= 1, "correction", "above 0, at most 1");
  require(c.init_share >= 0 && c.init_share < 1, "init_share", "from 0, below 1");
  require(c.validate_every >= 1, "validate_every", "1 or more");
  require(c.variants <= 64, "variants", "0 to 64");
  require(c.synthetic <= 1000, "synthetic", "0 to 1000");
  require(c.variant_share >= 0 && c.variant_share <= 1, "variant_share", "0 to 1");
  require(c.family_power >= 0 && c.family_power <= 2, "family_power", "0 to 2");
}

}  // namespace

uint32_t feature_flags(const TrainConfig& config) { return config.spectral ? kSpectralFlag : 0; }

TrainConfig parse_train_config(const std::string& json, const std::string& source) {
  Json root;
  try {
    root = Json::parse(json);
  } catch (const Json::parse_error& error) {
    throw Error(source + ": not JSON, byte " + std::to_string(error.byte));
  }
  if (!root.is_object()) throw Error(source + ": expected a JSON object");
  Json flat = Json::object();  // "field": {"width": 32} becomes "field.width": 32
  for (const auto& [key, value] : root.items()) {
    if (key != "field") {
      flat[key] = value;
    } else if (!value.is_object()) {
      throw Error(source + ": field: expected an object, found " + value.dump());
    } else {
      for (const auto& [inner, setting] : value.items()) flat["field." + inner] = setting;
    }
  }
  TrainConfig config;
  visit_settings(config, [&](const std::string& key, auto& setting) {
    const auto found = flat.find(key);
    if (found == flat.end()) return;
    read_value(*found, source + ": " + key, &setting);
    flat.erase(found);
  });
  if (!flat.empty()) throw Error(source + ": unknown key \"" + flat.begin().key() + "\"");
  check(config, source);
  return config;
}

std::string train_config_json(const TrainConfig& config) {
  Json root = Json::object();
  visit_settings(config, [&](const std::string& key, const auto& setting) {
    if (key.rfind("field.", 0) == 0) {
      root["field"][key.substr(6)] = setting;
    } else {
      root[key] = setting;
    }
  });
  return root.dump(2) + "\n";
}

}  // namespace sinew
