// SPDX-License-Identifier: MIT
// The yardstick of predicted skeletons: how far they are from the target skeleton of a rigged character, and the
// report on them.
#ifndef SINEW_TRAINER_RIG_SCORE_HPP
#define SINEW_TRAINER_RIG_SCORE_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/draw/image.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/character.hpp"
#include "votes/joint_class.hpp"

namespace sinew {

// N joints, bone ends among them. Lengths in longest sides of the mesh.
struct ScoredSkeleton {
  std::vector<std::array<double, 3>> positions;
  std::vector<int> parents;                                 // -1 = root
  std::vector<std::optional<rigging::JointClass>> classes;  // nullopt: a detail
  std::vector<uint8_t> tips;                                // 1: a bone end
};
ScoredSkeleton scored_skeleton(const TargetSkeleton& target);
// As a file says it: classes by names, and a leaf called NAME_end or NAME_tip is a bone end. `side` is the mesh's.
ScoredSkeleton scored_skeleton(const std::vector<Joint>& joints, double side);

// Scores of one character, or means over several. All joints count, bone ends too. NaN: there was nothing to count.
struct RigScore {
  double j2j =
      0;  // mean of the distances from predicted to nearest reference joints and from reference to nearest predicted joints
  double j2b = 0;  // the same from joints to points on the other's bones, which are 0.005 apart
  double b2b = 0;  // the same from points on bones to points on bones
  // Pairs of predicted and reference joints, one to one, at most 0.05 apart: as many as can be, as near as can be.
  double precision = 0, recall = 0, iou = 0;  // pairs over predicted joints, over reference joints, over their mean
  double joined = 0;     // share of reference bones between paired joints whose joints are connected in the prediction,
                         // through unpaired joints at most
  double classes = 0;    // share of pairs without bone ends whose classes agree
  double symmetric = 0;  // 1 where every predicted joint has a mirror image, within 2e-6, about the middle of them all
};
// Its figures, in the order and by the names of the yardstick.
struct RigFigure {
  const char* key;
  double RigScore::*value;
};
inline constexpr std::array<RigFigure, 9> kRigFigures = {{{"J2J", &RigScore::j2j},
                                                          {"J2B", &RigScore::j2b},
                                                          {"B2B", &RigScore::b2b},
                                                          {"precision", &RigScore::precision},
                                                          {"recall", &RigScore::recall},
                                                          {"IoU", &RigScore::iou},
                                                          {"joined", &RigScore::joined},
                                                          {"class", &RigScore::classes},
                                                          {"symmetric", &RigScore::symmetric}}};

// The reference joint paired with every predicted joint, -1 = none.
std::vector<int> pair_joints(const ScoredSkeleton& predicted, const ScoredSkeleton& reference);
// Same figures as rig_eval.py. Throws Error where either has no joints.
RigScore score_rig(const ScoredSkeleton& predicted, const ScoredSkeleton& reference);

// A reference with head, arms and legs of two bones, and no tail.
bool is_humanoid(const ScoredSkeleton& reference);
// Reasons why a skeleton cannot be retargeted, one line each; empty = complete. Of the 15 bones that every humanoid
// has, pelvis, spine and head must be in the middle (0.01), upper arm, forearm, hand, thigh, calf and foot once on
// each side, each below the one before, and a pelvis must be the root. x points left; the middle is that of a
// symmetric skeleton, of others where the root is.
std::vector<std::string> humanoid_gaps(const ScoredSkeleton& skeleton);

// A skeleton and the weights that a bind to it gave, in a character whose artist's weights are known.
struct BoundSkeleton {
  const std::vector<Joint>& joints;
  const std::vector<uint8_t>& classes;                    // [J] JointClass; a bone end's is its joint's
  const std::vector<std::vector<Influence>>& influences;  // [V]
  int axis = 0;                                           // across the mirror plane: 0 = x, 2 = z
  double plane = 0;                                       // where it is, the mesh's units
};
// Share of the surface, 0..1, whose strongest joint has the class and the side of the reference's: in the middle (0.01 of
// the longest side), left or right. A target skeleton's details count as what they belong to.
double owned_surface(const BoundSkeleton& bound, const Character& character, const TargetSkeleton& reference);

struct RigScores {
  std::vector<std::pair<std::string, RigScore>> characters;  // by name
  std::map<std::string, RigScore> families;                  // mean of each family's characters
  std::map<std::string, size_t> family_sizes;
  RigScore all, family_mean;                                  // means over characters, over families
  std::map<std::string, std::string> failures;                // name -> one line
  std::map<std::string, std::vector<std::string>> humanoids;  // references that are one -> gaps of the prediction
  std::map<std::string, double> owned;                        // owned_surface() of those that were bound
};
// Fills all but failures, humanoids and owned.
RigScores summarize(std::vector<std::pair<std::string, RigScore>> characters);
// The table of the yardstick, times 100, as Markdown; JSON with every number as it is, null for NaN.
std::string rig_scores_markdown(const RigScores& scores);
std::string rig_scores_json(const RigScores& scores);

struct RigReportPicture {
  std::string character;                      // name, as in RigScores::characters
  std::vector<uint8_t> reference, predicted;  // PNG: the mesh with either skeleton, from the same side
};
// Both skeletons in the character's mesh, `side` pixels high.
RigReportPicture rig_report_picture(const Character& character, const TargetSkeleton& reference,
                                    const std::vector<Joint>& predicted, int side = 300);

struct RigReport {
  std::string title = "sinew: skeletons";
  RigScores scores;
  std::vector<RigReportPicture> pictures;
  std::vector<std::pair<std::string, std::string>> facts;  // how the numbers were made: term, fact
};
// The whole page; characters from the worst J2J to the best. The same report gives the same bytes.
std::string rig_report_html(const RigReport& report);

}  // namespace sinew
#endif
