// SPDX-License-Identifier: MIT
// Placements from the command line.
#include "placement_options.hpp"

#include "options.hpp"

namespace sinew::cli {

void add_placement_options(CLI::App* sub, Placement* placement) {
  section(sub, "Where the mesh is, before anything else");
  sub->add_option("--turn", placement->turns,
                  "A quarter turn about an axis, x brings y to z; may be repeated, one after the other")
      ->type_name("AXIS")
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  sub->add_option("--height", placement->height, "Scaled to be so tall, along y, with --up z along z")
      ->type_name("METRES")
      ->check(CLI::PositiveNumber);
  sub->add_flag("--floor", placement->floor, "The lowest vertex at 0");
}

}  // namespace sinew::cli
