// SPDX-License-Identifier: MIT
// Reads settings from JSON, and checks those that all runs have.
#include "run/settings.hpp"

#include <cmath>

namespace sinew {

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
void read_value(const Json& value, const std::string& where, std::map<std::string, double>* out) {
  if (!value.is_object()) throw Error(where + ": expected an object, name to number, found " + value.dump());
  out->clear();
  for (const auto& [name, number] : value.items()) read_value(number, where + ": " + name, &(*out)[name]);
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

Json read_flat_object(const std::string& json, const std::string& source, const std::string& group) {
  Json root;
  try {
    root = Json::parse(json);
  } catch (const Json::parse_error& error) {
    throw Error(source + ": not JSON, byte " + std::to_string(error.byte));
  }
  if (!root.is_object()) throw Error(source + ": expected a JSON object");
  Json flat = Json::object();
  for (const auto& [key, value] : root.items()) {
    if (group.empty() || key != group) {
      flat[key] = value;
    } else if (!value.is_object()) {
      throw Error(source + ": " + group + ": expected an object, found " + value.dump());
    } else {
      for (const auto& [inner, setting] : value.items()) flat[group + "." + inner] = setting;
    }
  }
  return flat;
}

void check_run_settings(const RunConfig& c, const Requirement& require) {
  require(c.optimizer == "adamw" || c.optimizer == "adam" || c.optimizer == "sgd", "optimizer",
          "\"adamw\", \"adam\" or \"sgd\"");
  require(c.learning_rate > 0 && std::isfinite(c.learning_rate), "learning_rate", "a number above 0");
  require(c.weight_decay >= 0, "weight_decay", "0 or more");
  require(c.momentum >= 0 && c.momentum < 1, "momentum", "0 or more and below 1");
  require(c.clip >= 0, "clip", "0 (off) or more");
  require(c.dropout >= 0 && c.dropout < 1, "dropout", "0 or more and below 1");
  require(c.feature_dropout >= 0 && c.feature_dropout < 1, "feature_dropout", "0 or more and below 1");
  require(c.feature_noise >= 0 && c.feature_noise <= 1, "feature_noise", "0 to 1");
  require(c.steps >= 1, "steps", "1 or more");
  require(c.batch >= 1 && c.batch <= 64, "batch", "1 to 64");
  require(c.average_decay >= 0 && c.average_decay < 1, "average_decay", "0 (off) or more and below 1");
  require(c.init_share >= 0 && c.init_share < 1, "init_share", "from 0, below 1");
  require(c.validate_every >= 1, "validate_every", "1 or more");
  require(c.stop_below >= 0 && std::isfinite(c.stop_below), "stop_below", "0 (off) or more");
  require(c.variant_share >= 0 && c.variant_share <= 1, "variant_share", "0 to 1");
  require(c.family_power >= 0 && c.family_power <= 2, "family_power", "0 to 2");
  double shares = 0;
  for (const auto& [name, share] : c.family_shares) {
    require(share >= 0, "family_shares", "shares of 0 or more");
    shares += share;
  }
  require(shares < 1, "family_shares", "shares that leave something for the other families");
}

bool is_left_out(const std::map<std::string, std::string>& leave_out, const std::string& name) {
  for (const auto& [pattern, reason] : leave_out) {
    const bool prefix = !pattern.empty() && pattern.back() == '*';
    if (prefix ? name.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0 : name == pattern)
      return true;
  }
  return false;
}

}  // namespace sinew
