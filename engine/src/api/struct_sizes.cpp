// SPDX-License-Identifier: MIT
// Generated from the C headers by scripts/declarations.py; a test compares.
#include "sinew/abi.h"
#include "sinew/bind.h"
#include "sinew/deform.h"
#include "sinew/joint_limits.h"
#include "sinew/map.h"
#include "sinew/model.h"
#include "sinew/motion.h"
#include "sinew/motion_clips.h"
#include "sinew/motion_stream.h"
#include "sinew/names.h"
#include "sinew/published.h"
#include "sinew/questions.h"
#include "sinew/rig.h"
#include "sinew/simplify.h"
#include "sinew/skeleton.h"
#include "sinew/skin.h"
#include "sinew/springs.h"
#include "sinew/transfer.h"
#include "sinew/types.h"

namespace {

struct StructSize {
  const char* name;
  size_t size_bytes;
};

constexpr StructSize kStructSizes[] = {
    {"sinew_mesh", sizeof(sinew_mesh)},
    {"sinew_model", sizeof(sinew_model)},
    {"sinew_answer", sizeof(sinew_answer)},
    {"sinew_alternative", sizeof(sinew_alternative)},
    {"sinew_question", sizeof(sinew_question)},
    {"sinew_skeleton", sizeof(sinew_skeleton)},
    {"sinew_skin", sizeof(sinew_skin)},
    {"sinew_bind_options", sizeof(sinew_bind_options)},
    {"sinew_bind_outputs", sizeof(sinew_bind_outputs)},
    {"sinew_deform_options", sizeof(sinew_deform_options)},
    {"sinew_deformer", sizeof(sinew_deformer)},
    {"sinew_deform_outputs", sizeof(sinew_deform_outputs)},
    {"sinew_joint_limit", sizeof(sinew_joint_limit)},
    {"sinew_map_pin", sizeof(sinew_map_pin)},
    {"sinew_map_options", sizeof(sinew_map_options)},
    {"sinew_map_outputs", sizeof(sinew_map_outputs)},
    {"sinew_retarget_options", sizeof(sinew_retarget_options)},
    {"sinew_motion_body", sizeof(sinew_motion_body)},
    {"sinew_floor", sizeof(sinew_floor)},
    {"sinew_contact_options", sizeof(sinew_contact_options)},
    {"sinew_motion_clip", sizeof(sinew_motion_clip)},
    {"sinew_limb_quality", sizeof(sinew_limb_quality)},
    {"sinew_contact_spot", sizeof(sinew_contact_spot)},
    {"sinew_retarget_stream_options", sizeof(sinew_retarget_stream_options)},
    {"sinew_rig_options", sizeof(sinew_rig_options)},
    {"sinew_rig_outputs", sizeof(sinew_rig_outputs)},
    {"sinew_joint_verdicts", sizeof(sinew_joint_verdicts)},
    {"sinew_bound_character", sizeof(sinew_bound_character)},
    {"sinew_vertex_pair", sizeof(sinew_vertex_pair)},
    {"sinew_transfer_options", sizeof(sinew_transfer_options)},
    {"sinew_transfer_part", sizeof(sinew_transfer_part)},
    {"sinew_transfer_outputs", sizeof(sinew_transfer_outputs)},
    {"sinew_reference_options", sizeof(sinew_reference_options)},
    {"sinew_simplify_options", sizeof(sinew_simplify_options)},
    {"sinew_spring_joint", sizeof(sinew_spring_joint)},
    {"sinew_spring_chain", sizeof(sinew_spring_chain)},
    {"sinew_spring_collider", sizeof(sinew_spring_collider)},
    {"sinew_spring_set", sizeof(sinew_spring_set)},
    {"sinew_springs_options", sizeof(sinew_springs_options)},
};

bool equal(const char* a, const char* b) {  // the engine needs no C library
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}

}  // namespace

size_t sinew_struct_size(const char* name) {
  if (name == nullptr) return 0;
  for (const StructSize& one : kStructSizes)
    if (equal(one.name, name)) return one.size_bytes;
  return 0;
}
