// SPDX-License-Identifier: MIT
// Characters of files for C#: what the command `sinew` does with one, with the same defaults and the same bytes in what is saved, over
// libsinew_character. sinew/character.h is the reference.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Sinew
{
    /// <summary>What jobs share.</summary>
    public class JobSettings
    {
        /// <summary>1 to 64; the bytes are the same for any number.</summary>
        public int Threads = 1;
        /// <summary>Gets a share of work done, 0 to 1, on the calling thread. Returns true to stop, as in C.</summary>
        public Func<float, bool> Progress;
    }

    /// <summary>`sinew bind`. What is not set is the command's default.</summary>
    public sealed class CharacterBindSettings : JobSettings
    {
        public Method Method;
        public JointsFrom Joints;
        public RigidParts RigidParts;
        public int Influences, SoftnessPercent, SurfaceVertices;
        public bool ZUp, KeepTips, BindProps, Fit, Symmetric, KeepConfidence;
        /// <summary>[joints] Native.JOINT_NEVER, JOINT_DEFORMS; or null.</summary>
        public byte[] JointFlags;
        /// <summary>[vertices] not 0: keeps its weights; or null. Hinted: and they steer the vertices around it.</summary>
        public byte[] Locked, Hinted;
        /// <summary>A bound character whose weights are carried over where they fit; or null.</summary>
        public Character Like;
        /// <summary>A file of `sinew bind --save-style`; or null.</summary>
        public string Style;
        /// <summary>Open what has grown together: vertices along it are doubled, the new ones come last.</summary>
        public bool Cut;
        /// <summary>The rest pose that the character is put into, cut before: "t", "a", or a file whose skeleton stands so; or null.</summary>
        public string ToPose;
        /// <summary>Bytes of a .sinew file in place of the bundled model; or null.</summary>
        public byte[] Model;
    }

    /// <summary>`sinew rig`.</summary>
    public sealed class CharacterRigSettings : JobSettings
    {
        public CharacterRigMethod Method;
        public CharacterDetail Detail;
        public Mirror Mirror;
        public int SpineCount, Influences;
        public bool ZUp, NoToes, NoEnds, NoBind, KeepLengths;
        /// <summary>Measure the result: what fails is a note that begins with "gate: ".</summary>
        public bool Gate;
        /// <summary>Open what has grown together; ToPose does so, too.</summary>
        public bool Cut;
        /// <summary>The rest pose that the character is put into: "t", "a", or a file whose skeleton stands so; or null.</summary>
        public string ToPose;
        /// <summary>A file or template:NAME that is put into the mesh; or null.</summary>
        public string Skeleton;
        /// <summary>What kind of body it is, where the model takes it for another.</summary>
        public Category Category;
        /// <summary>Bytes of .sinew files in place of the bundled models; or null. Model: of the method.</summary>
        public byte[] Model, HandsModel;
    }

    /// <summary>`sinew map`.</summary>
    public sealed class CharacterMapSettings
    {
        public MapMethod Method;
        public bool NoNames, NoEnds, GuessUp;
        public Up TargetUp, SourceUp;
        /// <summary>Of MapMethod.Branches: whose branches choose, and what two branches cost.</summary>
        public BranchesFirst First;
        public BranchesCost Cost;
        /// <summary>A map whose lines are kept; or null.</summary>
        public string PinsFile;
    }

    /// <summary>Which joint of the source stands for which of the target.</summary>
    public sealed class CharacterMap
    {
        /// <summary>[joints of the target] joint of the source, or -1.</summary>
        public int[] Sources;
        public float[] Confidence;
        public MapReason[] Reasons;
        public float Certainty;
        /// <summary>The map as `sinew map -o` writes it.</summary>
        public string Text;
    }

    /// <summary>`sinew animate`.</summary>
    public sealed class AnimateSettings : JobSettings
    {
        public AnimateMethod Method;
        public bool InPlace, NoRange, BodyContact, Force, Translations;
        public Up TargetUp, MotionUp;
        /// <summary>Volume and above: every frame is corrected by morph targets.</summary>
        public PoseDeform Deform;
        /// <summary>Of PoseDeform.Xpbd: of its springs, 0 = 0.2; where its tetrahedra have weights from; without smoothing.</summary>
        public double Stiffness;
        public TetWeights TetWeights;
        public bool NoSmoothing;
        public int Shapes;
        public double Fps, From, To;
        /// <summary>By name or number; null: all.</summary>
        public string Clip;
        /// <summary>A map file; null: found.</summary>
        public string Map;
        /// <summary>Which joints places alone are (.npy, .npz): "smpl24", "humanml3d22", "coco17", "mediapipe33"; null: guessed by their count.</summary>
        public string Layout;
        /// <summary>Of a file of several people, by the root's name or number; null: the first where all are alike.</summary>
        public string Actor;
        /// <summary>What joints stay within: a .urdf, a file of limits, or "human"; null: nothing but the natural range.</summary>
        public string Limits;
        /// <summary>Bones of a picture's character leave its plane as the motion's do.</summary>
        public bool Depth;
    }

    /// <summary>How a drawing or a photograph of a character is opened.</summary>
    public sealed class PictureSettings
    {
        /// <summary>What kind of body it is; Found: as the model says.</summary>
        public BodyClass BodyClass;
        /// <summary>Of several figures, from left to right, from 1 on; 0: the largest.</summary>
        public int Figure;
        /// <summary>Flat: a card. Pixels: places are the picture's, x right, y up from the bottom edge. Cut: opened along lines that are drawn into it
        /// from its outline, as a guess.</summary>
        public bool Flat, Pixels, Cut;
        /// <summary>A picture that is bright where the figure is, a path or the name of a file beside; null: found.</summary>
        public string Mask;
        /// <summary>Closed lines round the figure, x and y by turns, as PictureInfo has them; null: found.</summary>
        public float[][] Outline;
    }

    /// <summary>What was found in a picture.</summary>
    public sealed class PictureInfo
    {
        public int Width, Height, FigureCount, Figure;
        /// <summary>Found, and 0, before Rig(). Certainty: 0 to 1, of class and view together.</summary>
        public BodyClass BodyClass;
        public PictureView View;
        public float Certainty;
        /// <summary>Closed lines of the figure, x and y by turns, in pixels, x right, y down from the top left corner; the border first.</summary>
        public float[][] Outline;
    }

    /// <summary>`sinew pose`: one of four says the pose.</summary>
    public sealed class PoseSettings
    {
        public int Threads = 1;
        public PoseDeform Deform;
        public bool BodyContact;
        /// <summary>Of PoseDeform.Xpbd: of its springs, 0 = 0.2; where its tetrahedra have weights from; without smoothing.</summary>
        public double Stiffness;
        public TetWeights TetWeights;
        public bool NoSmoothing;
        /// <summary>[joints x 3] turned about x, then y, then z, degrees.</summary>
        public double[] Angles;
        /// <summary>[joints x 4] x y z w, local, against the rest pose.</summary>
        public double[] Rotations;
        /// <summary>[joints x 12] rows of 3x4, rest to posed space.</summary>
        public double[] Matrices;
        public string Clip;
        public double Time;
    }

    /// <summary>`sinew transfer`.</summary>
    public sealed class CharacterTransferSettings : JobSettings
    {
        public TransferMethod Method;
        public int Influences;
        public bool ZUp, SourceZUp, Garment, Heat;
        public byte[] Locked;
        public string Map;
    }

    /// <summary>`sinew bake`.</summary>
    public sealed class BakeSettings
    {
        public PoseDeform Deform;
        /// <summary>Of PoseDeform.Xpbd: of its springs, 0 = 0.2; where its tetrahedra have weights from; without smoothing.</summary>
        public double Stiffness;
        public TetWeights TetWeights;
        public bool NoSmoothing;
        public int Poses, Shapes;
        public ulong Seed;
        public double Limit;
        public string Clip;
        public Func<float, bool> Progress;
    }

    /// <summary>A file in memory.</summary>
    public sealed class NamedFile
    {
        public string Name;
        public byte[] Bytes;
    }

    /// <summary>A clip of a character: local poses of its skeleton, whose axes at rest are the world's.</summary>
    public sealed class MotionClip
    {
        public string Name = "motion";
        public double FrameTime = 1.0 / 30;
        public int FrameCount, JointCount;
        /// <summary>[frames x joints x 4] x y z w.</summary>
        public double[] Rotations;
        /// <summary>[frames x joints x 3] from the parent.</summary>
        public double[] Translations;
    }

    /// <summary>A character. Any number may be worked on at the same time, each by one thread at a time. What failed changed nothing.</summary>
    public sealed partial class Character : IDisposable
    {
        IntPtr handle_;
        static bool checked_;

        Character(IntPtr handle) { handle_ = handle; }
        ~Character() { Release(); }

        public void Dispose()
        {
            Release();
            GC.SuppressFinalize(this);
        }

        void Release()
        {
            if (handle_ != IntPtr.Zero) Native.sinew_character_close(handle_);
            handle_ = IntPtr.Zero;
        }

        IntPtr Handle
        {
            get
            {
                if (handle_ == IntPtr.Zero) throw new ObjectDisposedException(nameof(Character));
                return handle_;
            }
        }

        static void CheckLibrary()
        {
            if (checked_) return;
            Engine.CompareSizes(Native.CharacterLibrary, Native.CharacterStructs, name => (long)Native.sinew_character_struct_size(name));
            checked_ = true;
        }

        // ---- files

        /// <summary>Opens a file of any format that the command reads.</summary>
        /// <exception cref="SinewException">It cannot be read; the message names it.</exception>
        public static Character Open(string path)
        {
            CheckLibrary();
            IntPtr handle;
            using (var pins = new Pins()) Check(Native.sinew_character_open(pins.Of(path), out handle), IntPtr.Zero, "open");
            return new Character(handle);
        }

        /// <summary>The same from memory: the first file is opened, the others lie beside it.</summary>
        public static Character Open(params NamedFile[] files)
        {
            CheckLibrary();
            IntPtr handle;
            using (var pins = new Pins())
            {
                var list = new Native.sinew_file[files.Length];
                for (int i = 0; i < files.Length; ++i)
                    list[i] = new Native.sinew_file
                    {
                        name = pins.Of(files[i].Name), bytes = pins.Of(files[i].Bytes), size_bytes = (UIntPtr)files[i].Bytes.Length
                    };
                Check(Native.sinew_character_open_files(pins.Of(list), (uint)files.Length, out handle), IntPtr.Zero, "open");
            }
            return new Character(handle);
        }

        /// <summary>Opens a drawing or a photograph of a character, PNG or JPEG. Rig() gives it a skeleton in the picture's plane; Animate() does so
        /// where it has none, and plays a clip of its class where no motion is given.</summary>
        public static Character OpenPicture(string path, PictureSettings settings = null)
        {
            CheckLibrary();
            IntPtr handle;
            using (var pins = new Pins())
                Check(Native.sinew_character_open_picture(pins.Of(path), Options(settings, pins), out handle), IntPtr.Zero, "open");
            return new Character(handle);
        }

        static IntPtr Options(PictureSettings settings, Pins pins)
        {
            settings = settings ?? new PictureSettings();
            var places = new List<float>();
            var offsets = new List<uint> { 0 };
            foreach (float[] line in settings.Outline ?? new float[0][])
            {
                places.AddRange(line);
                offsets.Add((uint)places.Count / 2);
            }
            bool drawn = offsets.Count > 1;
            return pins.Of(new Native.sinew_character_picture_options
            {
                struct_size = Size<Native.sinew_character_picture_options>(), body_class = (uint)settings.BodyClass, figure = (uint)settings.Figure,
                flat = One(settings.Flat), cut = One(settings.Cut), pixels = One(settings.Pixels), mask = pins.Of(settings.Mask), line_count = (uint)offsets.Count - 1,
                line_offsets = drawn ? pins.Of(offsets.ToArray()) : IntPtr.Zero, outline = drawn ? pins.Of(places.ToArray()) : IntPtr.Zero
            });
        }

        /// <summary>What was found in the picture that it is of.</summary>
        /// <exception cref="SinewException">It is of none.</exception>
        public PictureInfo Picture
        {
            get
            {
                using (var pins = new Pins())
                {
                    IntPtr at = pins.Of(new Native.sinew_character_picture_info { struct_size = Size<Native.sinew_character_picture_info>() });
                    Check(Native.sinew_character_picture(Handle, at), handle_, "picture");
                    var info = Read<Native.sinew_character_picture_info>(at);
                    var offsets = Ints(info.line_offsets, info.line_count + 1);
                    var places = Floats(info.outline, 2 * (uint)offsets[info.line_count]);
                    var outline = new float[info.line_count][];
                    for (int l = 0; l < outline.Length; ++l)
                    {
                        outline[l] = new float[2 * (offsets[l + 1] - offsets[l])];
                        Array.Copy(places, 2 * offsets[l], outline[l], 0, outline[l].Length);
                    }
                    return new PictureInfo
                    {
                        Width = (int)info.width, Height = (int)info.height, FigureCount = (int)info.figure_count, Figure = (int)info.figure,
                        BodyClass = (BodyClass)info.body_class, View = (PictureView)info.view, Certainty = info.certainty, Outline = outline
                    };
                }
            }
        }

        /// <summary>Of arrays, which are copied. Mesh or skeleton may be null.</summary>
        public static Character Create(Mesh mesh, Skeleton skeleton)
        {
            CheckLibrary();
            if (mesh != null) mesh.Check();
            if (skeleton != null) skeleton.Check();
            IntPtr handle;
            using (var pins = new Pins())
                Check(Native.sinew_character_create(mesh == null ? IntPtr.Zero : pins.Of(Engine.View(mesh, pins)),
                    skeleton == null ? IntPtr.Zero : pins.Of(Engine.View(skeleton, pins)), out handle), IntPtr.Zero, "create");
            return new Character(handle);
        }

        public Character Copy()
        {
            IntPtr handle;
            Check(Native.sinew_character_copy(Handle, out handle), handle_, "copy");
            return new Character(handle);
        }

        /// <summary>Saves by the extension: .glb, .gltf, .vrm, .fbx, .obj, .rig.txt, .bvh.</summary>
        public void Save(string path)
        {
            using (var pins = new Pins()) Check(Native.sinew_character_save(Handle, pins.Of(path)), handle_, "save");
        }

        /// <summary>What Save(name) would write, the file itself first.</summary>
        public NamedFile[] Write(string name)
        {
            using (var pins = new Pins())
            {
                var files = new IntPtr[1];
                var count = new uint[1];
                Check(Native.sinew_character_write(Handle, pins.Of(name), pins.Of(files), pins.Of(count)), handle_, "write");
                var result = new NamedFile[count[0]];
                int size = Marshal.SizeOf(typeof(Native.sinew_file));
                for (int i = 0; i < result.Length; ++i)
                {
                    var file = Read<Native.sinew_file>(new IntPtr(files[0].ToInt64() + i * size));
                    result[i] = new NamedFile { Name = Text(file.name), Bytes = new byte[(int)file.size_bytes] };
                    Marshal.Copy(file.bytes, result[i].Bytes, 0, result[i].Bytes.Length);
                }
                return result;
            }
        }

        /// <summary>Remarks of the reader and of the jobs, a line each.</summary>
        public string Notes { get { return Text(Native.sinew_character_notes(Handle)); } }

        // ---- arrays

        Native.sinew_character_arrays Arrays()
        {
            var arrays = new Native.sinew_character_arrays { struct_size = Size<Native.sinew_character_arrays>() };
            using (var pins = new Pins())
            {
                IntPtr at = pins.Of(arrays);
                Check(Native.sinew_character_view(Handle, at), handle_, "view");
                return Read<Native.sinew_character_arrays>(at);
            }
        }

        public string Name { get { return Text(Arrays().name); } }

        /// <summary>A copy of the mesh; null for a skeleton alone.</summary>
        public Mesh Mesh
        {
            get
            {
                var a = Arrays();
                if (a.vertex_count == 0) return null;
                return new Mesh
                {
                    Positions = Floats(a.positions, 3 * a.vertex_count), FaceVertices = (uint[])(object)Ints(a.face_vertices, a.corner_count),
                    FaceOffsets = (uint[])(object)Ints(a.face_offsets, a.face_count + 1)
                };
            }
        }

        /// <summary>A copy of the skeleton; null for a mesh alone.</summary>
        public Skeleton Skeleton
        {
            get
            {
                var a = Arrays();
                if (a.joint_count == 0) return null;
                var names = new string[a.joint_count];
                for (int j = 0; j < names.Length; ++j) names[j] = Text(Marshal.ReadIntPtr(a.joint_names, j * IntPtr.Size));
                return new Skeleton { Positions = Floats(a.joint_positions, 3 * a.joint_count), Parents = Ints(a.parents, a.joint_count), Names = names };
            }
        }

        /// <summary>Weights as the engine has them; null without any.</summary>
        public Skin Skin
        {
            get
            {
                var a = Arrays();
                if (a.influence_count == 0) return null;
                int k = (int)Math.Min(a.influence_count, Native.MAX_INFLUENCES), rows = (int)a.vertex_count * k;
                var skin = new Skin { Influences = k, Joints = new ushort[rows], Weights = new ushort[rows] };
                using (var pins = new Pins())
                    Check(Native.sinew_character_skin(Handle, (uint)k, pins.Of(skin.Joints), pins.Of(skin.Weights)), handle_, "skin");
                if (a.confidence != IntPtr.Zero)
                {
                    skin.Confidence = new byte[a.vertex_count];
                    Marshal.Copy(a.confidence, skin.Confidence, 0, skin.Confidence.Length);
                }
                return skin;
            }
        }

        /// <summary>What each joint is for, as retargeting has it.</summary>
        public JointClass[] JointClasses
        {
            get
            {
                var classes = new byte[Arrays().joint_count];
                using (var pins = new Pins()) Check(Native.sinew_character_joint_classes(Handle, pins.Of(classes)), handle_, "classes");
                return Array.ConvertAll(classes, c => (JointClass)c);
            }
        }

        /// <summary>Another skeleton for the mesh; weights go.</summary>
        public void SetSkeleton(Skeleton skeleton)
        {
            skeleton.Check();
            using (var pins = new Pins())
                Check(Native.sinew_character_set_skeleton(Handle, pins.Of(Engine.View(skeleton, pins))), handle_, "skeleton");
        }

        /// <summary>The skeleton of another character, with its weights where the mesh is the same.</summary>
        public void TakeSkeleton(Character other, bool withWeights = false)
        {
            Check(Native.sinew_character_take_skeleton(Handle, other.Handle, withWeights ? 1u : 0), handle_, "skeleton");
            GC.KeepAlive(other);
        }

        /// <summary>Weights of the mesh, rows of 65535.</summary>
        public void SetSkin(Skin skin)
        {
            int vertices = skin.Joints.Length / skin.Influences;
            if (vertices != Arrays().vertex_count || skin.Weights.Length != skin.Joints.Length)
                throw new ArgumentException("Skin.Joints: expected rows of every vertex");
            var offsets = new uint[vertices + 1];
            var joints = new List<uint>();
            var weights = new List<float>();
            for (int v = 0; v < vertices; ++v)
            {
                for (int i = v * skin.Influences; i < (v + 1) * skin.Influences; ++i)
                {
                    if (skin.Weights[i] == 0) continue;
                    joints.Add(skin.Joints[i]);
                    weights.Add(skin.Weights[i] / 65535f);
                }
                offsets[v + 1] = (uint)joints.Count;
            }
            using (var pins = new Pins())
                Check(Native.sinew_character_set_weights(Handle, pins.Of(offsets), pins.Of(joints.ToArray()), pins.Of(weights.ToArray())), handle_, "weights");
        }

        public int ClipCount
        {
            get
            {
                var count = new uint[1];
                using (var pins = new Pins()) Check(Native.sinew_character_clip_count(Handle, pins.Of(count)), handle_, "clips");
                return (int)count[0];
            }
        }

        /// <summary>A clip; its first joints are the character's, others that move stand behind them.</summary>
        public MotionClip Clip(int index)
        {
            var clip = new Native.sinew_character_clip { struct_size = Size<Native.sinew_character_clip>() };
            using (var pins = new Pins())
            {
                IntPtr at = pins.Of(clip);
                Check(Native.sinew_character_get_clip(Handle, (uint)index, at), handle_, "clip");
                clip = Read<Native.sinew_character_clip>(at);
            }
            uint poses = clip.frame_count * clip.joint_count;
            return new MotionClip
            {
                Name = Text(clip.name), FrameTime = clip.frame_time, FrameCount = (int)clip.frame_count, JointCount = (int)clip.joint_count,
                Rotations = Doubles(clip.rotations, 4 * poses), Translations = Doubles(clip.translations, 3 * poses)
            };
        }

        /// <summary>Adds a clip of the character's joints; it is saved as an animation.</summary>
        public void AddClip(MotionClip clip)
        {
            if (clip.Rotations.Length != 4 * clip.FrameCount * clip.JointCount || clip.Translations.Length != 3 * clip.FrameCount * clip.JointCount)
                throw new ArgumentException("MotionClip.Rotations: expected four numbers, and Translations three, a frame and joint");
            using (var pins = new Pins())
                Check(Native.sinew_character_add_clip(Handle, pins.Of(new Native.sinew_character_clip
                {
                    struct_size = Size<Native.sinew_character_clip>(), frame_count = (uint)clip.FrameCount, joint_count = (uint)clip.JointCount,
                    frame_time = clip.FrameTime, name = pins.Of(clip.Name), rotations = pins.Of(clip.Rotations), translations = pins.Of(clip.Translations)
                })), handle_, "clip");
        }

        // ---- jobs

        /// <summary>Skin weights for the mesh. Returns their hash, as `sinew bind --json` has it.</summary>
        public string Bind(CharacterBindSettings settings = null)
        {
            settings = settings ?? new CharacterBindSettings();
            var a = Arrays();
            Length(settings.JointFlags, a.joint_count, "CharacterBindSettings.JointFlags: expected a number a joint");
            Length(settings.Locked, a.vertex_count, "CharacterBindSettings.Locked: expected a number a vertex");
            Length(settings.Hinted, a.vertex_count, "CharacterBindSettings.Hinted: expected a number a vertex");
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = pins.Of(new Native.sinew_character_bind_result { struct_size = Size<Native.sinew_character_bind_result>() });
                int status = Native.sinew_character_bind(Handle, pins.Of(new Native.sinew_character_bind_options
                {
                    struct_size = Size<Native.sinew_character_bind_options>(), thread_count = (uint)settings.Threads, progress = watch.Callback,
                    models = Models(pins, settings.Model, null, null, null), method = (uint)settings.Method, joints = (uint)settings.Joints,
                    rigid_parts = (uint)settings.RigidParts, influence_count = (uint)settings.Influences,
                    softness_percent = (uint)settings.SoftnessPercent, surface_vertices = (uint)settings.SurfaceVertices,
                    up = Axis(settings.ZUp), keep_tips = One(settings.KeepTips), bind_props = One(settings.BindProps), fit = One(settings.Fit),
                    symmetric = One(settings.Symmetric), keep_confidence = One(settings.KeepConfidence), joint_flags = pins.Of(settings.JointFlags),
                    locked = pins.Of(settings.Locked), hinted = pins.Of(settings.Hinted),
                    like = settings.Like == null ? IntPtr.Zero : settings.Like.Handle, style = pins.Of(settings.Style),
                    cut = One(settings.Cut), to_pose = pins.Of(settings.ToPose)
                }), result);
                Check(status, handle_, "bind", watch);
                GC.KeepAlive(settings);
                return Text(Read<Native.sinew_character_bind_result>(result).hash);
            }
        }

        /// <summary>A skeleton for the mesh, and weights for it. Returns how far off the joints are thought to be.</summary>
        public float Rig(CharacterRigSettings settings = null)
        {
            settings = settings ?? new CharacterRigSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                bool slots = settings.Method == CharacterRigMethod.Slots;
                IntPtr result = pins.Of(new Native.sinew_character_rig_result { struct_size = Size<Native.sinew_character_rig_result>() });
                int status = Native.sinew_character_rig(Handle, pins.Of(new Native.sinew_character_rig_options
                {
                    struct_size = Size<Native.sinew_character_rig_options>(), thread_count = (uint)settings.Threads, progress = watch.Callback,
                    models = Models(pins, null, slots ? null : settings.Model, settings.HandsModel, slots ? settings.Model : null),
                    method = (uint)settings.Method, category = (uint)settings.Category,
                    detail = (uint)settings.Detail, mirror = (uint)settings.Mirror, up = Axis(settings.ZUp),
                    spine_count = (uint)settings.SpineCount, no_toes = One(settings.NoToes), no_ends = One(settings.NoEnds),
                    no_bind = One(settings.NoBind), keep_lengths = One(settings.KeepLengths), influence_count = (uint)settings.Influences,
                    skeleton = pins.Of(settings.Skeleton), gate = One(settings.Gate), cut = One(settings.Cut), to_pose = pins.Of(settings.ToPose)
                }), result);
                Check(status, handle_, "rig", watch);
                return Read<Native.sinew_character_rig_result>(result).spread;
            }
        }

        /// <summary>Which joint of the source stands for which of this character. Changes neither.</summary>
        public CharacterMap Map(Character source, CharacterMapSettings settings = null)
        {
            settings = settings ?? new CharacterMapSettings();
            using (var pins = new Pins())
            {
                IntPtr at = pins.Of(new Native.sinew_character_map_result { struct_size = Size<Native.sinew_character_map_result>() });
                Check(Native.sinew_character_map(Handle, source.Handle, pins.Of(new Native.sinew_character_map_options
                {
                    struct_size = Size<Native.sinew_character_map_options>(), method = (uint)settings.Method, no_names = One(settings.NoNames),
                    no_ends = One(settings.NoEnds), guess_up = One(settings.GuessUp), target_up = (uint)settings.TargetUp,
                    source_up = (uint)settings.SourceUp, pins_file = pins.Of(settings.PinsFile), branches_first = (uint)settings.First,
                    branches_cost = (uint)settings.Cost
                }), at), handle_, "map");
                GC.KeepAlive(source);
                var result = Read<Native.sinew_character_map_result>(at);
                var reasons = new byte[result.joint_count];
                Marshal.Copy(result.reasons, reasons, 0, reasons.Length);
                return new CharacterMap
                {
                    Sources = Ints(result.sources, result.joint_count), Confidence = Floats(result.confidence, result.joint_count),
                    Reasons = Array.ConvertAll(reasons, r => (MapReason)r), Certainty = result.certainty, Text = Text(result.text)
                };
            }
        }

        /// <summary>Adds clips of another skeleton; a bare mesh is rigged first. Null: a clip of its class, for a picture's character. Returns how many.</summary>
        public int Animate(Character motion, AnimateSettings settings = null)
        {
            settings = settings ?? new AnimateSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = pins.Of(new Native.sinew_character_animate_result { struct_size = Size<Native.sinew_character_animate_result>() });
                int status = Native.sinew_character_animate(Handle, motion == null ? IntPtr.Zero : motion.Handle, pins.Of(new Native.sinew_character_animate_options
                {
                    struct_size = Size<Native.sinew_character_animate_options>(), thread_count = (uint)settings.Threads, progress = watch.Callback,
                    method = (uint)settings.Method, in_place = One(settings.InPlace), no_range = One(settings.NoRange), force = One(settings.Force), translations = One(settings.Translations),
                    target_up = (uint)settings.TargetUp, motion_up = (uint)settings.MotionUp, deform = (uint)settings.Deform,
                    body_contact = One(settings.BodyContact), shapes = (uint)settings.Shapes, stiffness = settings.Stiffness,
                    tet_weights = (uint)settings.TetWeights, no_smoothing = One(settings.NoSmoothing), fps = settings.Fps, from = settings.From,
                    to = settings.To, clip = pins.Of(settings.Clip), map = pins.Of(settings.Map), layout = pins.Of(settings.Layout), actor = pins.Of(settings.Actor),
                    limits = pins.Of(settings.Limits), depth = One(settings.Depth)
                }), result);
                Check(status, handle_, "animate", watch);
                GC.KeepAlive(motion);
                return (int)Read<Native.sinew_character_animate_result>(result).clip_count;
            }
        }

        /// <summary>A copy in a pose, to save as .obj or to take positions of.</summary>
        public Character Pose(PoseSettings settings)
        {
            uint joints = Arrays().joint_count;
            Length(settings.Angles, 3 * joints, "PoseSettings.Angles: expected three numbers a joint");
            Length(settings.Rotations, 4 * joints, "PoseSettings.Rotations: expected four numbers a joint");
            Length(settings.Matrices, 12 * joints, "PoseSettings.Matrices: expected twelve numbers a joint");
            IntPtr posed;
            using (var pins = new Pins())
                Check(Native.sinew_character_pose(Handle, pins.Of(new Native.sinew_character_pose_options
                {
                    struct_size = Size<Native.sinew_character_pose_options>(), thread_count = (uint)settings.Threads, deform = (uint)settings.Deform,
                    body_contact = One(settings.BodyContact), angles = pins.Of(settings.Angles), rotations = pins.Of(settings.Rotations),
                    matrices = pins.Of(settings.Matrices), clip = pins.Of(settings.Clip), time = settings.Time, stiffness = settings.Stiffness,
                    tet_weights = (uint)settings.TetWeights, no_smoothing = One(settings.NoSmoothing)
                }), out posed), handle_, "pose");
            return new Character(posed);
        }

        /// <summary>Weights of a bound character for this mesh. Returns the share that was carried over.</summary>
        public double Transfer(Character source, CharacterTransferSettings settings = null)
        {
            settings = settings ?? new CharacterTransferSettings();
            Length(settings.Locked, Arrays().vertex_count, "CharacterTransferSettings.Locked: expected a number a vertex");
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = pins.Of(new Native.sinew_character_transfer_result { struct_size = Size<Native.sinew_character_transfer_result>() });
                int status = Native.sinew_character_transfer(source.Handle, Handle, pins.Of(new Native.sinew_character_transfer_options
                {
                    struct_size = Size<Native.sinew_character_transfer_options>(), thread_count = (uint)settings.Threads, progress = watch.Callback,
                    method = (uint)settings.Method, influence_count = (uint)settings.Influences, target_up = Axis(settings.ZUp),
                    source_up = Axis(settings.SourceZUp), garment = One(settings.Garment), heat = One(settings.Heat),
                    locked = pins.Of(settings.Locked), map = pins.Of(settings.Map)
                }), result);
                Check(status, handle_, "transfer", watch);
                GC.KeepAlive(source);
                return Read<Native.sinew_character_transfer_result>(result).carried;
            }
        }

        /// <summary>Leaves joints out. Returns the joint, of those before, that each is part of now.</summary>
        public uint[] Simplify(bool low = false, int jointCount = 0, params string[] keep)
        {
            var into = new uint[Arrays().joint_count];
            using (var pins = new Pins())
                Check(Native.sinew_character_simplify(Handle, pins.Of(new Native.sinew_character_simplify_options
                {
                    struct_size = Size<Native.sinew_character_simplify_options>(), low = One(low), joint_count = (uint)jointCount,
                    keep_count = (uint)keep.Length, keep = pins.Of(keep)
                }), pins.Of(into)), handle_, "simplify");
            return into;
        }

        /// <summary>Morph targets that correct bends, with what drives them. Returns how many.</summary>
        public int Bake(BakeSettings settings = null)
        {
            settings = settings ?? new BakeSettings();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                IntPtr result = pins.Of(new Native.sinew_character_bake_result { struct_size = Size<Native.sinew_character_bake_result>() });
                int status = Native.sinew_character_bake(Handle, pins.Of(new Native.sinew_character_bake_options
                {
                    struct_size = Size<Native.sinew_character_bake_options>(), progress = watch.Callback, deform = (uint)settings.Deform,
                    poses = (uint)settings.Poses, shapes = (uint)settings.Shapes, seed = settings.Seed, limit = settings.Limit,
                    clip = pins.Of(settings.Clip), stiffness = settings.Stiffness,
                    tet_weights = (uint)settings.TetWeights, no_smoothing = One(settings.NoSmoothing)
                }), result);
                Check(status, handle_, "bake", watch);
                return (int)Read<Native.sinew_character_bake_result>(result).shape_count;
            }
        }

        // ---- how

        static void Check(int status, IntPtr handle, string what, Watch watch = null)
        {
            if (watch != null) watch.End();
            GC.KeepAlive(watch);
            if (status == 0) return;
            if (status == Native.ERROR_CANCELLED) throw new CancelledException(what + ": the progress function asked to stop");
            throw new SinewException(Text(Native.sinew_character_error(handle)), status);
        }

        static uint Axis(bool z) { return (uint)(z ? Up.Z : Up.Y); }
        static uint One(bool value) { return value ? 1u : 0; }
        static uint Size<T>() { return (uint)Marshal.SizeOf(typeof(T)); }
        static T Read<T>(IntPtr at) { return (T)Marshal.PtrToStructure(at, typeof(T)); }

        static void Length(Array array, uint expected, string what)
        {
            if (array != null && array.Length != expected) throw new ArgumentException(what);
        }

        static IntPtr Models(Pins pins, byte[] bind, byte[] rig, byte[] hands, byte[] slots)
        {
            if (bind == null && rig == null && hands == null && slots == null) return IntPtr.Zero;
            return pins.Of(new Native.sinew_character_models
            {
                struct_size = Size<Native.sinew_character_models>(), bind = pins.Of(bind), bind_size = Bytes(bind), rig = pins.Of(rig),
                rig_size = Bytes(rig), hands = pins.Of(hands), hands_size = Bytes(hands), slots = pins.Of(slots),
                slots_size = Bytes(slots)
            });
        }

        static UIntPtr Bytes(byte[] file) { return (UIntPtr)(file == null ? 0 : file.Length); }

        static string Text(IntPtr at)
        {
            if (at == IntPtr.Zero) return "";
            int length = 0;
            while (Marshal.ReadByte(at, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(at, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        static float[] Floats(IntPtr at, uint count)
        {
            var array = new float[count];
            if (count > 0) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        static double[] Doubles(IntPtr at, uint count)
        {
            var array = new double[count];
            if (count > 0) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        static int[] Ints(IntPtr at, uint count)
        {
            var array = new int[count];
            if (count > 0) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }
    }
}
