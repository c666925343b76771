# SPDX-License-Identifier: MIT
# What character is compiled from, once for every build of it: this folder's and the WebAssembly modules'.
# Pictures of characters: read, outlined, made a mesh of; frames as sprites and animated PNG.
set(sinew_picture_sources
  picture/mesh/contour
  picture/mesh/delaunay
  picture/mesh/picture_mesh
  picture/mesh/plane_mesh
  picture/mesh/mesh_drawing
  picture/outline/background
  picture/outline/figure_parts
  picture/outline/figure
  picture/outline/foreground
  picture/outline/free_limbs
  picture/outline/inner_lines
  picture/outline/raster
  picture/read/read_jpeg
  picture/read/read_picture
  picture/read/read_png
  picture/read/read_stb
  picture/sprites/sprite_files
  picture/sprites/draw_in_plane)
# Renders, textures and HTML pages, which need libpng.
set(sinew_draw_sources
  crowd/vertex_textures
  draw/color
  draw/image
  draw/pose_frame
  draw/render
  jobs/vat_job
  page/pages
  page/html)
set(sinew_character_sources
  rig/infer_parents
  rig/joint_mirror
  rig/joint_verdicts
  rig/joints_beside_mesh
  rig/mesh_surface
  bind/answers
  bind/bind
  bind/bind_character
  bind/choose_joints
  bind/cut_seams
  bind/engine_views
  bind/fold_tips
  bind/seam_homes
  bind/seam_leak
  bind/seam_steps
  bind/seams
  bind/transfer
  predict/edit_skeleton
  predict/fit_fingers
  predict/fit_skeleton
  predict/keep_inside
  predict/label_skeleton
  predict/limbs
  predict/lone_hand
  predict/marker_edits
  predict/match_limbs
  predict/part_skeleton
  predict/predict_details
  predict/predict_skeleton
  predict/fused_base
  predict/scenery
  predict/skeleton_fit
  predict/skeleton_template
  predict/turn
  predict/vehicle_skeleton
  pose/bend_volume
  pose/deform
  pose/character_transform
  pose/pose
  pose/rest_pose
  bake/bake
  bake/bends
  bake/corrections
  bake/driver_fit
  clips/builtin_motion
  clips/gait
  clips/performance
  clips/puppet
  motion/body_kind
  motion/body_parts
  motion/common_body
  motion/human_limits
  motion/joint_limits
  motion/map_file
  motion/map_findings
  motion/map_skeleton
  motion/map_source
  motion/motion_file
  motion/motion_map
  motion/motion_summary
  motion/moving_joints
  motion/retarget
  motion/simplify_skeleton
  motion/stance
  motion/typical_pose
  motion/upright_body
  motion/upside_down
  motion/urdf_limits
  springs/find_garments
  springs/find_springs
  springs/fit_colliders
  springs/garment_lattice
  springs/make_chains
  springs/play_springs
  springs/sections
  springs/spring_player
  springs/spring_presets
  springs/swing_inside
  springs/swing_words
  check/bone_distance
  check/check
  check/check_gate
  check/check_output
  check/clips
  check/findings
  check/joints
  check/label_check
  check/surface_faults
  check/matrices
  check/mesh_check
  check/names
  check/stray_weights
  check/poses
  check/rig_facts
  check/rig_gate
  check/rows
  check/rules
  check/spring_chains
  check/symmetry
  check/test_poses
  check/weigh_findings
  style/style
  style/style_file
  picture/joints_inside
  picture/outline_class
  picture/picture_frames
  jobs/picture_view
  jobs/plane_bones
  jobs/plane_motion
  profile/control_text
  profile/controls
  profile/joint_axes
  profile/profiles
  profile/standard_bones
  profile/vrm_clips
  profile/write_for_profile)
# Jobs as the command does them, the bundled models, and the C API over both; a page has models of its own.
set(sinew_job_sources
  predict/own_skeleton
  capi/animate
  capi/arrays
  capi/bake
  capi/bind
  capi/check
  capi/clips
  capi/keypoints
  capi/map
  capi/open
  capi/picture
  capi/pose
  capi/rig
  capi/save
  capi/simplify
  capi/springs
  capi/struct_sizes
  capi/transfer
  jobs/animate_job
  jobs/bake_job
  jobs/bind_job
  jobs/character_file
  jobs/check_job
  jobs/lod_job
  jobs/picture_job
  jobs/pose_job
  jobs/rig_job
  jobs/sheet_skeleton
  jobs/simplify_job
  jobs/springs_job
  jobs/transfer_job
  models/models)
foreach(sources sinew_picture_sources sinew_draw_sources sinew_character_sources sinew_job_sources)
  list(TRANSFORM ${sources} PREPEND ${CMAKE_CURRENT_LIST_DIR}/src/)
  list(TRANSFORM ${sources} APPEND .cpp)
endforeach()

# A model of samples/data as a source file, generated again when it changes or appears.
function(sinew_embed_model name file output)
  set(model ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../samples/data/${file})
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

# The bundled skeletons and clips become part of the library as texts; generated again when a file changes.
set(embed_texts ${CMAKE_CURRENT_LIST_DIR}/src/predict/embed_texts.cmake)
function(sinew_embed_texts function header output)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFUNCTION=${function} -DHEADER=${header} -DOUTPUT=${output} "-DFILES=${ARGN}" -P ${embed_texts}
    DEPENDS ${embed_texts} ${ARGN}
    COMMENT "Embedding texts of ${function}" VERBATIM)
endfunction()
file(GLOB template_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/src/predict/templates/*.txt)
sinew_embed_texts(sinew::template_texts sinew_character/predict/skeleton_template.hpp
  ${CMAKE_CURRENT_BINARY_DIR}/template_texts.cpp ${template_files})
# Kinds of bodies in the order in which they are tried, where several have a clip of the name; then the variants.
set(gait_files person quadruped quadruped2 spider insect bird wings fish variants)
list(TRANSFORM gait_files PREPEND ${CMAKE_CURRENT_LIST_DIR}/src/clips/gaits/)
list(TRANSFORM gait_files APPEND .txt)
sinew_embed_texts(sinew::clips::gait_texts clips/gait.hpp ${CMAKE_CURRENT_BINARY_DIR}/gait_texts.cpp ${gait_files})
list(APPEND sinew_character_sources ${CMAKE_CURRENT_BINARY_DIR}/template_texts.cpp ${CMAKE_CURRENT_BINARY_DIR}/gait_texts.cpp)
