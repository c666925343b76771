// SPDX-License-Identifier: MIT
#include "animate_report.hpp"

#include <cstdio>

#include "animate_vat.hpp"
#include "options.hpp"
#include "support.hpp"

namespace sinew::cli {

using Json = nlohmann::ordered_json;

namespace {

Json limb_json(const sinew_limb_quality& limb) {
  return {{"deep_frames", limb.deep_frames},       {"depth", limb.depth}, {"greatest_depth", limb.greatest_depth},
          {"contact_frames", limb.contact_frames}, {"error", limb.error}, {"greatest_error", limb.greatest_error},
          {"range_frames", limb.range_frames}};
}

// A line a limb: copied, then as the method left it.
void tell_report(const Character& character, const ClipReport& report) {
  if (report.before.empty()) std::printf("  no arms or legs to measure\n");
  for (size_t i = 0; i < report.before.size(); ++i) {
    const sinew_limb_quality &a = report.before[i], &b = report.after[i];
    const auto percent = [](float share) { return 100 * static_cast<double>(share); };
    const bool leg = a.leg != 0;
    std::printf("  %s: %s in %u of %u frames -> %u, at most %.2f %% of the height -> %.2f",
                printable(character.joints[a.joint].name).c_str(), leg ? "under the floor" : "in the body",
                a.deep_frames, a.frames, b.deep_frames, percent(a.greatest_depth), percent(b.greatest_depth));
    if (a.contact_frames > 0)
      std::printf("; %s in %u, %s %.3f %% -> %.3f", leg ? "stands" : "touches", a.contact_frames,
                  leg ? "slides a frame" : "distance off by", percent(a.error), percent(b.error));
    if (a.range_frames + b.range_frames > 0)
      std::printf("; %s out of range in %u -> %u", leg ? "knee" : "elbow", a.range_frames, b.range_frames);
    std::printf("\n");
  }
}

}  // namespace

Json animate_json(const AnimateSettings& s, const Animated& animated) {
  Json json = {{"sinew_animate", 1}};
  json["character"] = s.character;
  if (!s.output.empty()) json["output"] = s.output;
  json["joints"] = animated.character.joints.size();
  json["rigged"] = animated.rigged;
  if (animated.picture) json["picture"] = picture_json(*animated.picture);
  for (const AnimatedClip& one : animated.animated_clips) {
    json["clips"].push_back({{"motion", one.file},
                             {"name", one.clip},
                             {"frames", one.frames},
                             {"fps", 1 / one.frame_time},
                             {"mapped", one.mapped},
                             {"map", one.map}});
    for (size_t i = 0; i < one.report.before.size(); ++i)
      json["clips"].back()["report"].push_back({{"joint", animated.character.joints[one.report.before[i].joint].name},
                                                {"limb", one.report.before[i].leg != 0 ? "leg" : "arm"},
                                                {"before", limb_json(one.report.before[i])},
                                                {"after", limb_json(one.report.after[i])}});
    if (s.springs)
      json["clips"].back()["springs"] = {{"joints", one.springs.joints},
                                         {"loops", one.springs.loops},
                                         {"gap", one.springs.gap},
                                         {"passes", one.springs.passes}};
    if (one.swing)
      json["clips"].back()["springs"]["inside"] = {{"vertices", one.swing->vertices},
                                                   {"at_rest", one.swing->rigid.at_rest},
                                                   {"rigid", one.swing->rigid.share},
                                                   {"swung", one.swing->swung.share}};
    if (s.deform.method.empty() || s.output.empty()) continue;  // shapes are of the character's file
    json["clips"].back()["shapes"] = one.shapes;
    json["clips"].back()["error"] = {{"linear", one.error.linear}, {"baked", one.error.baked}};
  }
  if (animated.vat) json["vat"] = vat_json(s.vat, *animated.vat);
  json["notes"] = animated.motion.notes;
  return json;
}

void tell_animated(const AnimateSettings& s, const Animated& animated) {
  if (s.json) {
    std::printf("%s\n", json_line(animate_json(s, animated)).c_str());
    return;
  }
  const size_t joints = animated.character.joints.size();
  if (animated.rigged) std::printf("%s: rigged first, %zu joints\n", printable(s.character).c_str(), joints);
  for (const AnimatedClip& one : animated.animated_clips) {
    std::printf("%s, %s: %zu frames, %.4g per second; %zu of %zu joints mapped by %s\n", printable(one.file).c_str(),
                printable(one.clip).c_str(), one.frames, 1 / one.frame_time, one.mapped, joints,
                printable(one.map).c_str());
    if (s.report) tell_report(animated.character, one.report);
    if (s.springs)
      std::printf(one.springs.loops ? "  %zu joints swing; the loop closes within %.2f degrees after %zu passes\n"
                                    : "  %zu joints swing\n",
                  one.springs.joints, one.springs.gap, one.springs.passes);
    if (one.swing)
      std::printf("  %zu swinging vertices: %.2f %% enter the body, %.2f %% without springs\n", one.swing->vertices,
                  100 * one.swing->swung.share, 100 * one.swing->rigid.share);
  }
  for (const AnimatedClip& one : animated.animated_clips)
    if (!s.deform.method.empty() && !s.output.empty())
      std::printf("  %s: %zu shapes, %.3f %% of the size off the corrected poses, %.3f %% with linear skinning alone\n",
                  printable(one.clip).c_str(), one.shapes, 100 * one.error.baked, 100 * one.error.linear);
  for (const std::string& note : animated.motion.notes) std::printf("  %s\n", printable(note).c_str());
  if (animated.vat) tell_vat(s.vat, *animated.vat, s.in_place ? "" : " ; --in-place keeps it in place");
  if (!s.output.empty()) std::printf("wrote %s\n", printable(s.output).c_str());
}

}  // namespace sinew::cli
