# SPDX-License-Identifier: MIT
"""The C interface by ctypes: constants, words of enumerations, structs, functions. Generated from the C headers by scripts/declarations.py; a test compares."""
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_float, c_int, c_int32, c_size_t, c_uint16, c_uint32, c_uint64,
                    c_void_p)
from typing import Any, Dict, List, Literal, Tuple

# Constants, without SINEW_.
VERSION_MAJOR = 0
VERSION_MINOR = 1
VERSION_PATCH = 0
MAX_INFLUENCES = 12
MAX_CANDIDATES = 16
MAX_JOINTS = 4096
MAX_VERTICES = 4000000
WORKSPACE_ALIGNMENT = 64
MAX_THREADS = 64
MAX_ALTERNATIVES = 8
MAX_QUESTIONS = 1024
NO_QUESTION = 4294967295
JOINT_NEVER = 1
JOINT_DEFORMS = 2
MAX_DEFORM_CELLS = 64
MAX_DEFORM_ROUNDS = 200
MAX_DEFORM_ENERGY = 1000000
MAX_MAP_LIMBS = 1024
MAX_FLOOR_SIDE = 4096
MAX_MOTION_LIMBS = 16
MAX_RIG_JOINTS = 192
JOINT_NAME_BYTES = 32
MAX_TRANSFER_PAIRS = 128
MAX_BIHARMONIC_VERTICES = 65536
NO_AREA = 4294967295
MAX_CHAIN_COLLIDERS = 65536
ERROR_INPUT = -30
ERROR_MEMORY = -31
MAX_LOD_LEVELS = 8
WITHOUT_TOES = 1
WITHOUT_ENDS = 2
WITHOUT_BIND = 4
WITHOUT_NAMES = 8
WITHOUT_RANGE = 16
WITHOUT_CONTACTS = 32
WITHOUT_TWIST_SPREAD = 64
WITHOUT_SMOOTHING = 128
WITHOUT_POSES = 256
WITHOUT_CLIPS = 512
LIMIT_HINGE = 1
LIMIT_BALL = 2
DETAIL_HANDS = 1
DETAIL_FACE = 2
DETAIL_PROPS = 4
COLLIDER_SPHERE = 1
COLLIDER_CAPSULE = 2
COLLIDER_INSIDE_SPHERE = 3
COLLIDER_INSIDE_CAPSULE = 4
COLLIDER_PLANE = 5
READ_MESH = 1
READ_SKELETON = 2
READ_MOTION = 4
READ_WHOLE = 8
WRITE_CHARACTER = 16
WRITE_MOTION = 32
WRITE_MESH = 64
READ_PICTURE = 256

# Words of enumerations, by number.
STATUS: Dict[str, int] = {"OK": 0, "ERROR_ARGUMENT": -1, "ERROR_WORKSPACE": -2, "ERROR_COUNT": -3, "ERROR_NOT_FINITE": -4,
    "ERROR_INDEX": -5, "ERROR_HIERARCHY": -6, "ERROR_NO_JOINT": -7, "ERROR_CANCELLED": -8, "ERROR_MODEL_MAGIC": -9,
    "ERROR_MODEL_VERSION": -10, "ERROR_MODEL_TRUNCATED": -11, "ERROR_MODEL_CHECKSUM": -12, "ERROR_MODEL_LAYOUT": -13,
    "ERROR_MODEL_OVERFLOW": -14, "ERROR_MODEL_ALIGNMENT": -15, "ERROR_RANGE": -16, "ERROR_KERNEL": -17, "ERROR_VERSION": -18,
    "ERROR_MODEL_TASK": -19, "ERROR_NOT_BUILT": -20, "ERROR_CHAIN": -21}
Kernel = Literal["auto", "ref", "avx2", "avxvnni", "vnni", "simd128", "neon", "dsp"]
KERNEL: Tuple[str, ...] = ("auto", "ref", "avx2", "avxvnni", "vnni", "simd128", "neon", "dsp")
WITHOUT: Dict[str, int] = {"WITHOUT_TOES": 1, "WITHOUT_ENDS": 2, "WITHOUT_BIND": 4, "WITHOUT_NAMES": 8, "WITHOUT_RANGE": 16,
    "WITHOUT_CONTACTS": 32, "WITHOUT_TWIST_SPREAD": 64, "WITHOUT_SMOOTHING": 128, "WITHOUT_POSES": 256, "WITHOUT_CLIPS": 512}
AnswerKind = Literal["proposed", "rigid", "soft", "hard", "softer", "host"]
ANSWER_KIND: Tuple[str, ...] = ("proposed", "rigid", "soft", "hard", "softer", "host")
Up = Literal["auto", "x", "y", "z"]
UP: Tuple[str, ...] = ("auto", "x", "y", "z")
WeightFormat = Literal["unorm16", "unorm8", "float"]
WEIGHT_FORMAT: Tuple[str, ...] = ("unorm16", "unorm8", "float")
Method = Literal["model", "heat", "distance"]
METHOD: Tuple[str, ...] = ("model", "heat", "distance")
RigidParts = Literal["auto", "always", "never"]
RIGID_PARTS: Tuple[str, ...] = ("auto", "always", "never")
DeformMethod = Literal["volume", "xpbd", "delta-mush"]
DEFORM_METHOD: Tuple[str, ...] = ("volume", "xpbd", "delta-mush")
TetWeights = Literal["skin", "distance"]
TET_WEIGHTS: Tuple[str, ...] = ("skin", "distance")
LIMIT_KIND: Dict[str, int] = {"LIMIT_HINGE": 1, "LIMIT_BALL": 2}
MapMethod = Literal["auto", "sinew", "branches"]
MAP_METHOD: Tuple[str, ...] = ("auto", "sinew", "branches")
MapReason = Literal["found", "pinned", "no-counterpart", "fewer-joints", "end", "outside", "taken", "beside-limits"]
MAP_REASON: Tuple[str, ...] = ("found", "pinned", "no-counterpart", "fewer-joints", "end", "outside", "taken", "beside-limits")
RetargetMethod = Literal["auto", "copy", "node-offsets"]
RETARGET_METHOD: Tuple[str, ...] = ("auto", "copy", "node-offsets")
SpotKind = Literal["none", "stands", "touches", "inside"]
SPOT_KIND: Tuple[str, ...] = ("none", "stands", "touches", "inside")
JointClass = Literal["pelvis", "spine", "neck", "head", "clavicle", "upper-arm", "forearm", "hand", "hip", "thigh", "calf", "foot", "toe",
    "tail", "wing", "ear", "hair", "other", "thumb", "index", "middle", "ring", "pinky", "eye", "jaw", "prop"]
JOINT_CLASS: Tuple[str, ...] = ("pelvis", "spine", "neck", "head", "clavicle", "upper-arm", "forearm", "hand", "hip", "thigh", "calf",
    "foot", "toe", "tail", "wing", "ear", "hair", "other", "", "thumb", "index", "middle", "ring", "pinky", "eye", "jaw", "prop")
Mirror = Literal["auto", "always", "never"]
MIRROR: Tuple[str, ...] = ("auto", "always", "never")
Front = Literal["auto", "plus-z", "minus-z", "plus-x", "minus-x", "plus-y", "minus-y"]
FRONT: Tuple[str, ...] = ("auto", "plus-z", "minus-z", "plus-x", "minus-x", "plus-y", "minus-y")
RigMethod = Literal["votes", "shape", "regions", "slots"]
RIG_METHOD: Tuple[str, ...] = ("votes", "shape", "regions", "slots")
Category = Literal["any", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "vehicle"]
CATEGORY: Tuple[str, ...] = ("any", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "vehicle")
RIG_DETAIL: Dict[str, int] = {"DETAIL_HANDS": 1, "DETAIL_FACE": 2, "DETAIL_PROPS": 4}
JointRole = Literal["deforms", "root", "control", "slot", "end", "twist", "face", "finger", "helper"]
JOINT_ROLE: Tuple[str, ...] = ("deforms", "root", "control", "slot", "end", "twist", "face", "finger", "helper")
Follows = Literal["unknown", "some", "none"]
FOLLOWS: Tuple[str, ...] = ("unknown", "some", "none")
Naming = Literal["sinew", "mixamo", "vrm", "unreal", "rigify", "makehuman"]
NAMING: Tuple[str, ...] = ("sinew", "mixamo", "vrm", "unreal", "rigify", "makehuman")
TransferMethod = Literal["auto", "nearest", "biharmonic", "rebind"]
TRANSFER_METHOD: Tuple[str, ...] = ("auto", "nearest", "biharmonic", "rebind")
TransferReason = Literal["asked", "style", "mismatch", "plain", "near", "far", "no-match", "kept"]
TRANSFER_REASON: Tuple[str, ...] = ("asked", "style", "mismatch", "plain", "near", "far", "no-match", "kept")
BranchesFirst = Literal["both", "target", "source"]
BRANCHES_FIRST: Tuple[str, ...] = ("both", "target", "source")
BranchesCost = Literal["mean", "sum"]
BRANCHES_COST: Tuple[str, ...] = ("mean", "sum")
SimplifyLevel = Literal["high", "low"]
SIMPLIFY_LEVEL: Tuple[str, ...] = ("high", "low")
COLLIDER_SHAPE: Dict[str, int] = {"COLLIDER_SPHERE": 1, "COLLIDER_CAPSULE": 2, "COLLIDER_INSIDE_SPHERE": 3, "COLLIDER_INSIDE_CAPSULE": 4,
    "COLLIDER_PLANE": 5}
FILE_USE: Dict[str, int] = {"READ_MESH": 1, "READ_SKELETON": 2, "READ_MOTION": 4, "READ_WHOLE": 8, "WRITE_CHARACTER": 16,
    "WRITE_MOTION": 32, "WRITE_MESH": 64, "READ_PICTURE": 256}
CheckSeverity = Literal["note", "warning", "error"]
CHECK_SEVERITY: Tuple[str, ...] = ("note", "warning", "error")
JointsFrom = Literal["auto", "own", "names", "all"]
JOINTS_FROM: Tuple[str, ...] = ("auto", "own", "names", "all")
CharacterRigMethod = Literal["auto", "votes", "shape", "regions", "slots"]
CHARACTER_RIG_METHOD: Tuple[str, ...] = ("auto", "votes", "shape", "regions", "slots")
CharacterDetail = Literal["body", "hands", "full"]
CHARACTER_DETAIL: Tuple[str, ...] = ("body", "hands", "full")
EditKind = Literal["move", "add", "remove", "parent", "rename", "at"]
EDIT_KIND: Tuple[str, ...] = ("move", "add", "remove", "parent", "rename", "at")
AnimateMethod = Literal["auto", "copy", "contacts", "reference-points", "stream", "node-offsets"]
ANIMATE_METHOD: Tuple[str, ...] = ("auto", "copy", "contacts", "reference-points", "stream", "node-offsets")
PoseDeform = Literal["linear", "dual-quaternion", "volume", "xpbd", "delta-mush"]
POSE_DEFORM: Tuple[str, ...] = ("linear", "dual-quaternion", "volume", "xpbd", "delta-mush")
BodyClass = Literal["found", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "other"]
BODY_CLASS: Tuple[str, ...] = ("found", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "other")
PictureView = Literal["front", "faces-right", "faces-left"]
PICTURE_VIEW: Tuple[str, ...] = ("front", "faces-right", "faces-left")

# Callbacks.
sinew_progress = CFUNCTYPE(c_int, c_void_p, c_uint32)
sinew_parallel_for_body = CFUNCTYPE(None, c_void_p, c_uint32)
sinew_parallel_for = CFUNCTYPE(None, c_void_p, c_uint32, sinew_parallel_for_body, c_void_p)


class sinew_mesh(Structure):
    _fields_ = [("positions", c_void_p), ("vertex_count", c_uint32), ("face_offsets", c_void_p), ("face_vertices", c_void_p),
        ("face_count", c_uint32), ("corner_count", c_uint32)]


class sinew_model(Structure):
    _fields_ = [("bytes", c_void_p), ("size_bytes", c_size_t), ("packed", c_void_p), ("format_version", c_uint32),
        ("candidate_count", c_uint32), ("grid_size", c_uint32), ("feature_set", c_uint32), ("fixed_candidates", c_uint32),
        ("layer_count", c_uint32), ("parameter_count", c_uint32), ("checksum", c_uint32), ("confidence_offset", c_uint32),
        ("confidence_count", c_uint32), ("task", c_uint32), ("input_count", c_uint32), ("reserved", c_uint32 * 14)]


class sinew_answer(Structure):
    _fields_ = [("vertex", c_uint32), ("kind", c_uint16), ("joint", c_uint16), ("alone", c_uint32)]


class sinew_alternative(Structure):
    _fields_ = [("kind", c_uint16), ("joint", c_uint16), ("change", c_uint32)]


class sinew_question(Structure):
    _fields_ = [("vertex", c_uint32), ("part_count", c_uint32), ("vertex_count", c_uint32), ("joint", c_uint16), ("share", c_uint16),
        ("doubt", c_uint32), ("gain", c_uint32), ("alternative_count", c_uint32), ("reserved", c_uint32),
        ("alternatives", sinew_alternative * 8)]


class sinew_skeleton(Structure):
    _fields_ = [("struct_size", c_uint32), ("joint_count", c_uint32), ("positions", c_void_p), ("parents", c_void_p), ("flags", c_void_p),
        ("ends", c_void_p), ("names", POINTER(c_char_p)), ("rotations", c_void_p), ("up", c_uint32), ("reserved", c_uint32)]


class sinew_skin(Structure):
    _fields_ = [("joint_indices", c_void_p), ("weights", c_void_p), ("influence_count", c_uint32), ("weight_format", c_uint32)]


class sinew_bind_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("influence_count", c_uint32), ("weight_format", c_uint32),
        ("candidate_count", c_uint32), ("grid_size", c_uint32), ("surface_vertices", c_uint32), ("symmetric", c_uint32),
        ("rigid_parts", c_uint32), ("softness_percent", c_uint32), ("weights_in_place", c_uint32), ("kernel", c_uint32),
        ("thread_count", c_uint32), ("reserved", c_uint32), ("locked", c_void_p), ("hints", c_void_p), ("parallel_for", sinew_parallel_for),
        ("parallel_user", c_void_p), ("progress", sinew_progress), ("progress_user", c_void_p), ("answers", POINTER(sinew_answer)),
        ("answer_count", c_uint32), ("question_count", c_uint32)]


class sinew_bind_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("symmetric_vertices", c_uint32), ("joint_indices", c_void_p), ("weights", c_void_p),
        ("confidence", c_void_p), ("used_bytes", c_size_t), ("questions", POINTER(sinew_question)), ("vertex_questions", c_void_p),
        ("vertex_parts", c_void_p), ("questions_written", c_uint32), ("reserved", c_uint32)]


class sinew_deform_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("cell_count", c_uint32), ("round_count", c_uint32),
        ("softness", c_uint32), ("without", c_uint32), ("thread_count", c_uint32), ("body_contact", c_uint32),
        ("parallel_for", sinew_parallel_for), ("parallel_user", c_void_p), ("energy", c_uint32), ("tet_weights", c_uint32),
        ("as_drawn", c_uint32), ("reserved", c_uint32)]


class sinew_deformer(Structure):
    _fields_ = [("memory", c_void_p), ("pose_bytes", c_size_t), ("vertex_count", c_uint32), ("joint_count", c_uint32),
        ("tetrahedron_count", c_uint32), ("node_count", c_uint32), ("split_cell_count", c_uint32), ("reserved", c_uint32 * 7)]


class sinew_deform_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("corrected", c_uint32), ("positions", c_void_p), ("active_tetrahedra", c_uint32),
        ("inverted_tetrahedra", c_uint32)]


class sinew_joint_limit(Structure):
    _fields_ = [("joint", c_uint32), ("kind", c_uint32), ("zero", c_float * 4), ("axis", c_float * 3), ("side", c_float * 3),
        ("least", c_float * 3), ("most", c_float * 3)]


class sinew_map_pin(Structure):
    _fields_ = [("target", c_uint32), ("source", c_int32)]


class sinew_map_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("pin_count", c_uint32), ("reserved", c_uint32),
        ("pins", POINTER(sinew_map_pin)), ("branches_first", c_uint32), ("branches_cost", c_uint32), ("target_areas", c_void_p),
        ("source_areas", c_void_p), ("source_animated", c_void_p)]


class sinew_map_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("sources", c_void_p), ("confidence", c_void_p), ("reasons", c_void_p),
        ("mapped", c_uint32), ("certainty", c_uint32), ("used_bytes", c_size_t)]


class sinew_retarget_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("in_place", c_uint32), ("scale", c_float), ("translations", c_uint32),
        ("arm_spread", c_float)]


class sinew_motion_body(Structure):
    _fields_ = [("positions", c_void_p), ("triangles", c_void_p), ("skin", sinew_skin), ("vertex_count", c_uint32),
        ("triangle_count", c_uint32)]


class sinew_floor(Structure):
    _fields_ = [("heights", c_void_p), ("columns", c_uint32), ("rows", c_uint32), ("first", c_float * 2), ("step", c_float),
        ("reserved", c_uint32)]


class sinew_contact_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("fps", c_float), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("floor", POINTER(sinew_floor))]


class sinew_motion_clip(Structure):
    _fields_ = [("source_rotations", c_void_p), ("source_translations", c_void_p), ("rotations", c_void_p), ("translations", c_void_p),
        ("frame_count", c_uint32), ("ground", c_float)]


class sinew_limb_quality(Structure):
    _fields_ = [("joint", c_uint32), ("leg", c_uint32), ("frames", c_uint32), ("deep_frames", c_uint32), ("contact_frames", c_uint32),
        ("range_frames", c_uint32), ("depth", c_float), ("greatest_depth", c_float), ("error", c_float), ("greatest_error", c_float),
        ("reserved", c_uint32 * 2)]


class sinew_contact_spot(Structure):
    _fields_ = [("kind", c_uint32), ("position", c_float * 3), ("error", c_float), ("reserved", c_uint32)]


class sinew_retarget_stream_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("fps", c_float), ("ground", c_float), ("has_ground", c_uint32), ("without", c_uint32),
        ("reserved", c_uint32), ("floor", POINTER(sinew_floor)), ("source", POINTER(sinew_motion_body))]


class sinew_rig_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("up", c_uint32), ("mirror", c_uint32), ("spine_count", c_uint32), ("without", c_uint32),
        ("reserved", c_uint32), ("weights_in_place", c_uint32), ("kernel", c_uint32), ("progress", sinew_progress),
        ("progress_user", c_void_p), ("method", c_uint32), ("category", c_uint32), ("front_model", POINTER(sinew_model)),
        ("front", c_uint32), ("axes_known", c_uint32)]


class sinew_rig_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("joint_count", c_uint32), ("positions", c_void_p), ("parents", c_void_p), ("flags", c_void_p),
        ("joint_classes", c_void_p), ("partners", c_void_p), ("confidence", c_void_p), ("parent_confidence", c_void_p), ("names", c_void_p),
        ("mirrored", c_uint32), ("facing", c_uint32), ("plane", c_float), ("spread", c_float), ("used_bytes", c_size_t),
        ("front", c_float * 3), ("up", c_uint32), ("front_confidence", c_float), ("up_confidence", c_float)]


class sinew_joint_verdicts(Structure):
    _fields_ = [("struct_size", c_uint32), ("mirror_axis", c_uint32), ("classes", c_void_p), ("roles", c_void_p), ("sides", c_void_p),
        ("numbers", c_void_p), ("partners", c_void_p), ("images", c_void_p), ("mirror_planes", c_float * 3), ("mirrored", c_uint32)]


class sinew_bound_character(Structure):
    _fields_ = [("mesh", POINTER(sinew_mesh)), ("skeleton", POINTER(sinew_skeleton)), ("skin", sinew_skin), ("joint_map", c_void_p)]


class sinew_vertex_pair(Structure):
    _fields_ = [("source", c_uint32), ("target", c_uint32)]


class sinew_transfer_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("influence_count", c_uint32), ("weight_format", c_uint32),
        ("garment", c_uint32), ("as_drawn", c_uint32), ("weights_in_place", c_uint32), ("kernel", c_uint32), ("thread_count", c_uint32),
        ("pair_count", c_uint32), ("locked", c_void_p), ("pairs", POINTER(sinew_vertex_pair)), ("parallel_for", sinew_parallel_for),
        ("parallel_user", c_void_p), ("progress", sinew_progress), ("progress_user", c_void_p)]


class sinew_transfer_part(Structure):
    _fields_ = [("vertex", c_uint32), ("vertex_count", c_uint32), ("reason", c_uint32), ("carried_q16", c_uint32), ("style_q16", c_uint32),
        ("mismatch_q16", c_uint32), ("distance_q16", c_uint32), ("reserved", c_uint32)]


class sinew_transfer_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("part_capacity", c_uint32), ("joint_indices", c_void_p), ("weights", c_void_p),
        ("confidence", c_void_p), ("parts", POINTER(sinew_transfer_part)), ("vertex_parts", c_void_p), ("part_count", c_uint32),
        ("bound_by", c_uint32), ("carried_q16", c_uint32), ("style_q16", c_uint32), ("mismatch_q16", c_uint32),
        ("reference_count", c_uint32), ("used_bytes", c_size_t)]


class sinew_reference_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("area_power", c_uint32), ("own_limb", c_uint32), ("legs", c_uint32), ("falloff", c_float),
        ("least_cosine", c_float), ("progress", sinew_progress), ("progress_user", c_void_p), ("head", c_uint32), ("torso", c_uint32),
        ("source_points", c_uint32), ("as_drawn", c_uint32)]


class sinew_simplify_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("level", c_uint32), ("joint_count", c_uint32), ("as_drawn", c_uint32), ("centroids", c_void_p)]


class sinew_spring_joint(Structure):
    _fields_ = [("joint", c_uint32), ("hit_radius", c_float), ("stiffness", c_float), ("gravity_power", c_float), ("gravity", c_float * 3),
        ("drag", c_float), ("limit", c_float)]


class sinew_spring_chain(Structure):
    _fields_ = [("first_joint", c_uint32), ("joint_count", c_uint32), ("first_collider", c_uint32), ("collider_count", c_uint32),
        ("center", c_int32)]


class sinew_spring_collider(Structure):
    _fields_ = [("joint", c_uint32), ("shape", c_uint32), ("offset", c_float * 3), ("tail", c_float * 3), ("radius", c_float)]


class sinew_spring_set(Structure):
    _fields_ = [("struct_size", c_uint32), ("joint_count", c_uint32), ("chain_count", c_uint32), ("collider_count", c_uint32),
        ("chain_collider_count", c_uint32), ("reserved", c_uint32), ("joints", POINTER(sinew_spring_joint)),
        ("chains", POINTER(sinew_spring_chain)), ("colliders", POINTER(sinew_spring_collider)), ("chain_colliders", c_void_p),
        ("hinges", c_void_p)]


class sinew_springs_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("steps", c_float), ("unit", c_float), ("teleport", c_float), ("gap", c_float),
        ("reserved", c_uint32)]


class sinew_file(Structure):
    _fields_ = [("name", c_char_p), ("bytes", c_void_p), ("size_bytes", c_size_t)]


class sinew_character_profile_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("keep_axes", c_uint32), ("profile", c_char_p), ("license", c_char_p), ("title", c_char_p),
        ("authors", POINTER(c_char_p)), ("author_count", c_uint32), ("controls", c_uint32)]


class sinew_character_arrays(Structure):
    _fields_ = [("struct_size", c_uint32), ("vertex_count", c_uint32), ("face_count", c_uint32), ("corner_count", c_uint32),
        ("joint_count", c_uint32), ("mesh_count", c_uint32), ("influence_count", c_uint32), ("reserved", c_uint32), ("name", c_char_p),
        ("positions", c_void_p), ("face_offsets", c_void_p), ("face_vertices", c_void_p), ("joint_positions", c_void_p),
        ("parents", c_void_p), ("joint_names", POINTER(c_char_p)), ("row_offsets", c_void_p), ("joint_indices", c_void_p),
        ("weights", c_void_p), ("confidence", c_void_p), ("vertex_meshes", c_void_p), ("mesh_names", POINTER(c_char_p)),
        ("mesh_joints", c_void_p), ("mesh_skinned", c_void_p)]


class sinew_character_clip(Structure):
    _fields_ = [("struct_size", c_uint32), ("frame_count", c_uint32), ("joint_count", c_uint32), ("reserved", c_uint32),
        ("frame_time", c_double), ("name", c_char_p), ("rotations", c_void_p), ("translations", c_void_p),
        ("joint_names", POINTER(c_char_p)), ("parents", c_void_p)]


class sinew_character_transform_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("turn_count", c_uint32), ("turns", POINTER(c_char_p)), ("height", c_double),
        ("floor", c_uint32), ("up", c_uint32)]


class sinew_character_finding(Structure):
    _fields_ = [("rule", c_char_p), ("what", c_char_p), ("cure", c_char_p), ("pose", c_char_p), ("clip", c_char_p), ("seconds", c_double),
        ("value", c_double), ("bound", c_double), ("vertices", c_void_p), ("vertex_count", c_uint32), ("severity", c_uint32),
        ("joint", c_int32), ("other", c_int32), ("mesh", c_int32), ("position", c_float * 3), ("radius", c_float), ("reserved", c_uint32)]


class sinew_character_check_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("without", c_uint32), ("score", c_uint32), ("bound_count", c_uint32),
        ("bound_rules", POINTER(c_char_p)), ("bounds", c_void_p)]


class sinew_character_check_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("finding_count", c_uint32), ("errors", c_uint32), ("warnings", c_uint32), ("notes", c_uint32),
        ("reserved", c_uint32), ("findings", POINTER(sinew_character_finding)), ("line", c_char_p), ("score", c_double)]


class sinew_character_models(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("bind", c_void_p), ("bind_size", c_size_t), ("rig", c_void_p),
        ("rig_size", c_size_t), ("hands", c_void_p), ("hands_size", c_size_t), ("slots", c_void_p), ("slots_size", c_size_t),
        ("front", c_void_p), ("front_size", c_size_t)]


class sinew_character_bind_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("thread_count", c_uint32), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("models", POINTER(sinew_character_models)), ("method", c_uint32), ("influence_count", c_uint32), ("up", c_uint32),
        ("joints", c_uint32), ("rigid_parts", c_uint32), ("softness_percent", c_uint32), ("surface_vertices", c_uint32),
        ("keep_tips", c_uint32), ("bind_props", c_uint32), ("fit", c_uint32), ("symmetric", c_uint32), ("keep_confidence", c_uint32),
        ("question_count", c_uint32), ("answer_count", c_uint32), ("answers", POINTER(sinew_answer)), ("joint_flags", c_void_p),
        ("locked", c_void_p), ("hinted", c_void_p), ("hints", c_void_p), ("like", c_void_p), ("style", c_char_p), ("to_pose", c_char_p),
        ("cut", c_uint32), ("reserved", c_uint32)]


class sinew_character_seam(Structure):
    _fields_ = [("joints", c_uint32 * 2), ("position", c_float * 3), ("length", c_float)]


class sinew_character_left_out(Structure):
    _fields_ = [("why", c_char_p), ("joint", c_uint32), ("reserved", c_uint32)]


class sinew_character_bind_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("symmetric_vertices", c_uint32), ("kept_meshes", c_uint32), ("folded_tips", c_uint32),
        ("left_out_count", c_uint32), ("question_count", c_uint32), ("answers_by_style", c_uint32), ("seam_count", c_uint32),
        ("seconds", c_double), ("workspace_bytes", c_size_t), ("left_out", POINTER(sinew_character_left_out)),
        ("questions", POINTER(sinew_question)), ("vertex_questions", c_void_p), ("hash", c_char_p),
        ("seams", POINTER(sinew_character_seam)), ("doubled_vertices", c_uint32), ("reserved", c_uint32)]


class sinew_skeleton_edit(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("joint", c_char_p), ("other", c_char_p), ("position", c_float * 3),
        ("reserved2", c_uint32)]


class sinew_character_rig_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("thread_count", c_uint32), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("models", POINTER(sinew_character_models)), ("bind", POINTER(sinew_character_bind_options)), ("method", c_uint32),
        ("detail", c_uint32), ("mirror", c_uint32), ("up", c_uint32), ("front", c_uint32), ("category", c_uint32),
        ("spine_count", c_uint32), ("without", c_uint32), ("keep_lengths", c_uint32), ("gate", c_uint32), ("reserved", c_uint32),
        ("edit_count", c_uint32), ("edits", POINTER(sinew_skeleton_edit)), ("skeleton", c_char_p), ("skeleton_character", c_void_p)]


class sinew_character_doubt(Structure):
    _fields_ = [("name", c_char_p), ("doubt", c_float), ("reserved", c_uint32)]


class sinew_character_rig_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("mirrored", c_uint32), ("matched", c_uint32), ("joint_count", c_uint32), ("spread", c_float),
        ("reserved", c_float), ("scale", c_double), ("seconds", c_double), ("bind_seconds", c_double), ("ends", c_void_p),
        ("confidence", c_void_p), ("parent_confidence", c_void_p), ("front", c_float * 3), ("up", c_uint32), ("front_confidence", c_float),
        ("up_confidence", c_float), ("seam_count", c_uint32), ("seams", POINTER(sinew_character_seam)), ("doubtful_count", c_uint32),
        ("doubtful", POINTER(sinew_character_doubt))]


class sinew_motion_source(Structure):
    _fields_ = [("struct_size", c_uint32), ("up", c_uint32), ("file", c_char_p), ("layout", c_char_p), ("actor", c_char_p),
        ("clip", c_char_p), ("fps", c_double), ("from", c_double), ("to", c_double)]


class sinew_character_map_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("without", c_uint32), ("target_up", c_uint32), ("guess_up", c_uint32),
        ("pin_count", c_uint32), ("pins", POINTER(sinew_map_pin)), ("pins_file", c_char_p), ("branches_first", c_uint32),
        ("branches_cost", c_uint32), ("source", POINTER(sinew_motion_source))]


class sinew_character_map_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("joint_count", c_uint32), ("mapped", c_uint32), ("certainty", c_float),
        ("cover", c_float), ("seconds", c_double), ("sources", c_void_p), ("confidence", c_void_p), ("reasons", c_void_p),
        ("text", c_char_p)]


class sinew_character_deformation(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("cells", c_uint32), ("rounds", c_uint32), ("body_contact", c_uint32),
        ("tet_weights", c_uint32), ("without", c_uint32), ("deform_as_drawn", c_uint32), ("stiffness", c_double)]


class sinew_character_animate_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("thread_count", c_uint32), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("models", POINTER(sinew_character_models)), ("motion", POINTER(sinew_motion_source)),
        ("deform", POINTER(sinew_character_deformation)), ("reference", POINTER(sinew_reference_options)), ("method", c_uint32),
        ("without", c_uint32), ("in_place", c_uint32), ("target_up", c_uint32), ("shapes", c_uint32), ("report", c_uint32),
        ("force", c_uint32), ("translations", c_uint32), ("depth", c_uint32), ("pin_count", c_uint32), ("pins", POINTER(sinew_map_pin)),
        ("map", c_char_p), ("sources", c_void_p), ("limits", c_char_p), ("springs", c_uint32), ("arm_spread", c_float)]


class sinew_character_animate_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("clip_count", c_uint32), ("first_clip", c_uint32), ("mapped", c_uint32), ("rigged", c_uint32),
        ("shape_count", c_uint32), ("certainty", c_float), ("limb_count", c_uint32), ("limbs_before", POINTER(sinew_limb_quality)),
        ("limbs_after", POINTER(sinew_limb_quality)), ("mapped_by", c_char_p), ("sources", c_void_p), ("reasons", c_void_p),
        ("source_ends", c_void_p), ("source_names", c_char_p), ("source_count", c_uint32), ("spot_count", c_uint32),
        ("spot_kinds", c_void_p), ("spot_positions", c_void_p), ("spot_errors", c_void_p)]


class sinew_character_pose_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("thread_count", c_uint32), ("deform", POINTER(sinew_character_deformation)),
        ("angles", c_void_p), ("rotations", c_void_p), ("matrices", c_void_p), ("clip", c_char_p), ("time", c_double)]


class sinew_character_transfer_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("thread_count", c_uint32), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("models", POINTER(sinew_character_models)), ("method", c_uint32), ("influence_count", c_uint32), ("target_up", c_uint32),
        ("source_up", c_uint32), ("garment", c_uint32), ("as_drawn", c_uint32), ("heat", c_uint32), ("pair_count", c_uint32),
        ("pairs", POINTER(sinew_vertex_pair)), ("locked", c_void_p), ("map", c_char_p)]


class sinew_character_transfer_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("mapped_joints", c_uint32), ("fitted", c_uint32), ("bound", c_uint32), ("bound_by", c_uint32),
        ("part_count", c_uint32), ("carried", c_double), ("style", c_double), ("mismatch", c_double), ("seconds", c_double),
        ("mapped_by", c_char_p), ("parts", POINTER(sinew_transfer_part))]


class sinew_character_simplify_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("low", c_uint32), ("joint_count", c_uint32), ("keep_count", c_uint32),
        ("keep", POINTER(c_char_p)), ("as_drawn", c_uint32), ("reserved", c_uint32)]


class sinew_character_lod_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("level_count", c_uint32), ("ratio", c_double), ("fewer_joints", c_uint32),
        ("reserved", c_uint32)]


class sinew_character_lod_level(Structure):
    _fields_ = [("rest_error", c_double), ("posed_error", c_double), ("mean_error", c_double), ("triangle_count", c_uint32),
        ("reserved", c_uint32)]


class sinew_character_springs_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("replace", c_uint32), ("take_count", c_uint32), ("drop_count", c_uint32),
        ("preset_count", c_uint32), ("value_count", c_uint32), ("take", POINTER(c_char_p)), ("drop", POINTER(c_char_p)),
        ("presets", POINTER(c_char_p)), ("values", POINTER(c_char_p)), ("make", c_uint32), ("reserved", c_uint32)]


class sinew_character_springs_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("chain_count", c_uint32), ("joint_count", c_uint32), ("collider_count", c_uint32),
        ("proposal_count", c_uint32), ("own_count", c_uint32), ("kept", c_void_p), ("certainties", c_void_p), ("names", c_char_p),
        ("kinds", c_char_p)]


class sinew_character_bake_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("progress", sinew_progress), ("progress_user", c_void_p),
        ("deform", POINTER(sinew_character_deformation)), ("poses", c_uint32), ("shapes", c_uint32), ("seed", c_uint64),
        ("limit", c_double), ("clip", c_char_p), ("error", c_double)]


class sinew_character_bake_result(Structure):
    _fields_ = [("struct_size", c_uint32), ("shape_count", c_uint32), ("bend_count", c_uint32), ("moved_vertices", c_uint32),
        ("learnt_poses", c_uint32), ("held_out_poses", c_uint32), ("linear_error", c_double), ("baked_error", c_double),
        ("held_out_linear_error", c_double), ("held_out_baked_error", c_double)]


class sinew_character_picture_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("body_class", c_uint32), ("figure", c_uint32), ("flat", c_uint32), ("pixels", c_uint32),
        ("line_count", c_uint32), ("mask", c_char_p), ("line_offsets", c_void_p), ("outline", c_void_p), ("cut", c_uint32),
        ("reserved", c_uint32)]


class sinew_character_picture_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("width", c_uint32), ("height", c_uint32), ("figure_count", c_uint32), ("figure", c_uint32),
        ("body_class", c_uint32), ("view", c_uint32), ("certainty", c_float), ("line_count", c_uint32), ("reserved", c_uint32),
        ("line_offsets", c_void_p), ("outline", c_void_p)]



STRUCTS: Tuple[Any, ...] = (sinew_mesh, sinew_model, sinew_answer, sinew_alternative, sinew_question, sinew_skeleton, sinew_skin,
    sinew_bind_options, sinew_bind_outputs, sinew_deform_options, sinew_deformer, sinew_deform_outputs, sinew_joint_limit, sinew_map_pin,
    sinew_map_options, sinew_map_outputs, sinew_retarget_options, sinew_motion_body, sinew_floor, sinew_contact_options, sinew_motion_clip,
    sinew_limb_quality, sinew_contact_spot, sinew_retarget_stream_options, sinew_rig_options, sinew_rig_outputs, sinew_joint_verdicts,
    sinew_bound_character, sinew_vertex_pair, sinew_transfer_options, sinew_transfer_part, sinew_transfer_outputs, sinew_reference_options,
    sinew_simplify_options, sinew_spring_joint, sinew_spring_chain, sinew_spring_collider, sinew_spring_set, sinew_springs_options)


CHARACTER_STRUCTS: Tuple[Any, ...] = (sinew_file, sinew_character_profile_options, sinew_character_arrays, sinew_character_clip,
    sinew_character_transform_options, sinew_character_finding, sinew_character_check_options, sinew_character_check_result,
    sinew_character_models, sinew_character_bind_options, sinew_character_seam, sinew_character_left_out, sinew_character_bind_result,
    sinew_skeleton_edit, sinew_character_rig_options, sinew_character_doubt, sinew_character_rig_result, sinew_motion_source,
    sinew_character_map_options, sinew_character_map_result, sinew_character_deformation, sinew_character_animate_options,
    sinew_character_animate_result, sinew_character_pose_options, sinew_character_transfer_options, sinew_character_transfer_result,
    sinew_character_simplify_options, sinew_character_lod_options, sinew_character_lod_level, sinew_character_springs_options,
    sinew_character_springs_result, sinew_character_bake_options, sinew_character_bake_result, sinew_character_picture_options,
    sinew_character_picture_info)


# Result and arguments.
FUNCTIONS: Dict[str, Tuple[Any, List[Any]]] = {
    "sinew_status_text": (c_char_p, [c_int]),
    "sinew_version": (c_char_p, []),
    "sinew_kernel_name": (c_char_p, [c_uint32]),
    "sinew_kernel_select": (c_uint32, [c_uint32]),
    "sinew_struct_size": (c_size_t, [c_char_p]),
    "sinew_model_open": (c_int, [c_void_p, c_size_t, POINTER(sinew_model)]),
    "sinew_model_pack_workspace_size": (c_int, [POINTER(sinew_model), POINTER(c_size_t)]),
    "sinew_model_pack": (c_int, [POINTER(sinew_model), c_void_p, c_size_t]),
    "sinew_skin_linear": (c_int, [c_void_p, c_uint32, POINTER(sinew_skin), c_void_p, c_uint32, c_void_p]),
    "sinew_skin_dual_quaternion": (c_int, [c_void_p, c_uint32, POINTER(sinew_skin), c_void_p, c_uint32, c_void_p]),
    "sinew_bind_workspace_size": (c_int, [POINTER(sinew_model), c_uint32, c_uint32, c_uint32, c_uint32, POINTER(sinew_bind_options),
        POINTER(c_size_t)]),
    "sinew_bind": (c_int, [POINTER(sinew_model), POINTER(sinew_mesh), POINTER(sinew_skeleton), POINTER(sinew_bind_options), c_void_p,
        c_size_t, POINTER(sinew_bind_outputs)]),
    "sinew_deform_create_workspace_size": (c_int, [POINTER(sinew_mesh), c_uint32, c_uint32, POINTER(sinew_deform_options),
        POINTER(c_size_t)]),
    "sinew_deform_create": (c_int, [POINTER(sinew_mesh), POINTER(sinew_skeleton), POINTER(sinew_skin), POINTER(sinew_deform_options),
        c_void_p, c_size_t, POINTER(sinew_deformer)]),
    "sinew_deform_pose": (c_int, [POINTER(sinew_deformer), c_void_p, c_void_p, c_size_t, POINTER(sinew_deform_outputs)]),
    "sinew_keep_joint_limits": (c_int, [POINTER(sinew_joint_limit), c_uint32, c_uint32, c_uint32, c_void_p]),
    "sinew_map_workspace_size": (c_int, [c_uint32, c_uint32, POINTER(c_size_t)]),
    "sinew_map": (c_int, [POINTER(sinew_skeleton), POINTER(sinew_skeleton), POINTER(sinew_map_options), c_void_p, c_size_t,
        POINTER(sinew_map_outputs)]),
    "sinew_retarget_create_workspace_size": (c_int, [c_uint32, c_uint32, POINTER(c_size_t)]),
    "sinew_retarget_create": (c_int, [POINTER(sinew_skeleton), POINTER(sinew_skeleton), c_void_p, c_void_p, POINTER(sinew_retarget_options),
        c_void_p, c_size_t, POINTER(c_void_p)]),
    "sinew_retarget_height": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p]),
    "sinew_retarget_ground": (c_int, [c_void_p, c_void_p, c_size_t, c_void_p]),
    "sinew_retarget_frame": (c_int, [c_void_p, c_void_p, c_void_p, c_float, c_void_p, c_void_p]),
    "sinew_retarget_contacts_workspace_size": (c_int, [c_void_p, POINTER(sinew_motion_body), c_uint32, POINTER(c_size_t)]),
    "sinew_retarget_contacts": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_body), POINTER(sinew_motion_clip),
        POINTER(sinew_contact_options), c_void_p, c_size_t]),
    "sinew_retarget_keep_range": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_clip), c_void_p, c_size_t]),
    "sinew_retarget_measure": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_body), POINTER(sinew_motion_clip),
        POINTER(sinew_contact_options), c_void_p, c_size_t, POINTER(sinew_limb_quality), c_void_p]),
    "sinew_retarget_spots": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_body), POINTER(sinew_motion_clip),
        POINTER(sinew_contact_options), c_void_p, c_size_t, POINTER(sinew_limb_quality), c_void_p, POINTER(sinew_contact_spot)]),
    "sinew_retarget_stream_workspace_size": (c_int, [c_uint32, c_uint32, c_uint32, c_uint32, POINTER(c_size_t)]),
    "sinew_retarget_stream_create": (c_int, [POINTER(sinew_skeleton), POINTER(sinew_skeleton), c_void_p, c_void_p,
        POINTER(sinew_retarget_options), POINTER(sinew_motion_body), POINTER(sinew_retarget_stream_options), c_void_p, c_size_t,
        POINTER(c_void_p)]),
    "sinew_retarget_stream_frame": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_void_p]),
    "sinew_retarget_stream_restart": (c_int, [c_void_p]),
    "sinew_rig_model_open": (c_int, [c_void_p, c_size_t, POINTER(sinew_model)]),
    "sinew_rig_workspace_size": (c_int, [POINTER(sinew_model), c_uint32, c_uint32, c_uint32, POINTER(sinew_rig_options),
        POINTER(c_size_t)]),
    "sinew_rig": (c_int, [POINTER(sinew_model), POINTER(sinew_mesh), POINTER(sinew_rig_options), c_void_p, c_size_t,
        POINTER(sinew_rig_outputs)]),
    "sinew_rig_details_workspace_size": (c_int, [POINTER(sinew_model), c_uint32, c_uint32, c_uint32, c_uint32, POINTER(sinew_rig_options),
        POINTER(c_size_t)]),
    "sinew_rig_details": (c_int, [POINTER(sinew_model), POINTER(sinew_mesh), c_uint32, POINTER(sinew_rig_options), c_void_p, c_size_t,
        POINTER(sinew_rig_outputs)]),
    "sinew_joint_classes_workspace_size": (c_int, [c_uint32, POINTER(c_size_t)]),
    "sinew_joint_classes": (c_int, [POINTER(sinew_skeleton), c_void_p, c_void_p, c_size_t, POINTER(sinew_joint_verdicts)]),
    "sinew_limb_classes_workspace_size": (c_int, [c_uint32, c_uint32, POINTER(c_size_t)]),
    "sinew_limb_classes": (c_int, [POINTER(sinew_skeleton), POINTER(sinew_skeleton), c_void_p, c_void_p, c_size_t, c_void_p]),
    "sinew_joint_side": (c_int32, [c_char_p]),
    "sinew_joint_other_side": (c_int, [c_char_p, c_void_p, c_size_t]),
    "sinew_naming_text": (c_char_p, [c_uint32]),
    "sinew_joint_standard_name": (c_int, [c_uint32, c_uint32, c_int32, c_uint32, c_void_p]),
    "sinew_transfer_workspace_size": (c_int, [POINTER(sinew_model), POINTER(sinew_bound_character), POINTER(sinew_mesh),
        POINTER(sinew_skeleton), POINTER(sinew_transfer_options), POINTER(c_size_t)]),
    "sinew_transfer": (c_int, [POINTER(sinew_model), POINTER(sinew_bound_character), POINTER(sinew_mesh), POINTER(sinew_skeleton),
        POINTER(sinew_transfer_options), c_void_p, c_size_t, POINTER(sinew_transfer_outputs)]),
    "sinew_retarget_reference_points_workspace_size": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(c_size_t)]),
    "sinew_retarget_reference_points": (c_int, [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_body),
        POINTER(sinew_motion_clip), POINTER(sinew_reference_options), c_void_p, c_size_t]),
    "sinew_corresponding_points_workspace_size": (c_int, [POINTER(sinew_bound_character), POINTER(sinew_mesh), POINTER(sinew_skeleton),
        POINTER(c_size_t)]),
    "sinew_corresponding_points": (c_int, [POINTER(sinew_bound_character), POINTER(sinew_mesh), POINTER(sinew_skeleton), c_void_p, c_size_t,
        c_void_p, c_void_p]),
    "sinew_simplify_workspace_size": (c_int, [c_uint32, POINTER(c_size_t)]),
    "sinew_simplify": (c_int, [POINTER(sinew_skeleton), c_void_p, c_void_p, POINTER(sinew_simplify_options), c_void_p, c_size_t, c_void_p]),
    "sinew_springs_workspace_size": (c_int, [c_uint32, c_uint32, c_uint32, c_uint32, c_uint32, POINTER(c_size_t)]),
    "sinew_springs_create": (c_int, [POINTER(sinew_skeleton), POINTER(sinew_spring_set), POINTER(sinew_springs_options), c_void_p, c_size_t,
        POINTER(c_void_p)]),
    "sinew_springs_frame": (c_int, [c_void_p, c_float, c_void_p, c_void_p, c_void_p]),
    "sinew_springs_restart": (c_int, [c_void_p]),
}


# Result and arguments of sinew/character.h.
CHARACTER_FUNCTIONS: Dict[str, Tuple[Any, List[Any]]] = {
    "sinew_character_error": (c_char_p, [c_void_p]),
    "sinew_character_struct_size": (c_size_t, [c_char_p]),
    "sinew_character_extensions": (c_char_p, [c_uint32]),
    "sinew_character_open": (c_int, [c_char_p, POINTER(c_void_p)]),
    "sinew_character_open_files": (c_int, [POINTER(sinew_file), c_uint32, POINTER(c_void_p)]),
    "sinew_character_open_keypoints": (c_int, [c_char_p, c_void_p, c_uint32, c_uint32, POINTER(c_void_p)]),
    "sinew_character_keypoints_frame": (c_int, [c_void_p, c_void_p, c_uint32, c_void_p, c_void_p]),
    "sinew_character_create": (c_int, [POINTER(sinew_mesh), POINTER(sinew_skeleton), POINTER(c_void_p)]),
    "sinew_character_copy": (c_int, [c_void_p, POINTER(c_void_p)]),
    "sinew_character_close": (None, [c_void_p]),
    "sinew_character_save": (c_int, [c_void_p, c_char_p]),
    "sinew_character_write": (c_int, [c_void_p, c_char_p, POINTER(POINTER(sinew_file)), c_void_p]),
    "sinew_character_set_profile": (c_int, [c_void_p, POINTER(sinew_character_profile_options)]),
    "sinew_character_profiles": (c_char_p, []),
    "sinew_character_controls": (c_int, [c_void_p, POINTER(c_char_p)]),
    "sinew_character_view": (c_int, [c_void_p, POINTER(sinew_character_arrays)]),
    "sinew_character_skin": (c_int, [c_void_p, c_uint32, c_void_p, c_void_p]),
    "sinew_character_joint_classes": (c_int, [c_void_p, c_void_p]),
    "sinew_character_notes": (c_char_p, [c_void_p]),
    "sinew_character_set_skeleton": (c_int, [c_void_p, POINTER(sinew_skeleton)]),
    "sinew_character_take_skeleton": (c_int, [c_void_p, c_void_p, c_uint32]),
    "sinew_character_set_weights": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p]),
    "sinew_character_clip_count": (c_int, [c_void_p, c_void_p]),
    "sinew_character_get_clip": (c_int, [c_void_p, c_uint32, POINTER(sinew_character_clip)]),
    "sinew_character_add_clip": (c_int, [c_void_p, POINTER(sinew_character_clip)]),
    "sinew_character_transform": (c_int, [c_void_p, POINTER(sinew_character_transform_options)]),
    "sinew_character_check": (c_int, [c_void_p, POINTER(sinew_character_check_options), POINTER(sinew_character_check_result)]),
    "sinew_character_check_rules": (c_char_p, []),
    "sinew_character_bind": (c_int, [c_void_p, POINTER(sinew_character_bind_options), POINTER(sinew_character_bind_result)]),
    "sinew_character_rig": (c_int, [c_void_p, POINTER(sinew_character_rig_options), POINTER(sinew_character_rig_result)]),
    "sinew_character_templates": (c_char_p, []),
    "sinew_character_map": (c_int, [c_void_p, c_void_p, POINTER(sinew_character_map_options), POINTER(sinew_character_map_result)]),
    "sinew_character_animate": (c_int, [c_void_p, c_void_p, POINTER(sinew_character_animate_options),
        POINTER(sinew_character_animate_result)]),
    "sinew_character_pose": (c_int, [c_void_p, POINTER(sinew_character_pose_options), POINTER(c_void_p)]),
    "sinew_character_transfer": (c_int, [c_void_p, c_void_p, POINTER(sinew_character_transfer_options),
        POINTER(sinew_character_transfer_result)]),
    "sinew_character_simplify": (c_int, [c_void_p, POINTER(sinew_character_simplify_options), c_void_p]),
    "sinew_character_lod": (c_int, [c_void_p, POINTER(sinew_character_lod_options), POINTER(c_void_p), POINTER(sinew_character_lod_level)]),
    "sinew_character_springs": (c_int, [c_void_p, POINTER(sinew_character_springs_options), POINTER(sinew_character_springs_result)]),
    "sinew_character_springs_frame": (c_int, [c_void_p, c_float, c_void_p, c_void_p, c_void_p]),
    "sinew_character_springs_restart": (c_int, [c_void_p]),
    "sinew_character_bake": (c_int, [c_void_p, POINTER(sinew_character_bake_options), POINTER(sinew_character_bake_result)]),
    "sinew_character_open_picture": (c_int, [c_char_p, POINTER(sinew_character_picture_options), POINTER(c_void_p)]),
    "sinew_character_open_picture_files": (c_int, [POINTER(sinew_file), c_uint32, POINTER(sinew_character_picture_options),
        POINTER(c_void_p)]),
    "sinew_character_picture": (c_int, [c_void_p, POINTER(sinew_character_picture_info)]),
}
