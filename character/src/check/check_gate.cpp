// SPDX-License-Identifier: MIT
// Profiles of gates.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "sinew_character/check/check_output.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

using GateJson = nlohmann::json;

[[noreturn]] void refuse(const std::string& path, const std::string& member, const std::string& expected) {
  throw Error(path + ": " + member + ": expected " + expected);
}

size_t count_at(const std::string& path, const std::string& member, const GateJson& json) {
  if (!json.is_number_unsigned()) refuse(path, member, "a number of findings, 0 or more");
  return json.get<size_t>();
}

void read_most(const std::string& path, const GateJson& json, CheckGate* gate) {
  if (!json.is_object()) refuse(path, "most", "an object: {\"error\": 0, \"warning\": 0, \"note\": 5}");
  for (const auto& [kind, count] : json.items()) {
    if (kind == "error")
      gate->most_errors = count_at(path, "most.error", count);
    else if (kind == "warning")
      gate->most_warnings = count_at(path, "most.warning", count);
    else if (kind == "note")
      gate->most_notes = count_at(path, "most.note", count);
    else
      refuse(path, "most." + kind, "error, warning or note");
  }
}

void read_bounds(const std::string& path, const GateJson& json, CheckGate* gate) {
  if (!json.is_object()) refuse(path, "bounds", "an object of numbers by rule");
  for (const auto& [rule, bound] : json.items()) {
    check_rule(rule);
    if (!bound.is_number()) refuse(path, "bounds." + rule, "a number");
    gate->bounds[rule] = bound.get<double>();
  }
}

}  // namespace

CheckGate read_check_gate(const std::string& path) {
  const std::string text = read_text_file(path);
  const GateJson json = GateJson::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw Error(path + ": expected a profile, a JSON object with \"sinew_check\": 1");
  if (!json.contains("sinew_check") || json["sinew_check"] != 1)
    refuse(path, "sinew_check", "1, the version of the profile");
  CheckGate gate;
  try {
    for (const auto& [member, value] : json.items()) {
      if (member == "most") {
        read_most(path, value, &gate);
      } else if (member == "bounds") {
        read_bounds(path, value, &gate);
      } else if (member == "ignore") {
        if (!value.is_array()) refuse(path, "ignore", "a list of rules");
        for (const GateJson& rule : value) {
          if (!rule.is_string()) refuse(path, "ignore", "a list of rules");
          gate.ignored.push_back(check_rule(rule.get<std::string>()).name);
        }
      } else if (member != "sinew_check") {
        refuse(path, member, "sinew_check, most, bounds or ignore");
      }
    }
  } catch (const Error& error) {
    const std::string line = error.what();
    if (line.rfind(path, 0) == 0) throw;
    throw Error(path + ": " + line);
  }
  return gate;
}

std::vector<std::string> check_failures(const CheckGate& gate, const CheckedFile& file) {
  size_t counts[3] = {};
  const auto& findings = file.check.findings;
  for (size_t i = 0; i < findings.size(); ++i) {
    const bool old =
        file.before && std::find(file.change.added.begin(), file.change.added.end(), i) == file.change.added.end();
    const bool ignored =
        std::find(gate.ignored.begin(), gate.ignored.end(), findings[i].rule->name) != gate.ignored.end();
    if (!old && !ignored) ++counts[static_cast<size_t>(findings[i].severity)];
  }
  std::vector<std::string> failures;
  const size_t most[3] = {gate.most_notes, gate.most_warnings, gate.most_errors};
  for (size_t kind = 3; kind-- > 0;)
    if (counts[kind] > most[kind])
      failures.push_back(
          print("%zu %ss, more than %zu", counts[kind], severity_text(static_cast<CheckSeverity>(kind)), most[kind]));
  return failures;
}

}  // namespace sinew
