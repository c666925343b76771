// SPDX-License-Identifier: MIT
// Style files: JSON in, JSON out (formats/spec/style.md).
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sinew_character/bind/answers.hpp"
#include "sinew_character/style/style.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

uint16_t kind_of(const std::string& name) {
  const std::vector<std::string>& names = answer_names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error("unknown answer \"" + name + "\"");
  return static_cast<uint16_t>(at - names.begin());
}

double share(const Json& json, const char* key) {
  const double value = json.at(key).get<double>();
  if (!(value >= 0 && value <= 2)) throw Error(std::string(key) + " is out of range");
  return value;
}

// A joint may stand outside of the mesh.
std::array<double, 3> position(const Json& json, const char* key) {
  const auto value = json.at(key).get<std::array<double, 3>>();
  for (const double x : value)
    if (!(x >= -1e6 && x <= 1e6)) throw Error(std::string(key) + " is out of range");
  return value;
}

// C libraries differ in the last digit of a hypot().
double rounded(double value) { return std::round(value * 1e6) / 1e6; }
Json rounded(const std::array<double, 3>& position) {
  return {rounded(position[0]), rounded(position[1]), rounded(position[2])};
}

StyleRule rule_of(const Json& json) {
  StyleRule rule;
  rule.kind = kind_of(json.at("answer").get<std::string>());
  if (rule.kind == SINEW_ANSWER_RIGID) {
    rule.joint = json.at("joint").get<std::string>();
    rule.steps_up = json.value("steps_up", -1);
    rule.joint_position = position(json, "joint_place");
  }
  const Json& part = json.at("part");
  rule.part.body = part.value("body", false);
  rule.part.size = share(part, "size");
  rule.part.radius = share(part, "radius");
  rule.part.position = position(part, "place");
  rule.part.joint = part.at("joint").get<std::string>();
  return rule;
}

}  // namespace

Style read_style(const std::string& path) {
  const std::string text = read_text_file(path);
  try {
    const Json json = Json::parse(text);
    const int version = json.at("sinew_style").get<int>();
    if (version != kVersion) throw Error("version " + std::to_string(version) + ", expected version 1");
    Style style;
    for (const Json& one : json.at("characters")) {
      StyleSheet sheet;
      for (const Json& joint : one.at("joints"))
        sheet.joints.emplace_back(joint.at("name").get<std::string>(), position(joint, "place"));
      for (const Json& rule : one.at("rules")) sheet.rules.push_back(rule_of(rule));
      style.sheets.push_back(std::move(sheet));
    }
    return style;
  } catch (const Json::exception& error) {
    throw Error(path + ": expected a style file (JSON as written by sinew bind --save-style): " + error.what());
  } catch (const Error& error) {
    throw Error(path + ": unsupported style file: " + error.what());
  }
}

void write_style(const std::string& path, const Style& style) {
  Json json = {{"sinew_style", kVersion}, {"characters", Json::array()}};
  for (const StyleSheet& sheet : style.sheets) {
    Json rules = Json::array();
    for (const StyleRule& rule : sheet.rules) {
      Json one = {{"answer", answer_names()[rule.kind]}};
      if (rule.kind == SINEW_ANSWER_RIGID) {
        one["joint"] = rule.joint;
        one["steps_up"] = rule.steps_up;
        one["joint_place"] = rounded(rule.joint_position);
      }
      one["part"] = {{"body", rule.part.body},
                     {"size", rounded(rule.part.size)},
                     {"radius", rounded(rule.part.radius)},
                     {"place", rounded(rule.part.position)},
                     {"joint", rule.part.joint}};
      rules.push_back(std::move(one));
    }
    Json joints = Json::array();
    for (const auto& [name, at] : sheet.joints) joints.push_back({{"name", name}, {"place", rounded(at)}});
    json["characters"].push_back({{"joints", std::move(joints)}, {"rules", std::move(rules)}});
  }
  write_text_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace sinew
