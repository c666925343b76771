// SPDX-License-Identifier: MIT
// Findings as rules make them: what is not above its bound is dropped.
#ifndef SINEW_CHARACTER_CHECK_FINDINGS_HPP
#define SINEW_CHARACTER_CHECK_FINDINGS_HPP

#include <string>
#include <utility>
#include <vector>

#include "sinew_character/check/check.hpp"

namespace sinew {

// The value of name-order where a joint hangs on another limb; 1 within a limb.
constexpr double kOtherLimb = 2;

class Findings {
 public:
  Findings(const Character& character, const CheckOptions& options);

  // Above which a rule's values are findings.
  double bound(const char* rule) const;

  // `finding.value` and what else it has is set; the rule's name, bound and severity are set here, as is where to look: around its
  // vertices, or at its joint.
  //   meant  artists do so on purpose, too: a note
  void add(const char* rule, RigFinding finding, bool meant = false);
  std::vector<RigFinding>& all() { return findings_; }  // in the order in which they were added
  // Errors first.
  RigCheck take();

  const std::string& name_of(int joint) const;
  // "'LeftHand'".
  std::string quoted(int joint) const;
  double size() const { return size_; }  // the mesh's longest side; of a skeleton alone the skeleton's

 private:
  int mesh_of(const std::vector<uint32_t>& vertices) const;
  const Character& character_;
  const CheckOptions options_;  // a copy: callers pass a temporary
  double size_ = 1;
  std::vector<RigFinding> findings_;
};

// "12, 40, 41, ...", of five at most.
std::string first_of(const std::vector<uint32_t>& numbers);
// "1 vertex", "3 vertices".
std::string vertices_text(size_t count);

}  // namespace sinew
#endif
