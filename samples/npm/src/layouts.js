// SPDX-License-Identifier: MIT
// The engine's structs on wasm32, constants and words of enumerations. Generated from the C headers by scripts/declarations.py; a test compares.
// A member is name@offset:type, or name@offset:typexCOUNT for an array in a struct; a struct in a struct has its members here,
// those of an array of them as name_0_member. Addresses are u32.
/** @type {(size: number, text: string) => any} */
const layout = (size, text) => ({
  size,
  members: text.split(" ").map((word) => {
    const [, name, offset, type, count] = /^(\w+)@(\d+):([uif]\d+)(?:x(\d+))?$/.exec(word) ?? [];
    return { name, offset: Number(offset), type, count: Number(count ?? 0) };
  }),
});

export const LAYOUTS = {
  mesh: layout(24,
    "positions@0:u32 vertex_count@4:u32 face_offsets@8:u32 face_vertices@12:u32 face_count@16:u32 corner_count@20:u32"),
  model: layout(116,
    "bytes@0:u32 size_bytes@4:u32 packed@8:u32 format_version@12:u32 candidate_count@16:u32 grid_size@20:u32 " +
    "feature_set@24:u32 fixed_candidates@28:u32 layer_count@32:u32 parameter_count@36:u32 checksum@40:u32 " +
    "confidence_offset@44:u32 confidence_count@48:u32 task@52:u32 input_count@56:u32 reserved@60:u32x14"),
  answer: layout(12, "vertex@0:u32 kind@4:u16 joint@6:u16 alone@8:u32"),
  alternative: layout(8, "kind@0:u16 joint@2:u16 change@4:u32"),
  question: layout(96,
    "vertex@0:u32 part_count@4:u32 vertex_count@8:u32 joint@12:u16 share@14:u16 doubt@16:u32 gain@20:u32 " +
    "alternative_count@24:u32 reserved@28:u32 alternatives_0_kind@32:u16 alternatives_0_joint@34:u16 " +
    "alternatives_0_change@36:u32 alternatives_1_kind@40:u16 alternatives_1_joint@42:u16 alternatives_1_change@44:u32 " +
    "alternatives_2_kind@48:u16 alternatives_2_joint@50:u16 alternatives_2_change@52:u32 alternatives_3_kind@56:u16 " +
    "alternatives_3_joint@58:u16 alternatives_3_change@60:u32 alternatives_4_kind@64:u16 alternatives_4_joint@66:u16 " +
    "alternatives_4_change@68:u32 alternatives_5_kind@72:u16 alternatives_5_joint@74:u16 alternatives_5_change@76:u32 " +
    "alternatives_6_kind@80:u16 alternatives_6_joint@82:u16 alternatives_6_change@84:u32 alternatives_7_kind@88:u16 " +
    "alternatives_7_joint@90:u16 alternatives_7_change@92:u32"),
  skeleton: layout(40,
    "struct_size@0:u32 joint_count@4:u32 positions@8:u32 parents@12:u32 flags@16:u32 ends@20:u32 names@24:u32 " +
    "rotations@28:u32 up@32:u32 reserved@36:u32"),
  skin: layout(16, "joint_indices@0:u32 weights@4:u32 influence_count@8:u32 weight_format@12:u32"),
  bindOptions: layout(92,
    "struct_size@0:u32 method@4:u32 influence_count@8:u32 weight_format@12:u32 candidate_count@16:u32 grid_size@20:u32 " +
    "surface_vertices@24:u32 symmetric@28:u32 rigid_parts@32:u32 softness_percent@36:u32 weights_in_place@40:u32 kernel@44:u32 " +
    "thread_count@48:u32 reserved@52:u32 locked@56:u32 hints@60:u32 parallel_for@64:u32 parallel_user@68:u32 progress@72:u32 " +
    "progress_user@76:u32 answers@80:u32 answer_count@84:u32 question_count@88:u32"),
  bindOutputs: layout(44,
    "struct_size@0:u32 symmetric_vertices@4:u32 joint_indices@8:u32 weights@12:u32 confidence@16:u32 used_bytes@20:u32 " +
    "questions@24:u32 vertex_questions@28:u32 vertex_parts@32:u32 questions_written@36:u32 reserved@40:u32"),
  deformOptions: layout(56,
    "struct_size@0:u32 method@4:u32 cell_count@8:u32 round_count@12:u32 softness@16:u32 without@20:u32 thread_count@24:u32 " +
    "body_contact@28:u32 parallel_for@32:u32 parallel_user@36:u32 energy@40:u32 tet_weights@44:u32 as_drawn@48:u32 " +
    "reserved@52:u32"),
  deformer: layout(56,
    "memory@0:u32 pose_bytes@4:u32 vertex_count@8:u32 joint_count@12:u32 tetrahedron_count@16:u32 node_count@20:u32 " +
    "split_cell_count@24:u32 reserved@28:u32x7"),
  deformOutputs: layout(20,
    "struct_size@0:u32 corrected@4:u32 positions@8:u32 active_tetrahedra@12:u32 inverted_tetrahedra@16:u32"),
  jointLimit: layout(72, "joint@0:u32 kind@4:u32 zero@8:f32x4 axis@24:f32x3 side@36:f32x3 least@48:f32x3 most@60:f32x3"),
  mapPin: layout(8, "target@0:u32 source@4:i32"),
  mapOptions: layout(40,
    "struct_size@0:u32 method@4:u32 pin_count@8:u32 reserved@12:u32 pins@16:u32 branches_first@20:u32 branches_cost@24:u32 " +
    "target_areas@28:u32 source_areas@32:u32 source_animated@36:u32"),
  mapOutputs: layout(32,
    "struct_size@0:u32 method@4:u32 sources@8:u32 confidence@12:u32 reasons@16:u32 mapped@20:u32 certainty@24:u32 " +
    "used_bytes@28:u32"),
  retargetOptions: layout(24, "struct_size@0:u32 method@4:u32 in_place@8:u32 scale@12:f32 translations@16:u32 arm_spread@20:f32"),
  motionBody: layout(32,
    "positions@0:u32 triangles@4:u32 joint_indices@8:u32 weights@12:u32 influence_count@16:u32 weight_format@20:u32 " +
    "vertex_count@24:u32 triangle_count@28:u32"),
  floor: layout(28, "heights@0:u32 columns@4:u32 rows@8:u32 first@12:f32x2 step@20:f32 reserved@24:u32"),
  contactOptions: layout(20, "struct_size@0:u32 fps@4:f32 progress@8:u32 progress_user@12:u32 floor@16:u32"),
  motionClip: layout(24,
    "source_rotations@0:u32 source_translations@4:u32 rotations@8:u32 translations@12:u32 frame_count@16:u32 ground@20:f32"),
  limbQuality: layout(48,
    "joint@0:u32 leg@4:u32 frames@8:u32 deep_frames@12:u32 contact_frames@16:u32 range_frames@20:u32 depth@24:f32 " +
    "greatest_depth@28:f32 error@32:f32 greatest_error@36:f32 reserved@40:u32x2"),
  contactSpot: layout(24, "kind@0:u32 position@4:f32x3 error@16:f32 reserved@20:u32"),
  retargetStreamOptions: layout(32,
    "struct_size@0:u32 fps@4:f32 ground@8:f32 has_ground@12:u32 without@16:u32 reserved@20:u32 floor@24:u32 source@28:u32"),
  rigOptions: layout(60,
    "struct_size@0:u32 up@4:u32 mirror@8:u32 spine_count@12:u32 without@16:u32 reserved@20:u32 weights_in_place@24:u32 " +
    "kernel@28:u32 progress@32:u32 progress_user@36:u32 method@40:u32 category@44:u32 front_model@48:u32 front@52:u32 " +
    "axes_known@56:u32"),
  rigOutputs: layout(84,
    "struct_size@0:u32 joint_count@4:u32 positions@8:u32 parents@12:u32 flags@16:u32 joint_classes@20:u32 partners@24:u32 " +
    "confidence@28:u32 parent_confidence@32:u32 names@36:u32 mirrored@40:u32 facing@44:u32 plane@48:f32 spread@52:f32 " +
    "used_bytes@56:u32 front@60:f32x3 up@72:u32 front_confidence@76:f32 up_confidence@80:f32"),
  jointVerdicts: layout(48,
    "struct_size@0:u32 mirror_axis@4:u32 classes@8:u32 roles@12:u32 sides@16:u32 numbers@20:u32 partners@24:u32 images@28:u32 " +
    "mirror_planes@32:f32x3 mirrored@44:u32"),
  boundCharacter: layout(28,
    "mesh@0:u32 skeleton@4:u32 joint_indices@8:u32 weights@12:u32 influence_count@16:u32 weight_format@20:u32 joint_map@24:u32"),
  vertexPair: layout(8, "source@0:u32 target@4:u32"),
  transferOptions: layout(64,
    "struct_size@0:u32 method@4:u32 influence_count@8:u32 weight_format@12:u32 garment@16:u32 as_drawn@20:u32 " +
    "weights_in_place@24:u32 kernel@28:u32 thread_count@32:u32 pair_count@36:u32 locked@40:u32 pairs@44:u32 " +
    "parallel_for@48:u32 parallel_user@52:u32 progress@56:u32 progress_user@60:u32"),
  transferPart: layout(32,
    "vertex@0:u32 vertex_count@4:u32 reason@8:u32 carried_q16@12:u32 style_q16@16:u32 mismatch_q16@20:u32 distance_q16@24:u32 " +
    "reserved@28:u32"),
  transferOutputs: layout(56,
    "struct_size@0:u32 part_capacity@4:u32 joint_indices@8:u32 weights@12:u32 confidence@16:u32 parts@20:u32 " +
    "vertex_parts@24:u32 part_count@28:u32 bound_by@32:u32 carried_q16@36:u32 style_q16@40:u32 mismatch_q16@44:u32 " +
    "reference_count@48:u32 used_bytes@52:u32"),
  referenceOptions: layout(48,
    "struct_size@0:u32 area_power@4:u32 own_limb@8:u32 legs@12:u32 falloff@16:f32 least_cosine@20:f32 progress@24:u32 " +
    "progress_user@28:u32 head@32:u32 torso@36:u32 source_points@40:u32 as_drawn@44:u32"),
  simplifyOptions: layout(20, "struct_size@0:u32 level@4:u32 joint_count@8:u32 as_drawn@12:u32 centroids@16:u32"),
  springJoint: layout(36,
    "joint@0:u32 hit_radius@4:f32 stiffness@8:f32 gravity_power@12:f32 gravity@16:f32x3 drag@28:f32 limit@32:f32"),
  springChain: layout(20, "first_joint@0:u32 joint_count@4:u32 first_collider@8:u32 collider_count@12:u32 center@16:i32"),
  springCollider: layout(36, "joint@0:u32 shape@4:u32 offset@8:f32x3 tail@20:f32x3 radius@32:f32"),
  springSet: layout(44,
    "struct_size@0:u32 joint_count@4:u32 chain_count@8:u32 collider_count@12:u32 chain_collider_count@16:u32 reserved@20:u32 " +
    "joints@24:u32 chains@28:u32 colliders@32:u32 chain_colliders@36:u32 hinges@40:u32"),
  springsOptions: layout(24, "struct_size@0:u32 steps@4:f32 unit@8:f32 teleport@12:f32 gap@16:f32 reserved@20:u32"),
  file: layout(12, "name@0:u32 bytes@4:u32 size_bytes@8:u32"),
  characterProfileOptions: layout(32,
    "struct_size@0:u32 keep_axes@4:u32 profile@8:u32 license@12:u32 title@16:u32 authors@20:u32 author_count@24:u32 " +
    "controls@28:u32"),
  characterArrays: layout(92,
    "struct_size@0:u32 vertex_count@4:u32 face_count@8:u32 corner_count@12:u32 joint_count@16:u32 mesh_count@20:u32 " +
    "influence_count@24:u32 reserved@28:u32 name@32:u32 positions@36:u32 face_offsets@40:u32 face_vertices@44:u32 " +
    "joint_positions@48:u32 parents@52:u32 joint_names@56:u32 row_offsets@60:u32 joint_indices@64:u32 weights@68:u32 " +
    "confidence@72:u32 vertex_meshes@76:u32 mesh_names@80:u32 mesh_joints@84:u32 mesh_skinned@88:u32"),
  characterClip: layout(48,
    "struct_size@0:u32 frame_count@4:u32 joint_count@8:u32 reserved@12:u32 frame_time@16:f64 name@24:u32 rotations@28:u32 " +
    "translations@32:u32 joint_names@36:u32 parents@40:u32"),
  characterTransformOptions: layout(32, "struct_size@0:u32 turn_count@4:u32 turns@8:u32 height@16:f64 floor@24:u32 up@28:u32"),
  characterFinding: layout(96,
    "rule@0:u32 what@4:u32 cure@8:u32 pose@12:u32 clip@16:u32 seconds@24:f64 value@32:f64 bound@40:f64 vertices@48:u32 " +
    "vertex_count@52:u32 severity@56:u32 joint@60:i32 other@64:i32 mesh@68:i32 position@72:f32x3 radius@84:f32 reserved@88:u32"),
  characterCheckOptions: layout(24, "struct_size@0:u32 without@4:u32 score@8:u32 bound_count@12:u32 bound_rules@16:u32 bounds@20:u32"),
  characterCheckResult: layout(40,
    "struct_size@0:u32 finding_count@4:u32 errors@8:u32 warnings@12:u32 notes@16:u32 reserved@20:u32 findings@24:u32 " +
    "line@28:u32 score@32:f64"),
  characterModels: layout(48,
    "struct_size@0:u32 reserved@4:u32 bind@8:u32 bind_size@12:u32 rig@16:u32 rig_size@20:u32 hands@24:u32 hands_size@28:u32 " +
    "slots@32:u32 slots_size@36:u32 front@40:u32 front_size@44:u32"),
  characterBindOptions: layout(116,
    "struct_size@0:u32 thread_count@4:u32 progress@8:u32 progress_user@12:u32 models@16:u32 method@20:u32 " +
    "influence_count@24:u32 up@28:u32 joints@32:u32 rigid_parts@36:u32 softness_percent@40:u32 surface_vertices@44:u32 " +
    "keep_tips@48:u32 bind_props@52:u32 fit@56:u32 symmetric@60:u32 keep_confidence@64:u32 question_count@68:u32 " +
    "answer_count@72:u32 answers@76:u32 joint_flags@80:u32 locked@84:u32 hinted@88:u32 hints@92:u32 like@96:u32 style@100:u32 " +
    "to_pose@104:u32 cut@108:u32 reserved@112:u32"),
  characterSeam: layout(24, "joints@0:u32x2 position@8:f32x3 length@20:f32"),
  characterLeftOut: layout(12, "why@0:u32 joint@4:u32 reserved@8:u32"),
  characterBindResult: layout(72,
    "struct_size@0:u32 symmetric_vertices@4:u32 kept_meshes@8:u32 folded_tips@12:u32 left_out_count@16:u32 " +
    "question_count@20:u32 answers_by_style@24:u32 seam_count@28:u32 seconds@32:f64 workspace_bytes@40:u32 left_out@44:u32 " +
    "questions@48:u32 vertex_questions@52:u32 hash@56:u32 seams@60:u32 doubled_vertices@64:u32 reserved@68:u32"),
  skeletonEdit: layout(32, "kind@0:u32 reserved@4:u32 joint@8:u32 other@12:u32 position@16:f32x3 reserved2@28:u32"),
  characterRigOptions: layout(84,
    "struct_size@0:u32 thread_count@4:u32 progress@8:u32 progress_user@12:u32 models@16:u32 bind@20:u32 method@24:u32 " +
    "detail@28:u32 mirror@32:u32 up@36:u32 front@40:u32 category@44:u32 spine_count@48:u32 without@52:u32 keep_lengths@56:u32 " +
    "gate@60:u32 reserved@64:u32 edit_count@68:u32 edits@72:u32 skeleton@76:u32 skeleton_character@80:u32"),
  characterDoubt: layout(12, "name@0:u32 doubt@4:f32 reserved@8:u32"),
  characterRigResult: layout(104,
    "struct_size@0:u32 mirrored@4:u32 matched@8:u32 joint_count@12:u32 spread@16:f32 reserved@20:f32 scale@24:f64 " +
    "seconds@32:f64 bind_seconds@40:f64 ends@48:u32 confidence@52:u32 parent_confidence@56:u32 front@60:f32x3 up@72:u32 " +
    "front_confidence@76:f32 up_confidence@80:f32 seam_count@84:u32 seams@88:u32 doubtful_count@92:u32 doubtful@96:u32"),
  motionSource: layout(48,
    "struct_size@0:u32 up@4:u32 file@8:u32 layout@12:u32 actor@16:u32 clip@20:u32 fps@24:f64 from@32:f64 to@40:f64"),
  characterMapOptions: layout(44,
    "struct_size@0:u32 method@4:u32 without@8:u32 target_up@12:u32 guess_up@16:u32 pin_count@20:u32 pins@24:u32 " +
    "pins_file@28:u32 branches_first@32:u32 branches_cost@36:u32 source@40:u32"),
  characterMapResult: layout(48,
    "struct_size@0:u32 method@4:u32 joint_count@8:u32 mapped@12:u32 certainty@16:f32 cover@20:f32 seconds@24:f64 " +
    "sources@32:u32 confidence@36:u32 reasons@40:u32 text@44:u32"),
  characterDeformation: layout(40,
    "struct_size@0:u32 method@4:u32 cells@8:u32 rounds@12:u32 body_contact@16:u32 tet_weights@20:u32 without@24:u32 " +
    "deform_as_drawn@28:u32 stiffness@32:f64"),
  characterAnimateOptions: layout(96,
    "struct_size@0:u32 thread_count@4:u32 progress@8:u32 progress_user@12:u32 models@16:u32 motion@20:u32 deform@24:u32 " +
    "reference@28:u32 method@32:u32 without@36:u32 in_place@40:u32 target_up@44:u32 shapes@48:u32 report@52:u32 force@56:u32 " +
    "translations@60:u32 depth@64:u32 pin_count@68:u32 pins@72:u32 map@76:u32 sources@80:u32 limits@84:u32 springs@88:u32 " +
    "arm_spread@92:f32"),
  characterAnimateResult: layout(80,
    "struct_size@0:u32 clip_count@4:u32 first_clip@8:u32 mapped@12:u32 rigged@16:u32 shape_count@20:u32 certainty@24:f32 " +
    "limb_count@28:u32 limbs_before@32:u32 limbs_after@36:u32 mapped_by@40:u32 sources@44:u32 reasons@48:u32 " +
    "source_ends@52:u32 source_names@56:u32 source_count@60:u32 spot_count@64:u32 spot_kinds@68:u32 spot_positions@72:u32 " +
    "spot_errors@76:u32"),
  characterPoseOptions: layout(40,
    "struct_size@0:u32 thread_count@4:u32 deform@8:u32 angles@12:u32 rotations@16:u32 matrices@20:u32 clip@24:u32 time@32:f64"),
  characterTransferOptions: layout(64,
    "struct_size@0:u32 thread_count@4:u32 progress@8:u32 progress_user@12:u32 models@16:u32 method@20:u32 " +
    "influence_count@24:u32 target_up@28:u32 source_up@32:u32 garment@36:u32 as_drawn@40:u32 heat@44:u32 pair_count@48:u32 " +
    "pairs@52:u32 locked@56:u32 map@60:u32"),
  characterTransferResult: layout(64,
    "struct_size@0:u32 mapped_joints@4:u32 fitted@8:u32 bound@12:u32 bound_by@16:u32 part_count@20:u32 carried@24:f64 " +
    "style@32:f64 mismatch@40:f64 seconds@48:f64 mapped_by@56:u32 parts@60:u32"),
  characterSimplifyOptions: layout(28,
    "struct_size@0:u32 low@4:u32 joint_count@8:u32 keep_count@12:u32 keep@16:u32 as_drawn@20:u32 reserved@24:u32"),
  characterLodOptions: layout(24, "struct_size@0:u32 level_count@4:u32 ratio@8:f64 fewer_joints@16:u32 reserved@20:u32"),
  characterLodLevel: layout(32, "rest_error@0:f64 posed_error@8:f64 mean_error@16:f64 triangle_count@24:u32 reserved@28:u32"),
  characterSpringsOptions: layout(48,
    "struct_size@0:u32 replace@4:u32 take_count@8:u32 drop_count@12:u32 preset_count@16:u32 value_count@20:u32 take@24:u32 " +
    "drop@28:u32 presets@32:u32 values@36:u32 make@40:u32 reserved@44:u32"),
  characterSpringsResult: layout(40,
    "struct_size@0:u32 chain_count@4:u32 joint_count@8:u32 collider_count@12:u32 proposal_count@16:u32 own_count@20:u32 " +
    "kept@24:u32 certainties@28:u32 names@32:u32 kinds@36:u32"),
  characterBakeOptions: layout(64,
    "struct_size@0:u32 reserved@4:u32 progress@8:u32 progress_user@12:u32 deform@16:u32 poses@20:u32 shapes@24:u32 " +
    "seed@32:u64 limit@40:f64 clip@48:u32 error@56:f64"),
  characterBakeResult: layout(56,
    "struct_size@0:u32 shape_count@4:u32 bend_count@8:u32 moved_vertices@12:u32 learnt_poses@16:u32 held_out_poses@20:u32 " +
    "linear_error@24:f64 baked_error@32:f64 held_out_linear_error@40:f64 held_out_baked_error@48:f64"),
  characterPictureOptions: layout(44,
    "struct_size@0:u32 body_class@4:u32 figure@8:u32 flat@12:u32 pixels@16:u32 line_count@20:u32 mask@24:u32 " +
    "line_offsets@28:u32 outline@32:u32 cut@36:u32 reserved@40:u32"),
  characterPictureInfo: layout(48,
    "struct_size@0:u32 width@4:u32 height@8:u32 figure_count@12:u32 figure@16:u32 body_class@20:u32 view@24:u32 " +
    "certainty@28:f32 line_count@32:u32 reserved@36:u32 line_offsets@40:u32 outline@44:u32"),
};

export const MODEL_BYTES = LAYOUTS.model.size, QUESTION_BYTES = LAYOUTS.question.size;

// Constants, without SINEW_.
export const VERSION_MAJOR = 0;
export const VERSION_MINOR = 1;
export const VERSION_PATCH = 0;
export const MAX_INFLUENCES = 12;
export const MAX_CANDIDATES = 16;
export const MAX_JOINTS = 4096;
export const MAX_VERTICES = 4000000;
export const WORKSPACE_ALIGNMENT = 64;
export const MAX_THREADS = 64;
export const MAX_ALTERNATIVES = 8;
export const MAX_QUESTIONS = 1024;
export const NO_QUESTION = 4294967295;
export const JOINT_NEVER = 1;
export const JOINT_DEFORMS = 2;
export const MAX_DEFORM_CELLS = 64;
export const MAX_DEFORM_ROUNDS = 200;
export const MAX_DEFORM_ENERGY = 1000000;
export const MAX_MAP_LIMBS = 1024;
export const MAX_FLOOR_SIDE = 4096;
export const MAX_MOTION_LIMBS = 16;
export const MAX_RIG_JOINTS = 192;
export const JOINT_NAME_BYTES = 32;
export const MAX_TRANSFER_PAIRS = 128;
export const MAX_BIHARMONIC_VERTICES = 65536;
export const NO_AREA = 4294967295;
export const MAX_CHAIN_COLLIDERS = 65536;
export const ERROR_INPUT = -30;
export const ERROR_MEMORY = -31;
export const MAX_LOD_LEVELS = 8;
export const WITHOUT_TOES = 1;
export const WITHOUT_ENDS = 2;
export const WITHOUT_BIND = 4;
export const WITHOUT_NAMES = 8;
export const WITHOUT_RANGE = 16;
export const WITHOUT_CONTACTS = 32;
export const WITHOUT_TWIST_SPREAD = 64;
export const WITHOUT_SMOOTHING = 128;
export const WITHOUT_POSES = 256;
export const WITHOUT_CLIPS = 512;
export const LIMIT_HINGE = 1;
export const LIMIT_BALL = 2;
export const DETAIL_HANDS = 1;
export const DETAIL_FACE = 2;
export const DETAIL_PROPS = 4;
export const COLLIDER_SPHERE = 1;
export const COLLIDER_CAPSULE = 2;
export const COLLIDER_INSIDE_SPHERE = 3;
export const COLLIDER_INSIDE_CAPSULE = 4;
export const COLLIDER_PLANE = 5;
export const READ_MESH = 1;
export const READ_SKELETON = 2;
export const READ_MOTION = 4;
export const READ_WHOLE = 8;
export const WRITE_CHARACTER = 16;
export const WRITE_MOTION = 32;
export const WRITE_MESH = 64;
export const READ_PICTURE = 256;

// Words of enumerations, by number.
export const WORDS = {
  kernel: ["auto", "ref", "avx2", "avxvnni", "vnni", "simd128", "neon", "dsp"],
  answerKind: ["proposed", "rigid", "soft", "hard", "softer", "host"],
  up: ["auto", "x", "y", "z"],
  weightFormat: ["unorm16", "unorm8", "float"],
  method: ["model", "heat", "distance"],
  rigidParts: ["auto", "always", "never"],
  deformMethod: ["volume", "xpbd", "delta-mush"],
  tetWeights: ["skin", "distance"],
  mapMethod: ["auto", "sinew", "branches"],
  mapReason: ["found", "pinned", "no-counterpart", "fewer-joints", "end", "outside", "taken", "beside-limits"],
  retargetMethod: ["auto", "copy", "node-offsets"],
  spotKind: ["none", "stands", "touches", "inside"],
  jointClass: ["pelvis", "spine", "neck", "head", "clavicle", "upper-arm", "forearm", "hand", "hip", "thigh", "calf", "foot",
    "toe", "tail", "wing", "ear", "hair", "other", "", "thumb", "index", "middle", "ring", "pinky", "eye", "jaw", "prop"],
  mirror: ["auto", "always", "never"],
  front: ["auto", "plus-z", "minus-z", "plus-x", "minus-x", "plus-y", "minus-y"],
  rigMethod: ["votes", "shape", "regions", "slots"],
  category: ["any", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "vehicle"],
  jointRole: ["deforms", "root", "control", "slot", "end", "twist", "face", "finger", "helper"],
  follows: ["unknown", "some", "none"],
  naming: ["sinew", "mixamo", "vrm", "unreal", "rigify", "makehuman"],
  transferMethod: ["auto", "nearest", "biharmonic", "rebind"],
  transferReason: ["asked", "style", "mismatch", "plain", "near", "far", "no-match", "kept"],
  branchesFirst: ["both", "target", "source"],
  branchesCost: ["mean", "sum"],
  simplifyLevel: ["high", "low"],
  checkSeverity: ["note", "warning", "error"],
  jointsFrom: ["auto", "own", "names", "all"],
  characterRigMethod: ["auto", "votes", "shape", "regions", "slots"],
  characterDetail: ["body", "hands", "full"],
  editKind: ["move", "add", "remove", "parent", "rename", "at"],
  animateMethod: ["auto", "copy", "contacts", "reference-points", "stream", "node-offsets"],
  poseDeform: ["linear", "dual-quaternion", "volume", "xpbd", "delta-mush"],
  bodyClass: ["found", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "other"],
  pictureView: ["front", "faces-right", "faces-left"],
};
