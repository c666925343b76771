// SPDX-License-Identifier: MIT
// A motion's file to clips of the character, as sinew animate makes them.
#include "player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sinew_character/motion_file.hpp"
#include "sinew_character/plane_motion.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {

using Json = nlohmann::ordered_json;

namespace {

const char* up_text(uint32_t up) { return up == 0 ? "y" : up == 1 ? "z" : "auto"; }

Json limb_json(const sinew_limb_measure& limb) {
  return {{"deep", limb.deep_frames}, {"contacts", limb.contact_frames}, {"depth", limb.depth}, {"error", limb.error}};
}

Json map_json(const MotionMap& map) {
  Json list = Json::array();
  for (size_t t = 0; t < map.sources.size(); ++t)
    list.push_back({{"source", map.sources[t]}, {"why", map_reason_text(map.reasons[t])}});
  return list;
}

Json joints_json(const Motion& motion) {
  Json list = Json::array();
  for (const MotionJoint& joint : motion.joints)
    list.push_back({{"name", joint.name}, {"parent", joint.parent}, {"end", joint.end}});
  return list;
}

}  // namespace

void Player::make(MotionMethod method, Opened* opened) {
  const auto at = opened->made.find(method);
  if (at != opened->made.end()) {
    opened->now = &at->second;
    return;
  }
  AnimateOptions options;
  options.character = opened->work.character.name;
  options.up = up_text(opened->up);
  options.pins = opened->pins;
  options.method = method == MotionMethod::kCopy              ? AnimateMethod::kCopy
                   : method == MotionMethod::kReferencePoints ? AnimateMethod::kReferencePoints
                   : opened->picture != nullptr               ? AnimateMethod::kAuto
                                                              : AnimateMethod::kContacts;
  options.report = options.force = true;  // what does not fit is told beside the map, where it can be mended
  AnimatedCharacter& work = opened->work;
  work.motion = motion_of(work.character.joints);
  work.made.clear();
  const MotionInput input = {opened->file, "", &opened->source, [opened] { return opened->body; }};
  const StepsOf steps = [](size_t) { return [] { return true; }; };
  if (opened->picture != nullptr)
    add_picture_motion(*opened->picture, false, options, input, steps, &work);
  else
    add_motion(options, input, steps, &work);
  opened->now = &opened->made.emplace(method, Made{std::move(work.motion), std::move(work.made)}).first->second;
}

Json Player::clips_json(const Opened& opened) {
  Json list = Json::array();
  for (size_t c = 0; c < opened.now->motion.clips.size(); ++c) {
    const Clip& clip = opened.now->motion.clips[c];
    const ClipReport& report = opened.now->clips[c].report;
    Json limbs = Json::array();
    for (size_t l = 0; l < report.before.size(); ++l)
      limbs.push_back({{"joint", report.before[l].joint},
                       {"leg", report.before[l].leg != 0},
                       {"before", limb_json(report.before[l])},
                       {"after", limb_json(report.after[l])}});
    list.push_back({{"name", clip.name},
                    {"frames", clip.frames.size()},
                    {"seconds", static_cast<double>(clip.frames.size() - 1) * clip.frame_time},
                    {"limbs", std::move(limbs)}});
  }
  return list;
}

Json Player::open(const std::string& file, const Character& character, std::shared_ptr<const PictureCharacter> picture,
                  uint32_t up, bool own, MotionMethod method, const std::vector<sinew_map_pin>& pins) {
  auto opened = std::make_unique<Opened>();
  MotionFile read = read_motion_for({file, 0, "", "", up == 1 ? "z" : "auto"}, map_rig_of(character));
  opened->source = std::move(read.motion);
  std::vector<Clip>& clips = opened->source.clips;
  clips.erase(std::remove_if(clips.begin(), clips.end(), [](const Clip& clip) { return clip.frames.empty(); }),
              clips.end());
  if (clips.empty()) throw Error(file + ": expected a motion, found a skeleton without frames");
  opened->file = file;
  opened->work.character = character;
  opened->picture = std::move(picture);
  if (read.whole) opened->body = body_of_motion(file);
  opened->pins = pins;
  opened->up = up;
  opened->own = own;
  make(method, opened.get());
  Json reply;
  reply["clips"] = clips_json(*opened);
  reply["joints"] = character.joints.size();
  const MotionMap& map = opened->work.map;
  reply["mapped"] = map.sources.size() - static_cast<size_t>(std::count(map.sources.begin(), map.sources.end(), -1));
  reply["how"] = map.how;
  reply["sourceJoints"] = joints_json(opened->source);
  reply["map"] = map_json(map);
  reply["notes"] = Json::array();
  for (std::string note : opened->now->motion.notes) {  // the page names the file itself
    const size_t at = note.find(file + ": ");
    if (at != std::string::npos) note.erase(at, file.size() + 2);
    reply["notes"].push_back(std::move(note));
  }
  open_ = std::move(opened);
  return reply;
}

Json Player::use(MotionMethod method) {
  if (!open_) throw Error("no motion is open");
  make(method, open_.get());
  return {{"clips", clips_json(*open_)}};
}

const Player::Opened& Player::opened(uint32_t clip) const {
  if (!open_ || clip >= open_->now->motion.clips.size()) throw Error("no motion is open");
  return *open_;
}

std::vector<Affine> Player::palette(uint32_t clip, double seconds) const {
  const Motion& motion = opened(clip).now->motion;
  return motion_palette(motion, frame_at(motion.clips[clip], seconds), motion.joints.size());
}

Json Player::spots(uint32_t clip, double seconds) const {
  const Made& made = *opened(clip).now;
  const Clip& one = made.motion.clips[clip];
  const ClipReport& report = made.clips[clip].report;
  const double last = static_cast<double>(one.frames.size() - 1);
  const auto frame = static_cast<size_t>(std::clamp(std::round(seconds / one.frame_time), 0.0, last));
  Json list = Json::array();
  if (report.spots.empty()) return list;
  for (size_t l = 0; l < report.after.size(); ++l) {
    const sinew_contact_spot& spot = report.spots[frame * SINEW_MAX_MOTION_LIMBS + l];
    if (spot.kind == SINEW_SPOT_NONE) continue;
    list.push_back({{"joint", report.after[l].joint},
                    {"kind", spot.kind},
                    {"place", {spot.position[0], spot.position[1], spot.position[2]}},
                    {"error", spot.error}});
  }
  return list;
}

}  // namespace sinew::web
