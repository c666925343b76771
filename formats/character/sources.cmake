# SPDX-License-Identifier: MIT
# What character is compiled from, once for every build of it: this folder's and the WebAssembly modules'.
set(sinew_character_sources
  bake/bake_bends
  bake/bake_clip
  bake/bends
  bake/corrections
  bake/driver_fit
  bind/answers
  bind/bind
  bind/bind_character
  bind/choose_joints
  bind/engine_views
  bind/fold_tips
  bind/joint_map
  bind/mesh_neighbours
  bind/round_influences
  bind/transfer
  check/bone_distance
  check/check
  check/check_gate
  check/check_output
  check/clips
  check/findings
  check/joints
  check/label_check
  check/layer_crossings
  check/matrices
  check/names
  check/places
  check/poses
  check/rig_facts
  check/rows
  check/rules
  check/symmetry
  check/test_poses
  check/torn_edges
  check/weigh_findings
  clips/builtin_motion
  clips/gait
  clips/others
  clips/person
  clips/puppet
  clips/quadruped
  map/map_cover
  map/map_file
  map/map_levels
  map/map_skeleton
  map/map_source
  map/motion_map
  motion/common_body
  motion/human_limits
  motion/joint_limits
  motion/limb_bends
  motion/motion_file
  motion/moving_joints
  motion/rest_floor
  motion/retarget
  motion/stance
  motion/upright_body
  motion/urdf_limits
  picture/body_class
  picture/joints_inside
  picture/outline_class
  picture/picture_frames
  picture/picture_view
  picture/pins_by_class
  picture/plane_bones
  picture/plane_motion
  picture/side_limbs
  picture/silhouette
  pose/bend_volume
  pose/deform
  pose/pose
  pose/pose_file
  pose/placement
  pose/rest_pose
  predict/edit_skeleton
  predict/fit_fingers
  predict/fit_skeleton
  predict/keep_inside
  predict/limbs
  predict/lone_hand
  predict/marker_edits
  predict/match_limbs
  predict/predict_details
  predict/predict_face
  predict/predict_hands
  predict/predict_skeleton
  predict/skeleton_arrays
  predict/skeleton_template
  predict/turn
  profile/joint_axes
  profile/profile_names
  profile/profiles
  profile/standard_bones
  profile/write_for_profile
  rig/cut_seams
  rig/control_text
  rig/controls
  rig/infer_parents
  rig/joint_mirror
  rig/joint_surfaces
  rig/joint_verdicts
  rig/joints_beside_mesh
  rig/label_skeleton
  rig/limb_doubts
  rig/rig_gate
  rig/seam_homes
  rig/seam_leak
  rig/seam_surface
  rig/seams
  rig/simplify_skeleton
  rig/skeleton_fit
  rig/skeleton_paths
  style/style
  style/style_file)
# Jobs as the command does them, the bundled models, and the C API over both; a page has models of its own.
set(sinew_job_sources
  src/jobs/animate_job
  src/jobs/bake_job
  src/jobs/bind_job
  src/jobs/character_file
  src/jobs/check_job
  src/jobs/check_score
  src/jobs/find_joint_map
  src/jobs/lod_job
  src/jobs/own_skeleton
  src/jobs/picture_job
  src/jobs/pose_job
  src/jobs/rig_bare_mesh
  src/jobs/rig_job
  src/jobs/simplify_job
  src/jobs/thread_pool
  src/jobs/transfer_job
  src/models/models
  capi/animate
  capi/arrays
  capi/bake
  capi/bind
  capi/check
  capi/clips
  capi/lod
  capi/map
  capi/open
  capi/picture
  capi/place
  capi/places
  capi/pose
  capi/rig
  capi/save
  capi/simplify
  capi/struct_sizes
  capi/transfer)
list(TRANSFORM sinew_job_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
list(TRANSFORM sinew_job_sources APPEND .cpp)

# A model of samples/data as a source file, generated again when it changes or appears.
function(sinew_embed_model name file output)
  set(model ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../samples/data/${file})
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/src/models/embed_model.cmake)
  file(GLOB model_if_there CONFIGURE_DEPENDS ${model})
  add_custom_command(OUTPUT ${output} COMMAND ${CMAKE_COMMAND} -DMODEL=${model} -DNAME=${name} -DOUTPUT=${output} -P ${script}
    DEPENDS ${script} ${model_if_there} COMMENT "Embedding ${file}" VERBATIM)
endfunction()
sinew_embed_model(BundledModel sinew_default.sinew ${CMAKE_CURRENT_BINARY_DIR}/bundled_model.cpp)
sinew_embed_model(BundledRigModel sinew_rig.sinew ${CMAKE_CURRENT_BINARY_DIR}/bundled_rig_model.cpp)
sinew_embed_model(BundledHandsModel sinew_hands.sinew ${CMAKE_CURRENT_BINARY_DIR}/bundled_hands_model.cpp)
sinew_embed_model(BundledFrontModel sinew_front.sinew ${CMAKE_CURRENT_BINARY_DIR}/bundled_front_model.cpp)
sinew_embed_model(BundledSlotsModel sinew_slots.sinew ${CMAKE_CURRENT_BINARY_DIR}/bundled_slots_model.cpp)
list(APPEND sinew_job_sources ${CMAKE_CURRENT_BINARY_DIR}/bundled_model.cpp ${CMAKE_CURRENT_BINARY_DIR}/bundled_rig_model.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/bundled_hands_model.cpp ${CMAKE_CURRENT_BINARY_DIR}/bundled_front_model.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/bundled_slots_model.cpp)

list(TRANSFORM sinew_character_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/src/)
list(TRANSFORM sinew_character_sources APPEND .cpp)

# The bundled skeletons become part of the library; generated again when a file changes or appears.
set(templates ${CMAKE_CURRENT_LIST_DIR}/src/predict/templates)
set(template_texts ${CMAKE_CURRENT_BINARY_DIR}/template_texts.cpp)
set(embed_templates ${CMAKE_CURRENT_LIST_DIR}/src/predict/embed_templates.cmake)
file(GLOB template_files CONFIGURE_DEPENDS ${templates}/*.txt)
add_custom_command(OUTPUT ${template_texts}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${templates} -DOUTPUT=${template_texts} -P ${embed_templates}
  DEPENDS ${embed_templates} ${template_files}
  COMMENT "Embedding skeleton templates" VERBATIM)
list(APPEND sinew_character_sources ${template_texts})
