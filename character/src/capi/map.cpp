// SPDX-License-Identifier: MIT
// sinew_character_map(): the job of `sinew map`.
#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

// As `sinew map` reads the file: ends of a motion are its End Sites, ends of a rig.txt alone are in its weights.
MapRig rig_of_handle(const sinew_character& from) {
  if (from.character.joints.empty()) throw Error(from.character.name + ": expected a skeleton, found only a mesh");
  MapRig rig = map_rig_of(from.character);
  if (from.same_skin && from.character.vertices.empty() && !from.path.empty()) {
    const FilesOf scope(from);
    rig = read_map_rig(from.path);
  }
  rig.name = file_of(from);
  return rig;
}

MapSourceRequest request_of(const std::string& path, const sinew_character_map_options& options,
                            const sinew_motion_source& source) {
  const MaybeAxis target_up = options.guess_up != 0 ? std::nullopt : maybe_axis(options.target_up);
  const MaybeAxis given = maybe_axis(source.up), source_up = given ? given : target_up;
  return {path, text_or_empty(source.layout), text_or_empty(source.actor), source_up, target_up};
}

// As sinew_character_animate() plays it.
MapRig source_of_handle(const sinew_character& from, const MapSourceRequest& request, const MapRig& target) {
  std::optional<MotionFile> motion;
  if (plays_its_file(from)) {
    const FilesOf scope(from);
    motion = read_motion_in(request, target);
  } else if (!from.clips.empty()) {
    motion = added_motion(from);
  }
  if (!motion) return rig_of_handle(from);
  MapRig rig = map_source_of(motion->motion, body_of(from, *motion), target.joints, request.up).rig;
  rig.name = file_of(from);
  return rig;
}

void map(const sinew_character_map_options& options, const sinew_character* from, sinew_character* character,
         sinew_character_map_result* result) {
  check_at_most("method", options.method, SINEW_MAP_BRANCHES);
  check_at_most("branches_first", options.branches_first, SINEW_BRANCHES_SOURCE);
  check_at_most("branches_cost", options.branches_cost, SINEW_BRANCHES_SUM);
  if (options.method != SINEW_MAP_BRANCHES && (options.branches_first != 0 || options.branches_cost != 0))
    throw Failure(SINEW_ERROR_ARGUMENT, "branches_first and branches_cost need SINEW_MAP_BRANCHES");
  check_at_most("target_up", options.target_up, SINEW_UP_Z);
  check_without(options.without, SINEW_WITHOUT_NAMES | SINEW_WITHOUT_ENDS);
  const sinew_motion_source motion = options_of(options.source);
  check_at_most("source_up", motion.up, SINEW_UP_Z);
  need(from != nullptr || motion.file != nullptr, "source");
  need(options.pins != nullptr || options.pin_count == 0, "pins");
  const MapRig target = rig_of_handle(*character);
  const MapSourceRequest request = request_of(from != nullptr ? from->path : motion.file, options, motion);
  const MapRig source = from != nullptr ? source_of_handle(*from, request, target) : read_map_source(request, target);
  MapSkeletonOptions job;
  job.method = options.method;
  job.branches_first = options.branches_first;
  job.branches_cost = options.branches_cost;
  job.names = (options.without & SINEW_WITHOUT_NAMES) == 0;
  job.ends = (options.without & SINEW_WITHOUT_ENDS) == 0;
  job.target_up = options.guess_up != 0 ? std::nullopt : maybe_axis(options.target_up);
  const MaybeAxis source_up = maybe_axis(motion.up);
  job.source_up = source_up ? source_up : from == nullptr && is_template(motion.file) ? Axis::kY : job.target_up;
  if (options.pins_file != nullptr) job.pins = read_map_file(options.pins_file, target, source);
  check_pins(options.pins, options.pin_count, target.joints.size(), source.joints.size());
  for (uint32_t p = 0; p < options.pin_count; ++p) {
    const sinew_map_pin& pin = options.pins[p];
    std::erase_if(job.pins, [&](const sinew_map_pin& one) {
      return one.target == pin.target || (pin.source >= 0 && one.source == pin.source);
    });
    job.pins.push_back(pin);
  }
  const MappedSkeleton mapped = map_skeleton(target, source, job);
  ResultViews& views = character->results;
  views = {};
  views.sources = mapped.sources;
  views.confidence = mapped.confidence;
  views.reasons = mapped.reasons;
  views.text = map_text(target, source, mapped);
  sinew_character_map_result filled = SINEW_INIT(sinew_character_map_result);
  filled.method = mapped.method;
  filled.joint_count = count32(target.joints.size());
  filled.mapped = count32(mapped.mapped);
  filled.certainty = mapped.certainty;
  filled.cover = map_cover(target, job.target_up, source, job.source_up, mapped.sources).share;
  filled.seconds = mapped.seconds;
  filled.sources = views.sources.data();
  filled.confidence = views.confidence.data();
  filled.reasons = views.reasons.data();
  filled.text = views.text.c_str();
  give(filled, result);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_map(sinew_character* target, const sinew_character* source,
                                            const sinew_character_map_options* given,
                                            sinew_character_map_result* result) {
  return guarded(target, [&] {
    need(target != nullptr, "target");
    need(result != nullptr, "result");
    check_result(result);
    map(options_of(given), source, target, result);
  });
}
