// SPDX-License-Identifier: MIT
// Upper bounds that every allocation of a bind is a function of.
#ifndef SINEW_CORE_COUNTS_HPP
#define SINEW_CORE_COUNTS_HPP

#include <stdint.h>

#include "sinew/sinew.h"

namespace sinew {

constexpr uint16_t kNoJoint = 0xFFFF;

// V, F, corners, J, K and the grid size of one bind. T (fan triangles) is at most corner_count - 2 * faces <= corner_count.
struct Counts {
  uint32_t vertices = 0;
  uint32_t faces = 0;
  uint32_t corners = 0;
  uint32_t joints = 0;
  uint32_t candidates = 8;
  uint32_t grid = 64;

  // Fan triangles: every face with n >= 3 corners gives n - 2; never more than corners.
  uint32_t triangles() const { return corners; }
};

// Progress shared by the stages; report() returns false when the caller wants to stop.
struct Progress {
  sinew_progress callback = nullptr;
  void* user = nullptr;
  bool report(uint32_t permille) const { return callback == nullptr || callback(user, permille) == 0; }
};

}  // namespace sinew
#endif
