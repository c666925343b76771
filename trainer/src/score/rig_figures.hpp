// SPDX-License-Identifier: MIT
// The figures of a rig score, in the order and by the names of the yardstick.
#ifndef SINEW_TRAINER_SCORE_RIG_FIGURES_HPP
#define SINEW_TRAINER_SCORE_RIG_FIGURES_HPP

#include <array>

#include "sinew_trainer/rig_score.hpp"

namespace sinew {

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

}  // namespace sinew
#endif
