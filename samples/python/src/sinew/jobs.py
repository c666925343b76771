# SPDX-License-Identifier: MIT
"""The command's jobs as methods of a character. Generated from the C headers by scripts/declarations.py; a test compares."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Tuple

from . import declarations
from .binder import ProgressFunction
from .marshalling import Correction, ModelFile, Source, Text, run
from .results import AnimateResult, BakeResult, BindResult, CheckResult, MapResult, RigResult, TransferResult

if TYPE_CHECKING:
    from .opened import OpenCharacter


class Jobs:
    """What the command does with a character, with its defaults. All of them raise ValueError for arguments, Error for what cannot be done and
    Cancelled; a failed call changes nothing. `progress` is called with the share that is done and returns True to stop; `threads` work, and the
    bytes are the same for any number."""

    def transform(self, *, turns: Sequence[str] = (), height: float = 0, floor: bool = False, up: declarations.Up = "auto") -> None:
        """Turns and scales the character as a whole: mesh, joints, the file's own animations. Weights stay. A picture, a
        character without a mesh, and one that has clips or morph targets of other calls are an Error.

        turns  quarters about the origin, one after the other: "x", "-x", "y", ...
        height  metres along up; 0 = as it is
        floor  the lowest vertex is at 0 along up
        up  afterwards; "auto": Y
        """
        run("transform", locals())

    def bind(self, *, method: declarations.Method = "model", influences: int = 0, up: declarations.Up = "auto",
             joints: declarations.JointsFrom = "auto", rigid_parts: declarations.RigidParts = "auto", softness: float = 1,
             surface_vertices: int = 0, keep_tips: bool = False, bind_props: bool = False, fit: bool = False, symmetric: bool = False,
             keep_confidence: bool = False, questions: int = 0, answers: Sequence[Tuple[Any, ...]] = (), deform: Any = None,
             never: Any = None, locked: Any = None, hints: Any = None, like: Optional["OpenCharacter"] = None, style: Text = None,
             to_pose: Text = None, cut: bool = False, model: ModelFile = None, threads: int = 1,
             progress: ProgressFunction = None) -> BindResult:
        """Gives the mesh weights for its skeleton. A mesh without a skeleton is an Error.

        influences  1..12; 0 = 4
        up  "auto": Y
        softness  0.25..4; 0 = 1
        surface_vertices  0 = 32768
        keep_tips  joints that only end a chain keep the weight they get
        bind_props  meshes without a skin are bound too
        fit  a skeleton in other units or beside the mesh is brought into it
        symmetric  mirrored vertices get mirrored rows
        keep_confidence  a saved .glb has the confidence as _CONFIDENCE
        questions  list at most so many parts that are worth a question
        deform, never  joints, by name or number, that alone get weight, or none
        locked  mask [n] of bool or uint8, or indices: keeps the weights it has
        hints  mask [n] of bool or uint8, or indices: keeps the weights it has, which steer their surroundings; or weights of some
            vertices of the same mesh, joints by name: the same as hints
        like  a bound character whose weights are carried over where they fit
        style  a .style file that answers what it knows
        to_pose  rest pose of the result: "t", "a", or a file whose skeleton stands so; None = as it stands. Cuts, too
        cut  what has grown together is opened, its vertices doubled; the new ones come last
        model  files or bytes in place of the bundled ones
        """
        return run("bind", locals())

    def rig(self, *, method: declarations.CharacterRigMethod = "auto", detail: declarations.CharacterDetail = "body",
            mirror: declarations.Mirror = "auto", up: declarations.Up = "auto", spine: int = 0, toes: bool = True, ends: bool = True,
            bind: bool = True, keep_lengths: bool = False, influences: int = 0, rigid_parts: declarations.RigidParts = "auto",
            softness: float = 1, surface_vertices: int = 0, edits: Sequence[Tuple[declarations.EditKind, str]] = (), skeleton: Any = None,
            category: declarations.Category = "any", front: str = "auto", gate: bool = False, cut: bool = False, to_pose: Text = None,
            model: ModelFile = None, hands_model: ModelFile = None, front_model: ModelFile = None, threads: int = 1,
            progress: ProgressFunction = None) -> RigResult:
        """Makes a skeleton for a mesh and binds the mesh to it. A skeleton that the character has is left out.

        up  "auto": found, or as the file's format says
        spine  1..16; 0 = as the model says
        toes  False: without
        ends  False: without
        bind  False: the skeleton alone
        keep_lengths  with a skeleton, its bones are turned and all scaled alike
        influences  of the bind, and the three below
        skeleton  a file, or template:NAME, that is put into the mesh; or the same of a character
        category  what kind of body it is; "any": as the model says
        front  "auto": found
        gate  the result is measured; what fails is a note that begins with "gate: "
        cut  what has grown together is opened, as of a bind; to_pose does so, too
        to_pose  rest pose of the result: "t", "a", or a file whose skeleton stands so; None = as the mesh stands
        model, hands_model, front_model  files or bytes in place of the bundled ones
        """
        return run("rig", locals())

    def map(self, source: Source, *, method: declarations.MapMethod = "auto", names: bool = True, ends: bool = True,
            target_up: declarations.Up = "auto", source_up: declarations.Up = "auto", guess_up: bool = False, pins: Any = None,
            first: declarations.BranchesFirst = "both", cost: declarations.BranchesCost = "mean", layout: Text = None,
            actor: Text = None) -> MapResult:
        """Which joint of the source stands for which of the target. Changes neither; the result's arrays are the target's. The
        source is read as retarget() reads it as a motion: in a stance that is guessed where its rest pose is none. A joint of its
        motion that it has beside its own (an animated node without skin) is counted behind them.

        names  False: not read
        ends  False: not read
        target_up  "auto": along the legs of a body that has two, else Y
        source_up  "auto": as the target's, Y for a template
        guess_up  as with target_up 0, whatever it is
        pins  pairs that are kept; or a map whose lines are kept
        first  of "branches"
        cost  of "branches"
        layout  of the source, as in retarget()
        actor  of the source, as in retarget()
        """
        return run("map", locals())

    def retarget(self, motion: Optional["OpenCharacter"] = None, *, method: declarations.AnimateMethod = "auto", in_place: bool = False,
                 natural_range: bool = True, target_up: declarations.Up = "auto", motion_up: declarations.Up = "auto",
                 correct: Correction = "none", cells: int = 0, rounds: int = 0, body_contact: bool = False, shapes: int = 0, fps: float = 0,
                 start: float = 0, end: float = 0, clip: Text = None, map_file: Text = None, joint_map: Any = None, area_power: int = 0,
                 legs: bool = False, report: bool = False, falloff: float = 0, own_limb: bool = False, head: bool = False,
                 torso: bool = False, source_points: bool = False, force: bool = False, translations: bool = False, stiffness: float = 0,
                 tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, layout: Text = None, actor: Text = None,
                 limits: Text = None, depth: bool = False, model: ModelFile = None, hands_model: ModelFile = None,
                 front_model: ModelFile = None, threads: int = 1, progress: ProgressFunction = None) -> AnimateResult:
        """Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.

        in_place  stays above where it stands at rest
        natural_range  False: knees and elbows may leave their natural range
        correct  every frame is corrected by morph targets, VOLUME and above
        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  with "volume" or "xpbd", limbs keep out of the body
        shapes  most morph targets a clip; 0 = 16
        fps  0 = as the motion has
        start  seconds; to 0 = the end
        end  seconds; to 0 = the end
        clip  by name or number; None: all
        map_file  a map file; None: found
        joint_map  [j] joint of the motion or -1, in place of a map
        area_power  reference points: 1..4, or NO_AREA; 0 = 3
        legs  reference points
        report  limbs are measured before and after
        falloff  reference points; 0 = 0.05, NO_FALLOFF: none
        own_limb  reference points, as in sinew_reference_options
        head  reference points, as in sinew_reference_options
        torso  reference points, as in sinew_reference_options
        source_points  reference points, as in sinew_reference_options
        force  plays a motion that does not fit, such as a person's on a horse; else an error
        translations  bones stretch as the source's do, as in sinew_retarget_options
        stiffness  "xpbd": of the springs in the lattice's tetrahedra, 0.001 to 1000; 0 = 0.2
        tet_weights  "xpbd": sinew_tet_weights
        smoothing  False: "xpbd": bends are not smoothed
        layout  which joints places alone are (.npy, .npz): "smpl24", ...; None: guessed by their count
        actor  of a file of several people, by the root's name or number; None: the first where all are alike
        limits  what joints stay within, contacts or not: a .urdf, a file of formats/spec/limits.md, or "human" for what bodies
            can do; None: nothing but the natural range
        depth  bones of a picture's character leave its plane as the motion's do
        model, hands_model, front_model  files or bytes in place of the bundled ones
        """
        return run("animate", locals())

    def pose(self, *, method: declarations.PoseDeform = "linear", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             angles: Any = None, rotations: Any = None, matrices: Any = None, clip: Text = None, time: float = 0, stiffness: float = 0,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, threads: int = 1) -> "OpenCharacter":
        """A copy of a bound character in a pose; saved as .obj, or viewed.

        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  with "volume" or "xpbd"
        angles  [j, 3] joints turned about x, then y, then z, in degrees
        rotations  [j, 4] x y z w, local, against the rest pose
        matrices  [j, 12] row-major 3x4, rest to posed space
        clip  of the character's own, by name or number
        time  second of the clip
        stiffness  "xpbd", as in retarget(), and the two below
        """
        return run("pose", locals())

    def transfer(self, source: "OpenCharacter", *, method: declarations.TransferMethod = "auto", influences: int = 0,
                 up: declarations.Up = "auto", source_up: declarations.Up = "auto", garment: bool = False, as_drawn: bool = False,
                 heat: bool = False, pairs: Sequence[Tuple[int, int]] = (), locked: Any = None, map_file: Text = None,
                 model: ModelFile = None, threads: int = 1, progress: ProgressFunction = None) -> TransferResult:
        """Carries the weights of a bound character to the target's mesh, which keeps its skeleton or gets the source's, fitted.

        influences  1..12; 0 = 4
        up  "auto": Y
        source_up  "auto": Y
        garment  the target is worn by the source
        as_drawn  of "biharmonic"
        heat  binds by heat alone, without a model
        pairs  of "biharmonic"
        locked  mask [n] of bool or uint8, or indices: of the target
        map_file  a map file; None: found
        model  files or bytes in place of the bundled ones
        """
        return run("transfer", locals())

    def check(self, *, poses: bool = True, clips: bool = True, bounds: Optional[Mapping[str, float]] = None,
              score: bool = False) -> CheckResult:
        """Looks for what is wrong with the skeleton, the weights, the matrices and the animations; changes nothing. A character
        without joints is an Error.

        poses  False: the mesh is not posed: no tears, lost volume, flips, crossings
        clips  False: animations are not looked at
        bounds  rules that get other bounds
        score  the result has a score
        """
        return run("check", locals())

    def bake(self, *, method: declarations.PoseDeform = "volume", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             poses: int = 0, shapes: int = 0, seed: int = 0, limit: float = 0, clip: Text = None, stiffness: float = 0,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, progress: ProgressFunction = None) -> BakeResult:
        """Adds morph targets that correct bends, with what drives them, which are saved with the character.

        method  "linear": "volume"
        cells  of the deformer; 0 = its own
        rounds  of the deformer; 0 = its own
        body_contact  as in retarget()
        poses  to learn from; 0 = 1500
        shapes  a bend; 0 = 8
        seed  of the poses; 0 = 1
        limit  largest angle, degrees; 0 = 60
        clip  learn from a clip of the character's own; None: random poses
        stiffness  "xpbd", as in retarget(), and the two below
        """
        return run("bake", locals())
