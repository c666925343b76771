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
        """Turns and scales the character as a whole: mesh, joints, the file's own animations. Weights stay. A picture, a
        character without a mesh, and one to which a call has added clips or morph targets are an Error.

        turns  quarter turns about the origin, one after the other: "x", "-x", "y", ...
        height  height in meters along up; 0 = unchanged
        floor  the lowest vertex is moved to 0 along up
        up  after the turns; "auto": Y
        """
        run("transform", locals())

    def check(self, *, poses: bool = True, clips: bool = True, score: bool = False,
              bounds: Optional[Mapping[str, float]] = None) -> CheckResult:
        """Looks for faults of the skeleton, the weights, the matrices and the animations; changes nothing. A character without
        joints is an Error.

        poses  False: the mesh is not posed: no tears, lost volume, flips, crossings
        clips  False: animations are not looked at
        score  the result has a score
        bounds  rules that get other bounds
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

        influences  1..12 influences a vertex; 0 = 4
        up  "auto": Y
        softness  0.25..4, 2 blends twice as softly; 0 = 1
        surface_vertices  a mesh of more vertices is bound on a surface reduced to so many; 0 = 32768
        keep_tips  joints that only end a chain keep the weight they get
        bind_props  meshes without a skin are bound too
        fit  a skeleton in other units or beside the mesh is brought into it
        symmetric  mirrored vertices get mirrored rows
        keep_confidence  a saved .glb has the confidence as _CONFIDENCE
        questions  lists at most so many parts that are worth a question
        deform, never  joints, by name or number, that alone get weight, or none
        locked  mask [n] of bool or uint8, or indices: keeps the weights it has
        hints  mask [n] of bool or uint8, or indices: keeps the weights it has, which steer their surroundings; or weights of some
            vertices of the same mesh, joints by name, in place of hinted
        like  a bound character whose weights are carried over where they fit
        style  a .style file that answers what it knows
        to_pose  rest pose of the result: "t", "a", or a file whose skeleton stands so; None = as it stands. Cuts, too
        cut  what has grown together is opened, its vertices doubled; the new ones come last
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
        """Makes a skeleton for a mesh and binds the mesh to it. A skeleton that the character has is replaced.

        up  "auto": found, or as the file's format says
        front  "auto": found
        category  what kind of body it is; "any": as the model says
        spine  1..16; 0 = as the model says
        toes  False: feet have no toe joints
        ends  False: chains have no NAME_end joints
        bind  False: the skeleton alone, without weights
        keep_lengths  with a skeleton, its bones are turned and all scaled alike
        gate  the result is measured; what fails is a note that begins with "gate: "
        edits  changes of the skeleton
        skeleton  a file, or template:NAME, that is put into the mesh; or a character whose skeleton is put into the mesh
        influences  of the bind: 1..12 influences a vertex; 0 = 4
        softness  of the bind: 0.25..4, 2 blends twice as softly; 0 = 1
        surface_vertices  of the bind: a mesh of more vertices is bound on a surface reduced to so many; 0 = 32768
        to_pose  of the bind: rest pose of the result: "t", "a", or a file whose skeleton stands so; None = as it stands. Cuts,
            too
        cut  of the bind: what has grown together is opened, its vertices doubled; the new ones come last
        model, hands_model, front_model  files or bytes in place of the bundled ones
        """
        return cast(RigResult, run("rig", locals()))

    def map(self, source: Source, *, method: declarations.MapMethod = "auto", names: bool = True, ends: bool = True,
            target_up: declarations.Up = "auto", guess_up: bool = False, pins: Any = None, first: declarations.BranchesFirst = "both",
            cost: declarations.BranchesCost = "mean", source_up: declarations.Up = "auto", layout: Text = None,
            actor: Text = None) -> MapResult:
        """Finds the joint of the source for each joint of the target. Changes neither; the result's arrays are the target's. The
        source is read as retarget() reads a motion: in a stance that is guessed where its rest pose is none. Joints of its motion
        beside its own (animated nodes without skin) are counted behind them.

        names  False: joints' names are not read
        ends  False: bone ends are not read
        target_up  "auto": along the legs of a body that has two, else Y
        guess_up  as with target_up 0, whatever it is
        pins  pairs that are kept; or a map whose lines are kept
        first  of "branches"
        cost  of "branches"
        source_up  of the motion; "auto": found
        layout  layout of keypoints (.npy, .npz): "smpl24", ...; None: guessed by their count
        actor  of a file of several people, by the root's name or number; None: the first where all are alike
        """
        return cast(MapResult, run("map", locals()))

    def retarget(self, motion: Source = None, *, method: declarations.AnimateMethod = "auto", natural_range: bool = True,
                 in_place: bool = False, target_up: declarations.Up = "auto", shapes: int = 0, report: bool = False, force: bool = False,
                 translations: bool = False, depth: bool = False, pins: Sequence[Tuple[int, int]] = (), map_file: Text = None,
                 joint_map: Any = None, limits: Text = None, springs: bool = False, motion_up: declarations.Up = "auto",
                 layout: Text = None, actor: Text = None, clip: Text = None, fps: float = 0, start: float = 0, end: float = 0,
                 correct: Correction = "none", cells: int = 0, rounds: int = 0, body_contact: bool = False,
                 tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, deform_as_drawn: bool = False, stiffness: float = 0,
                 area_power: int = 0, own_limb: bool = False, legs: bool = False, falloff: float = 0, head: bool = False,
                 torso: bool = False, source_points: bool = False, as_drawn: bool = False, model: ModelFile = None,
                 hands_model: ModelFile = None, front_model: ModelFile = None, threads: int = 1,
                 progress: ProgressFunction = None) -> AnimateResult:
        """Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.

        natural_range  False: knees and elbows may leave their natural range
        in_place  stays above where it stands at rest
        target_up  of the character; "auto": found
        shapes  most morph targets a clip; 0 = 16
        report  limbs are measured before and after
        force  plays a motion that does not fit, such as a person's on a horse; else an error
        translations  bones stretch as the source's do, as in sinew_retarget_options
        depth  bones of a picture's character leave its plane as the motion's do
        pins  pairs that a found map keeps
        map_file  a map file; None: found
        joint_map  [j] joint of the motion or -1, in place of a map
        limits  what joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what bodies
            can do; None: the natural range alone
        springs  hair, tails, ears and skirts swing in the clips, by the springs of the character, see springs()
        motion_up  of the motion; "auto": found
        layout  layout of keypoints (.npy, .npz): "smpl24", ...; None: guessed by their count
        actor  of a file of several people, by the root's name or number; None: the first where all are alike
        clip  by name or number; None: all
        fps  frames a second; 0 = as the motion has
        start  first second that is played
        end  last second that is played; 0 = the end
        correct  animate makes morph targets of corrections, VOLUME and above; bake takes no other. 0 = none, linear blending or
            VOLUME, as the call says
        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  with VOLUME or XPBD, limbs keep out of the body
        tet_weights  of "xpbd"
        smoothing  False: bends are not smoothed, of POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  of "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2
        area_power  reference points: n, 1 .. 4, or NO_AREA for 0; 0 = 3
        own_limb  reference points: triangles of the limb itself have influence as well
        legs  reference points: knees and ankles move as well
        falloff  reference points: d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05, which is ours
        head  reference points: the head moves as well
        torso  reference points: torso joints lie as the source's do, each seen from the one before; 0: they turn as copied
        source_points  reference points: reference points are the source's, in the size of the target; 0: the target's
        as_drawn  reference points: as published: one sum over all triangles, the limb's own too; knees, ankles, head and torso as
            well; the source's reference points; no falloff, no push-out. own_limb to source_points say nothing then
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
        clip  of the character's own, by name or number
        time  second of the clip
        method  animate makes morph targets of corrections, VOLUME and above; bake takes no other. 0 = none, linear blending or
            VOLUME, as the call says
        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  with VOLUME or XPBD, limbs keep out of the body
        tet_weights  of "xpbd"
        smoothing  False: bends are not smoothed, of POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  of "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2
        """
        return cast("OpenCharacter", run("pose", locals()))

    def transfer(self, source: "OpenCharacter", *, method: declarations.TransferMethod = "auto", influences: int = 0,
                 up: declarations.Up = "auto", source_up: declarations.Up = "auto", garment: bool = False, as_drawn: bool = False,
                 heat: bool = False, pairs: Sequence[Tuple[int, int]] = (), locked: Any = None, map_file: Text = None,
                 model: ModelFile = None, threads: int = 1, progress: ProgressFunction = None) -> TransferResult:
        """Carries the weights of a bound character to the target's mesh, which keeps its skeleton or gets the source's, fitted.

        influences  1..12 influences a vertex; 0 = 4
        up  "auto": Y
        source_up  "auto": Y
        garment  the target is worn by the source
        as_drawn  as its paper says, of "biharmonic"
        heat  binds by heat alone, without a model
        pairs  of "biharmonic"
        locked  mask [n] of bool or uint8, or indices: the target's vertex keeps the weights it has
        map_file  a map file; None: found
        model  files or bytes in place of the bundled ones
        """
        return cast(TransferResult, run("transfer", locals()))

    def springs(self, *, replace: bool = False, take: Sequence[str] = (), drop: Sequence[str] = (), presets: Sequence[str] = (),
                values: Sequence[str] = (), make: bool = False) -> SpringsResult:
        """Finds what swings on a bound character, hair, tails, ears and skirts, with colliders. They are saved with it
        (VRMC_springBone), and played by retarget().

        replace  finds springs anew in place of the file's own
        take  chains that are kept although they are not sure, or beside the file's own
        drop  chains that are left out
        presets  NAME=KIND: numbers of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon
        values  NAME:FIELD=X, one number of a chain's joints, or NAME:FIELD=xF, F times what each has: stiffness, gravity, drag,
            radius or limit
        make  chains of joints are laid into skirts, coats and capes that have none, and these are bound to them
        """
        return cast(SpringsResult, run("springs", locals()))

    def bake(self, *, poses: int = 0, shapes: int = 0, seed: int = 0, limit: float = 0, clip: Text = None, error: float = 0,
             method: declarations.PoseDeform = "volume", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, deform_as_drawn: bool = False, stiffness: float = 0,
             progress: ProgressFunction = None) -> BakeResult:
        """Adds morph targets that correct bends, with what drives them, which are saved with the character.

        poses  poses to learn from; 0 = 1500
        shapes  most weights that drive a bend, each of which has one or two morph targets; 0 = 8
        seed  of the random poses; 0 = 1
        limit  largest angle in degrees; 0 = 60
        clip  learns from a clip of the character's own; None: random poses
        error  what may be left out of a vertex's moves, root mean square over the poses, a share of the size; 0 = 0.002
        method  animate makes morph targets of corrections, VOLUME and above; bake takes no other. 0 = none, linear blending or
            VOLUME, as the call says
        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  with VOLUME or XPBD, limbs keep out of the body
        tet_weights  of "xpbd"
        smoothing  False: bends are not smoothed, of POSE_XPBD
        deform_as_drawn  "xpbd" as published, see sinew/deform.h
        stiffness  of "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2
        """
        return cast(BakeResult, run("bake", locals()))
