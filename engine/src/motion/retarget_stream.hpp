// SPDX-License-Identifier: MIT
// Streaming retargeting: a plan, a body and the state of past frames. Implements sinew_retarget_stream_*().
#ifndef SINEW_MOTION_RETARGET_STREAM_HPP
#define SINEW_MOTION_RETARGET_STREAM_HPP

#include "motion/contacts.hpp"
#include "sinew/motion_stream.h"

namespace sinew::motion {

// The height of the floor under a source whose rest pose stands on none, from the frames so far.
struct GroundMemory {
  bool is_known = true;  // given, or the rest pose's
  bool any = false;      // a frame came before
  double goal = 0;       // what the floor moves to
  double before = 0;     // how high the lowest foot was
  double rested = 0;     // for how many seconds it has been slow, over the floor
};

}  // namespace sinew::motion

// The type of the interface: the stream is one block of memory, this is its beginning.
struct sinew_retarget_stream {
  sinew_retarget* plan = nullptr;
  sinew::motion::ContactScene scene;
  sinew::motion::ClipInputs inputs;  // the frame
  sinew::motion::FloorMemory memory;
  sinew::motion::HandMemory hands;
  sinew_motion_body body = {}, source = {};
  float ground = 0;
  sinew::motion::GroundMemory ground_memory;
  bool contacts = false, range = false, has_hands = false;
};

namespace sinew::motion {

// The options of the interface, checked.
struct StreamOptions {
  double fps = 30;
  float ground = 0;
  bool has_ground = false, contacts = true, range = true;
  FloorGrid floor;
  const sinew_motion_body* source = nullptr;  // not checked
};
// Returns SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_VERSION, SINEW_ERROR_COUNT or SINEW_ERROR_NOT_FINITE.
sinew_status read_stream_options(const sinew_retarget_stream_options* options, StreamOptions* out);

// body_vertices 0: none; body_triangles 0: hands know nothing of it.
size_t measure_stream(uint32_t source_joints, uint32_t target_joints, uint32_t body_vertices, uint32_t body_triangles);
// As sinew_retarget_stream_create() after its checks of pointers, counts, bodies and memory. body: or null.
sinew_status create_stream(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                           const uint8_t* classes, const RetargetOptions& plan_options, const sinew_motion_body* body,
                           const StreamOptions& options, void* memory, size_t memory_bytes,
                           sinew_retarget_stream** stream);
// The caller has checked for null pointers.
sinew_status stream_frame(sinew_retarget_stream* stream, const float* rotations, const float* translations,
                          float* out_rotations, float* out_translations);
void restart_stream(sinew_retarget_stream* stream);

}  // namespace sinew::motion
#endif
