// SPDX-License-Identifier: MIT
// Generated from the C headers by scripts/declarations.py; a test compares.
#include "sinew/character.h"
#include "sinew/character_check.h"
#include "sinew/character_file.h"
#include "sinew/character_jobs.h"
#include "sinew/character_picture.h"

namespace {

struct StructSize {
  const char* name;
  size_t size_bytes;
};

constexpr StructSize kStructSizes[] = {
    {"sinew_file", sizeof(sinew_file)},
    {"sinew_character_profile_options", sizeof(sinew_character_profile_options)},
    {"sinew_character_arrays", sizeof(sinew_character_arrays)},
    {"sinew_character_clip", sizeof(sinew_character_clip)},
    {"sinew_character_transform_options", sizeof(sinew_character_transform_options)},
    {"sinew_character_finding", sizeof(sinew_character_finding)},
    {"sinew_character_check_options", sizeof(sinew_character_check_options)},
    {"sinew_character_check_result", sizeof(sinew_character_check_result)},
    {"sinew_character_models", sizeof(sinew_character_models)},
    {"sinew_character_bind_options", sizeof(sinew_character_bind_options)},
    {"sinew_character_seam", sizeof(sinew_character_seam)},
    {"sinew_character_left_out", sizeof(sinew_character_left_out)},
    {"sinew_character_bind_result", sizeof(sinew_character_bind_result)},
    {"sinew_skeleton_edit", sizeof(sinew_skeleton_edit)},
    {"sinew_character_rig_options", sizeof(sinew_character_rig_options)},
    {"sinew_character_doubt", sizeof(sinew_character_doubt)},
    {"sinew_character_rig_result", sizeof(sinew_character_rig_result)},
    {"sinew_motion_source", sizeof(sinew_motion_source)},
    {"sinew_character_map_options", sizeof(sinew_character_map_options)},
    {"sinew_character_map_result", sizeof(sinew_character_map_result)},
    {"sinew_character_deformation", sizeof(sinew_character_deformation)},
    {"sinew_character_animate_options", sizeof(sinew_character_animate_options)},
    {"sinew_character_animate_result", sizeof(sinew_character_animate_result)},
    {"sinew_character_pose_options", sizeof(sinew_character_pose_options)},
    {"sinew_character_transfer_options", sizeof(sinew_character_transfer_options)},
    {"sinew_character_transfer_result", sizeof(sinew_character_transfer_result)},
    {"sinew_character_simplify_options", sizeof(sinew_character_simplify_options)},
    {"sinew_character_lod_options", sizeof(sinew_character_lod_options)},
    {"sinew_character_lod_level", sizeof(sinew_character_lod_level)},
    {"sinew_character_springs_options", sizeof(sinew_character_springs_options)},
    {"sinew_character_springs_result", sizeof(sinew_character_springs_result)},
    {"sinew_character_bake_options", sizeof(sinew_character_bake_options)},
    {"sinew_character_bake_result", sizeof(sinew_character_bake_result)},
    {"sinew_character_picture_options", sizeof(sinew_character_picture_options)},
    {"sinew_character_picture_info", sizeof(sinew_character_picture_info)},
};

bool equal(const char* a, const char* b) {  // the engine needs no C library
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}

}  // namespace

size_t sinew_character_struct_size(const char* name) {
  if (name == nullptr) return 0;
  for (const StructSize& one : kStructSizes)
    if (equal(one.name, name)) return one.size_bytes;
  return 0;
}
