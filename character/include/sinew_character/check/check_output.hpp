// SPDX-License-Identifier: MIT
// Checks of files as text, JSON (formats/spec/check.md) and SARIF, and the profile that a gate holds them against.
#ifndef SINEW_CHARACTER_CHECK_OUTPUT_HPP
#define SINEW_CHARACTER_CHECK_OUTPUT_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew_character/check/check.hpp"

namespace sinew {

// What `sinew check` does with one file.
struct CheckedFile {
  std::string file;
  Character character;
  Motion motion;  // its clips; none without animations
  RigCheck check;
  std::optional<RigCheck> before;  // of the older version
  std::vector<Joint> joints_before;
  CheckChange change;                 // with `before`
  std::vector<std::string> failures;  // of a gate, one line each
  std::optional<double> score;        // weight_score(), if requested
};

// Reads and checks a mesh with its skeleton, weights and animations. Throws Error.
CheckedFile check_file(const std::string& path, const CheckOptions& options);
// Compares with an older version of the file. Throws Error.
void check_against(const std::string& path, const CheckOptions& options, CheckedFile* file);

// 0..100: how near the weights are to those of the bundled model, the heat method and the nearest bone, among joints that names and positions let have weight: 100 less
// half of the mean L1 difference, in percent. Binds on which methods disagree, or that no method would make, get less. Of weights that were
// made by a program; an artist's own style of weighting costs points without being worse. Throws Error.
double weight_score(const Character& character);

// Limits of a pipeline.
struct CheckGate {
  size_t most_errors = 0, most_warnings = 0, most_notes = SIZE_MAX;
  std::vector<std::string> ignored;      // rules whose findings do not count
  std::map<std::string, double> bounds;  // of rules, for CheckOptions
};
// JSON: {"sinew_check": 1, "most": {"error": 0, "warning": 0}, "ignore": ["crossing"], "bounds": {"tear": 0.01}}; what is left out is as above.
// Throws Error with the file and the member.
CheckGate read_check_gate(const std::string& path);
// One line for each kind of which there are too many; with an older version only what is new counts.
std::vector<std::string> check_failures(const CheckGate& gate, const CheckedFile& file);

std::string check_text(const CheckedFile& file);                 // lines, the last one without '\n'
std::string check_json(const CheckedFile& file);                 // one line
std::string check_sarif(const std::vector<CheckedFile>& files);  // SARIF 2.1.0
// "posed: elbows and knees bent by 90 degrees", "clip 'walk' at 0.53 s", "" for one at rest.
std::string where_shown(const RigFinding& finding);

// The character as a finding's test pose or clip has it; itself at rest.
Character as_shown(const CheckedFile& file, const RigFinding& finding);

}  // namespace sinew
#endif
