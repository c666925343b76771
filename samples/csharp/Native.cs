// SPDX-License-Identifier: MIT
// The C interface by P/Invoke, as it is. Generated from the C headers by scripts/declarations.py; a test compares.
// Every pointer is an IntPtr; structs have no managed members, so that a pinned box of one is what C reads. Arrays in structs have
// their elements as members, name_0 and so on.
#pragma warning disable 1591
using System;
using System.Runtime.InteropServices;

namespace Sinew
{
    public enum Kernel { Auto = 0, Ref = 1, Avx2 = 2, Avxvnni = 3, Vnni = 4, Simd128 = 5, Neon = 6, Dsp = 7 }
    public enum AnswerKind { Proposed = 0, Rigid = 1, Soft = 2, Hard = 3, Softer = 4, Host = 5 }
    public enum Up { Auto = 0, X = 1, Y = 2, Z = 3 }
    public enum WeightFormat { Unorm16 = 0, Unorm8 = 1, Float = 2 }
    public enum Method { Model = 0, Heat = 1, Distance = 2 }
    public enum RigidParts { Auto = 0, Always = 1, Never = 2 }
    public enum DeformMethod { Volume = 0, Xpbd = 1, DeltaMush = 2 }
    public enum TetWeights { Skin = 0, Distance = 1 }
    public enum MapMethod { Auto = 0, Sinew = 1, Branches = 2 }
    public enum MapReason { Found = 0, Pinned = 1, NoCounterpart = 2, FewerJoints = 3, End = 4, Outside = 5, Taken = 6, BesideLimits = 7 }
    public enum RetargetMethod { Auto = 0, Copy = 1, NodeOffsets = 2 }
    public enum SpotKind { None = 0, Stands = 1, Touches = 2, Inside = 3 }
    public enum JointClass { Pelvis = 0, Spine = 1, Neck = 2, Head = 3, Clavicle = 4, UpperArm = 5, Forearm = 6, Hand = 7, Hip = 8,
        Thigh = 9, Calf = 10, Foot = 11, Toe = 12, Tail = 13, Wing = 14, Ear = 15, Hair = 16, Other = 17, Thumb = 19, Index = 20,
        Middle = 21, Ring = 22, Pinky = 23, Eye = 24, Jaw = 25, Prop = 26 }
    public enum Mirror { Auto = 0, Always = 1, Never = 2 }
    public enum Front { Auto = 0, PlusZ = 1, MinusZ = 2, PlusX = 3, MinusX = 4, PlusY = 5, MinusY = 6 }
    public enum RigMethod { Votes = 0, Shape = 1, Regions = 2, Slots = 3 }
    public enum Category { Any = 0, Biped = 1, Quadruped = 2, Bird = 3, Fish = 4, Snake = 5, ManyLegged = 6, Vehicle = 7 }
    public enum JointRole { Deforms = 0, Root = 1, Control = 2, Slot = 3, End = 4, Twist = 5, Face = 6, Finger = 7, Helper = 8 }
    public enum Follows { Unknown = 0, Some = 1, None = 2 }
    public enum Naming { Sinew = 0, Mixamo = 1, Vrm = 2, Unreal = 3, Rigify = 4, Makehuman = 5 }
    public enum TransferMethod { Auto = 0, Nearest = 1, Biharmonic = 2, Rebind = 3 }
    public enum TransferReason { Asked = 0, Style = 1, Mismatch = 2, Plain = 3, Near = 4, Far = 5, NoMatch = 6, Kept = 7 }
    public enum BranchesFirst { Both = 0, Target = 1, Source = 2 }
    public enum BranchesCost { Mean = 0, Sum = 1 }
    public enum SimplifyLevel { High = 0, Low = 1 }
    public enum CheckSeverity { Note = 0, Warning = 1, Error = 2 }
    public enum JointsFrom { Auto = 0, Own = 1, Names = 2, All = 3 }
    public enum CharacterRigMethod { Auto = 0, Votes = 1, Shape = 2, Regions = 3, Slots = 4 }
    public enum CharacterDetail { Body = 0, Hands = 1, Full = 2 }
    public enum EditKind { Move = 0, Add = 1, Remove = 2, Parent = 3, Rename = 4, At = 5 }
    public enum AnimateMethod { Auto = 0, Copy = 1, Contacts = 2, ReferencePoints = 3, Stream = 4, NodeOffsets = 5 }
    public enum PoseDeform { Linear = 0, DualQuaternion = 1, Volume = 2, Xpbd = 3, DeltaMush = 4 }
    public enum BodyClass { Found = 0, Biped = 1, Quadruped = 2, Bird = 3, Fish = 4, Snake = 5, ManyLegged = 6, Other = 7 }
    public enum PictureView { Front = 0, FacesRight = 1, FacesLeft = 2 }

    /// <summary>The C interface as it is. Structs have the names and the layout of C.</summary>
    public static class Native
    {
        public const string Library = "sinew", CharacterLibrary = "sinew_character";
        public const uint VERSION_MAJOR = 0;
        public const uint VERSION_MINOR = 1;
        public const uint VERSION_PATCH = 0;
        public const uint MAX_INFLUENCES = 12;
        public const uint MAX_CANDIDATES = 16;
        public const uint MAX_JOINTS = 4096;
        public const uint MAX_VERTICES = 4000000;
        public const uint WORKSPACE_ALIGNMENT = 64;
        public const uint MAX_THREADS = 64;
        public const uint MAX_ALTERNATIVES = 8;
        public const uint MAX_QUESTIONS = 1024;
        public const uint NO_QUESTION = 4294967295;
        public const uint JOINT_NEVER = 1;
        public const uint JOINT_DEFORMS = 2;
        public const uint MAX_DEFORM_CELLS = 64;
        public const uint MAX_DEFORM_ROUNDS = 200;
        public const uint MAX_DEFORM_ENERGY = 1000000;
        public const uint MAX_MAP_LIMBS = 1024;
        public const uint MAX_FLOOR_SIDE = 4096;
        public const uint MAX_MOTION_LIMBS = 16;
        public const uint MAX_RIG_JOINTS = 192;
        public const uint JOINT_NAME_BYTES = 32;
        public const uint MAX_TRANSFER_PAIRS = 128;
        public const uint MAX_BIHARMONIC_VERTICES = 65536;
        public const uint NO_AREA = 4294967295;
        public const uint MAX_CHAIN_COLLIDERS = 65536;
        public const int ERROR_INPUT = -30;
        public const int ERROR_MEMORY = -31;
        public const uint MAX_LOD_LEVELS = 8;
        public const uint WITHOUT_TOES = 1;
        public const uint WITHOUT_ENDS = 2;
        public const uint WITHOUT_BIND = 4;
        public const uint WITHOUT_NAMES = 8;
        public const uint WITHOUT_RANGE = 16;
        public const uint WITHOUT_CONTACTS = 32;
        public const uint WITHOUT_TWIST_SPREAD = 64;
        public const uint WITHOUT_SMOOTHING = 128;
        public const uint WITHOUT_POSES = 256;
        public const uint WITHOUT_CLIPS = 512;
        public const uint LIMIT_HINGE = 1;
        public const uint LIMIT_BALL = 2;
        public const uint DETAIL_HANDS = 1;
        public const uint DETAIL_FACE = 2;
        public const uint DETAIL_PROPS = 4;
        public const uint COLLIDER_SPHERE = 1;
        public const uint COLLIDER_CAPSULE = 2;
        public const uint COLLIDER_INSIDE_SPHERE = 3;
        public const uint COLLIDER_INSIDE_CAPSULE = 4;
        public const uint COLLIDER_PLANE = 5;
        public const uint READ_MESH = 1;
        public const uint READ_SKELETON = 2;
        public const uint READ_MOTION = 4;
        public const uint READ_WHOLE = 8;
        public const uint WRITE_CHARACTER = 16;
        public const uint WRITE_MOTION = 32;
        public const uint WRITE_MESH = 64;
        public const uint READ_PICTURE = 256;
        public const int OK = 0;
        public const int ERROR_ARGUMENT = -1;
        public const int ERROR_WORKSPACE = -2;
        public const int ERROR_COUNT = -3;
        public const int ERROR_NOT_FINITE = -4;
        public const int ERROR_INDEX = -5;
        public const int ERROR_HIERARCHY = -6;
        public const int ERROR_NO_JOINT = -7;
        public const int ERROR_CANCELLED = -8;
        public const int ERROR_MODEL_MAGIC = -9;
        public const int ERROR_MODEL_VERSION = -10;
        public const int ERROR_MODEL_TRUNCATED = -11;
        public const int ERROR_MODEL_CHECKSUM = -12;
        public const int ERROR_MODEL_LAYOUT = -13;
        public const int ERROR_MODEL_OVERFLOW = -14;
        public const int ERROR_MODEL_ALIGNMENT = -15;
        public const int ERROR_RANGE = -16;
        public const int ERROR_KERNEL = -17;
        public const int ERROR_VERSION = -18;
        public const int ERROR_MODEL_TASK = -19;
        public const int ERROR_NOT_BUILT = -20;
        public const int ERROR_CHAIN = -21;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        public delegate int sinew_progress(IntPtr a, uint b);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        public delegate void sinew_parallel_for_body(IntPtr a, uint b);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        public delegate void sinew_parallel_for(IntPtr a, uint b, IntPtr c, IntPtr d);

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_mesh
        {
            public IntPtr positions;
            public uint vertex_count;
            public IntPtr face_offsets, face_vertices;
            public uint face_count, corner_count;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_model
        {
            public IntPtr bytes;
            public UIntPtr size_bytes;
            public IntPtr packed;
            public uint format_version, candidate_count, grid_size, feature_set, fixed_candidates, layer_count, parameter_count, checksum,
                confidence_offset, confidence_count, task, input_count, reserved_0, reserved_1, reserved_2, reserved_3, reserved_4,
                reserved_5, reserved_6, reserved_7, reserved_8, reserved_9, reserved_10, reserved_11, reserved_12, reserved_13;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_answer
        {
            public uint vertex;
            public ushort kind, joint;
            public uint alone;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_alternative
        {
            public ushort kind, joint;
            public uint change;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_question
        {
            public uint vertex, part_count, vertex_count;
            public ushort joint, share;
            public uint doubt, gain, alternative_count, reserved;
            public sinew_alternative alternatives_0, alternatives_1, alternatives_2, alternatives_3, alternatives_4, alternatives_5,
                alternatives_6, alternatives_7;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_skeleton
        {
            public uint struct_size, joint_count;
            public IntPtr positions, parents, flags, ends, names, rotations;
            public uint up, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_skin
        {
            public IntPtr joint_indices, weights;
            public uint influence_count, weight_format;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_bind_options
        {
            public uint struct_size, method, influence_count, weight_format, candidate_count, grid_size, surface_vertices, symmetric,
                rigid_parts, softness_percent, weights_in_place, kernel, thread_count, reserved;
            public IntPtr locked, hints, parallel_for, parallel_user, progress, progress_user, answers;
            public uint answer_count, question_count;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_bind_outputs
        {
            public uint struct_size, symmetric_vertices;
            public IntPtr joint_indices, weights, confidence;
            public UIntPtr used_bytes;
            public IntPtr questions, vertex_questions, vertex_parts;
            public uint questions_written, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_deform_options
        {
            public uint struct_size, method, cell_count, round_count, softness, without, thread_count, body_contact;
            public IntPtr parallel_for, parallel_user;
            public uint energy, tet_weights, as_drawn, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_deformer
        {
            public IntPtr memory;
            public UIntPtr pose_bytes;
            public uint vertex_count, joint_count, tetrahedron_count, node_count, split_cell_count, reserved_0, reserved_1, reserved_2,
                reserved_3, reserved_4, reserved_5, reserved_6;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_deform_outputs
        {
            public uint struct_size, corrected;
            public IntPtr positions;
            public uint active_tetrahedra, inverted_tetrahedra;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_joint_limit
        {
            public uint joint, kind;
            public float zero_0, zero_1, zero_2, zero_3, axis_0, axis_1, axis_2, side_0, side_1, side_2, least_0, least_1, least_2, most_0,
                most_1, most_2;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_map_pin
        {
            public uint target;
            public int source;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_map_options
        {
            public uint struct_size, method, pin_count, reserved;
            public IntPtr pins;
            public uint branches_first, branches_cost;
            public IntPtr target_areas, source_areas, source_animated;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_map_outputs
        {
            public uint struct_size, method;
            public IntPtr sources, confidence, reasons;
            public uint mapped, certainty;
            public UIntPtr used_bytes;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_retarget_options
        {
            public uint struct_size, method, in_place;
            public float scale;
            public uint translations;
            public float arm_spread;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_motion_body
        {
            public IntPtr positions, triangles;
            public sinew_skin skin;
            public uint vertex_count, triangle_count;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_floor
        {
            public IntPtr heights;
            public uint columns, rows;
            public float first_0, first_1, step;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_contact_options
        {
            public uint struct_size;
            public float fps;
            public IntPtr progress, progress_user, floor;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_motion_clip
        {
            public IntPtr source_rotations, source_translations, rotations, translations;
            public uint frame_count;
            public float ground;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_limb_quality
        {
            public uint joint, leg, frames, deep_frames, contact_frames, range_frames;
            public float depth, greatest_depth, error, greatest_error;
            public uint reserved_0, reserved_1;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_contact_spot
        {
            public uint kind;
            public float position_0, position_1, position_2, error;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_retarget_stream_options
        {
            public uint struct_size;
            public float fps, ground;
            public uint has_ground, without, reserved;
            public IntPtr floor, source;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_rig_options
        {
            public uint struct_size, up, mirror, spine_count, without, reserved, weights_in_place, kernel;
            public IntPtr progress, progress_user;
            public uint method, category;
            public IntPtr front_model;
            public uint front, axes_known;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_rig_outputs
        {
            public uint struct_size, joint_count;
            public IntPtr positions, parents, flags, joint_classes, partners, confidence, parent_confidence, names;
            public uint mirrored, facing;
            public float plane, spread;
            public UIntPtr used_bytes;
            public float front_0, front_1, front_2;
            public uint up;
            public float front_confidence, up_confidence;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_joint_verdicts
        {
            public uint struct_size, mirror_axis;
            public IntPtr classes, roles, sides, numbers, partners, images;
            public float mirror_planes_0, mirror_planes_1, mirror_planes_2;
            public uint mirrored;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_bound_character
        {
            public IntPtr mesh, skeleton;
            public sinew_skin skin;
            public IntPtr joint_map;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_vertex_pair
        {
            public uint source, target;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_transfer_options
        {
            public uint struct_size, method, influence_count, weight_format, garment, as_drawn, weights_in_place, kernel, thread_count,
                pair_count;
            public IntPtr locked, pairs, parallel_for, parallel_user, progress, progress_user;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_transfer_part
        {
            public uint vertex, vertex_count, reason, carried_q16, style_q16, mismatch_q16, distance_q16, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_transfer_outputs
        {
            public uint struct_size, part_capacity;
            public IntPtr joint_indices, weights, confidence, parts, vertex_parts;
            public uint part_count, bound_by, carried_q16, style_q16, mismatch_q16, reference_count;
            public UIntPtr used_bytes;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_reference_options
        {
            public uint struct_size, area_power, own_limb, legs;
            public float falloff, least_cosine;
            public IntPtr progress, progress_user;
            public uint head, torso, source_points, as_drawn;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_simplify_options
        {
            public uint struct_size, level, joint_count, as_drawn;
            public IntPtr centroids;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_spring_joint
        {
            public uint joint;
            public float hit_radius, stiffness, gravity_power, gravity_0, gravity_1, gravity_2, drag, limit;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_spring_chain
        {
            public uint first_joint, joint_count, first_collider, collider_count;
            public int center;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_spring_collider
        {
            public uint joint, shape;
            public float offset_0, offset_1, offset_2, tail_0, tail_1, tail_2, radius;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_spring_set
        {
            public uint struct_size, joint_count, chain_count, collider_count, chain_collider_count, reserved;
            public IntPtr joints, chains, colliders, chain_colliders, hinges;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_springs_options
        {
            public uint struct_size;
            public float steps, unit, teleport, gap;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_file
        {
            public IntPtr name, bytes;
            public UIntPtr size_bytes;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_profile_options
        {
            public uint struct_size, keep_axes;
            public IntPtr profile, license, title, authors;
            public uint author_count, controls;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_arrays
        {
            public uint struct_size, vertex_count, face_count, corner_count, joint_count, mesh_count, influence_count, reserved;
            public IntPtr name, positions, face_offsets, face_vertices, joint_positions, parents, joint_names, row_offsets, joint_indices,
                weights, confidence, vertex_meshes, mesh_names, mesh_joints, mesh_skinned;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_clip
        {
            public uint struct_size, frame_count, joint_count, reserved;
            public double frame_time;
            public IntPtr name, rotations, translations, joint_names, parents;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_transform_options
        {
            public uint struct_size, turn_count;
            public IntPtr turns;
            public double height;
            public uint floor, up;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_finding
        {
            public IntPtr rule, what, cure, pose, clip;
            public double seconds, value, bound;
            public IntPtr vertices;
            public uint vertex_count, severity;
            public int joint, other, mesh;
            public float position_0, position_1, position_2, radius;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_check_options
        {
            public uint struct_size, without, score, bound_count;
            public IntPtr bound_rules, bounds;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_check_result
        {
            public uint struct_size, finding_count, errors, warnings, notes, reserved;
            public IntPtr findings, line;
            public double score;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_models
        {
            public uint struct_size, reserved;
            public IntPtr bind;
            public UIntPtr bind_size;
            public IntPtr rig;
            public UIntPtr rig_size;
            public IntPtr hands;
            public UIntPtr hands_size;
            public IntPtr slots;
            public UIntPtr slots_size;
            public IntPtr front;
            public UIntPtr front_size;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_bind_options
        {
            public uint struct_size, thread_count;
            public IntPtr progress, progress_user, models;
            public uint method, influence_count, up, joints, rigid_parts, softness_percent, surface_vertices, keep_tips, bind_props, fit,
                symmetric, keep_confidence, question_count, answer_count;
            public IntPtr answers, joint_flags, locked, hinted, hints, like, style, to_pose;
            public uint cut, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_seam
        {
            public uint joints_0, joints_1;
            public float position_0, position_1, position_2, length;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_left_out
        {
            public IntPtr why;
            public uint joint, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_bind_result
        {
            public uint struct_size, symmetric_vertices, kept_meshes, folded_tips, left_out_count, question_count, answers_by_style,
                seam_count;
            public double seconds;
            public UIntPtr workspace_bytes;
            public IntPtr left_out, questions, vertex_questions, hash, seams;
            public uint doubled_vertices, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_skeleton_edit
        {
            public uint kind, reserved;
            public IntPtr joint, other;
            public float position_0, position_1, position_2;
            public uint reserved2;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_rig_options
        {
            public uint struct_size, thread_count;
            public IntPtr progress, progress_user, models, bind;
            public uint method, detail, mirror, up, front, category, spine_count, without, keep_lengths, gate, reserved, edit_count;
            public IntPtr edits, skeleton, skeleton_character;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_doubt
        {
            public IntPtr name;
            public float doubt;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_rig_result
        {
            public uint struct_size, mirrored, matched, joint_count;
            public float spread, reserved;
            public double scale, seconds, bind_seconds;
            public IntPtr ends, confidence, parent_confidence;
            public float front_0, front_1, front_2;
            public uint up;
            public float front_confidence, up_confidence;
            public uint seam_count;
            public IntPtr seams;
            public uint doubtful_count;
            public IntPtr doubtful;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_motion_source
        {
            public uint struct_size, up;
            public IntPtr file, layout, actor, clip;
            public double fps, from, to;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_map_options
        {
            public uint struct_size, method, without, target_up, guess_up, pin_count;
            public IntPtr pins, pins_file;
            public uint branches_first, branches_cost;
            public IntPtr source;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_map_result
        {
            public uint struct_size, method, joint_count, mapped;
            public float certainty, cover;
            public double seconds;
            public IntPtr sources, confidence, reasons, text;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_deformation
        {
            public uint struct_size, method, cells, rounds, body_contact, tet_weights, without, deform_as_drawn;
            public double stiffness;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_animate_options
        {
            public uint struct_size, thread_count;
            public IntPtr progress, progress_user, models, motion, deform, reference;
            public uint method, without, in_place, target_up, shapes, report, force, translations, depth, pin_count;
            public IntPtr pins, map, sources, limits;
            public uint springs;
            public float arm_spread;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_animate_result
        {
            public uint struct_size, clip_count, first_clip, mapped, rigged, shape_count;
            public float certainty;
            public uint limb_count;
            public IntPtr limbs_before, limbs_after, mapped_by, sources, reasons, source_ends, source_names;
            public uint source_count, spot_count;
            public IntPtr spot_kinds, spot_positions, spot_errors;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_pose_options
        {
            public uint struct_size, thread_count;
            public IntPtr deform, angles, rotations, matrices, clip;
            public double time;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_transfer_options
        {
            public uint struct_size, thread_count;
            public IntPtr progress, progress_user, models;
            public uint method, influence_count, target_up, source_up, garment, as_drawn, heat, pair_count;
            public IntPtr pairs, locked, map;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_transfer_result
        {
            public uint struct_size, mapped_joints, fitted, bound, bound_by, part_count;
            public double carried, style, mismatch, seconds;
            public IntPtr mapped_by, parts;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_simplify_options
        {
            public uint struct_size, low, joint_count, keep_count;
            public IntPtr keep;
            public uint as_drawn, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_lod_options
        {
            public uint struct_size, level_count;
            public double ratio;
            public uint fewer_joints, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_lod_level
        {
            public double rest_error, posed_error, mean_error;
            public uint triangle_count, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_springs_options
        {
            public uint struct_size, replace, take_count, drop_count, preset_count, value_count;
            public IntPtr take, drop, presets, values;
            public uint make, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_springs_result
        {
            public uint struct_size, chain_count, joint_count, collider_count, proposal_count, own_count;
            public IntPtr kept, certainties, names, kinds;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_bake_options
        {
            public uint struct_size, reserved;
            public IntPtr progress, progress_user, deform;
            public uint poses, shapes;
            public ulong seed;
            public double limit;
            public IntPtr clip;
            public double error;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_bake_result
        {
            public uint struct_size, shape_count, bend_count, moved_vertices, learnt_poses, held_out_poses;
            public double linear_error, baked_error, held_out_linear_error, held_out_baked_error;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_picture_options
        {
            public uint struct_size, body_class, figure, flat, pixels, line_count;
            public IntPtr mask, line_offsets, outline;
            public uint cut, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_character_picture_info
        {
            public uint struct_size, width, height, figure_count, figure, body_class, view;
            public float certainty;
            public uint line_count, reserved;
            public IntPtr line_offsets, outline;
        }

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_status_text(int status);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_kernel_name(uint kernel);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint sinew_kernel_select(uint kernel);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr sinew_struct_size(IntPtr name);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_model_open(IntPtr bytes, UIntPtr size_bytes, IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_model_pack_workspace_size(IntPtr model, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_model_pack(IntPtr model, IntPtr memory, UIntPtr memory_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_skin_linear(IntPtr positions, uint vertex_count, IntPtr skin, IntPtr palette, uint joint_count,
            IntPtr @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_skin_dual_quaternion(IntPtr positions, uint vertex_count, IntPtr skin, IntPtr palette,
            uint joint_count, IntPtr @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_bind_workspace_size(IntPtr model, uint vertex_count, uint face_count, uint corner_count,
            uint joint_count, IntPtr options, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_bind(IntPtr model, IntPtr mesh, IntPtr skeleton, IntPtr options, IntPtr workspace,
            UIntPtr workspace_bytes, IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_deform_create_workspace_size(IntPtr mesh, uint joint_count, uint influence_count, IntPtr options,
            out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_deform_create(IntPtr mesh, IntPtr skeleton, IntPtr skin, IntPtr options, IntPtr memory,
            UIntPtr memory_bytes, IntPtr deformer);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_deform_pose(IntPtr deformer, IntPtr palette, IntPtr workspace, UIntPtr workspace_bytes,
            IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_keep_joint_limits(IntPtr limits, uint limit_count, uint joint_count, uint frame_count,
            IntPtr rotations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_map_workspace_size(uint target_count, uint source_count, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_map(IntPtr target, IntPtr source, IntPtr options, IntPtr workspace, UIntPtr workspace_bytes,
            IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_create_workspace_size(uint source_joints, uint target_joints, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_create(IntPtr source, IntPtr target, IntPtr map, IntPtr target_classes, IntPtr options,
            IntPtr memory, UIntPtr memory_bytes, out IntPtr plan);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_height(IntPtr plan, IntPtr rotations, IntPtr translations, IntPtr height);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_ground(IntPtr plan, IntPtr heights, UIntPtr count, IntPtr ground);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_frame(IntPtr plan, IntPtr rotations, IntPtr translations, float ground,
            IntPtr out_rotations, IntPtr out_translations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_contacts_workspace_size(IntPtr plan, IntPtr target, uint frame_count,
            out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_contacts(IntPtr plan, IntPtr source, IntPtr target, IntPtr clip, IntPtr options,
            IntPtr workspace, UIntPtr workspace_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_keep_range(IntPtr plan, IntPtr target, IntPtr clip, IntPtr workspace,
            UIntPtr workspace_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_measure(IntPtr plan, IntPtr source, IntPtr target, IntPtr clip, IntPtr options,
            IntPtr workspace, UIntPtr workspace_bytes, IntPtr limbs, IntPtr limb_count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_spots(IntPtr plan, IntPtr source, IntPtr target, IntPtr clip, IntPtr options,
            IntPtr workspace, UIntPtr workspace_bytes, IntPtr limbs, IntPtr limb_count, IntPtr spots);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_stream_workspace_size(uint source_joints, uint target_joints, uint body_vertices,
            uint body_triangles, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_stream_create(IntPtr source, IntPtr target, IntPtr map, IntPtr target_classes,
            IntPtr plan_options, IntPtr body, IntPtr options, IntPtr memory, UIntPtr memory_bytes, out IntPtr stream);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_stream_frame(IntPtr stream, IntPtr rotations, IntPtr translations, IntPtr out_rotations,
            IntPtr out_translations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_stream_restart(IntPtr stream);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_model_open(IntPtr bytes, UIntPtr size_bytes, IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_workspace_size(IntPtr model, uint vertex_count, uint face_count, uint corner_count,
            IntPtr options, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig(IntPtr model, IntPtr mesh, IntPtr options, IntPtr workspace, UIntPtr workspace_bytes,
            IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_details_workspace_size(IntPtr hands_model, uint vertex_count, uint face_count, uint corner_count,
            uint wanted, IntPtr options, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_details(IntPtr hands_model, IntPtr mesh, uint wanted, IntPtr options, IntPtr workspace,
            UIntPtr workspace_bytes, IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_joint_classes_workspace_size(uint joint_count, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_joint_classes(IntPtr skeleton, IntPtr follows, IntPtr workspace, UIntPtr workspace_bytes,
            IntPtr verdicts);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_limb_classes_workspace_size(uint target_count, uint source_count, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_limb_classes(IntPtr target, IntPtr source, IntPtr sources, IntPtr workspace, UIntPtr workspace_bytes,
            IntPtr classes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_joint_side(IntPtr name);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_joint_other_side(IntPtr name, IntPtr other, UIntPtr room);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_naming_text(uint naming);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_joint_standard_name(uint naming, uint joint_class, int side, uint index, IntPtr name);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_transfer_workspace_size(IntPtr model, IntPtr source, IntPtr target, IntPtr skeleton, IntPtr options,
            out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_transfer(IntPtr model, IntPtr source, IntPtr target, IntPtr skeleton, IntPtr options,
            IntPtr workspace, UIntPtr workspace_bytes, IntPtr outputs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_reference_points_workspace_size(IntPtr plan, IntPtr target, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_retarget_reference_points(IntPtr plan, IntPtr source, IntPtr target, IntPtr clip, IntPtr options,
            IntPtr workspace, UIntPtr workspace_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_corresponding_points_workspace_size(IntPtr source, IntPtr target, IntPtr skeleton,
            out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_corresponding_points(IntPtr source, IntPtr target, IntPtr skeleton, IntPtr workspace,
            UIntPtr workspace_bytes, IntPtr vertices, IntPtr shares);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_simplify_workspace_size(uint joint_count, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_simplify(IntPtr skeleton, IntPtr areas, IntPtr keep, IntPtr options, IntPtr workspace,
            UIntPtr workspace_bytes, IntPtr into);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_springs_workspace_size(uint skeleton_joints, uint joint_count, uint chain_count, uint collider_count,
            uint chain_collider_count, out UIntPtr size_bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_springs_create(IntPtr skeleton, IntPtr set, IntPtr options, IntPtr memory, UIntPtr memory_bytes,
            IntPtr springs);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_springs_frame(IntPtr springs, float seconds, IntPtr rotations, IntPtr translations,
            IntPtr out_rotations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_springs_restart(IntPtr springs);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_error(IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr sinew_character_struct_size(IntPtr name);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_extensions(uint uses);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_open(IntPtr path, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_open_files(IntPtr files, uint file_count, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_open_keypoints(IntPtr layout, IntPtr keypoints, uint keypoint_count, uint frame_count,
            out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_keypoints_frame(IntPtr character, IntPtr keypoints, uint keypoint_count, IntPtr rotations,
            IntPtr translations);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_create(IntPtr mesh, IntPtr skeleton, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_copy(IntPtr from, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void sinew_character_close(IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_save(IntPtr character, IntPtr path);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_write(IntPtr character, IntPtr name, IntPtr files, IntPtr file_count);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_set_profile(IntPtr character, IntPtr options);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_profiles();

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_controls(IntPtr character, IntPtr text);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_view(IntPtr character, IntPtr arrays);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_skin(IntPtr character, uint influence_count, IntPtr joint_indices, IntPtr weights);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_joint_classes(IntPtr character, IntPtr classes);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_notes(IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_set_skeleton(IntPtr character, IntPtr skeleton);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_take_skeleton(IntPtr character, IntPtr other, uint with_weights);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_set_weights(IntPtr character, IntPtr row_offsets, IntPtr joint_indices, IntPtr weights);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_clip_count(IntPtr character, IntPtr count);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_get_clip(IntPtr character, uint index, IntPtr clip);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_add_clip(IntPtr character, IntPtr clip);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_transform(IntPtr character, IntPtr options);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_check(IntPtr character, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_check_rules();

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_bind(IntPtr character, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_rig(IntPtr character, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_character_templates();

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_map(IntPtr target, IntPtr source, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_animate(IntPtr character, IntPtr motion, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_pose(IntPtr character, IntPtr options, out IntPtr posed);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_transfer(IntPtr source, IntPtr target, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_simplify(IntPtr character, IntPtr options, IntPtr into);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_lod(IntPtr character, IntPtr options, IntPtr levels, IntPtr figures);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_springs(IntPtr character, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_springs_frame(IntPtr character, float seconds, IntPtr rotations, IntPtr translations,
            IntPtr out_rotations);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_springs_restart(IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_bake(IntPtr character, IntPtr options, IntPtr result);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_open_picture(IntPtr path, IntPtr options, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_open_picture_files(IntPtr files, uint file_count, IntPtr options, out IntPtr character);

        [DllImport(CharacterLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_character_picture(IntPtr character, IntPtr info);

        internal static readonly StructSize[] Structs =
        {
            new StructSize("sinew_mesh", Marshal.SizeOf(typeof(sinew_mesh)), false),
            new StructSize("sinew_model", Marshal.SizeOf(typeof(sinew_model)), false),
            new StructSize("sinew_answer", Marshal.SizeOf(typeof(sinew_answer)), false),
            new StructSize("sinew_alternative", Marshal.SizeOf(typeof(sinew_alternative)), false),
            new StructSize("sinew_question", Marshal.SizeOf(typeof(sinew_question)), false),
            new StructSize("sinew_skeleton", Marshal.SizeOf(typeof(sinew_skeleton)), true),
            new StructSize("sinew_skin", Marshal.SizeOf(typeof(sinew_skin)), false),
            new StructSize("sinew_bind_options", Marshal.SizeOf(typeof(sinew_bind_options)), true),
            new StructSize("sinew_bind_outputs", Marshal.SizeOf(typeof(sinew_bind_outputs)), true),
            new StructSize("sinew_deform_options", Marshal.SizeOf(typeof(sinew_deform_options)), true),
            new StructSize("sinew_deformer", Marshal.SizeOf(typeof(sinew_deformer)), false),
            new StructSize("sinew_deform_outputs", Marshal.SizeOf(typeof(sinew_deform_outputs)), true),
            new StructSize("sinew_joint_limit", Marshal.SizeOf(typeof(sinew_joint_limit)), false),
            new StructSize("sinew_map_pin", Marshal.SizeOf(typeof(sinew_map_pin)), false),
            new StructSize("sinew_map_options", Marshal.SizeOf(typeof(sinew_map_options)), true),
            new StructSize("sinew_map_outputs", Marshal.SizeOf(typeof(sinew_map_outputs)), true),
            new StructSize("sinew_retarget_options", Marshal.SizeOf(typeof(sinew_retarget_options)), true),
            new StructSize("sinew_motion_body", Marshal.SizeOf(typeof(sinew_motion_body)), false),
            new StructSize("sinew_floor", Marshal.SizeOf(typeof(sinew_floor)), false),
            new StructSize("sinew_contact_options", Marshal.SizeOf(typeof(sinew_contact_options)), true),
            new StructSize("sinew_motion_clip", Marshal.SizeOf(typeof(sinew_motion_clip)), false),
            new StructSize("sinew_limb_quality", Marshal.SizeOf(typeof(sinew_limb_quality)), false),
            new StructSize("sinew_contact_spot", Marshal.SizeOf(typeof(sinew_contact_spot)), false),
            new StructSize("sinew_retarget_stream_options", Marshal.SizeOf(typeof(sinew_retarget_stream_options)), true),
            new StructSize("sinew_rig_options", Marshal.SizeOf(typeof(sinew_rig_options)), true),
            new StructSize("sinew_rig_outputs", Marshal.SizeOf(typeof(sinew_rig_outputs)), true),
            new StructSize("sinew_joint_verdicts", Marshal.SizeOf(typeof(sinew_joint_verdicts)), true),
            new StructSize("sinew_bound_character", Marshal.SizeOf(typeof(sinew_bound_character)), false),
            new StructSize("sinew_vertex_pair", Marshal.SizeOf(typeof(sinew_vertex_pair)), false),
            new StructSize("sinew_transfer_options", Marshal.SizeOf(typeof(sinew_transfer_options)), true),
            new StructSize("sinew_transfer_part", Marshal.SizeOf(typeof(sinew_transfer_part)), false),
            new StructSize("sinew_transfer_outputs", Marshal.SizeOf(typeof(sinew_transfer_outputs)), true),
            new StructSize("sinew_reference_options", Marshal.SizeOf(typeof(sinew_reference_options)), true),
            new StructSize("sinew_simplify_options", Marshal.SizeOf(typeof(sinew_simplify_options)), true),
            new StructSize("sinew_spring_joint", Marshal.SizeOf(typeof(sinew_spring_joint)), false),
            new StructSize("sinew_spring_chain", Marshal.SizeOf(typeof(sinew_spring_chain)), false),
            new StructSize("sinew_spring_collider", Marshal.SizeOf(typeof(sinew_spring_collider)), false),
            new StructSize("sinew_spring_set", Marshal.SizeOf(typeof(sinew_spring_set)), true),
            new StructSize("sinew_springs_options", Marshal.SizeOf(typeof(sinew_springs_options)), true),
        };

        internal static readonly StructSize[] CharacterStructs =
        {
            new StructSize("sinew_file", Marshal.SizeOf(typeof(sinew_file)), false),
            new StructSize("sinew_character_profile_options", Marshal.SizeOf(typeof(sinew_character_profile_options)), true),
            new StructSize("sinew_character_arrays", Marshal.SizeOf(typeof(sinew_character_arrays)), true),
            new StructSize("sinew_character_clip", Marshal.SizeOf(typeof(sinew_character_clip)), true),
            new StructSize("sinew_character_transform_options", Marshal.SizeOf(typeof(sinew_character_transform_options)), true),
            new StructSize("sinew_character_finding", Marshal.SizeOf(typeof(sinew_character_finding)), false),
            new StructSize("sinew_character_check_options", Marshal.SizeOf(typeof(sinew_character_check_options)), true),
            new StructSize("sinew_character_check_result", Marshal.SizeOf(typeof(sinew_character_check_result)), true),
            new StructSize("sinew_character_models", Marshal.SizeOf(typeof(sinew_character_models)), true),
            new StructSize("sinew_character_bind_options", Marshal.SizeOf(typeof(sinew_character_bind_options)), true),
            new StructSize("sinew_character_seam", Marshal.SizeOf(typeof(sinew_character_seam)), false),
            new StructSize("sinew_character_left_out", Marshal.SizeOf(typeof(sinew_character_left_out)), false),
            new StructSize("sinew_character_bind_result", Marshal.SizeOf(typeof(sinew_character_bind_result)), true),
            new StructSize("sinew_skeleton_edit", Marshal.SizeOf(typeof(sinew_skeleton_edit)), false),
            new StructSize("sinew_character_rig_options", Marshal.SizeOf(typeof(sinew_character_rig_options)), true),
            new StructSize("sinew_character_doubt", Marshal.SizeOf(typeof(sinew_character_doubt)), false),
            new StructSize("sinew_character_rig_result", Marshal.SizeOf(typeof(sinew_character_rig_result)), true),
            new StructSize("sinew_motion_source", Marshal.SizeOf(typeof(sinew_motion_source)), true),
            new StructSize("sinew_character_map_options", Marshal.SizeOf(typeof(sinew_character_map_options)), true),
            new StructSize("sinew_character_map_result", Marshal.SizeOf(typeof(sinew_character_map_result)), true),
            new StructSize("sinew_character_deformation", Marshal.SizeOf(typeof(sinew_character_deformation)), true),
            new StructSize("sinew_character_animate_options", Marshal.SizeOf(typeof(sinew_character_animate_options)), true),
            new StructSize("sinew_character_animate_result", Marshal.SizeOf(typeof(sinew_character_animate_result)), true),
            new StructSize("sinew_character_pose_options", Marshal.SizeOf(typeof(sinew_character_pose_options)), true),
            new StructSize("sinew_character_transfer_options", Marshal.SizeOf(typeof(sinew_character_transfer_options)), true),
            new StructSize("sinew_character_transfer_result", Marshal.SizeOf(typeof(sinew_character_transfer_result)), true),
            new StructSize("sinew_character_simplify_options", Marshal.SizeOf(typeof(sinew_character_simplify_options)), true),
            new StructSize("sinew_character_lod_options", Marshal.SizeOf(typeof(sinew_character_lod_options)), true),
            new StructSize("sinew_character_lod_level", Marshal.SizeOf(typeof(sinew_character_lod_level)), false),
            new StructSize("sinew_character_springs_options", Marshal.SizeOf(typeof(sinew_character_springs_options)), true),
            new StructSize("sinew_character_springs_result", Marshal.SizeOf(typeof(sinew_character_springs_result)), true),
            new StructSize("sinew_character_bake_options", Marshal.SizeOf(typeof(sinew_character_bake_options)), true),
            new StructSize("sinew_character_bake_result", Marshal.SizeOf(typeof(sinew_character_bake_result)), true),
            new StructSize("sinew_character_picture_options", Marshal.SizeOf(typeof(sinew_character_picture_options)), true),
            new StructSize("sinew_character_picture_info", Marshal.SizeOf(typeof(sinew_character_picture_info)), true),
        };
    }

    /// <summary>What is compared with the library when it is loaded.</summary>
    struct StructSize
    {
        public readonly string Name;
        public readonly int Bytes;
        public readonly bool Grows;

        public StructSize(string name, int bytes, bool grows)
        {
            Name = name;
            Bytes = bytes;
            Grows = grows;
        }
    }
}
