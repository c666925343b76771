// SPDX-License-Identifier: MIT
// Findings as rules make them: what is not above its bound is dropped.
#ifndef SINEW_CHARACTER_CHECK_FINDINGS_HPP
#define SINEW_CHARACTER_CHECK_FINDINGS_HPP

#include <string>
#include <utility>
#include <vector>

#include "check/rig_facts.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Value of name-order for a joint whose parent is in another limb; 1 within a limb.
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

// The parts of a check, in the order in which check_rig() asks them.
void check_rows(const RigFacts& facts, Findings* findings);           // sums, rows without weight, long rows, cracks
void check_stray_weights(const RigFacts& facts, Findings* findings);  // weight where it does not belong
void check_joints(const RigFacts& facts, Findings* findings);         // outside, without length, without weight
void check_names(const RigFacts& facts,
                 Findings* findings);  // against the hierarchy, left against right, against positions
void check_symmetry(const RigFacts& facts, Findings* findings);       // joints and rows against their mirror images
void check_matrices(const RigFacts& facts, Findings* findings);       // of a glTF's skins
void check_spring_chains(const RigFacts& facts, Findings* findings);  // of the file
void check_poses(const RigFacts& facts, Findings* findings);          // test poses
void check_clips(const RigFacts& facts, const Motion& motion, Findings* findings);
void weigh_findings(const RigFacts& facts, Findings* findings);  // which of all that is there are notes

}  // namespace sinew
#endif
