# SPDX-License-Identifier: MIT
"""What jobs give back, and how keywords and results are members of C's structs. Generated from the C headers by scripts/declarations.py; a test compares."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

from . import declarations
from .binding import Array
from .character import Question


@dataclass
class Finding:
    """sinew_character_finding of C.

    rule  "left-right"; check_rules() lists them
    what  one line of English
    cure  one line: the remedy
    pose  test pose in which it shows; "": none
    clip  animation in which it shows; "": none
    seconds  time in the clip
    value  measured value
    bound  the value above which it is a finding
    vertices  ascending; None for a finding about joints or clips
    joint  joint of the finding; -1: none
    other  joint for comparison; -1: none
    mesh  mesh of all its vertices; -1: none, or several
    position  position of the finding, in the mesh's units
    radius  radius of the finding around the position
    """

    rule: str
    what: str
    cure: str
    pose: str
    clip: str
    seconds: float
    value: float
    bound: float
    vertices: Array
    severity: declarations.CheckSeverity
    joint: int
    other: int
    mesh: int
    position: Tuple[float, ...]
    radius: float


@dataclass
class CheckResult:
    """sinew_character_check_result of C.

    errors  number of findings of each severity
    findings  errors first
    line  "checked: 0 findings"
    score  0..100, similarity of the weights to those of three methods; -1 if not requested
    """

    errors: int
    warnings: int
    notes: int
    findings: List[Finding]
    line: str
    score: Optional[float]


@dataclass
class Seam:
    """sinew_character_seam of C.

    joints  the joints on its two sides
    position  its center
    """

    joints: Tuple[int, ...]
    position: Tuple[float, ...]
    length: float


@dataclass
class BindResult:
    """sinew_character_bind_result of C.

    symmetric_vertices  with symmetric: number of vertices with a mirror image
    kept_meshes  number of meshes that stay attached to one joint
    folded_tips  number of joints that gave their weight to their parents
    answers_by_style  number of answers from the style file
    seconds  duration of sinew_bind()
    left_out  joints that must not get weight
    questions  by descending gain
    vertex_questions  question of each vertex before a cut, or NO_QUESTION; None without questions
    hash  hash of the weights, as in `sinew bind --json`
    seams  longest first
    doubled_vertices  with cut or to_pose: number of doubled vertices
    """

    symmetric_vertices: int
    kept_meshes: int
    folded_tips: int
    answers_by_style: int
    seconds: float
    workspace_bytes: int
    left_out: Dict[str, str]
    questions: List[Question]
    vertex_questions: Optional[Array]
    hash: str
    seams: List[Seam]
    doubled_vertices: int


@dataclass
class Doubt:
    """sinew_character_doubt of C.

    name  joint that names the limb: LeftArm, RightUpLeg, Tail
    doubt  probability that the limb is wrong, 0..1
    """

    name: str
    doubt: float


@dataclass
class RigResult:
    """sinew_character_rig_result of C.

    mirrored  the skeleton is symmetric
    matched  with a skeleton: number of its joints that match the prediction
    joint_count  N: number of joints of the arrays below
    spread  estimated error of the votes, see sinew_rig_outputs
    scale  with a skeleton: its scale factor
    ends  a bone end
    confidence  confidence of positions, 0..1
    parent_confidence  confidence of parents, 0..1
    front  unit vector of the front direction
    up  Y or Z
    front_certainty  0..1, see sinew_rig_outputs; uncertain below 0.7
    seams  longest first
    doubtful  limbs by descending doubt; for votes
    """

    mirrored: bool
    matched: int
    joint_count: int
    spread: float
    scale: float
    seconds: float
    bind_seconds: float
    ends: Array
    confidence: Array
    parent_confidence: Array
    front: Tuple[float, ...]
    up: declarations.Up
    front_certainty: float
    up_certainty: float
    seams: List[Seam]
    doubtful: List[Doubt]


@dataclass
class MapResult:
    """sinew_character_map_result of C.

    method  that was used
    joint_count  J: number of joints of the target
    mapped  number of joints with a source
    certainty  0..1, certainty of front, sides and torso
    cover  0..1, share of both bodies that is mapped; below 0.5 retarget() rejects it
    sources  joint of the source, -1 = none
    confidence  0..1
    text  the map as `sinew map -o` writes it
    """

    method: declarations.MapMethod
    joint_count: int
    mapped: int
    certainty: float
    cover: float
    seconds: float
    sources: Array
    confidence: Array
    reasons: Array
    text: str


@dataclass
class LimbQuality:
    """sinew_limb_quality of C.

    joint  of the target: wrist or ankle
    leg  leg, 0: arm
    frames  of the clip
    deep_frames  with a depth above 0.006
    contact_frames  with a contact
    range_frames  with elbow or knee out of its natural range by more than a degree
    depth  mean over frames
    error  mean over contact frames
    """

    joint: int
    leg: bool
    frames: int
    deep_frames: int
    contact_frames: int
    range_frames: int
    depth: float
    greatest_depth: float
    error: float
    greatest_error: float


@dataclass
class AnimateResult:
    """sinew_character_animate_result of C.

    clips  number of clips that were added
    mapped  number of joints with a source
    rigged  a bare mesh was rigged first
    shape_count  number of morph targets that were added
    certainty  0..1, certainty of front and sides, at most the share of both bodies that is mapped
    limb_count  with report: number of limbs in both arrays below
    limbs_before  with report
    limbs_after  with report
    mapped_by  how the map was found: "anatomy and names", ..
    sources  the map that was used: joint of the motion, -1 = none
    source_ends  a bone end, which does not rotate
    source_names  names of the joints of the motion, one per line
    spot_positions  positions, see sinew_contact_spot
    """

    clips: range
    mapped: int
    rigged: bool
    shape_count: int
    certainty: float
    limb_count: int
    limbs_before: List[LimbQuality]
    limbs_after: List[LimbQuality]
    mapped_by: str
    sources: Array
    reasons: Array
    source_ends: Array
    source_names: str
    spot_kinds: Array
    spot_positions: Array
    spot_errors: Array


@dataclass
class TransferPart:
    """sinew_transfer_part of C.

    vertex  its vertex of lowest index
    vertex_count  of the target
    reason  of the larger share
    carried  share of its weights that was transferred, 65536 = all; the rest was rebound
    style  difference between the source's weights there and a bind: sum over joints, mean over the vertices, 0..131072. 0 if nothing
        was bound
    mismatch  the same between a bind of the target and the transferred bind of the source: the match error
    distance  mean distance of its vertices from the aligned source, in longest sides of the target
    """

    vertex: int
    vertex_count: int
    reason: declarations.TransferReason
    carried: float
    style: float
    mismatch: float
    distance: float


@dataclass
class TransferResult:
    """sinew_character_transfer_result of C.

    mapped_joints  number of source joints that were mapped
    fitted  the target had no skeleton and got the source's
    bound  a part was rebound
    carried  as in sinew_transfer_outputs; so are style and mismatch
    parts  by descending size
    """

    mapped_joints: int
    fitted: bool
    bound: bool
    bound_by: declarations.Method
    carried: float
    style: float
    mismatch: float
    seconds: float
    mapped_by: str
    parts: List[TransferPart]


@dataclass
class LodLevel:
    """sinew_character_lod_level of C.

    rest_error  largest distance of a vertex from the level's surface
    posed_error  the same in the worst test pose
    mean_error  the mean in that pose
    """

    rest_error: float
    posed_error: float
    mean_error: float
    triangle_count: int


@dataclass
class SpringsResult:
    """sinew_character_springs_result of C.

    chain_count  number of chains that are kept
    joint_count  number of joints that swing
    collider_count  number of spheres and capsules that push them
    own_count  number of the file's own chains, which come first
    kept  kept
    certainties  0..1
    names  names of the proposals, one per line
    kinds  kinds of the proposals, one per line
    """

    chain_count: int
    joint_count: int
    collider_count: int
    own_count: int
    kept: Array
    certainties: Array
    names: str
    kinds: str


@dataclass
class BakeResult:
    """sinew_character_bake_result of C.

    linear_error  error in the training poses as a share of the size, with linear skinning; the next member with the shapes
    held_out_linear_error  the same in other poses
    """

    shape_count: int
    bend_count: int
    moved_vertices: int
    learnt_poses: int
    held_out_poses: int
    linear_error: float
    baked_error: float
    held_out_linear_error: float
    held_out_baked_error: float


@dataclass
class PictureInfo:
    """sinew_character_picture_info of C.

    width  pixels of the picture as displayed
    figure_count  number of figures in the picture
    figure  the figure that was taken, starting at 1
    body_class  0 before it is rigged
    view  0 before it is rigged
    certainty  0..1, certainty of class and view together; 0 before it is rigged
    outline  pixels, x right, y down from the top left corner
    """

    width: int
    height: int
    figure_count: int
    figure: int
    body_class: declarations.BodyClass
    view: declarations.PictureView
    certainty: float
    outline: List[Array]


# A struct's keywords: name, kind, member, and what the kind needs.
Rows = List[Tuple[str, str, str, Any]]
OPTIONS: Dict[Any, Rows] = {
    declarations.sinew_character_profile_options: [("keep_axes", "flag", "keep_axes", None), ("profile", "text", "profile", None),
        ("license", "text", "license", None), ("title", "text", "title", None), ("authors", "texts", "authors", ('author_count',)),
        ("controls", "flag", "controls", None)],
    declarations.sinew_character_transform_options: [("turns", "texts", "turns", ('turn_count',)), ("height", "number", "height", False),
        ("floor", "flag", "floor", None), ("up", "word", "up", declarations.UP)],
    declarations.sinew_character_check_options: [("poses", "without", "without", 256), ("clips", "without", "without", 512),
        ("score", "flag", "score", None), ("bounds", "mapping", "bounds", ('bound_rules', 'bound_count'))],
    declarations.sinew_character_bind_options: [("method", "word", "method", declarations.METHOD),
        ("influences", "number", "influence_count", False), ("up", "word", "up", declarations.UP),
        ("joints", "word", "joints", declarations.JOINTS_FROM), ("rigid_parts", "word", "rigid_parts", declarations.RIGID_PARTS),
        ("softness", "percent", "softness_percent", None), ("surface_vertices", "number", "surface_vertices", False),
        ("keep_tips", "flag", "keep_tips", None), ("bind_props", "flag", "bind_props", None), ("fit", "flag", "fit", None),
        ("symmetric", "flag", "symmetric", None), ("keep_confidence", "flag", "keep_confidence", None),
        ("questions", "number", "question_count", False), ("answers", "structs", "answers", (declarations.sinew_answer, ('answer_count',))),
        ("joint_flags", "array", "joint_flags", ('uint8', ('J',), True, False)),
        ("locked", "array", "locked", ('uint8', ('V',), True, False)), ("hints", "array", "hinted", ('uint8', ('V',), True, False)),
        ("hints", "character", "hints", None), ("like", "character", "like", None), ("style", "text", "style", None),
        ("to_pose", "text", "to_pose", None), ("cut", "flag", "cut", None)],
    declarations.sinew_character_rig_options: [("method", "word", "method", declarations.CHARACTER_RIG_METHOD),
        ("detail", "word", "detail", declarations.CHARACTER_DETAIL), ("mirror", "word", "mirror", declarations.MIRROR),
        ("up", "word", "up", declarations.UP), ("front", "word", "front", declarations.FRONT),
        ("category", "word", "category", declarations.CATEGORY), ("spine", "number", "spine_count", False),
        ("toes", "without", "without", 1), ("ends", "without", "without", 2), ("bind", "without", "without", 4),
        ("keep_lengths", "flag", "keep_lengths", None), ("gate", "flag", "gate", None),
        ("edits", "structs", "edits", (declarations.sinew_skeleton_edit, ('edit_count',))), ("skeleton", "text", "skeleton", None),
        ("skeleton", "character", "skeleton_character", None), ("influences", "number", "bind.influence_count", False),
        ("rigid_parts", "word", "bind.rigid_parts", declarations.RIGID_PARTS), ("softness", "percent", "bind.softness_percent", None),
        ("surface_vertices", "number", "bind.surface_vertices", False), ("to_pose", "text", "bind.to_pose", None),
        ("cut", "flag", "bind.cut", None)],
    declarations.sinew_character_map_options: [("method", "word", "method", declarations.MAP_METHOD), ("names", "without", "without", 8),
        ("ends", "without", "without", 2), ("target_up", "word", "target_up", declarations.UP), ("guess_up", "flag", "guess_up", None),
        ("pins", "structs", "pins", (declarations.sinew_map_pin, ('pin_count',))), ("pins", "text", "pins_file", None),
        ("first", "word", "branches_first", declarations.BRANCHES_FIRST), ("cost", "word", "branches_cost", declarations.BRANCHES_COST),
        ("source_up", "word", "source.up", declarations.UP), ("layout", "text", "source.layout", None),
        ("actor", "text", "source.actor", None)],
    declarations.sinew_character_animate_options: [("method", "word", "method", declarations.ANIMATE_METHOD),
        ("natural_range", "without", "without", 16), ("in_place", "flag", "in_place", None),
        ("target_up", "word", "target_up", declarations.UP), ("shapes", "number", "shapes", False), ("report", "flag", "report", None),
        ("force", "flag", "force", None), ("translations", "flag", "translations", None), ("depth", "flag", "depth", None),
        ("pins", "structs", "pins", (declarations.sinew_map_pin, ('pin_count',))), ("map_file", "text", "map", None),
        ("joint_map", "array", "sources", ('int32', ('J',), True, False)), ("limits", "text", "limits", None),
        ("springs", "flag", "springs", None), ("arm_spread", "number", "arm_spread", False),
        ("motion_up", "word", "motion.up", declarations.UP), ("layout", "text", "motion.layout", None),
        ("actor", "text", "motion.actor", None), ("clip", "text", "motion.clip", None), ("fps", "number", "motion.fps", False),
        ("start", "number", "motion.from", False), ("end", "number", "motion.to", False),
        ("correct", "word", "deform.method", declarations.POSE_DEFORM), ("cells", "number", "deform.cells", False),
        ("rounds", "number", "deform.rounds", False), ("body_contact", "flag", "deform.body_contact", None),
        ("tet_weights", "word", "deform.tet_weights", declarations.TET_WEIGHTS), ("smoothing", "without", "deform.without", 128),
        ("deform_as_drawn", "flag", "deform.deform_as_drawn", None), ("stiffness", "number", "deform.stiffness", False),
        ("area_power", "number", "reference.area_power", False), ("own_limb", "flag", "reference.own_limb", None),
        ("legs", "flag", "reference.legs", None), ("falloff", "number", "reference.falloff", False),
        ("head", "flag", "reference.head", None), ("torso", "flag", "reference.torso", None),
        ("source_points", "flag", "reference.source_points", None), ("as_drawn", "flag", "reference.as_drawn", None)],
    declarations.sinew_character_pose_options: [("angles", "array", "angles", ('float64', ('J', '3'), False, False)),
        ("rotations", "array", "rotations", ('float64', ('J', '4'), False, False)),
        ("matrices", "array", "matrices", ('float64', ('J', '12'), False, False)), ("clip", "text", "clip", None),
        ("time", "number", "time", False), ("method", "word", "deform.method", declarations.POSE_DEFORM),
        ("cells", "number", "deform.cells", False), ("rounds", "number", "deform.rounds", False),
        ("body_contact", "flag", "deform.body_contact", None), ("tet_weights", "word", "deform.tet_weights", declarations.TET_WEIGHTS),
        ("smoothing", "without", "deform.without", 128), ("deform_as_drawn", "flag", "deform.deform_as_drawn", None),
        ("stiffness", "number", "deform.stiffness", False)],
    declarations.sinew_character_transfer_options: [("method", "word", "method", declarations.TRANSFER_METHOD),
        ("influences", "number", "influence_count", False), ("up", "word", "target_up", declarations.UP),
        ("source_up", "word", "source_up", declarations.UP), ("garment", "flag", "garment", None), ("as_drawn", "flag", "as_drawn", None),
        ("heat", "flag", "heat", None), ("pairs", "structs", "pairs", (declarations.sinew_vertex_pair, ('pair_count',))),
        ("locked", "array", "locked", ('uint8', ('V',), True, False)), ("map_file", "text", "map", None)],
    declarations.sinew_character_simplify_options: [("low", "flag", "low", None), ("joint_count", "number", "joint_count", False),
        ("keep", "texts", "keep", ('keep_count',)), ("as_drawn", "flag", "as_drawn", None)],
    declarations.sinew_character_lod_options: [("levels", "number", "level_count", False), ("ratio", "number", "ratio", False),
        ("fewer_joints", "flag", "fewer_joints", None)],
    declarations.sinew_character_springs_options: [("replace", "flag", "replace", None), ("take", "texts", "take", ('take_count',)),
        ("drop", "texts", "drop", ('drop_count',)), ("presets", "texts", "presets", ('preset_count',)),
        ("values", "texts", "values", ('value_count',)), ("make", "flag", "make", None)],
    declarations.sinew_character_bake_options: [("poses", "number", "poses", False), ("shapes", "number", "shapes", False),
        ("seed", "number", "seed", False), ("limit", "number", "limit", False), ("clip", "text", "clip", None),
        ("error", "number", "error", False), ("method", "word", "deform.method", declarations.POSE_DEFORM),
        ("cells", "number", "deform.cells", False), ("rounds", "number", "deform.rounds", False),
        ("body_contact", "flag", "deform.body_contact", None), ("tet_weights", "word", "deform.tet_weights", declarations.TET_WEIGHTS),
        ("smoothing", "without", "deform.without", 128), ("deform_as_drawn", "flag", "deform.deform_as_drawn", None),
        ("stiffness", "number", "deform.stiffness", False)],
    declarations.sinew_character_picture_options: [("body_class", "word", "body_class", declarations.BODY_CLASS),
        ("figure", "number", "figure", False), ("flat", "flag", "flat", None), ("units", "flag", "pixels", None),
        ("mask_file", "text", "mask", None), ("outline", "lines", "outline", ('line_offsets', 'line_count', '2')),
        ("cut", "flag", "cut", None)],
}
# The class of a struct, and its fields.
RESULTS: Dict[Any, Tuple[Any, Rows]] = {
    declarations.sinew_character_finding: (Finding, [("rule", "text", "rule", None), ("what", "text", "what", None),
        ("cure", "text", "cure", None), ("pose", "text", "pose", None), ("clip", "text", "clip", None),
        ("seconds", "number", "seconds", False), ("value", "number", "value", False), ("bound", "number", "bound", False),
        ("vertices", "array", "vertices", ('uint32', ('vertex_count',), False, False)),
        ("severity", "word", "severity", declarations.CHECK_SEVERITY), ("joint", "number", "joint", False),
        ("other", "number", "other", False), ("mesh", "number", "mesh", False), ("position", "numbers", "position", None),
        ("radius", "number", "radius", False)]),
    declarations.sinew_character_check_result: (CheckResult, [("errors", "number", "errors", False),
        ("warnings", "number", "warnings", False), ("notes", "number", "notes", False),
        ("findings", "structs", "findings", (declarations.sinew_character_finding, ('finding_count',))), ("line", "text", "line", None),
        ("score", "number", "score", True)]),
    declarations.sinew_character_seam: (Seam, [("joints", "numbers", "joints", None), ("position", "numbers", "position", None),
        ("length", "number", "length", False)]),
    declarations.sinew_character_bind_result: (BindResult, [("symmetric_vertices", "number", "symmetric_vertices", False),
        ("kept_meshes", "number", "kept_meshes", False), ("folded_tips", "number", "folded_tips", False),
        ("answers_by_style", "number", "answers_by_style", False), ("seconds", "number", "seconds", False),
        ("workspace_bytes", "number", "workspace_bytes", False),
        ("left_out", "structs", "left_out", (declarations.sinew_character_left_out, ('left_out_count',))),
        ("questions", "structs", "questions", (declarations.sinew_question, ('question_count',))),
        ("vertex_questions", "array", "vertex_questions", ('uint32', ('V',), True, False)), ("hash", "text", "hash", None),
        ("seams", "structs", "seams", (declarations.sinew_character_seam, ('seam_count',))),
        ("doubled_vertices", "number", "doubled_vertices", False)]),
    declarations.sinew_character_doubt: (Doubt, [("name", "text", "name", None), ("doubt", "number", "doubt", False)]),
    declarations.sinew_character_rig_result: (RigResult, [("mirrored", "flag", "mirrored", None), ("matched", "number", "matched", False),
        ("joint_count", "number", "joint_count", False), ("spread", "number", "spread", False), ("scale", "number", "scale", False),
        ("seconds", "number", "seconds", False), ("bind_seconds", "number", "bind_seconds", False),
        ("ends", "array", "ends", ('uint8', ('joint_count',), False, True)),
        ("confidence", "array", "confidence", ('float32', ('joint_count',), False, False)),
        ("parent_confidence", "array", "parent_confidence", ('float32', ('joint_count',), False, False)),
        ("front", "numbers", "front", None), ("up", "word", "up", declarations.UP),
        ("front_certainty", "number", "front_confidence", False), ("up_certainty", "number", "up_confidence", False),
        ("seams", "structs", "seams", (declarations.sinew_character_seam, ('seam_count',))),
        ("doubtful", "structs", "doubtful", (declarations.sinew_character_doubt, ('doubtful_count',)))]),
    declarations.sinew_character_map_result: (MapResult, [("method", "word", "method", declarations.MAP_METHOD),
        ("joint_count", "number", "joint_count", False), ("mapped", "number", "mapped", False), ("certainty", "number", "certainty", False),
        ("cover", "number", "cover", False), ("seconds", "number", "seconds", False),
        ("sources", "array", "sources", ('int32', ('joint_count',), False, False)),
        ("confidence", "array", "confidence", ('float32', ('joint_count',), False, False)),
        ("reasons", "array", "reasons", ('uint8', ('joint_count',), False, False)), ("text", "text", "text", None)]),
    declarations.sinew_limb_quality: (LimbQuality, [("joint", "number", "joint", False), ("leg", "flag", "leg", None),
        ("frames", "number", "frames", False), ("deep_frames", "number", "deep_frames", False),
        ("contact_frames", "number", "contact_frames", False), ("range_frames", "number", "range_frames", False),
        ("depth", "number", "depth", False), ("greatest_depth", "number", "greatest_depth", False), ("error", "number", "error", False),
        ("greatest_error", "number", "greatest_error", False)]),
    declarations.sinew_character_animate_result: (AnimateResult, [("clips", "number", "clip_count", False),
        ("first_clip", "number", "first_clip", False), ("mapped", "number", "mapped", False), ("rigged", "flag", "rigged", None),
        ("shape_count", "number", "shape_count", False), ("certainty", "number", "certainty", False),
        ("limb_count", "number", "limb_count", False),
        ("limbs_before", "structs", "limbs_before", (declarations.sinew_limb_quality, ('clip_count', 'limb_count'))),
        ("limbs_after", "structs", "limbs_after", (declarations.sinew_limb_quality, ('clip_count', 'limb_count'))),
        ("mapped_by", "text", "mapped_by", None), ("sources", "array", "sources", ('int32', ('J',), False, False)),
        ("reasons", "array", "reasons", ('uint8', ('J',), False, False)),
        ("source_ends", "array", "source_ends", ('uint8', ('source_count',), False, True)), ("source_names", "text", "source_names", None),
        ("spot_kinds", "array", "spot_kinds", ('uint8', ('spot_count',), False, False)),
        ("spot_positions", "array", "spot_positions", ('float32', ('spot_count', '3'), False, False)),
        ("spot_errors", "array", "spot_errors", ('float32', ('spot_count',), False, False))]),
    declarations.sinew_transfer_part: (TransferPart, [("vertex", "number", "vertex", False),
        ("vertex_count", "number", "vertex_count", False), ("reason", "word", "reason", declarations.TRANSFER_REASON),
        ("carried", "fraction", "carried_q16", None), ("style", "fraction", "style_q16", None),
        ("mismatch", "fraction", "mismatch_q16", None), ("distance", "fraction", "distance_q16", None)]),
    declarations.sinew_character_transfer_result: (TransferResult, [("mapped_joints", "number", "mapped_joints", False),
        ("fitted", "flag", "fitted", None), ("bound", "flag", "bound", None), ("bound_by", "word", "bound_by", declarations.METHOD),
        ("carried", "number", "carried", False), ("style", "number", "style", False), ("mismatch", "number", "mismatch", False),
        ("seconds", "number", "seconds", False), ("mapped_by", "text", "mapped_by", None),
        ("parts", "structs", "parts", (declarations.sinew_transfer_part, ('part_count',)))]),
    declarations.sinew_character_lod_level: (LodLevel, [("rest_error", "number", "rest_error", False),
        ("posed_error", "number", "posed_error", False), ("mean_error", "number", "mean_error", False),
        ("triangle_count", "number", "triangle_count", False)]),
    declarations.sinew_character_springs_result: (SpringsResult, [("chain_count", "number", "chain_count", False),
        ("joint_count", "number", "joint_count", False), ("collider_count", "number", "collider_count", False),
        ("own_count", "number", "own_count", False), ("kept", "array", "kept", ('uint8', ('proposal_count',), False, False)),
        ("certainties", "array", "certainties", ('float32', ('proposal_count',), False, False)), ("names", "text", "names", None),
        ("kinds", "text", "kinds", None)]),
    declarations.sinew_character_bake_result: (BakeResult, [("shape_count", "number", "shape_count", False),
        ("bend_count", "number", "bend_count", False), ("moved_vertices", "number", "moved_vertices", False),
        ("learnt_poses", "number", "learnt_poses", False), ("held_out_poses", "number", "held_out_poses", False),
        ("linear_error", "number", "linear_error", False), ("baked_error", "number", "baked_error", False),
        ("held_out_linear_error", "number", "held_out_linear_error", False),
        ("held_out_baked_error", "number", "held_out_baked_error", False)]),
    declarations.sinew_character_picture_info: (PictureInfo, [("width", "number", "width", False), ("height", "number", "height", False),
        ("figure_count", "number", "figure_count", False), ("figure", "number", "figure", False),
        ("body_class", "word", "body_class", declarations.BODY_CLASS), ("view", "word", "view", declarations.PICTURE_VIEW),
        ("certainty", "number", "certainty", False), ("outline", "lines", "outline", ('line_offsets', 'line_count', '2'))]),
}
# Options, result, the other character, whether that comes first, and the member of a file in its place.
JOBS: Dict[str, Tuple[Any, Any, str, bool, str]] = {
    "set_profile": (declarations.sinew_character_profile_options, None, "", False, ""),
    "transform": (declarations.sinew_character_transform_options, None, "", False, ""),
    "check": (declarations.sinew_character_check_options, declarations.sinew_character_check_result, "", False, ""),
    "bind": (declarations.sinew_character_bind_options, declarations.sinew_character_bind_result, "", False, ""),
    "rig": (declarations.sinew_character_rig_options, declarations.sinew_character_rig_result, "", False, ""),
    "map": (declarations.sinew_character_map_options, declarations.sinew_character_map_result, "source", False, "source.file"),
    "animate": (declarations.sinew_character_animate_options, declarations.sinew_character_animate_result, "motion", False, "motion.file"),
    "pose": (declarations.sinew_character_pose_options, None, "", False, ""),
    "transfer": (declarations.sinew_character_transfer_options, declarations.sinew_character_transfer_result, "source", True, ""),
    "simplify": (declarations.sinew_character_simplify_options, None, "", False, ""),
    "lod": (declarations.sinew_character_lod_options, None, "", False, ""),
    "springs": (declarations.sinew_character_springs_options, declarations.sinew_character_springs_result, "", False, ""),
    "bake": (declarations.sinew_character_bake_options, declarations.sinew_character_bake_result, "", False, ""),
}
