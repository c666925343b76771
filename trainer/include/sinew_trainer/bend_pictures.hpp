// SPDX-License-Identifier: MIT
// Bends of a character before and after correction, for the report.
#ifndef SINEW_TRAINER_BEND_PICTURES_HPP
#define SINEW_TRAINER_BEND_PICTURES_HPP

#include "sinew_formats/base/box.hpp"
#include "sinew_trainer/report.hpp"

namespace sinew {

// Elbow, knee, hip and shoulder bent and wrist twisted, each as linear skinning shows it and with its volume kept: the joints of
// one side that names tell. A panel a joint; none where no name tells a joint.
ReportPicture bend_pictures(const Character& character, Axis up = Axis::kY, int side = 300);

}  // namespace sinew
#endif
