// SPDX-License-Identifier: MIT
// Characters of files for C#: what the command `sinew` does with one, with the same defaults and the same bytes in what is saved, over
// libsinew_character. sinew/character.h is the reference.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Sinew
{
    /// <summary>Options of all jobs.</summary>
    public class JobSettings
    {
        /// <summary>1 to 64; the bytes are the same for any number.</summary>
        public int Threads = 1;
        /// <summary>Called with the share of the work that is done, 0 to 1, on the calling thread. Returns true to stop, as in C.</summary>
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

    /// <summary>A character. Any number may be used at the same time, each by one thread at a time. A failed call changes nothing.</summary>
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

        internal IntPtr Handle
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
        /// <exception cref="SinewException">The file cannot be read; the message has its name.</exception>
        public static Character Open(string path)
        {
            CheckLibrary();
            IntPtr handle;
            using (var pins = new Pins()) Check(Native.sinew_character_open(pins.Of(path), out handle), IntPtr.Zero, "open");
            return new Character(handle);
        }

        /// <summary>The same from memory: the first file is opened, the others are beside it.</summary>
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

        /// <summary>Opens a drawing or a photograph of a character, PNG or JPEG. Rig() gives it a skeleton in the picture plane; Animate() does so
        /// if it has none, and plays a built-in clip of its class if no motion is given.</summary>
        public static Character OpenPicture(string path, PictureSettings settings = null)
        {
            CheckLibrary();
            IntPtr handle;
            using (var pins = new Pins())
                Check(Native.sinew_character_open_picture(pins.Of(path), (settings ?? new PictureSettings()).Options(pins, null, default(Native.sinew_character_arrays)), out handle), IntPtr.Zero, "open");
            return new Character(handle);
        }

        /// <summary>Result of reading the picture of this character.</summary>
        /// <exception cref="SinewException">The character is not from a picture.</exception>
        public PictureInfo Picture
        {
            get
            {
                using (var pins = new Pins())
                {
                    IntPtr result = PictureInfo.Room(pins);
                    Check(Native.sinew_character_picture(Handle, result), handle_, "picture");
                    return PictureInfo.Of(result, default(Native.sinew_character_arrays));
                }
            }
        }

        /// <summary>Creates a character from arrays, which are copied. Mesh or skeleton may be null.</summary>
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

        /// <summary>The files that Save(name) would write, the main file first.</summary>
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

        /// <summary>Notes and warnings of the reader and the jobs, one line each.</summary>
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

        /// <summary>A copy of the mesh; null for a skeleton only.</summary>
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

        /// <summary>A copy of the skeleton; null for a mesh only.</summary>
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

        /// <summary>Weights in the engine's format; null without weights.</summary>
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

        /// <summary>Class of each joint, as used by retargeting.</summary>
        public JointClass[] JointClasses
        {
            get
            {
                var classes = new byte[Arrays().joint_count];
                using (var pins = new Pins()) Check(Native.sinew_character_joint_classes(Handle, pins.Of(classes)), handle_, "classes");
                return Array.ConvertAll(classes, c => (JointClass)c);
            }
        }

        /// <summary>Replaces the skeleton and removes the weights.</summary>
        public void SetSkeleton(Skeleton skeleton)
        {
            skeleton.Check();
            using (var pins = new Pins())
                Check(Native.sinew_character_set_skeleton(Handle, pins.Of(Engine.View(skeleton, pins))), handle_, "skeleton");
        }

        /// <summary>Replaces the skeleton by that of another character, with its weights if the mesh is the same.</summary>
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

        /// <summary>A clip; its first joints are the character's, followed by other animated nodes.</summary>
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

        /// <summary>Removes joints; asDrawn: by the published conditions only. Returns the index (before) of the joint that each joint was merged into.</summary>
        public uint[] Simplify(bool low = false, int jointCount = 0, bool asDrawn = false, params string[] keep)
        {
            var into = new uint[Arrays().joint_count];
            using (var pins = new Pins())
                Check(Native.sinew_character_simplify(Handle, pins.Of(new Native.sinew_character_simplify_options
                {
                    struct_size = Size<Native.sinew_character_simplify_options>(), low = low ? 1u : 0, joint_count = (uint)jointCount,
                    keep_count = (uint)keep.Length, keep = pins.Of(keep), as_drawn = asDrawn ? 1u : 0
                }), pins.Of(into)), handle_, "simplify");
            return into;
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

        internal static uint Count(Array array) { return (uint)(array == null ? 0 : array.Length); }
        internal static uint Size<T>() { return (uint)Marshal.SizeOf(typeof(T)); }
        internal static T Read<T>(IntPtr at) { return (T)Marshal.PtrToStructure(at, typeof(T)); }

        internal static void Length(Array array, uint expected, string what)
        {
            if (array != null && array.Length != expected) throw new ArgumentException(what);
        }

        internal static IntPtr Models(Pins pins, byte[] bind, byte[] rig, byte[] hands, byte[] slots, byte[] front)
        {
            if (bind == null && rig == null && hands == null && slots == null && front == null) return IntPtr.Zero;
            return pins.Of(new Native.sinew_character_models
            {
                struct_size = Size<Native.sinew_character_models>(), bind = pins.Of(bind), bind_size = Bytes(bind), rig = pins.Of(rig),
                rig_size = Bytes(rig), hands = pins.Of(hands), hands_size = Bytes(hands), slots = pins.Of(slots),
                slots_size = Bytes(slots), front = pins.Of(front), front_size = Bytes(front)
            });
        }

        static UIntPtr Bytes(byte[] file) { return (UIntPtr)Count(file); }

        internal static string Text(IntPtr at)
        {
            if (at == IntPtr.Zero) return "";
            int length = 0;
            while (Marshal.ReadByte(at, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(at, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        // Copies of arrays of the library; without one zeros.
        internal static float[] Floats(IntPtr at, uint count)
        {
            var array = new float[count];
            if (at != IntPtr.Zero) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        internal static double[] Doubles(IntPtr at, uint count)
        {
            var array = new double[count];
            if (at != IntPtr.Zero) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        internal static int[] Ints(IntPtr at, uint count)
        {
            var array = new int[count];
            if (at != IntPtr.Zero) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        internal static byte[] Bytes(IntPtr at, uint count)
        {
            var array = new byte[count];
            if (at != IntPtr.Zero) Marshal.Copy(at, array, 0, array.Length);
            return array;
        }

        // Lines of x and y from arrays of all of them.
        internal static float[][] Lines(IntPtr at, IntPtr offsets, uint count)
        {
            int[] ends = Ints(offsets, count + 1);
            float[] all = Floats(at, 2 * (uint)ends[count]);
            var lines = new float[count][];
            for (int l = 0; l < count; ++l)
            {
                lines[l] = new float[2 * (ends[l + 1] - ends[l])];
                Array.Copy(all, 2 * ends[l], lines[l], 0, lines[l].Length);
            }
            return lines;
        }

        internal static T[] Structs<N, T>(IntPtr at, uint count, Native.sinew_character_arrays sizes, Func<IntPtr, Native.sinew_character_arrays, T> of)
        {
            var list = new T[at == IntPtr.Zero ? 0 : count];
            for (int i = 0; i < list.Length; ++i) list[i] = of(new IntPtr(at.ToInt64() + i * (long)Size<N>()), sizes);
            return list;
        }
    }
}
