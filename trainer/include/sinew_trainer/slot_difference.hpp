// SPDX-License-Identifier: MIT
// The published method's two networks on their way to integers, and how far joints and connections lie from float's.
#ifndef SINEW_TRAINER_SLOT_DIFFERENCE_HPP
#define SINEW_TRAINER_SLOT_DIFFERENCE_HPP

#include <string>

#include "sinew/sinew.h"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// One for each of a checkpoint's networks, which become a file's two.
struct SlotNetworks {
  FloatNetwork joints, connections;
  Calibration joint_ranges, connection_ranges;
};
// Ranges over a folder's characters, at most `limit` of them spread evenly (0 = all). Those that fail are left out; Error when
// none is left.
//   both  of the architecture slots
SlotNetworks calibrate_slots(const FloatNetwork& both, const std::string& folder, size_t limit);

struct SlotDifference {
  size_t characters = 0;
  double mean = 0, most = 0;  // of joints that are there, shares of the longest side
  double same_presence = 0;   // share of slots that hold a joint by both or by neither
  double same_connections =
      0;  // share of pairs of joints that more likely than not hang together by both or by neither
};
//   model  of calibrate_slots(), quantised and opened by sinew_rig_model_open()
SlotDifference compare_slots(const FloatNetwork& both, const sinew_model& model, const std::string& folder,
                             size_t limit);

}  // namespace sinew
#endif
