# SPDX-License-Identifier: MIT
"""The command's jobs as methods of a character. Generated from the C headers by scripts/declarations.py; a test compares."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Tuple, cast

from . import declarations
from .binder import ProgressFunction
from .marshalling import Correction, ModelFile, Source, Text, run
from .results import AnimateResult, BakeResult, BindResult, CheckResult, MapResult, RigResult, SpringsResult, TransferResult

if TYPE_CHECKING:
    from .opened import OpenCharacter


class Jobs:
    """What the command does with a character, with its defaults. All of them raise ValueError for arguments, Error for what cannot be done and
    Cancelled; a failed call changes nothing. `progress` is called with the share that is done and returns True to stop; `threads` work, and the
    bytes are the same for any number."""

    def transform(self, *, turns: Sequence[str] = (), height: float = 0, floor: bool = False, up: declarations.Up = "auto") -> None:
        """Rotates and scales the whole character: mesh, joints, the file's own animations. Weights stay. A picture, a character
        without a mesh, and one to which a call has added clips or morph targets are an Error.

        turns  rotations by 90 degrees about an axis through the origin, in order: "x", "-x", "y", ...
        height  height in meters along up; 0 = unchanged
        floor  the lowest vertex is moved to 0 along up
        up  after the rotations; "auto": Y
        """
        run("transform", locals())

    def check(self, *, poses: bool = True, clips: bool = True, score: bool = False,
              bounds: Optional[Mapping[str, float]] = None) -> CheckResult:
        """Finds faults of the skeleton, the weights, the matrices and the animations; changes nothing. A character without joints
        is an Error.

        poses  False: no test poses: no tears, lost volume, flips, crossings
        clips  False: ignores animations
        score  computes the score
        bounds  rules with other bounds
        """
        return cast(CheckResult, run("check", locals()))

    def bind(self, *, method: declarations.Method = "model", influences: int = 0, up: declarations.Up = "auto",
             joints: declarations.JointsFrom = "auto", rigid_parts: declarations.RigidParts = "auto", softness: float = 1,
             surface_vertices: int = 0, keep_tips: bool = False, bind_props: bool = False, fit: bool = False, symmetric: bool = False,
             keep_confidence: bool = False, questions: int = 0, answers: Sequence[Tuple[Any, ...]] = (), deform: Any = None,
             never: Any = None, locked: Any = None, hints: Any = None, like: Optional["OpenCharacter"] = None, style: Text = None,
             to_pose: Text = None, cut: bool = False, model: ModelFile = None, threads: int = 1,
             progress: ProgressFunction = None) -> BindResult:
        """Gives the mesh weights for its skeleton. A mesh without a skeleton is an Error.

        influences  1..12 influences per vertex; 0 = 4
        up  "auto": Y
        softness  0.25..4, 2 = twice as soft; 0 = 1
        surface_vertices  larger meshes are bound on a surface reduced to this many vertices; 0 = 32768
        keep_tips  joints that only end a chain keep their weight
        bind_props  meshes without a skin are bound too
        fit  scales, rotates and moves a skeleton that has other units or stands beside the mesh
        symmetric  mirrored vertices get mirrored weights
        keep_confidence  a saved .glb has the confidence as attribute _CONFIDENCE
        questions  maximum number of questions about parts
        deform, never  joints, by name or number, that alone get weight, or none
        locked  mask [n] of bool or uint8, or indices: the vertex keeps its weights
        hints  mask [n] of bool or uint8, or indices: the vertex keeps its weights, which guide its surroundings; or weights of
            some vertices of the same mesh, joints by name, instead of hinted
        like  a bound character whose weights are transferred where they fit
        style  a .style file with answers about similar parts
        to_pose  rest pose of the result: "t", "a", or a file with a skeleton in that pose; None = unchanged. Implies cut
        cut  fused parts are cut open; doubled vertices are appended
        model  files or bytes in place of the bundled ones
        """
        return cast(BindResult, run("bind", locals()))

    def rig(self, *, method: declarations.CharacterRigMethod = "auto", detail: declarations.CharacterDetail = "body",
            mirror: declarations.Mirror = "auto", up: declarations.Up = "auto", front: str = "auto",
            category: declarations.Category = "any", spine: int = 0, toes: bool = True, ends: bool = True, bind: bool = True,
            keep_lengths: bool = False, gate: bool = False, edits: Sequence[Tuple[Any, ...]] = (), skeleton: Any = None,
            influences: int = 0, rigid_parts: declarations.RigidParts = "auto", softness: float = 1, surface_vertices: int = 0,
            to_pose: Text = None, cut: bool = False, model: ModelFile = None, hands_model: ModelFile = None, front_model: ModelFile = None,
            threads: int = 1, progress: ProgressFunction = None) -> RigResult:
        """Makes a skeleton for a mesh and binds the mesh to it. It replaces the character's skeleton.

        up  "auto": by the file format, else found
        front  "auto": found
        category  body class; "any": as predicted
        spine  1..16 spine joints; 0 = as predicted
        toes  False: no toe joints
        ends  False: no NAME_end joints at chain ends
        bind  False: the skeleton only, without weights
        keep_lengths  with a skeleton, its bones are rotated and all scaled by one factor
        gate  checks the result; each failure is a note that begins with "gate: "
        edits  edits of the skeleton, in order
        skeleton  a file, or template:NAME, whose skeleton is fitted into the mesh; or a character whose skeleton is fitted into
            the mesh
        influences  bind: 1..12 influences per vertex; 0 = 4
        softness  bind: 0.25..4, 2 = twice as soft; 0 = 1
        surface_vertices  bind: larger meshes are bound on a surface reduced to this many vertices; 0 = 32768
        to_pose  bind: rest pose of the result: "t", "a", or a file with a skeleton in that pose; None = unchanged. Implies cut
        cut  bind: fused parts are cut open; doubled vertices are appended
        model, hands_model, front_model  files or bytes in place of the bundled ones
        """
        return cast(RigResult, run("rig", locals()))

    def map(self, source: Source, *, method: declarations.MapMethod = "auto", names: bool = True, ends: bool = True,
            target_up: declarations.Up = "auto", guess_up: bool = False, pins: Any = None, first: declarations.BranchesFirst = "both",
            cost: declarations.BranchesCost = "mean", source_up: declarations.Up = "auto", layout: Text = None,
            actor: Text = None) -> MapResult:
        """Finds the source joint of each target joint. Changes neither character; the result belongs to the target. The source is
        read as in retarget(): if its rest pose is not a standing pose, one is guessed from its frames. Animated nodes without
        skin are counted after its joints.

        names  False: ignores joint names
        ends  False: ignores bone ends
        target_up  "auto": along the legs of a body with two legs, else Y
        guess_up  guesses the up axis, as with target_up 0
        pins  pairs to keep; or a map file whose pairs are kept
        first  of "branches"
        cost  of "branches"
        source_up  of the motion; "auto": found
        layout  layout of keypoints (.npy, .npz): "smpl24", ...; None: chosen by the number of keypoints
        actor  actor of a file with several people, by name of the root or number; None: the first, if all have equal skeletons
        """
        return cast(MapResult, run("map", locals()))

    def retarget(self, motion: Source = None, *, method: declarations.AnimateMethod = "auto", natural_range: bool = True,
                 in_place: bool = False, target_up: declarations.Up = "auto", shapes: int = 0, report: bool = False, force: bool = False,
                 translations: bool = False, depth: bool = False, pins: Sequence[Tuple[int, int]] = (), map_file: Text = None,
                 joint_map: Any = None, limits: Text = None, springs: bool = False, arm_spread: float = 0,
                 motion_up: declarations.Up = "auto", layout: Text = None, actor: Text = None, clip: Text = None, fps: float = 0,
                 start: float = 0, end: float = 0, correct: Correction = "none", cells: int = 0, rounds: int = 0,
                 body_contact: bool = False, tet_weights: declarations.TetWeights = "skin", smoothing: bool = True,
                 deform_as_drawn: bool = False, stiffness: float = 0, area_power: int = 0, own_limb: bool = False, legs: bool = False,
                 falloff: float = 0, head: bool = False, torso: bool = False, source_points: bool = False, as_drawn: bool = False,
                 model: ModelFile = None, hands_model: ModelFile = None, front_model: ModelFile = None, threads: int = 1,
                 progress: ProgressFunction = None) -> AnimateResult:
        """Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.

        natural_range  False: knees and elbows may leave their natural range
        in_place  keeps the character above its rest position
        target_up  of the character; "auto": found
        shapes  maximum number of morph targets per clip; 0 = 16
        report  measures limbs before and after
        force  plays a motion that does not fit, such as a person's on a horse; 0: that is an error
        translations  bones stretch like the source's, as in sinew_retarget_options
        depth  bones of a picture's character may leave the picture plane
        pins  pairs to keep in a map that is found
        map_file  a map file; None: found
        joint_map  [j] joint of the motion or -1, instead of a map
        limits  rotation limits of joints, for every method: a .urdf, a file of formats/spec/limits.md, or "human"; None: only the
            natural range of knees and elbows
        springs  simulates the character's springs (hair, tails, ears, skirts) in the clips, see springs()
        arm_spread  degrees, -90..90, by which both arms are lifted away from the body, as in sinew_retarget_options
        motion_up  of the motion; "auto": found
        layout  layout of keypoints (.npy, .npz): "smpl24", ...; None: chosen by the number of keypoints
        actor  actor of a file with several people, by name of the root or number; None: the first, if all have equal skeletons
        clip  clip by name or number; None: all
        fps  frames per second; 0 = as in the motion
        start  first second to play
        end  last second to play; 0 = the end
        correct  animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
            VOLUME, depending on the call
        cells  lattice cells of the deformer; 0 = its default
        rounds  iterations of the deformer; 0 = its default
        body_contact  for VOLUME and XPBD, limbs keep out of the body
        tet_weights  for "xpbd"
        smoothing  False: bends are not smoothed, for POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2
        area_power  reference points: n, 1 .. 4, or NO_AREA for 0; 0 = 3
        own_limb  reference points: triangles of the limb itself have influence too
        legs  reference points: also corrects knees and ankles
        falloff  reference points: d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05 (added by
            sinew)
        head  reference points: also corrects the head
        torso  reference points: copies directions between torso joints; 0: copies their rotations
        source_points  reference points: reference points of the source's body, scaled to the target; 0: of the target's body
        as_drawn  reference points: as published: one sum over all triangles, including the limb's own; knees, ankles, head and
            torso too; the source's reference points; no falloff, no push-out. own_limb to source_points are ignored
        model, hands_model, front_model  files or bytes in place of the bundled ones
        """
        return cast(AnimateResult, run("animate", locals()))

    def pose(self, *, angles: Any = None, rotations: Any = None, matrices: Any = None, clip: Text = None, time: float = 0,
             method: declarations.PoseDeform = "linear", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, deform_as_drawn: bool = False, stiffness: float = 0,
             threads: int = 1) -> "OpenCharacter":
        """Makes a copy of a bound character in a pose, to be saved as .obj or viewed.

        angles  [j, 3] degrees about x, then y, then z
        rotations  [j, 4] x y z w, local, relative to the rest pose
        matrices  [j, 12] row-major 3x4, rest to posed space
        clip  clip of the character, by name or number
        time  time in the clip, in seconds
        method  animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
            VOLUME, depending on the call
        cells  lattice cells of the deformer; 0 = its default
        rounds  iterations of the deformer; 0 = its default
        body_contact  for VOLUME and XPBD, limbs keep out of the body
        tet_weights  for "xpbd"
        smoothing  False: bends are not smoothed, for POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2
        """
        return cast("OpenCharacter", run("pose", locals()))

    def transfer(self, source: "OpenCharacter", *, method: declarations.TransferMethod = "auto", influences: int = 0,
                 up: declarations.Up = "auto", source_up: declarations.Up = "auto", garment: bool = False, as_drawn: bool = False,
                 heat: bool = False, pairs: Sequence[Tuple[int, int]] = (), locked: Any = None, map_file: Text = None,
                 model: ModelFile = None, threads: int = 1, progress: ProgressFunction = None) -> TransferResult:
        """Transfers the weights of a bound character to the target's mesh. A target without a skeleton gets the source's, fitted.

        influences  1..12 influences per vertex; 0 = 4
        up  "auto": Y
        source_up  "auto": Y
        garment  the source wears the target
        as_drawn  "biharmonic" as published
        heat  binds by heat only, without a model
        pairs  reference points of "biharmonic"
        locked  mask [n] of bool or uint8, or indices: the target's vertex keeps its weights
        map_file  a map file; None: found
        model  files or bytes in place of the bundled ones
        """
        return cast(TransferResult, run("transfer", locals()))

    def springs(self, *, replace: bool = False, take: Sequence[str] = (), drop: Sequence[str] = (), presets: Sequence[str] = (),
                values: Sequence[str] = (), make: bool = False) -> SpringsResult:
        """Finds hair, tails, ears and skirts that swing on a bound character, with colliders. The springs are saved with it
        (VRMC_springBone) and simulated by retarget().

        replace  finds springs anew instead of the file's own
        take  chains to keep despite a low probability, or in addition to the file's own
        drop  chains to leave out
        presets  NAME=KIND: parameters of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon
        values  NAME:FIELD=X sets a parameter of a chain's joints, NAME:FIELD=xF scales it by F: stiffness, gravity, drag, radius
            or limit
        make  makes chains of joints in skirts, coats and capes that have none, and binds these to them
        """
        return cast(SpringsResult, run("springs", locals()))

    def bake(self, *, poses: int = 0, shapes: int = 0, seed: int = 0, limit: float = 0, clip: Text = None, error: float = 0,
             method: declarations.PoseDeform = "volume", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, deform_as_drawn: bool = False, stiffness: float = 0,
             progress: ProgressFunction = None) -> BakeResult:
        """Adds morph targets that correct bends, with their drivers, which are saved with the character.

        poses  number of training poses; 0 = 1500
        shapes  maximum number of driving weights per bend, each with one or two morph targets; 0 = 8
        seed  seed of the random poses; 0 = 1
        limit  maximum angle in degrees; 0 = 60
        clip  clip of the character to train on; None: random poses
        error  threshold for leaving out displacements of vertices: root mean square over the poses as a share of the size; 0 =
            0.002
        method  animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
            VOLUME, depending on the call
        cells  lattice cells of the deformer; 0 = its default
        rounds  iterations of the deformer; 0 = its default
        body_contact  for VOLUME and XPBD, limbs keep out of the body
        tet_weights  for "xpbd"
        smoothing  False: bends are not smoothed, for POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2
        """
        return cast(BakeResult, run("bake", locals()))
