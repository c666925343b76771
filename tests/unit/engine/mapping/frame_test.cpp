// SPDX-License-Identifier: MIT
// A rig's mirror plane and partners, wherever it stands and however it is turned.
#include "mapping/frame.hpp"

#include <utility>

#include "small_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapFrame, PartnersAreFoundAcrossThePlane) {
  for (const bool sideways : {false, true}) {
    SmallRig small;
    for (size_t i = 0; i < small.positions.size(); i += 3) {
      small.positions[i] += 5;  // off the origin
      if (sideways) std::swap(small.positions[i], small.positions[i + 2]);
    }
    ASSERT_EQ(small.build(), SINEW_OK);
    Frame frame;
    ASSERT_TRUE(frame.allocate(small.arena, 7));
    const Point up = {0, 1, 0};
    ASSERT_TRUE(find_frame(small.rig, &up, small.arena, &frame));
    const double side = sideways ? frame.across.z : frame.across.x;
    EXPECT_NEAR(side < 0 ? -side : side, 1, 1e-9);
    EXPECT_NEAR(frame.plane * side, 5, 1e-6);
    EXPECT_EQ(frame.mate[3], 5);
    EXPECT_EQ(frame.mate[6], 4);
    EXPECT_GT(frame.symmetry, 3);
  }
}

}  // namespace
}  // namespace sinew::mapping
