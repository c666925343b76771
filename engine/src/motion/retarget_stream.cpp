// SPDX-License-Identifier: MIT
// A clip of one frame, again and again.
#include "motion/retarget_stream.hpp"

#include <stddef.h>

#include "core/struct_size.hpp"
#include "motion/retarget.hpp"

namespace sinew::motion {
namespace {

constexpr double kSlow = 0.006;   // share of the source's height that a resting foot rises in a thirtieth of a second
constexpr double kHigher = 0.25;  // share of a leg by which another floor must be higher,
constexpr double kRestsOnHigher = 1.0;  // and the seconds that a foot must rest there

// All memory of a stream, itself included.
struct StreamMemory {
  sinew_retarget_stream made;
  sinew_retarget_stream* stream = nullptr;
  uint8_t* plan = nullptr;
  size_t plan_bytes = 0;
  // A body of joints, where there is no other.
  float* positions = nullptr;
  uint16_t *joints = nullptr, *weights = nullptr;

  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t body_vertices,
                uint32_t body_triangles) {
    const uint32_t vertices = body_vertices > 0 ? body_vertices : target_joints;
    stream = arena.alloc<sinew_retarget_stream>(1);
    plan_bytes = measure_plan(source_joints, target_joints);
    plan = arena.alloc<uint8_t>(plan_bytes);
    if (body_vertices == 0) {
      positions = arena.alloc<float>(size_t{3} * target_joints);
      joints = arena.alloc<uint16_t>(target_joints);
      weights = arena.alloc<uint16_t>(target_joints);
    }
    if (body_triangles > 0)
      return made.scene.allocate_all(arena, source_joints, target_joints, vertices, body_triangles, 1);
    (void)made.scene.allocate(arena, source_joints, target_joints, vertices, 0);
    return made.scene.allocate_floor(arena, target_joints, vertices, 1);
  }

  sinew_motion_body body_of_joints(const sinew_skeleton& target) {
    for (size_t i = 0; i < size_t{3} * target.joint_count; ++i) positions[i] = target.positions[i];
    for (uint32_t j = 0; j < target.joint_count; ++j) {
      joints[j] = static_cast<uint16_t>(j);
      weights[j] = 65535;
    }
    return {positions, nullptr, {joints, weights, 1, SINEW_WEIGHT_UNORM16}, target.joint_count, 0};
  }
};

// The lowest that a foot has rested is the floor; another one is higher where feet rest there for long, as after a first frame that is
// no motion. Poses the source.
sinew_status follow_ground(sinew_retarget_stream* stream, const float* rotations, const float* translations) {
  GroundMemory& memory = stream->ground_memory;
  if (memory.is_known) return SINEW_OK;
  const sinew_status status = pose_source(stream->plan, rotations, translations);
  if (status != SINEW_OK) return status;
  const double low = lowest_floor_joint(*stream->plan), fps = stream->inputs.fps;
  double ground = static_cast<double>(stream->ground);
  if (!memory.any) memory.goal = ground = low;
  const double rise = memory.any ? low - memory.before : 0;
  const bool slow = (rise < 0 ? -rise : rise) * fps / kContactFps < kSlow * stream->scene.source_height;
  const bool higher = low > memory.goal + kHigher * stream->plan->leg_length;
  memory.rested = slow && higher ? memory.rested + 1 / fps : 0;
  if (slow && (low < memory.goal || memory.rested > kRestsOnHigher)) memory.goal = low;
  ground = memory.goal + fade_at(fps, kFade) * (ground - memory.goal);
  memory.before = low;
  memory.any = true;
  stream->ground = static_cast<float>(ground);
  stream->inputs.ground = static_cast<double>(stream->ground);
  return SINEW_OK;
}

}  // namespace

sinew_status read_stream_options(const sinew_retarget_stream_options* options, StreamOptions* out) {
  sinew_retarget_stream_options o = SINEW_INIT(sinew_retarget_stream_options);
  constexpr uint32_t kFirstSize = offsetof(sinew_retarget_stream_options, source);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstSize, sizeof o, &o);
  if (status != SINEW_OK) return status;
  if (o.has_ground > 1 || (o.without & ~uint32_t{SINEW_WITHOUT_CONTACTS | SINEW_WITHOUT_RANGE}) != 0)
    return SINEW_ERROR_ARGUMENT;
  *out = StreamOptions();
  if (o.fps != 0) out->fps = static_cast<double>(o.fps);
  if (!(out->fps >= 1 && out->fps <= 1000)) return SINEW_ERROR_ARGUMENT;
  out->ground = o.ground;
  if (!is_finite(static_cast<double>(o.ground))) return SINEW_ERROR_NOT_FINITE;
  out->has_ground = o.has_ground != 0;
  out->contacts = (o.without & SINEW_WITHOUT_CONTACTS) == 0;
  out->range = (o.without & SINEW_WITHOUT_RANGE) == 0;
  out->source = o.source;
  return out->floor.take(o.floor);
}

size_t measure_stream(uint32_t source_joints, uint32_t target_joints, uint32_t body_vertices, uint32_t body_triangles) {
  Arena arena;
  StreamMemory memory;
  (void)memory.allocate(arena, source_joints, target_joints, body_vertices, body_triangles);
  return arena.ok() ? arena.high_water() : 0;
}

sinew_status create_stream(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                           const uint8_t* classes, const RetargetOptions& plan_options, const sinew_motion_body* body,
                           const StreamOptions& options, void* memory, size_t memory_bytes,
                           sinew_retarget_stream** stream) {
  Arena arena(memory, memory_bytes);
  StreamMemory room;
  if (!room.allocate(arena, source.joint_count, target.joint_count, body == nullptr ? 0 : body->vertex_count,
                     body == nullptr ? 0 : body->triangle_count))
    return SINEW_ERROR_WORKSPACE;
  sinew_retarget_stream& made = room.made;
  const sinew_status status =
      create_plan(source, target, map, classes, plan_options, room.plan, room.plan_bytes, &made.plan);
  if (status != SINEW_OK) return status;
  made.body = body == nullptr ? room.body_of_joints(target) : *body;
  if (options.source != nullptr) made.source = *options.source;
  made.inputs.fps = options.fps;
  made.inputs.floor = options.floor;
  made.ground = options.has_ground ? options.ground : static_cast<float>(made.plan->source_floor);
  made.inputs.ground = static_cast<double>(made.ground);
  made.ground_memory.is_known = options.has_ground || stands_at_rest(*made.plan);
  made.range = options.range && !made.plan->same_rig;
  *room.stream = made;
  sinew_retarget_stream& own = *room.stream;
  // Without a frame nothing can fail.
  (void)own.scene.open(own.plan, options.source == nullptr ? nullptr : &own.source, own.body, own.inputs);
  own.contacts = options.contacts && !own.scene.has_all_contacts();
  own.has_hands = own.contacts && own.body.triangle_count > 0;
  own.scene.floor_patches.open(&own.scene);
  find_hinges(own.scene, own.memory.hinges);
  if (own.has_hands) open_hands(&own.scene, &own.hands);
  *stream = room.stream;
  return SINEW_OK;
}

sinew_status stream_frame(sinew_retarget_stream* stream, const float* rotations, const float* translations,
                          float* out_rotations, float* out_translations) {
  sinew_status status = follow_ground(stream, rotations, translations);
  if (status == SINEW_OK)
    status = retarget_frame(stream->plan, rotations, translations, stream->ground, out_rotations, out_translations);
  if (status != SINEW_OK) return status;
  ContactScene& scene = stream->scene;
  ClipInputs& in = stream->inputs;
  in.frames = 1;
  in.source_rotations = rotations;
  in.source_translations = translations;
  in.rotations = out_rotations;
  in.translations = out_translations;
  if (stream->range) keep_range_of_frame(scene, stream->memory.hinges, 0);
  for (uint32_t l = 0; l < scene.limbs.count; ++l) scene.limbs.limbs[l].natural = stream->range;
  if (stream->contacts) FloorContacts(&scene, &stream->memory).run();
  if (stream->has_hands) place_hands_next(&scene, &stream->hands);
  return SINEW_OK;
}

void restart_stream(sinew_retarget_stream* stream) {
  stream->ground_memory.any = false;
  FloorMemory fresh;
  for (uint32_t l = 0; l < kMostLimbs; ++l) fresh.hinges[l] = stream->memory.hinges[l];
  stream->memory = fresh;
  HandMemory empty;
  for (uint32_t a = 0; a < kMostArms; ++a) empty.rest_depths[a] = stream->hands.rest_depths[a];
  stream->hands = empty;
}

}  // namespace sinew::motion
