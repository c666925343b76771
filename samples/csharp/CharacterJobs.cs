// SPDX-License-Identifier: MIT
// Settings and results of a character's jobs, and the jobs. Generated from the C headers by scripts/declarations.py; a test compares.
using System;
using System.Collections.Generic;
using System.Linq;

namespace Sinew
{
    /// <summary>sinew_character_profile_options of C; what is not set is its default.</summary>
    public sealed class ProfileSettings
    {
        /// <summary>Axes, names and roots of the skeleton stay as they are</summary>
        public bool KeepAxes;
        /// <summary>One of profiles(): "mixamo", "vrm"; null: none, files as they were read</summary>
        public string Profile;
        /// <summary>License of a VRM, in the words of its format; null: nothing is allowed</summary>
        public string License;
        /// <summary>Title of a VRM; null: the character's name</summary>
        public string Title;
        /// <summary>Authors of a VRM; null: those of its file, else "unknown" with a note</summary>
        public string[] Authors;
        /// <summary>A glTF has the text of controls() in its extras</summary>
        public bool Controls;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            return pins.Of(new Native.sinew_character_profile_options {
                struct_size = Character.Size<Native.sinew_character_profile_options>(), keep_axes = KeepAxes ? 1u : 0,
                profile = pins.Of(Profile), license = pins.Of(License), title = pins.Of(Title), author_count = Character.Count(Authors),
                authors = pins.Of(Authors), controls = Controls ? 1u : 0 });
        }
    }

    /// <summary>sinew_character_transform_options of C; what is not set is its default.</summary>
    public sealed class TransformSettings
    {
        /// <summary>Rotations by 90 degrees about an axis through the origin, in order: "x", "-x", "y", ...</summary>
        public string[] Turns;
        /// <summary>Height in meters along up; 0 = unchanged</summary>
        public double Height;
        /// <summary>The lowest vertex is moved to 0 along up</summary>
        public bool Floor;
        /// <summary>After the rotations; 0 = Y</summary>
        public Up Up;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            return pins.Of(new Native.sinew_character_transform_options {
                struct_size = Character.Size<Native.sinew_character_transform_options>(), turn_count = Character.Count(Turns),
                turns = pins.Of(Turns), height = Height, floor = Floor ? 1u : 0, up = (uint)Up });
        }
    }

    /// <summary>sinew_character_check_options of C; what is not set is its default.</summary>
    public sealed class CheckSettings
    {
        /// <summary>No test poses: no tears, lost volume, flips, crossings</summary>
        public bool Poses = true;
        /// <summary>Ignores animations</summary>
        public bool Clips = true;
        /// <summary>Computes the score</summary>
        public bool Score;
        /// <summary>Rules with other bounds</summary>
        public Dictionary<string, double> Bounds;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            string[] rules = Bounds == null ? null : Bounds.Keys.ToArray();
            return pins.Of(new Native.sinew_character_check_options {struct_size = Character.Size<Native.sinew_character_check_options>(),
                without = (Poses ? 0 : Native.WITHOUT_POSES) | (Clips ? 0 : Native.WITHOUT_CLIPS), score = Score ? 1u : 0,
                bound_count = Character.Count(rules), bound_rules = pins.Of(rules),
                bounds = pins.Of(Bounds == null ? null : Bounds.Values.ToArray()) });
        }
    }

    /// <summary>sinew_character_bind_options of C; what is not set is its default.</summary>
    public sealed class CharacterBindSettings : JobSettings
    {
        public Method Method;
        /// <summary>1..12 influences per vertex; 0 = 4</summary>
        public int Influences;
        /// <summary>0 = Y</summary>
        public Up Up;
        public JointsFrom Joints;
        public RigidParts RigidParts;
        /// <summary>25..400, 200 = twice as soft; 0 = 100</summary>
        public int SoftnessPercent;
        /// <summary>Larger meshes are bound on a surface reduced to this many vertices; 0 = 32768</summary>
        public int SurfaceVertices;
        /// <summary>Joints that only end a chain keep their weight</summary>
        public bool KeepTips;
        /// <summary>Meshes without a skin are bound too</summary>
        public bool BindProps;
        /// <summary>Scales, rotates and moves a skeleton that has other units or stands beside the mesh</summary>
        public bool Fit;
        /// <summary>Mirrored vertices get mirrored weights</summary>
        public bool Symmetric;
        /// <summary>A saved .glb has the confidence as attribute _CONFIDENCE</summary>
        public bool KeepConfidence;
        /// <summary>JOINT_NEVER, JOINT_DEFORMS (if any has it, no other deforms); or null</summary>
        public byte[] JointFlags;
        /// <summary>Not 0: the vertex keeps its weights; or null</summary>
        public byte[] Locked;
        /// <summary>Not 0: the vertex keeps its weights, which guide its surroundings; or null</summary>
        public byte[] Hinted;
        /// <summary>Weights of some vertices of the same mesh, joints by name, instead of hinted; or null</summary>
        public Character Hints;
        /// <summary>A bound character whose weights are transferred where they fit; or null</summary>
        public Character Like;
        /// <summary>A .style file with answers about similar parts</summary>
        public string Style;
        /// <summary>Rest pose of the result: "t", "a", or a file with a skeleton in that pose; null: unchanged. Implies cut</summary>
        public string ToPose;
        /// <summary>Fused parts are cut open; doubled vertices are appended</summary>
        public bool Cut;
        /// <summary>Bytes of .sinew files in place of the bundled models; or null.</summary>
        public byte[] Model;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            Character.Length(JointFlags, sizes.joint_count, "CharacterBindSettings.JointFlags: expected [J] numbers");
            Character.Length(Locked, sizes.vertex_count, "CharacterBindSettings.Locked: expected [V] numbers");
            Character.Length(Hinted, sizes.vertex_count, "CharacterBindSettings.Hinted: expected [V] numbers");
            return pins.Of(new Native.sinew_character_bind_options {struct_size = Character.Size<Native.sinew_character_bind_options>(),
                thread_count = (uint)Threads, progress = watch.Callback, models = Character.Models(pins, Model, null, null, null, null),
                method = (uint)Method, influence_count = (uint)Influences, up = (uint)Up, joints = (uint)Joints,
                rigid_parts = (uint)RigidParts, softness_percent = (uint)SoftnessPercent, surface_vertices = (uint)SurfaceVertices,
                keep_tips = KeepTips ? 1u : 0, bind_props = BindProps ? 1u : 0, fit = Fit ? 1u : 0, symmetric = Symmetric ? 1u : 0,
                keep_confidence = KeepConfidence ? 1u : 0, joint_flags = pins.Of(JointFlags), locked = pins.Of(Locked),
                hinted = pins.Of(Hinted), hints = Hints == null ? IntPtr.Zero : Hints.Handle,
                like = Like == null ? IntPtr.Zero : Like.Handle, style = pins.Of(Style), to_pose = pins.Of(ToPose), cut = Cut ? 1u : 0 });
        }
    }

    /// <summary>sinew_character_rig_options of C; what is not set is its default.</summary>
    public sealed class CharacterRigSettings : JobSettings
    {
        public CharacterRigMethod Method;
        public CharacterDetail Detail;
        public Mirror Mirror;
        /// <summary>0 = by the file format, else found</summary>
        public Up Up;
        /// <summary>0 = found</summary>
        public Front Front;
        /// <summary>Body class; 0 = as predicted</summary>
        public Category Category;
        /// <summary>1..16 spine joints; 0 = as predicted</summary>
        public int SpineCount;
        /// <summary>No toe joints</summary>
        public bool Toes = true;
        /// <summary>No NAME_end joints at chain ends</summary>
        public bool Ends = true;
        /// <summary>The skeleton only, without weights</summary>
        public bool Bind = true;
        /// <summary>With a skeleton, its bones are rotated and all scaled by one factor</summary>
        public bool KeepLengths;
        /// <summary>Checks the result; each failure is a note that begins with "gate: "</summary>
        public bool Gate;
        /// <summary>A file, or template:NAME, whose skeleton is fitted into the mesh</summary>
        public string Skeleton;
        /// <summary>A character whose skeleton is fitted into the mesh; or null</summary>
        public Character SkeletonCharacter;
        /// <summary>Bind: 1..12 influences per vertex; 0 = 4</summary>
        public int Influences;
        public RigidParts RigidParts;
        /// <summary>Bind: 25..400, 200 = twice as soft; 0 = 100</summary>
        public int SoftnessPercent;
        /// <summary>Bind: larger meshes are bound on a surface reduced to this many vertices; 0 = 32768</summary>
        public int SurfaceVertices;
        /// <summary>Bind: rest pose of the result: "t", "a", or a file with a skeleton in that pose; null: unchanged. Implies cut</summary>
        public string ToPose;
        /// <summary>Bind: fused parts are cut open; doubled vertices are appended</summary>
        public bool Cut;
        /// <summary>Bytes of .sinew files in place of the bundled models; or null.</summary>
        public byte[] Model, HandsModel, FrontModel;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            var bind = new Native.sinew_character_bind_options {struct_size = Character.Size<Native.sinew_character_bind_options>(),
                influence_count = (uint)Influences, rigid_parts = (uint)RigidParts, softness_percent = (uint)SoftnessPercent,
                surface_vertices = (uint)SurfaceVertices, to_pose = pins.Of(ToPose), cut = Cut ? 1u : 0 };
            return pins.Of(new Native.sinew_character_rig_options {struct_size = Character.Size<Native.sinew_character_rig_options>(),
                thread_count = (uint)Threads, progress = watch.Callback,
                models = Character.Models(pins, null, Method == CharacterRigMethod.Slots ? null : Model, HandsModel, Method == CharacterRigMethod.Slots ? Model : null, FrontModel),
                method = (uint)Method, detail = (uint)Detail, mirror = (uint)Mirror, up = (uint)Up, front = (uint)Front,
                category = (uint)Category, spine_count = (uint)SpineCount,
                without = (Toes ? 0 : Native.WITHOUT_TOES) | (Ends ? 0 : Native.WITHOUT_ENDS) | (Bind ? 0 : Native.WITHOUT_BIND),
                keep_lengths = KeepLengths ? 1u : 0, gate = Gate ? 1u : 0, skeleton = pins.Of(Skeleton),
                skeleton_character = SkeletonCharacter == null ? IntPtr.Zero : SkeletonCharacter.Handle, bind = pins.Of(bind) });
        }
    }

    /// <summary>sinew_character_map_options of C; what is not set is its default.</summary>
    public sealed class CharacterMapSettings
    {
        public MapMethod Method;
        /// <summary>Ignores joint names</summary>
        public bool Names = true;
        /// <summary>Ignores bone ends</summary>
        public bool Ends = true;
        /// <summary>0 = along the legs of a body with two legs, else Y</summary>
        public Up TargetUp;
        /// <summary>Guesses the up axis, as with target_up 0</summary>
        public bool GuessUp;
        /// <summary>Pairs to keep</summary>
        public Native.sinew_map_pin[] Pins;
        /// <summary>A map file whose pairs are kept</summary>
        public string PinsFile;
        /// <summary>Of "branches"</summary>
        public BranchesFirst First;
        /// <summary>Of "branches"</summary>
        public BranchesCost Cost;
        /// <summary>Of the motion; 0 = found</summary>
        public Up SourceUp;
        /// <summary>Layout of keypoints (.npy, .npz): "smpl24", ...; null: chosen by the number of keypoints</summary>
        public string Layout;
        /// <summary>Actor of a file with several people, by name of the root or number; null: the first, if all have equal
        /// skeletons</summary>
        public string Actor;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            var source = new Native.sinew_motion_source {struct_size = Character.Size<Native.sinew_motion_source>(), up = (uint)SourceUp,
                layout = pins.Of(Layout), actor = pins.Of(Actor) };
            return pins.Of(new Native.sinew_character_map_options {struct_size = Character.Size<Native.sinew_character_map_options>(),
                method = (uint)Method, without = (Names ? 0 : Native.WITHOUT_NAMES) | (Ends ? 0 : Native.WITHOUT_ENDS),
                target_up = (uint)TargetUp, guess_up = GuessUp ? 1u : 0, pin_count = Character.Count(Pins), pins = pins.Of((object)Pins),
                pins_file = pins.Of(PinsFile), branches_first = (uint)First, branches_cost = (uint)Cost, source = pins.Of(source) });
        }
    }

    /// <summary>sinew_character_animate_options of C; what is not set is its default.</summary>
    public sealed class AnimateSettings : JobSettings
    {
        public AnimateMethod Method;
        /// <summary>Knees and elbows may leave their natural range</summary>
        public bool Range = true;
        /// <summary>Keeps the character above its rest position</summary>
        public bool InPlace;
        /// <summary>Of the character; 0 = found</summary>
        public Up TargetUp;
        /// <summary>Maximum number of morph targets per clip; 0 = 16</summary>
        public int Shapes;
        /// <summary>Measures limbs before and after</summary>
        public bool Report;
        /// <summary>Plays a motion that does not fit, such as a person's on a horse; 0: that is an error</summary>
        public bool Force;
        /// <summary>Bones stretch like the source's, as in sinew_retarget_options</summary>
        public bool Translations;
        /// <summary>Bones of a picture's character may leave the picture plane</summary>
        public bool Depth;
        /// <summary>Pairs to keep in a map that is found</summary>
        public Native.sinew_map_pin[] Pins;
        /// <summary>A map file; null: found</summary>
        public string Map;
        /// <summary>Joint of the motion or -1, instead of a map; or null</summary>
        public int[] Sources;
        /// <summary>Rotation limits of joints, for every method: a .urdf, a file of formats/spec/limits.md, or "human"; null: only the
        /// natural range of knees and elbows</summary>
        public string Limits;
        /// <summary>Simulates the character's springs (hair, tails, ears, skirts) in the clips, see springs()</summary>
        public bool Springs;
        /// <summary>Degrees, -90..90, by which both arms are lifted away from the body, as in sinew_retarget_options</summary>
        public float ArmSpread;
        /// <summary>Of the motion; 0 = found</summary>
        public Up MotionUp;
        /// <summary>Layout of keypoints (.npy, .npz): "smpl24", ...; null: chosen by the number of keypoints</summary>
        public string Layout;
        /// <summary>Actor of a file with several people, by name of the root or number; null: the first, if all have equal
        /// skeletons</summary>
        public string Actor;
        /// <summary>Clip by name or number; null: all</summary>
        public string Clip;
        /// <summary>Frames per second; 0 = as in the motion</summary>
        public double Fps;
        /// <summary>First second to play</summary>
        public double From;
        /// <summary>Last second to play; 0 = the end</summary>
        public double To;
        /// <summary>Animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
        /// VOLUME, depending on the call</summary>
        public PoseDeform Deform;
        /// <summary>Lattice cells of the deformer; 0 = its default</summary>
        public int Cells;
        /// <summary>Iterations of the deformer; 0 = its default</summary>
        public int Rounds;
        /// <summary>For VOLUME and XPBD, limbs keep out of the body</summary>
        public bool BodyContact;
        /// <summary>For "xpbd"</summary>
        public TetWeights TetWeights;
        /// <summary>Bends are not smoothed, for SINEW_POSE_XPBD</summary>
        public bool Smoothing = true;
        /// <summary>"xpbd" as published, see sinew/deform.h</summary>
        public bool DeformAsDrawn;
        /// <summary>Stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2</summary>
        public double Stiffness;
        /// <summary>Reference points: n, 1 .. 4, or NO_AREA for 0; 0 = 3</summary>
        public int AreaPower;
        /// <summary>Reference points: triangles of the limb itself have influence too</summary>
        public bool OwnLimb;
        /// <summary>Reference points: also corrects knees and ankles</summary>
        public bool Legs;
        /// <summary>Reference points: d: influence also falls by exp(-(distance / (d * source's height))^2); 0 = 0.05 (added by
        /// sinew)</summary>
        public float Falloff;
        /// <summary>Reference points: also corrects the head</summary>
        public bool Head;
        /// <summary>Reference points: copies directions between torso joints; 0: copies their rotations</summary>
        public bool Torso;
        /// <summary>Reference points: reference points of the source's body, scaled to the target; 0: of the target's body</summary>
        public bool SourcePoints;
        /// <summary>Reference points: as published: one sum over all triangles, including the limb's own; knees, ankles, head and torso
        /// too; the source's reference points; no falloff, no push-out. own_limb to source_points are ignored</summary>
        public bool AsDrawn;
        /// <summary>Bytes of .sinew files in place of the bundled models; or null.</summary>
        public byte[] Model, HandsModel, FrontModel;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            Character.Length(Sources, sizes.joint_count, "AnimateSettings.Sources: expected [J] numbers");
            var motion = new Native.sinew_motion_source {struct_size = Character.Size<Native.sinew_motion_source>(), up = (uint)MotionUp,
                layout = pins.Of(Layout), actor = pins.Of(Actor), clip = pins.Of(Clip), fps = Fps, from = From, to = To };
            var deform = new Native.sinew_character_deformation {struct_size = Character.Size<Native.sinew_character_deformation>(),
                method = (uint)Deform, cells = (uint)Cells, rounds = (uint)Rounds, body_contact = BodyContact ? 1u : 0,
                tet_weights = (uint)TetWeights, without = (Smoothing ? 0 : Native.WITHOUT_SMOOTHING),
                deform_as_drawn = DeformAsDrawn ? 1u : 0, stiffness = Stiffness };
            var reference = new Native.sinew_reference_options {struct_size = Character.Size<Native.sinew_reference_options>(),
                area_power = (uint)AreaPower, own_limb = OwnLimb ? 1u : 0, legs = Legs ? 1u : 0, falloff = Falloff, head = Head ? 1u : 0,
                torso = Torso ? 1u : 0, source_points = SourcePoints ? 1u : 0, as_drawn = AsDrawn ? 1u : 0 };
            return pins.Of(new Native.sinew_character_animate_options {
                struct_size = Character.Size<Native.sinew_character_animate_options>(), thread_count = (uint)Threads,
                progress = watch.Callback, models = Character.Models(pins, null, Model, HandsModel, null, FrontModel),
                method = (uint)Method, without = (Range ? 0 : Native.WITHOUT_RANGE), in_place = InPlace ? 1u : 0,
                target_up = (uint)TargetUp, shapes = (uint)Shapes, report = Report ? 1u : 0, force = Force ? 1u : 0,
                translations = Translations ? 1u : 0, depth = Depth ? 1u : 0, pin_count = Character.Count(Pins),
                pins = pins.Of((object)Pins), map = pins.Of(Map), sources = pins.Of(Sources), limits = pins.Of(Limits),
                springs = Springs ? 1u : 0, arm_spread = ArmSpread, motion = pins.Of(motion), deform = pins.Of(deform),
                reference = pins.Of(reference) });
        }
    }

    /// <summary>sinew_character_pose_options of C; what is not set is its default.</summary>
    public sealed class PoseSettings
    {
        /// <summary>Degrees about x, then y, then z; or null</summary>
        public double[] Angles;
        /// <summary>X y z w, local, relative to the rest pose; or null</summary>
        public double[] Rotations;
        /// <summary>Row-major 3x4, rest to posed space; or null</summary>
        public double[] Matrices;
        /// <summary>Clip of the character, by name or number</summary>
        public string Clip;
        /// <summary>Time in the clip, in seconds</summary>
        public double Time;
        /// <summary>Animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
        /// VOLUME, depending on the call</summary>
        public PoseDeform Deform;
        /// <summary>Lattice cells of the deformer; 0 = its default</summary>
        public int Cells;
        /// <summary>Iterations of the deformer; 0 = its default</summary>
        public int Rounds;
        /// <summary>For VOLUME and XPBD, limbs keep out of the body</summary>
        public bool BodyContact;
        /// <summary>For "xpbd"</summary>
        public TetWeights TetWeights;
        /// <summary>Bends are not smoothed, for SINEW_POSE_XPBD</summary>
        public bool Smoothing = true;
        /// <summary>"xpbd" as published, see sinew/deform.h</summary>
        public bool DeformAsDrawn;
        /// <summary>Stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2</summary>
        public double Stiffness;
        public int Threads = 1;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            Character.Length(Angles, sizes.joint_count * 3, "PoseSettings.Angles: expected [J x 3] numbers");
            Character.Length(Rotations, sizes.joint_count * 4, "PoseSettings.Rotations: expected [J x 4] numbers");
            Character.Length(Matrices, sizes.joint_count * 12, "PoseSettings.Matrices: expected [J x 12] numbers");
            var deform = new Native.sinew_character_deformation {struct_size = Character.Size<Native.sinew_character_deformation>(),
                method = (uint)Deform, cells = (uint)Cells, rounds = (uint)Rounds, body_contact = BodyContact ? 1u : 0,
                tet_weights = (uint)TetWeights, without = (Smoothing ? 0 : Native.WITHOUT_SMOOTHING),
                deform_as_drawn = DeformAsDrawn ? 1u : 0, stiffness = Stiffness };
            return pins.Of(new Native.sinew_character_pose_options {struct_size = Character.Size<Native.sinew_character_pose_options>(),
                thread_count = (uint)Threads, angles = pins.Of(Angles), rotations = pins.Of(Rotations), matrices = pins.Of(Matrices),
                clip = pins.Of(Clip), time = Time, deform = pins.Of(deform) });
        }
    }

    /// <summary>sinew_character_transfer_options of C; what is not set is its default.</summary>
    public sealed class CharacterTransferSettings : JobSettings
    {
        public TransferMethod Method;
        /// <summary>1..12 influences per vertex; 0 = 4</summary>
        public int Influences;
        /// <summary>0 = Y</summary>
        public Up TargetUp;
        /// <summary>0 = Y</summary>
        public Up SourceUp;
        /// <summary>The source wears the target</summary>
        public bool Garment;
        /// <summary>"biharmonic" as published</summary>
        public bool AsDrawn;
        /// <summary>Binds by heat only, without a model</summary>
        public bool Heat;
        /// <summary>Reference points of "biharmonic"</summary>
        public Native.sinew_vertex_pair[] Pairs;
        /// <summary>Not 0: the target's vertex keeps its weights; or null</summary>
        public byte[] Locked;
        /// <summary>A map file; null: found</summary>
        public string Map;
        /// <summary>Bytes of .sinew files in place of the bundled models; or null.</summary>
        public byte[] Model;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            Character.Length(Locked, sizes.vertex_count, "CharacterTransferSettings.Locked: expected [V] numbers");
            return pins.Of(new Native.sinew_character_transfer_options {
                struct_size = Character.Size<Native.sinew_character_transfer_options>(), thread_count = (uint)Threads,
                progress = watch.Callback, models = Character.Models(pins, Model, null, null, null, null), method = (uint)Method,
                influence_count = (uint)Influences, target_up = (uint)TargetUp, source_up = (uint)SourceUp, garment = Garment ? 1u : 0,
                as_drawn = AsDrawn ? 1u : 0, heat = Heat ? 1u : 0, pair_count = Character.Count(Pairs), pairs = pins.Of((object)Pairs),
                locked = pins.Of(Locked), map = pins.Of(Map) });
        }
    }

    /// <summary>sinew_character_springs_options of C; what is not set is its default.</summary>
    public sealed class SpringsSettings
    {
        /// <summary>Finds springs anew instead of the file's own</summary>
        public bool Replace;
        /// <summary>Chains to keep despite a low probability, or in addition to the file's own</summary>
        public string[] Take;
        /// <summary>Chains to leave out</summary>
        public string[] Drop;
        /// <summary>NAME=KIND: parameters of another kind, hair, long-hair, skirt, tail, ear, cape, bust or ribbon</summary>
        public string[] Presets;
        /// <summary>NAME:FIELD=X sets a parameter of a chain's joints, NAME:FIELD=xF scales it by F: stiffness, gravity, drag, radius or
        /// limit</summary>
        public string[] Values;
        /// <summary>Makes chains of joints in skirts, coats and capes that have none, and binds these to them</summary>
        public bool Make;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            return pins.Of(new Native.sinew_character_springs_options {
                struct_size = Character.Size<Native.sinew_character_springs_options>(), replace = Replace ? 1u : 0,
                take_count = Character.Count(Take), take = pins.Of(Take), drop_count = Character.Count(Drop), drop = pins.Of(Drop),
                preset_count = Character.Count(Presets), presets = pins.Of(Presets), value_count = Character.Count(Values),
                values = pins.Of(Values), make = Make ? 1u : 0 });
        }
    }

    /// <summary>sinew_character_bake_options of C; what is not set is its default.</summary>
    public sealed class BakeSettings
    {
        /// <summary>Number of training poses; 0 = 1500</summary>
        public int Poses;
        /// <summary>Maximum number of driving weights per bend, each with one or two morph targets; 0 = 8</summary>
        public int Shapes;
        /// <summary>Seed of the random poses; 0 = 1</summary>
        public ulong Seed;
        /// <summary>Maximum angle in degrees; 0 = 60</summary>
        public double Limit;
        /// <summary>Clip of the character to train on; null: random poses</summary>
        public string Clip;
        /// <summary>Threshold for leaving out displacements of vertices: root mean square over the poses as a share of the size; 0 =
        /// 0.002</summary>
        public double Error;
        /// <summary>Animate makes morph targets for corrections (VOLUME and above), which bake requires. 0 = none, linear blending or
        /// VOLUME, depending on the call</summary>
        public PoseDeform Deform;
        /// <summary>Lattice cells of the deformer; 0 = its default</summary>
        public int Cells;
        /// <summary>Iterations of the deformer; 0 = its default</summary>
        public int Rounds;
        /// <summary>For VOLUME and XPBD, limbs keep out of the body</summary>
        public bool BodyContact;
        /// <summary>For "xpbd"</summary>
        public TetWeights TetWeights;
        /// <summary>Bends are not smoothed, for SINEW_POSE_XPBD</summary>
        public bool Smoothing = true;
        /// <summary>"xpbd" as published, see sinew/deform.h</summary>
        public bool DeformAsDrawn;
        /// <summary>Stiffness of the springs in the lattice's tetrahedra, 0.001 to 1000, for "xpbd"; 0 = 0.2</summary>
        public double Stiffness;
        public Func<float, bool> Progress;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            var deform = new Native.sinew_character_deformation {struct_size = Character.Size<Native.sinew_character_deformation>(),
                method = (uint)Deform, cells = (uint)Cells, rounds = (uint)Rounds, body_contact = BodyContact ? 1u : 0,
                tet_weights = (uint)TetWeights, without = (Smoothing ? 0 : Native.WITHOUT_SMOOTHING),
                deform_as_drawn = DeformAsDrawn ? 1u : 0, stiffness = Stiffness };
            return pins.Of(new Native.sinew_character_bake_options {struct_size = Character.Size<Native.sinew_character_bake_options>(),
                progress = watch.Callback, poses = (uint)Poses, shapes = (uint)Shapes, seed = Seed, limit = Limit, clip = pins.Of(Clip),
                error = Error, deform = pins.Of(deform) });
        }
    }

    /// <summary>sinew_character_picture_options of C; what is not set is its default.</summary>
    public sealed class PictureSettings
    {
        public BodyClass BodyClass;
        /// <summary>Number of the figure, from left to right, starting at 1; 0: the largest</summary>
        public int Figure;
        /// <summary>A flat card instead of a body as thick as it is wide</summary>
        public bool Flat;
        /// <summary>Positions in pixels, x right, y up from the bottom edge; 0: the longest side is 1</summary>
        public bool Pixels;
        /// <summary>Mask of the figure, bright inside: a file, or the name of one in memory; null: found</summary>
        public string Mask;
        /// <summary>Outline of the figure as in picture_info; null: found</summary>
        public float[][] Outline;
        /// <summary>Cuts the figure along lines drawn into it from its outline</summary>
        public bool Cut;

        internal IntPtr Options(Pins pins, Watch watch, Native.sinew_character_arrays sizes)
        {
            var ends = new List<uint> { 0 };
            foreach (float[] line in Outline ?? new float[0][]) ends.Add(ends[ends.Count - 1] + (uint)line.Length / 2);
            return pins.Of(new Native.sinew_character_picture_options {
                struct_size = Character.Size<Native.sinew_character_picture_options>(), body_class = (uint)BodyClass, figure = (uint)Figure,
                flat = Flat ? 1u : 0, pixels = Pixels ? 1u : 0, mask = pins.Of(Mask), line_count = Character.Count(Outline),
                line_offsets = Outline == null ? IntPtr.Zero : pins.Of(ends.ToArray()),
                outline = Outline == null ? IntPtr.Zero : pins.Of(Outline.SelectMany(line => line).ToArray()), cut = Cut ? 1u : 0 });
        }
    }

    /// <summary>sinew_character_finding of C.</summary>
    public sealed class Finding
    {
        /// <summary>"left-right"; check_rules() lists them</summary>
        public string Rule;
        /// <summary>One line of English</summary>
        public string What;
        /// <summary>One line: the remedy</summary>
        public string Cure;
        /// <summary>Test pose in which it shows; "": none</summary>
        public string Pose;
        /// <summary>Animation in which it shows; "": none</summary>
        public string Clip;
        /// <summary>Time in the clip</summary>
        public double Seconds;
        /// <summary>Measured value</summary>
        public double Value;
        /// <summary>The value above which it is a finding</summary>
        public double Bound;
        /// <summary>Ascending; null for a finding about joints or clips</summary>
        public int[] Vertices;
        public CheckSeverity Severity;
        /// <summary>Joint of the finding; -1: none</summary>
        public int Joint;
        /// <summary>Joint for comparison; -1: none</summary>
        public int Other;
        /// <summary>Mesh of all its vertices; -1: none, or several</summary>
        public int Mesh;
        /// <summary>Position of the finding, in the mesh's units</summary>
        public float[] Position;
        /// <summary>Radius of the finding around the position</summary>
        public float Radius;

        internal static Finding Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_finding>(at);
            return new Finding {Rule = Character.Text(r.rule), What = Character.Text(r.what), Cure = Character.Text(r.cure),
                Pose = Character.Text(r.pose), Clip = Character.Text(r.clip), Seconds = r.seconds, Value = r.value, Bound = r.bound,
                Vertices = Character.Ints(r.vertices, r.vertex_count), Severity = (CheckSeverity)r.severity, Joint = r.joint,
                Other = r.other, Mesh = r.mesh, Position = new[] { r.position_0, r.position_1, r.position_2 }, Radius = r.radius };
        }
    }

    /// <summary>sinew_character_check_result of C.</summary>
    public sealed class CheckResult
    {
        /// <summary>Number of findings of each severity</summary>
        public int Errors;
        public int Warnings;
        public int Notes;
        /// <summary>Errors first</summary>
        public Finding[] Findings;
        /// <summary>"checked: 0 findings"</summary>
        public string Line;
        /// <summary>0..100, similarity of the weights to those of three methods; -1 if not requested</summary>
        public double? Score;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_check_result { struct_size = Character.Size<Native.sinew_character_check_result>() });
        }

        internal static CheckResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_check_result>(at);
            return new CheckResult {Errors = (int)r.errors, Warnings = (int)r.warnings, Notes = (int)r.notes,
                Findings = Character.Structs<Native.sinew_character_finding, Finding>(r.findings, r.finding_count, sizes, Finding.Of),
                Line = Character.Text(r.line), Score = r.score < 0 ? (double?)null : r.score };
        }
    }

    /// <summary>sinew_character_left_out of C.</summary>
    public sealed class LeftOutJoint
    {
        /// <summary>Reason: "control", "no weight in the file", ..</summary>
        public string Why;
        public int Joint;

        internal static LeftOutJoint Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_left_out>(at);
            return new LeftOutJoint {Why = Character.Text(r.why), Joint = (int)r.joint };
        }
    }

    /// <summary>sinew_character_seam of C.</summary>
    public sealed class Seam
    {
        /// <summary>The joints on its two sides</summary>
        public int[] Joints;
        /// <summary>Its center</summary>
        public float[] Position;
        public float Length;

        internal static Seam Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_seam>(at);
            return new Seam {Joints = new[] { (int)r.joints_0, (int)r.joints_1 },
                Position = new[] { r.position_0, r.position_1, r.position_2 }, Length = r.length };
        }
    }

    /// <summary>sinew_character_bind_result of C.</summary>
    public sealed class CharacterBindResult
    {
        /// <summary>With symmetric: number of vertices with a mirror image</summary>
        public int SymmetricVertices;
        /// <summary>Number of meshes that stay attached to one joint</summary>
        public int KeptMeshes;
        /// <summary>Number of joints that gave their weight to their parents</summary>
        public int FoldedTips;
        /// <summary>Number of answers from the style file</summary>
        public int AnswersByStyle;
        /// <summary>Duration of sinew_bind()</summary>
        public double Seconds;
        public long WorkspaceBytes;
        /// <summary>Joints that must not get weight</summary>
        public LeftOutJoint[] LeftOut;
        /// <summary>Hash of the weights, as in `sinew bind --json`</summary>
        public string Hash;
        /// <summary>Longest first</summary>
        public Seam[] Seams;
        /// <summary>With cut or to_pose: number of doubled vertices</summary>
        public int DoubledVertices;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_bind_result { struct_size = Character.Size<Native.sinew_character_bind_result>() });
        }

        internal static CharacterBindResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_bind_result>(at);
            return new CharacterBindResult {SymmetricVertices = (int)r.symmetric_vertices, KeptMeshes = (int)r.kept_meshes,
                FoldedTips = (int)r.folded_tips, AnswersByStyle = (int)r.answers_by_style, Seconds = r.seconds,
                WorkspaceBytes = (long)r.workspace_bytes,
                LeftOut = Character.Structs<Native.sinew_character_left_out, LeftOutJoint>(r.left_out, r.left_out_count, sizes, LeftOutJoint.Of),
                Hash = Character.Text(r.hash),
                Seams = Character.Structs<Native.sinew_character_seam, Seam>(r.seams, r.seam_count, sizes, Seam.Of),
                DoubledVertices = (int)r.doubled_vertices };
        }
    }

    /// <summary>sinew_character_doubt of C.</summary>
    public sealed class LimbDoubt
    {
        /// <summary>Joint that names the limb: LeftArm, RightUpLeg, Tail</summary>
        public string Name;
        /// <summary>Probability that the limb is wrong, 0..1</summary>
        public float Doubt;

        internal static LimbDoubt Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_doubt>(at);
            return new LimbDoubt {Name = Character.Text(r.name), Doubt = r.doubt };
        }
    }

    /// <summary>sinew_character_rig_result of C.</summary>
    public sealed class CharacterRigResult
    {
        /// <summary>The skeleton is symmetric</summary>
        public bool Mirrored;
        /// <summary>With a skeleton: number of its joints that match the prediction</summary>
        public int Matched;
        /// <summary>N: number of joints of the arrays below</summary>
        public int JointCount;
        /// <summary>Estimated error of the votes, see sinew_rig_outputs</summary>
        public float Spread;
        /// <summary>With a skeleton: its scale factor</summary>
        public double Scale;
        public double Seconds;
        public double BindSeconds;
        /// <summary>A bone end</summary>
        public byte[] Ends;
        /// <summary>Confidence of positions, 0..1</summary>
        public float[] Confidence;
        /// <summary>Confidence of parents, 0..1</summary>
        public float[] ParentConfidence;
        /// <summary>Unit vector of the front direction</summary>
        public float[] Front;
        /// <summary>Y or Z</summary>
        public Up Up;
        /// <summary>0..1, see sinew_rig_outputs; uncertain below 0.7</summary>
        public float FrontConfidence;
        public float UpConfidence;
        /// <summary>Longest first</summary>
        public Seam[] Seams;
        /// <summary>Limbs by descending doubt; for votes</summary>
        public LimbDoubt[] Doubtful;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_rig_result { struct_size = Character.Size<Native.sinew_character_rig_result>() });
        }

        internal static CharacterRigResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_rig_result>(at);
            return new CharacterRigResult {Mirrored = r.mirrored != 0, Matched = (int)r.matched, JointCount = (int)r.joint_count,
                Spread = r.spread, Scale = r.scale, Seconds = r.seconds, BindSeconds = r.bind_seconds,
                Ends = Character.Bytes(r.ends, r.joint_count), Confidence = Character.Floats(r.confidence, r.joint_count),
                ParentConfidence = Character.Floats(r.parent_confidence, r.joint_count), Front = new[] { r.front_0, r.front_1, r.front_2 },
                Up = (Up)r.up, FrontConfidence = r.front_confidence, UpConfidence = r.up_confidence,
                Seams = Character.Structs<Native.sinew_character_seam, Seam>(r.seams, r.seam_count, sizes, Seam.Of),
                Doubtful = Character.Structs<Native.sinew_character_doubt, LimbDoubt>(r.doubtful, r.doubtful_count, sizes, LimbDoubt.Of) };
        }
    }

    /// <summary>sinew_character_map_result of C.</summary>
    public sealed class CharacterMap
    {
        /// <summary>That was used</summary>
        public MapMethod Method;
        /// <summary>J: number of joints of the target</summary>
        public int JointCount;
        /// <summary>Number of joints with a source</summary>
        public int Mapped;
        /// <summary>0..1, certainty of front, sides and torso</summary>
        public float Certainty;
        /// <summary>0..1, share of both bodies that is mapped; below 0.5 animate() rejects it</summary>
        public float Cover;
        public double Seconds;
        /// <summary>Joint of the source, -1 = none</summary>
        public int[] Sources;
        /// <summary>0..1</summary>
        public float[] Confidence;
        public byte[] Reasons;
        /// <summary>The map as `sinew map -o` writes it</summary>
        public string Text;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_map_result { struct_size = Character.Size<Native.sinew_character_map_result>() });
        }

        internal static CharacterMap Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_map_result>(at);
            return new CharacterMap {Method = (MapMethod)r.method, JointCount = (int)r.joint_count, Mapped = (int)r.mapped,
                Certainty = r.certainty, Cover = r.cover, Seconds = r.seconds, Sources = Character.Ints(r.sources, r.joint_count),
                Confidence = Character.Floats(r.confidence, r.joint_count), Reasons = Character.Bytes(r.reasons, r.joint_count),
                Text = Character.Text(r.text) };
        }
    }

    /// <summary>sinew_limb_quality of C.</summary>
    public sealed class LimbQuality
    {
        /// <summary>Of the target: wrist or ankle</summary>
        public int Joint;
        /// <summary>Leg, 0: arm</summary>
        public bool Leg;
        /// <summary>Of the clip</summary>
        public int Frames;
        /// <summary>With a depth above 0.006</summary>
        public int DeepFrames;
        /// <summary>With a contact</summary>
        public int ContactFrames;
        /// <summary>With elbow or knee out of its natural range by more than a degree</summary>
        public int RangeFrames;
        /// <summary>Mean over frames</summary>
        public float Depth;
        public float GreatestDepth;
        /// <summary>Mean over contact frames</summary>
        public float Error;
        public float GreatestError;

        internal static LimbQuality Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_limb_quality>(at);
            return new LimbQuality {Joint = (int)r.joint, Leg = r.leg != 0, Frames = (int)r.frames, DeepFrames = (int)r.deep_frames,
                ContactFrames = (int)r.contact_frames, RangeFrames = (int)r.range_frames, Depth = r.depth, GreatestDepth = r.greatest_depth,
                Error = r.error, GreatestError = r.greatest_error };
        }
    }

    /// <summary>sinew_character_animate_result of C.</summary>
    public sealed class AnimateResult
    {
        /// <summary>Number of clips that were added</summary>
        public int ClipCount;
        /// <summary>Index of the first of them, for get_clip()</summary>
        public int FirstClip;
        /// <summary>Number of joints with a source</summary>
        public int Mapped;
        /// <summary>A bare mesh was rigged first</summary>
        public bool Rigged;
        /// <summary>Number of morph targets that were added</summary>
        public int ShapeCount;
        /// <summary>0..1, certainty of front and sides, at most the share of both bodies that is mapped</summary>
        public float Certainty;
        /// <summary>With report: number of limbs in both arrays below</summary>
        public int LimbCount;
        /// <summary>With report</summary>
        public LimbQuality[] LimbsBefore;
        /// <summary>With report</summary>
        public LimbQuality[] LimbsAfter;
        /// <summary>How the map was found: "anatomy and names", ..</summary>
        public string MappedBy;
        /// <summary>The map that was used: joint of the motion, -1 = none</summary>
        public int[] Sources;
        public byte[] Reasons;
        /// <summary>A bone end, which does not rotate</summary>
        public byte[] SourceEnds;
        /// <summary>Names of the joints of the motion, one per line</summary>
        public string SourceNames;
        public byte[] SpotKinds;
        /// <summary>Positions, see sinew_contact_spot</summary>
        public float[] SpotPositions;
        public float[] SpotErrors;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_animate_result { struct_size = Character.Size<Native.sinew_character_animate_result>() });
        }

        internal static AnimateResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_animate_result>(at);
            return new AnimateResult {ClipCount = (int)r.clip_count, FirstClip = (int)r.first_clip, Mapped = (int)r.mapped,
                Rigged = r.rigged != 0, ShapeCount = (int)r.shape_count, Certainty = r.certainty, LimbCount = (int)r.limb_count,
                LimbsBefore = Character.Structs<Native.sinew_limb_quality, LimbQuality>(r.limbs_before, r.clip_count * r.limb_count, sizes, LimbQuality.Of),
                LimbsAfter = Character.Structs<Native.sinew_limb_quality, LimbQuality>(r.limbs_after, r.clip_count * r.limb_count, sizes, LimbQuality.Of),
                MappedBy = Character.Text(r.mapped_by), Sources = Character.Ints(r.sources, sizes.joint_count),
                Reasons = Character.Bytes(r.reasons, sizes.joint_count), SourceEnds = Character.Bytes(r.source_ends, r.source_count),
                SourceNames = Character.Text(r.source_names), SpotKinds = Character.Bytes(r.spot_kinds, r.spot_count),
                SpotPositions = Character.Floats(r.spot_positions, r.spot_count * 3),
                SpotErrors = Character.Floats(r.spot_errors, r.spot_count) };
        }
    }

    /// <summary>sinew_transfer_part of C.</summary>
    public sealed class TransferPart
    {
        /// <summary>Its vertex of lowest index</summary>
        public int Vertex;
        /// <summary>Of the target</summary>
        public int VertexCount;
        /// <summary>Of the larger share</summary>
        public TransferReason Reason;
        /// <summary>Share of its weights that was transferred, 65536 = all; the rest was rebound</summary>
        public double Carried;
        /// <summary>Difference between the source's weights there and a bind: sum over joints, mean over the vertices, 0..131072. 0 if
        /// nothing was bound</summary>
        public double Style;
        /// <summary>The same between a bind of the target and the transferred bind of the source: the match error</summary>
        public double Mismatch;
        /// <summary>Mean distance of its vertices from the aligned source, in longest sides of the target</summary>
        public double Distance;

        internal static TransferPart Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_transfer_part>(at);
            return new TransferPart {Vertex = (int)r.vertex, VertexCount = (int)r.vertex_count, Reason = (TransferReason)r.reason,
                Carried = r.carried_q16 / 65536.0, Style = r.style_q16 / 65536.0, Mismatch = r.mismatch_q16 / 65536.0,
                Distance = r.distance_q16 / 65536.0 };
        }
    }

    /// <summary>sinew_character_transfer_result of C.</summary>
    public sealed class CharacterTransferResult
    {
        /// <summary>Number of source joints that were mapped</summary>
        public int MappedJoints;
        /// <summary>The target had no skeleton and got the source's</summary>
        public bool Fitted;
        /// <summary>A part was rebound</summary>
        public bool Bound;
        public Method BoundBy;
        /// <summary>As in sinew_transfer_outputs; so are style and mismatch</summary>
        public double Carried;
        public double Style;
        public double Mismatch;
        public double Seconds;
        public string MappedBy;
        /// <summary>By descending size</summary>
        public TransferPart[] Parts;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_transfer_result { struct_size = Character.Size<Native.sinew_character_transfer_result>() });
        }

        internal static CharacterTransferResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_transfer_result>(at);
            return new CharacterTransferResult {MappedJoints = (int)r.mapped_joints, Fitted = r.fitted != 0, Bound = r.bound != 0,
                BoundBy = (Method)r.bound_by, Carried = r.carried, Style = r.style, Mismatch = r.mismatch, Seconds = r.seconds,
                MappedBy = Character.Text(r.mapped_by),
                Parts = Character.Structs<Native.sinew_transfer_part, TransferPart>(r.parts, r.part_count, sizes, TransferPart.Of) };
        }
    }

    /// <summary>sinew_character_springs_result of C.</summary>
    public sealed class SpringsResult
    {
        /// <summary>Number of chains that are kept</summary>
        public int ChainCount;
        /// <summary>Number of joints that swing</summary>
        public int JointCount;
        /// <summary>Number of spheres and capsules that push them</summary>
        public int ColliderCount;
        /// <summary>Number of the file's own chains, which come first</summary>
        public int OwnCount;
        /// <summary>Kept</summary>
        public byte[] Kept;
        /// <summary>0..1</summary>
        public float[] Certainties;
        /// <summary>Names of the proposals, one per line</summary>
        public string Names;
        /// <summary>Kinds of the proposals, one per line</summary>
        public string Kinds;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_springs_result { struct_size = Character.Size<Native.sinew_character_springs_result>() });
        }

        internal static SpringsResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_springs_result>(at);
            return new SpringsResult {ChainCount = (int)r.chain_count, JointCount = (int)r.joint_count,
                ColliderCount = (int)r.collider_count, OwnCount = (int)r.own_count, Kept = Character.Bytes(r.kept, r.proposal_count),
                Certainties = Character.Floats(r.certainties, r.proposal_count), Names = Character.Text(r.names),
                Kinds = Character.Text(r.kinds) };
        }
    }

    /// <summary>sinew_character_bake_result of C.</summary>
    public sealed class BakeResult
    {
        public int ShapeCount;
        public int BendCount;
        public int MovedVertices;
        public int LearntPoses;
        public int HeldOutPoses;
        /// <summary>Error in the training poses as a share of the size, with linear skinning; the next member with the shapes</summary>
        public double LinearError;
        public double BakedError;
        /// <summary>The same in other poses</summary>
        public double HeldOutLinearError;
        public double HeldOutBakedError;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_bake_result { struct_size = Character.Size<Native.sinew_character_bake_result>() });
        }

        internal static BakeResult Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_bake_result>(at);
            return new BakeResult {ShapeCount = (int)r.shape_count, BendCount = (int)r.bend_count, MovedVertices = (int)r.moved_vertices,
                LearntPoses = (int)r.learnt_poses, HeldOutPoses = (int)r.held_out_poses, LinearError = r.linear_error,
                BakedError = r.baked_error, HeldOutLinearError = r.held_out_linear_error, HeldOutBakedError = r.held_out_baked_error };
        }
    }

    /// <summary>sinew_character_picture_info of C.</summary>
    public sealed class PictureInfo
    {
        /// <summary>Pixels of the picture as displayed</summary>
        public int Width;
        public int Height;
        /// <summary>Number of figures in the picture</summary>
        public int FigureCount;
        /// <summary>The figure that was taken, starting at 1</summary>
        public int Figure;
        /// <summary>0 before it is rigged</summary>
        public BodyClass BodyClass;
        /// <summary>0 before it is rigged</summary>
        public PictureView View;
        /// <summary>0..1, certainty of class and view together; 0 before it is rigged</summary>
        public float Certainty;
        /// <summary>Pixels, x right, y down from the top left corner</summary>
        public float[][] Outline;

        internal static IntPtr Room(Pins pins)
        {
            return pins.Of(new Native.sinew_character_picture_info { struct_size = Character.Size<Native.sinew_character_picture_info>() });
        }

        internal static PictureInfo Of(IntPtr at, Native.sinew_character_arrays sizes)
        {
            var r = Character.Read<Native.sinew_character_picture_info>(at);
            return new PictureInfo {Width = (int)r.width, Height = (int)r.height, FigureCount = (int)r.figure_count, Figure = (int)r.figure,
                BodyClass = (BodyClass)r.body_class, View = (PictureView)r.view, Certainty = r.certainty,
                Outline = Character.Lines(r.outline, r.line_offsets, r.line_count) };
        }
    }

    public sealed partial class Character
    {
        /// <summary>Sets what Save() and Write() write: joint names and axes, a root, influences, facing, VRM data. The rest pose stays:
        /// see to_pose of bind and rig ("t" for most programs, "a" for unreal). Remarks are added to Notes() as files are written. An
        /// unknown profile is an error.</summary>
        public void SetProfile(ProfileSettings settings)
        {
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                Check(Native.sinew_character_set_profile(Handle, settings.Options(pins, watch, Arrays())), handle_, "set_profile", watch);
                GC.KeepAlive(settings);
            }
        }

        /// <summary>Rotates and scales the whole character: mesh, joints, the file's own animations. Weights stay. A picture, a character
        /// without a mesh, and one to which a call has added clips or morph targets are an error.</summary>
        public void Transform(TransformSettings settings)
        {
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                Check(Native.sinew_character_transform(Handle, settings.Options(pins, watch, Arrays())), handle_, "transform", watch);
                GC.KeepAlive(settings);
            }
        }

        /// <summary>Finds faults of the skeleton, the weights, the matrices and the animations; changes nothing. A character without joints
        /// is an error.</summary>
        public CheckResult Check(CheckSettings settings = null)
        {
            settings = settings ?? new CheckSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                IntPtr result = CheckResult.Room(pins);
                Check(Native.sinew_character_check(Handle, settings.Options(pins, watch, Arrays()), result), handle_, "check", watch);
                GC.KeepAlive(settings);
                return CheckResult.Of(result, Arrays());
            }
        }

        /// <summary>Gives the mesh weights for its skeleton. A mesh without a skeleton is an error.</summary>
        public CharacterBindResult Bind(CharacterBindSettings settings = null)
        {
            settings = settings ?? new CharacterBindSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = CharacterBindResult.Room(pins);
                Check(Native.sinew_character_bind(Handle, settings.Options(pins, watch, Arrays()), result), handle_, "bind", watch);
                GC.KeepAlive(settings);
                return CharacterBindResult.Of(result, Arrays());
            }
        }

        /// <summary>Makes a skeleton for a mesh and binds the mesh to it. It replaces the character's skeleton.</summary>
        public CharacterRigResult Rig(CharacterRigSettings settings = null)
        {
            settings = settings ?? new CharacterRigSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = CharacterRigResult.Room(pins);
                Check(Native.sinew_character_rig(Handle, settings.Options(pins, watch, Arrays()), result), handle_, "rig", watch);
                GC.KeepAlive(settings);
                return CharacterRigResult.Of(result, Arrays());
            }
        }

        /// <summary>Finds the source joint of each target joint. Changes neither character; the result belongs to the target. The source is
        /// read as in Animate(): if its rest pose is not a standing pose, one is guessed from its frames. Animated nodes without skin are
        /// counted after its joints.</summary>
        public CharacterMap Map(Character source, CharacterMapSettings settings = null)
        {
            settings = settings ?? new CharacterMapSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                IntPtr result = CharacterMap.Room(pins);
                Check(Native.sinew_character_map(Handle, source.Handle, settings.Options(pins, watch, Arrays()), result), handle_, "map", watch);
                GC.KeepAlive(settings);
                GC.KeepAlive(source);
                return CharacterMap.Of(result, Arrays());
            }
        }

        /// <summary>Adds clips of another skeleton to a bound character, which are saved with it. A bare mesh is rigged first.</summary>
        public AnimateResult Animate(Character motion, AnimateSettings settings = null)
        {
            settings = settings ?? new AnimateSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = AnimateResult.Room(pins);
                Check(Native.sinew_character_animate(Handle, motion == null ? IntPtr.Zero : motion.Handle, settings.Options(pins, watch, Arrays()), result), handle_, "animate", watch);
                GC.KeepAlive(settings);
                GC.KeepAlive(motion);
                return AnimateResult.Of(result, Arrays());
            }
        }

        /// <summary>Makes a copy of a bound character in a pose, to be saved as .obj or viewed.</summary>
        public Character Pose(PoseSettings settings)
        {
            IntPtr posed;
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                Check(Native.sinew_character_pose(Handle, settings.Options(pins, watch, Arrays()), out posed), handle_, "pose", watch);
                GC.KeepAlive(settings);
                return new Character(posed);
            }
        }

        /// <summary>Transfers the weights of a bound character to the target's mesh. A target without a skeleton gets the source's,
        /// fitted.</summary>
        public CharacterTransferResult Transfer(Character source, CharacterTransferSettings settings = null)
        {
            settings = settings ?? new CharacterTransferSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = CharacterTransferResult.Room(pins);
                Check(Native.sinew_character_transfer(source.Handle, Handle, settings.Options(pins, watch, Arrays()), result), handle_, "transfer", watch);
                GC.KeepAlive(settings);
                GC.KeepAlive(source);
                return CharacterTransferResult.Of(result, Arrays());
            }
        }

        /// <summary>Finds hair, tails, ears and skirts that swing on a bound character, with colliders. The springs are saved with it
        /// (VRMC_springBone) and simulated by Animate().</summary>
        public SpringsResult Springs(SpringsSettings settings = null)
        {
            settings = settings ?? new SpringsSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(null);
                IntPtr result = SpringsResult.Room(pins);
                Check(Native.sinew_character_springs(Handle, settings.Options(pins, watch, Arrays()), result), handle_, "springs", watch);
                GC.KeepAlive(settings);
                return SpringsResult.Of(result, Arrays());
            }
        }

        /// <summary>Adds morph targets that correct bends, with their drivers, which are saved with the character.</summary>
        public BakeResult Bake(BakeSettings settings = null)
        {
            settings = settings ?? new BakeSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = BakeResult.Room(pins);
                Check(Native.sinew_character_bake(Handle, settings.Options(pins, watch, Arrays()), result), handle_, "bake", watch);
                GC.KeepAlive(settings);
                return BakeResult.Of(result, Arrays());
            }
        }
    }
}
