// SPDX-License-Identifier: MIT
// The parts of a check, in the order in which check_rig() asks them.
#ifndef SINEW_CHARACTER_CHECK_CHECK_ROOMS_HPP
#define SINEW_CHARACTER_CHECK_CHECK_ROOMS_HPP

#include "check/findings.hpp"
#include "check/rig_facts.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

void check_rows(const RigFacts& facts, Findings* findings);           // sums, rows without weight, long rows, cracks
void check_stray_weights(const RigFacts& facts, Findings* findings);  // weight where it does not belong
void check_joints(const RigFacts& facts, Findings* findings);         // outside, without length, without weight
void check_names(const RigFacts& facts,
                 Findings* findings);  // against the hierarchy, left against right, against positions
void check_symmetry(const RigFacts& facts, Findings* findings);  // joints and rows against their mirror images
void check_matrices(const RigFacts& facts, Findings* findings);  // of a glTF's skins
void check_poses(const RigFacts& facts, Findings* findings);     // test poses
void check_clips(const RigFacts& facts, const Motion& motion, Findings* findings);
void weigh_findings(const RigFacts& facts, Findings* findings);  // which of all that is there are notes

}  // namespace sinew
#endif
