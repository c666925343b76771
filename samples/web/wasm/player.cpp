// SPDX-License-Identifier: MIT
// A motion's file to clips of the character, as sinew animate makes them.
#include "player.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sinew_character/motion/motion_file.hpp"
#include "sinew_character/picture/plane_motion.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {

using Json = nlohmann::ordered_json;

namespace {

MaybeAxis up_of(uint32_t up) { return up == 0 ? MaybeAxis(Axis::kY) : up == 1 ? MaybeAxis(Axis::kZ) : std::nullopt; }

Json limb_json(const sinew_limb_quality& limb) {
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

// What the joints take up in a clip, by axes: {is: [[least, most] x 3], around: the same, from the joints' middle in each frame}.
Json room_json(const Motion& motion, const Clip& clip, const std::vector<Joint>& rest) {
  std::array<std::array<double, 2>, 3> is, around;
  is.fill({1e30, -1e30});
  around = is;
  for (const MotionFrame& frame : clip.frames) {
    const std::vector<Affine> palette = motion_palette(motion, frame, rest.size());
    std::vector<std::array<double, 3>> places;
    std::array<double, 3> middle = {0, 0, 0};
    for (size_t j = 0; j < rest.size(); ++j) {
      const Vec3& p = rest[j].position;
      const auto at = transform_point(palette[j], p.x, p.y, p.z);
      places.push_back({at[0], at[1], at[2]});
      for (size_t i = 0; i < 3; ++i) middle[i] += at[i] / static_cast<double>(rest.size());
    }
    for (const auto& at : places)
      for (size_t i = 0; i < 3; ++i) {
        is[i] = {std::min(is[i][0], at[i]), std::max(is[i][1], at[i])};
        around[i] = {std::min(around[i][0], at[i] - middle[i]), std::max(around[i][1], at[i] - middle[i])};
      }
  }
  return {{"is", is}, {"around", around}};
}

// Notes from that number on; the page names the file itself.
std::vector<std::string> notes_from(const Motion& motion, size_t first, const std::string& file) {
  std::vector<std::string> notes(motion.notes.begin() + static_cast<std::ptrdiff_t>(first), motion.notes.end());
  for (std::string& note : notes) {
    const size_t at = note.find(file + ": ");
    if (at != std::string::npos) note.erase(at, file.size() + 2);
  }
  return notes;
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
  options.up = up_of(opened->up);
  options.method = method == MotionMethod::kCopy              ? AnimateMethod::kCopy
                   : method == MotionMethod::kReferencePoints ? AnimateMethod::kReferencePoints
                   : method == MotionMethod::kStream          ? AnimateMethod::kStream
                   : opened->picture != nullptr               ? AnimateMethod::kAuto
                                                              : AnimateMethod::kContacts;
  options.report = options.force = true;  // what does not fit is told beside the map, where it can be mended
  AnimatedCharacter& work = opened->work;
  work.motion = motion_of(work.character.joints);
  work.animated_clips.clear();
  Made made;
  for (size_t f = 0; f < opened->sources.size(); ++f) {
    Source& source = opened->sources[f];
    options.pins = source.pins;
    const size_t notes = work.motion.notes.size();
    Motion named = source.motion;
    name_clips(source.file, false, work.motion, &named);
    const MotionInput input = {source.file, "", &named, [&source] { return source.body; }};
    const StepsOf steps = [](size_t) { return [] { return true; }; };
    if (opened->picture != nullptr)
      add_picture_motion(*opened->picture, false, options, input, steps, &work);
    else
      add_motion(options, input, steps, &work);
    made.files.resize(work.motion.clips.size(), f);
    made.maps.push_back(work.map);
    made.notes.push_back(notes_from(work.motion, notes, source.file));
  }
  made.motion = std::move(work.motion);
  made.clips = std::move(work.animated_clips);
  opened->now = &opened->made.emplace(method, std::move(made)).first->second;
}

Json Player::clips_json(const Opened& opened) {
  Json list = Json::array();
  const std::vector<Joint>& rest = opened.work.character.joints;
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
                    {"file", opened.now->files[c]},
                    {"frames", clip.frames.size()},
                    {"seconds", static_cast<double>(clip.frames.size() - 1) * clip.frame_time},
                    {"room", room_json(opened.now->motion, clip, rest)},
                    {"limbs", std::move(limbs)}});
  }
  return list;
}

Player::Source Player::read(const std::string& file, const Character& character, uint32_t up) {
  MotionFile read =
      read_motion_for({file, 0, "", "", up == 1 ? MaybeAxis(Axis::kZ) : std::nullopt}, map_rig_of(character));
  Source source = {file, std::move(read.motion), std::nullopt, {}};
  std::vector<Clip>& clips = source.motion.clips;
  clips.erase(std::remove_if(clips.begin(), clips.end(), [](const Clip& clip) { return clip.frames.empty(); }),
              clips.end());
  if (clips.empty()) throw Error(file + ": expected a motion, found a skeleton without frames");
  if (read.whole) source.body = body_of_motion(file);
  return source;
}

Json Player::open(const std::vector<std::string>& files, const Character& character,
                  std::shared_ptr<const PictureCharacter> picture, uint32_t up, bool own, MotionMethod method,
                  const std::vector<std::vector<sinew_map_pin>>& pins) {
  auto opened = std::make_unique<Opened>();
  for (size_t f = 0; f < files.size(); ++f) {
    opened->sources.push_back(read(files[f], character, up));
    opened->sources.back().pins = pins[f];
  }
  opened->work.character = character;
  opened->picture = std::move(picture);
  opened->up = up;
  opened->own = own;
  make(method, opened.get());
  Json reply;
  reply["clips"] = clips_json(*opened);
  reply["joints"] = character.joints.size();
  reply["files"] = Json::array();
  for (size_t f = 0; f < files.size(); ++f) {
    const MotionMap& map = opened->now->maps[f];
    const auto none = std::count(map.sources.begin(), map.sources.end(), -1);
    reply["files"].push_back({{"file", files[f]},
                              {"mapped", map.sources.size() - static_cast<size_t>(none)},
                              {"how", map.how},
                              {"sourceJoints", joints_json(opened->sources[f].motion)},
                              {"map", map_json(map)},
                              {"notes", opened->now->notes[f]}});
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
