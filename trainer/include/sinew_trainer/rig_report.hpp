// SPDX-License-Identifier: MIT
// The report on predicted skeletons: one HTML page with figures and a picture of every character.
#ifndef SINEW_TRAINER_RIG_REPORT_HPP
#define SINEW_TRAINER_RIG_REPORT_HPP

#include <string>
#include <utility>
#include <vector>

#include "sinew_character/draw/image.hpp"
#include "sinew_trainer/rig_score.hpp"

namespace sinew {

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
