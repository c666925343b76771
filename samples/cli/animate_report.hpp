// SPDX-License-Identifier: MIT
// Options of sinew animate, and its report.
#ifndef SINEW_CLI_ANIMATE_REPORT_HPP
#define SINEW_CLI_ANIMATE_REPORT_HPP

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "option_groups.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/jobs/vat_job.hpp"

namespace sinew::cli {

struct AnimateSettings : AnimateOptions {
  std::string output, up_name = "auto", motion_up_name = "auto", sheet, vat, layout, actor;
  std::string format = "glb";
  std::vector<std::string> motions;
  DeformSettings deform;
  PictureOptions picture;
  SpriteSettings sprites;
  ProfileSettings profile;
  size_t shapes = 16;
  uint32_t area_power = 3;
  double falloff = 0.05;
  bool own_limb = false, legs = false, head = false, torso = false, source_points = false;
  bool json = false, depth = false, springs = false;
};

struct Animated : AnimatedCharacter {
  std::optional<PictureCharacter> picture = {};  // what it was made of
  std::optional<VatResult> vat = {};             // with --vat
};

nlohmann::ordered_json animate_json(const AnimateSettings& settings, const Animated& animated);
// On standard output.
void tell_animated(const AnimateSettings& settings, const Animated& animated);

}  // namespace sinew::cli
#endif
