// SPDX-License-Identifier: MIT
// Settings as JSON: every key optional, unknown keys and wrong types refused by name. One list of settings serves reading and
// writing: a function that calls visit(key, field) for each.
#ifndef SINEW_TRAINER_RUN_SETTINGS_HPP
#define SINEW_TRAINER_RUN_SETTINGS_HPP

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sinew_formats/error.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

using Json = nlohmann::ordered_json;

void read_value(const Json& value, const std::string& where, std::string* out);
void read_value(const Json& value, const std::string& where, bool* out);
void read_value(const Json& value, const std::string& where, double* out);
void read_value(const Json& value, const std::string& where, std::vector<std::string>* out);
void read_value(const Json& value, const std::string& where, std::map<std::string, std::string>* out);
void read_value(const Json& value, const std::string& where, std::map<std::string, double>* out);
void read_value(const Json& value, const std::string& where, uint64_t* out);
void read_value(const Json& value, const std::string& where, uint32_t* out);

// The object in a text, with {group: {"width": 32}} as "group.width": 32. Throws Error.
Json read_flat_object(const std::string& json, const std::string& source, const std::string& group);

template <class VisitAll>
void read_settings(const std::string& json, const std::string& source, const std::string& group, VisitAll&& visit_all) {
  Json flat = read_flat_object(json, source, group);
  visit_all([&](const std::string& key, auto& setting) {
    const auto found = flat.find(key);
    if (found == flat.end()) return;
    read_value(*found, source + ": " + key, &setting);
    flat.erase(found);
  });
  if (!flat.empty()) throw Error(source + ": unknown key \"" + flat.begin().key() + "\"");
}

template <class VisitAll>
std::string write_settings(const std::string& group, VisitAll&& visit_all) {
  Json root = Json::object();
  visit_all([&](const std::string& key, const auto& setting) {
    if (!group.empty() && key.rfind(group + ".", 0) == 0) {
      root[group][key.substr(group.size() + 1)] = setting;
    } else {
      root[key] = setting;
    }
  });
  return root.dump(2) + "\n";
}

// Throws Error where a setting is not what it has to be.
struct Requirement {
  const std::string& source;
  void operator()(bool good, const char* key, const char* expected) const {
    if (!good) throw Error(source + ": " + key + ": expected " + expected);
  }
};
// The settings that every run has.
template <class Config, class Visitor>
void visit_run_settings(Config& c, Visitor&& visit) {
  visit("optimizer", c.optimizer);
  visit("learning_rate", c.learning_rate);
  visit("weight_decay", c.weight_decay);
  visit("momentum", c.momentum);
  visit("clip", c.clip);
  visit("dropout", c.dropout);
  visit("feature_dropout", c.feature_dropout);
  visit("feature_noise", c.feature_noise);
  visit("steps", c.steps);
  visit("batch", c.batch);
  visit("seed", c.seed);
  visit("average_decay", c.average_decay);
  visit("init_share", c.init_share);
  visit("validate_every", c.validate_every);
  visit("patience", c.patience);
  visit("stop_below", c.stop_below);
  visit("variant_share", c.variant_share);
  visit("family_power", c.family_power);
  visit("family_shares", c.family_shares);
}
void check_run_settings(const RunConfig& config, const Requirement& require);
// Whether a configuration's list of characters that are not trained on has the name; a * at an entry's end represents any rest.
bool is_left_out(const std::map<std::string, std::string>& leave_out, const std::string& name);

}  // namespace sinew
#endif
