// SPDX-License-Identifier: MIT
// Checks a rig: findings about weights, joints, names, matrices, test poses and clips of one character, without a
// reference.
#ifndef SINEW_CHARACTER_CHECK_HPP
#define SINEW_CHARACTER_CHECK_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

enum class CheckSeverity : uint8_t { kNote, kWarning, kError };
const char* severity_text(CheckSeverity severity);  // "note", "warning", "error"

// A rule. The table in check/rules.cpp has a row for each.
struct CheckRule {
  const char* name;        // "left-right"
  CheckSeverity severity;  // severity of its findings
  bool cheap;              // checked after every job; other rules pose the mesh
  double bound;            // findings have values above it
  const char* value;       // meaning of the value
  const char* title;       // one line
  const char* cure;        // one line: the remedy
};
const std::vector<CheckRule>& check_rules();
// Throws Error that lists the rules.
const CheckRule& check_rule(const std::string& name);

// One fault.
struct RigFinding {
  const CheckRule* rule = nullptr;
  CheckSeverity severity = CheckSeverity::kNote;
  int joint = -1, other = -1;      // joint of the finding, and joint for comparison; -1: none
  std::vector<uint32_t> vertices;  // ascending; empty for a finding about joints or clips
  int mesh = -1;                   // index into Character::meshes if all of them are in one mesh
  Vec3 position;                   // position of the finding, in the mesh's units
  double radius = 0;               // radius around the position
  double value = 0, bound = 0;     // as CheckRule has them
  std::string pose;                // test pose in which it shows; empty: at rest
  std::string clip;                // animation in which it shows; empty: none
  double seconds = 0;              // in the clip
  std::string what;                // one line, without the character's name
};

struct CheckOptions {
  bool poses = true;                     // also poses the mesh, which takes 50 times as long as the rest
  std::map<std::string, double> bounds;  // by rule, instead of those of the table
};

struct RigCheck {
  std::vector<RigFinding> findings;  // errors first, then warnings, then notes; within them in the rules' order
  size_t errors = 0, warnings = 0, notes = 0;
};

// Checks a character with joints; without weights only the skeleton. Findings are the same on every machine.
//   motion  its clips, whose first joints are the character's; or null
// Throws Error for a character without joints, with a hierarchy that has a cycle, or with positions or weights that are not finite.
RigCheck check_rig(const Character& character, const Motion* motion, const CheckOptions& options = {});

// Runs only cheap rules, for the end of a job. Returns "checked: 0 findings", or the number of findings and their
// rules.
std::string checked_line(const RigCheck& check);

// Findings of the second version that the first one does not have, and vice versa. Findings are equal if rule, joints
// (by name), pose and clip are.
struct CheckChange {
  std::vector<size_t> added;    // of `now`
  std::vector<size_t> removed;  // of `before`
};
CheckChange check_change(const RigCheck& before, const std::vector<Joint>& joints_before, const RigCheck& now,
                         const std::vector<Joint>& joints_now);

// checked_line() of what is cheap; "" for a character without joints or weights.
std::string checked_note(const Character& character, const Motion* motion = nullptr);
// The same as a note of the character.
void add_checked_note(Character* character);

}  // namespace sinew
#endif
