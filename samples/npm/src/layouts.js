// SPDX-License-Identifier: MIT
// The engine's structs (sinew.h), member by member: each is 4 bytes long on wasm32, "name:f" is a float, the others are
// integers and addresses. wasm/skin.cpp checks the sizes; those that begin with struct_size may grow in the engine without
// harm (sinew/types.h).
const layout = (text) => text.trim().split(/\s+/).map((word) => ({ name: word.split(":")[0], isFloat: word.endsWith(":f") }));

export const LAYOUTS = {
  mesh: layout("positions vertex_count face_offsets face_vertices face_count corner_count"),
  skeleton: layout("struct_size joint_count positions parents flags ends names rotations up reserved"),
  options: layout(`struct_size method influence_count weight_format candidate_count grid_size surface_vertices symmetric
    rigid_parts softness_percent weights_in_place kernel thread_count reserved locked hints parallel_for parallel_user progress
    progress_user answers answer_count question_count`),
  bindOutputs: layout(`struct_size symmetric_vertices joint_indices weights confidence used_bytes questions vertex_questions
    vertex_parts questions_written reserved`),
  rigOptions: layout(`struct_size up mirror spine_count no_toes no_ends weights_in_place kernel progress progress_user method
    reserved`),
  rigOutputs: layout(`struct_size joint_count positions parents flags joint_classes partners confidence parent_confidence names
    mirrored facing plane:f spread:f used_bytes`),
  mapOptions: layout("struct_size method pin_count reserved pins"),
  mapOutputs: layout("struct_size method sources confidence reasons mapped certainty used_bytes"),
  retargetOptions: layout("struct_size method in_place scale:f"),
  motionBody: layout("positions triangles joint_indices weights influence_count weight_format vertex_count triangle_count"),
  contactOptions: layout("struct_size fps:f progress progress_user"),
  motionClip: layout("source_rotations source_translations rotations translations frame_count ground:f"),
  skin: layout("joint_indices weights influence_count weight_format"),
  deformOptions: layout("struct_size method cell_count round_count softness no_twist_spread no_contact no_smoothing parallel_for parallel_user thread_count body_contact"),
  deformer: layout("memory pose_bytes vertex_count joint_count tetrahedron_count node_count split_cell_count r0 r1 r2 r3 r4 r5 r6"),
  deformOutputs: layout("struct_size corrected positions active_tetrahedra inverted_tetrahedra"),
  boundCharacter: layout("mesh skeleton joint_indices weights influence_count weight_format joint_map"),
  transferOptions: layout(`struct_size method influence_count weight_format garment as_drawn weights_in_place
    kernel thread_count pair_count locked pairs parallel_for parallel_user progress progress_user`),
  transferOutputs: layout(`struct_size part_capacity joint_indices weights confidence parts vertex_parts part_count bound_by
    carried_q16 style_q16 mismatch_q16 reference_count used_bytes`),
  transferPart: layout("vertex vertex_count reason carried_q16 style_q16 mismatch_q16 distance_q16 reserved"),
  simplifyOptions: layout("struct_size level joint_count reserved"),
};

export const MODEL_BYTES = 4 * 29; // sizeof(sinew_model)
export const QUESTION_BYTES = 96; // sizeof(sinew_question)
export const MAX_RIG_JOINTS = 192;
export const JOINT_NAME_BYTES = 32;
