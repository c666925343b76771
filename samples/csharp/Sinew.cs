// SPDX-License-Identifier: MIT
// The engine of sinew for C#: skin weights and skeletons over the shared library (libsinew.so, sinew.dll, libsinew.dylib),
// by P/Invoke. Without dependencies, C# 7, for Mono, .NET and Unity. Native.cs has the C interface as it is; the C headers in
// engine/include/sinew are the reference of every struct and status.
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace Sinew
{
    /// <summary>A failed call of the engine, with one line of text. Status is the sinew_status.</summary>
    public class SinewException : Exception
    {
        public int Status { get; }
        public SinewException(string message, int status = 0) : base(message) { Status = status; }
    }

    /// <summary>The progress function stopped the call. Nothing was changed.</summary>
    public sealed class CancelledException : SinewException
    {
        public CancelledException(string message) : base(message, Native.ERROR_CANCELLED) { }
    }

    /// <summary>A model file (.sinew) in memory. Any number of calls may use it at once.</summary>
    public sealed class Model : IDisposable
    {
        readonly Block bytes_, model_;

        /// <param name="file">Bytes of a model for skin weights, such as sinew_default.sinew.</param>
        /// <exception cref="SinewException">The engine rejects the bytes.</exception>
        public static Model ForWeights(byte[] file) { return new Model(file, Native.sinew_model_open, "skin weights"); }
        /// <param name="file">Bytes of a model for skeletons, such as sinew_rig.sinew.</param>
        public static Model ForSkeletons(byte[] file)
        {
            return new Model(file, Native.sinew_rig_model_open, "skeletons");
        }

        delegate int Open(IntPtr bytes, UIntPtr size, IntPtr model);

        Model(byte[] file, Open open, string what)
        {
            if (file == null) throw new ArgumentNullException(nameof(file));
            Engine.CheckLibrary();
            bytes_ = new Block(file.Length);
            Marshal.Copy(file, 0, bytes_.Address, file.Length);
            model_ = new Block(Marshal.SizeOf(typeof(Native.sinew_model)));
            try
            {
                Engine.Throw(open(bytes_.Address, (UIntPtr)file.Length, model_.Address), "model for " + what);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal IntPtr Address
        {
            get
            {
                if (model_.Address == IntPtr.Zero) throw new ObjectDisposedException(nameof(Model));
                return model_.Address;
            }
        }

        public void Dispose()
        {
            model_.Dispose();
            bytes_.Dispose();
        }
    }

    /// <summary>A polygon mesh. Any topology is legal.</summary>
    public sealed class Mesh
    {
        /// <summary>[vertices x 3] any unit, rest pose.</summary>
        public float[] Positions;
        /// <summary>[corners] vertex indices.</summary>
        public uint[] FaceVertices;
        /// <summary>[faces + 1] start of each face in FaceVertices; null: all are triangles.</summary>
        public uint[] FaceOffsets;

        public int VertexCount { get { return Positions.Length / 3; } }

        internal void Check()
        {
            if (Positions == null || Positions.Length == 0 || Positions.Length % 3 != 0)
                throw new ArgumentException("Mesh.Positions: expected three numbers a vertex");
            if (FaceVertices == null) throw new ArgumentException("Mesh.FaceVertices: expected an array, empty for no faces");
            if (FaceOffsets == null && FaceVertices.Length % 3 != 0)
                throw new ArgumentException("Mesh.FaceVertices: expected three corners a face, or FaceOffsets");
            if (FaceOffsets != null && FaceOffsets.Length == 0)
                throw new ArgumentException("Mesh.FaceOffsets: expected one number more than there are faces");
        }
    }

    /// <summary>Joints with their parents, in any order.</summary>
    public sealed class Skeleton
    {
        /// <summary>[joints x 3] same space as the mesh.</summary>
        public float[] Positions;
        /// <summary>[joints] index of the parent, or -1.</summary>
        public int[] Parents;
        /// <summary>[joints] Native.JOINT_NEVER and others, or null.</summary>
        public byte[] Flags;
        /// <summary>[joints] or null; the engine does not need them.</summary>
        public string[] Names;

        public int JointCount { get { return Parents.Length; } }

        internal void Check()
        {
            if (Parents == null || Parents.Length == 0) throw new ArgumentException("Skeleton.Parents: expected a number a joint");
            if (Positions == null || Positions.Length != 3 * Parents.Length)
                throw new ArgumentException("Skeleton.Positions: expected three numbers a joint");
            if (Flags != null && Flags.Length != Parents.Length)
                throw new ArgumentException("Skeleton.Flags: expected a number a joint");
        }
    }

    /// <summary>Options of a bind. Unset members have the engine's defaults.</summary>
    public sealed class BindSettings
    {
        /// <summary>1 to 12 joints per vertex.</summary>
        public int Influences = 4;
        public bool ZUp, Symmetric;
        public RigidParts RigidParts;
        /// <summary>25 to 400: softness, 200 is twice as soft.</summary>
        public int SoftnessPercent = 100;
        /// <summary>[vertices] non-zero: the vertex keeps its row of Keep; or null.</summary>
        public byte[] Locked;
        /// <summary>[vertices] non-zero: the vertex keeps its row of Keep, which guides its surroundings; or null.</summary>
        public byte[] Hints;
        /// <summary>Rows of locked and hinted vertices, with the same number of influences.</summary>
        public Skin Keep;
        /// <summary>Called with the share of the work that is done, 0 to 1, on the calling thread. Returns true to stop, as in C.</summary>
        public Func<float, bool> Progress;
    }

    /// <summary>Skin weights: a fixed number of joints per vertex, by descending weight; a row sums to exactly 65535.</summary>
    public sealed class Skin
    {
        public int Influences;
        /// <summary>[vertices x Influences]</summary>
        public ushort[] Joints, Weights;
        /// <summary>[vertices] confidence of the strongest joint, 0 to 255 = 0 to 100 %.</summary>
        public byte[] Confidence;
    }

    public sealed class RigSettings
    {
        public bool ZUp, Toes = true, Ends = true;
        public Mirror Mirror;
        /// <summary>1 to 16 joints between pelvis and neck; 0: as predicted.</summary>
        public int SpineCount;
        public Func<float, bool> Progress;
    }

    /// <summary>A predicted skeleton, with names. Parents come before their children.</summary>
    public sealed class RiggedSkeleton
    {
        public Skeleton Skeleton;
        /// <summary>[joints] sinew_joint_class.</summary>
        public byte[] Classes;
        /// <summary>[joints] the mirror image's index, itself on the plane, or -1.</summary>
        public int[] Partners;
        /// <summary>[joints] confidence of the position, 0 to 1.</summary>
        public float[] Confidence;
        public bool Mirrored;
        /// <summary>Estimated error of the joints, share of the longest side: a guess above 0.09.</summary>
        public float Spread;
    }

    public static class Engine
    {
        public static string Version { get { return Marshal.PtrToStringAnsi(Native.sinew_version()); } }

        static bool checked_;

        /// <summary>Compares the loaded library with Native.cs, once; models and characters do so automatically.</summary>
        /// <exception cref="SinewException">The library has another version, or other structs.</exception>
        /// <exception cref="DllNotFoundException">The library was not found.</exception>
        public static void CheckLibrary()
        {
            if (checked_) return;
            string expected = Native.VERSION_MAJOR + "." + Native.VERSION_MINOR + ".";
            if (!Version.StartsWith(expected, StringComparison.Ordinal))
                throw new SinewException("library " + Native.Library + ": expected version " + expected + "x, found " + Version);
            CompareSizes(Native.Library, Native.Structs, name => (long)Native.sinew_struct_size(name));
            checked_ = true;
        }

        internal static void CompareSizes(string library, StructSize[] here, Func<IntPtr, long> sizeOf)
        {
            foreach (StructSize one in here)
            {
                long there;
                using (var pins = new Pins()) there = sizeOf(pins.Of(one.Name));
                // One that begins with struct_size may have grown.
                if (there != one.Bytes && !(one.Grows && there > one.Bytes))
                    throw new SinewException("library " + library + ": " + one.Name + " has " + there +
                        " bytes, Native.cs was made for " + one.Bytes + "; take both of one build");
            }
        }

        /// <summary>Predicts skin weights: the bytes that the command gives for the same character and settings.</summary>
        /// <exception cref="ArgumentException">An array has another length than it says.</exception>
        /// <exception cref="SinewException">The engine rejects the call.</exception>
        /// <exception cref="CancelledException">Progress returned true.</exception>
        public static Skin Bind(Model model, Mesh mesh, Skeleton skeleton, BindSettings settings = null)
        {
            if (model == null) throw new ArgumentNullException(nameof(model));
            settings = settings ?? new BindSettings();
            mesh.Check();
            skeleton.Check();
            int vertices = mesh.VertexCount, rows = vertices * settings.Influences;
            var skin = new Skin
            {
                Influences = settings.Influences, Joints = new ushort[rows], Weights = new ushort[rows],
                Confidence = new byte[vertices]
            };
            CheckKept(settings, vertices, skin);
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                var options = new Native.sinew_bind_options
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_bind_options)),
                    influence_count = (uint)settings.Influences,
                    symmetric = settings.Symmetric ? 1u : 0, rigid_parts = (uint)settings.RigidParts,
                    softness_percent = (uint)settings.SoftnessPercent, locked = pins.Of(settings.Locked),
                    hints = pins.Of(settings.Hints), progress = watch.Callback
                };
                Native.sinew_mesh view = View(mesh, pins);
                Native.sinew_skeleton bones = View(skeleton, pins, settings.ZUp ? Up.Z : Up.Y);
                var outputs = new Native.sinew_bind_outputs
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_bind_outputs)),
                    joint_indices = pins.Of(skin.Joints), weights = pins.Of(skin.Weights),
                    confidence = pins.Of(skin.Confidence)
                };
                IntPtr asked = pins.Of(options);
                UIntPtr size;
                Throw(Native.sinew_bind_workspace_size(model.Address, view.vertex_count, view.face_count,
                    view.corner_count, bones.joint_count, asked, out size), "bind");
                using (var workspace = new Block((long)size))
                {
                    int status = Native.sinew_bind(model.Address, pins.Of(view), pins.Of(bones), asked, workspace.Address,
                        size, pins.Of(outputs));
                    watch.End();
                    Throw(status, "bind");
                }
                GC.KeepAlive(watch);
            }
            GC.KeepAlive(model);
            return skin;
        }

        /// <summary>Predicts a skeleton for a bare mesh. Bind takes the result without changes.</summary>
        public static RiggedSkeleton Rig(Model model, Mesh mesh, RigSettings settings = null)
        {
            if (model == null) throw new ArgumentNullException(nameof(model));
            settings = settings ?? new RigSettings();
            mesh.Check();
            const int most = (int)Native.MAX_RIG_JOINTS, room = (int)Native.JOINT_NAME_BYTES;
            var positions = new float[3 * most];
            int[] parents = new int[most], partners = new int[most];
            byte[] flags = new byte[most], classes = new byte[most], names = new byte[most * room];
            var confidence = new ushort[most];
            var outputs = new Native.sinew_rig_outputs();
            using (var pins = new Pins())
            {
                var watch = new Watch(settings.Progress);
                var options = new Native.sinew_rig_options
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_rig_options)), up = (uint)(settings.ZUp ? Up.Z : Up.Y),
                    mirror = (uint)settings.Mirror, spine_count = (uint)settings.SpineCount,
                    without = (settings.Toes ? 0 : Native.WITHOUT_TOES) | (settings.Ends ? 0 : Native.WITHOUT_ENDS), progress = watch.Callback
                };
                Native.sinew_mesh view = View(mesh, pins);
                outputs.struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_rig_outputs));
                outputs.positions = pins.Of(positions);
                outputs.parents = pins.Of(parents);
                outputs.flags = pins.Of(flags);
                outputs.joint_classes = pins.Of(classes);
                outputs.partners = pins.Of(partners);
                outputs.confidence = pins.Of(confidence);
                outputs.names = pins.Of(names);
                IntPtr asked = pins.Of(options), written = pins.Of(outputs);
                UIntPtr size;
                Throw(Native.sinew_rig_workspace_size(model.Address, view.vertex_count, view.face_count,
                    view.corner_count, asked, out size), "rig");
                using (var workspace = new Block((long)size))
                {
                    int status = Native.sinew_rig(model.Address, pins.Of(view), asked, workspace.Address, size, written);
                    watch.End();
                    Throw(status, "rig");
                }
                outputs = (Native.sinew_rig_outputs)Marshal.PtrToStructure(written, typeof(Native.sinew_rig_outputs));
                GC.KeepAlive(watch);
            }
            GC.KeepAlive(model);
            int count = (int)outputs.joint_count;
            var texts = new string[count];
            var sure = new float[count];
            for (int j = 0; j < count; ++j)
            {
                int end = Array.IndexOf(names, (byte)0, j * room);
                texts[j] = Encoding.ASCII.GetString(names, j * room, end - j * room);
                sure[j] = confidence[j] / 32768f;
            }
            Array.Resize(ref positions, 3 * count);
            Array.Resize(ref parents, count);
            Array.Resize(ref partners, count);
            Array.Resize(ref flags, count);
            Array.Resize(ref classes, count);
            return new RiggedSkeleton
            {
                Skeleton = new Skeleton { Positions = positions, Parents = parents, Flags = flags, Names = texts },
                Classes = classes, Partners = partners, Confidence = sure, Mirrored = outputs.mirrored != 0,
                Spread = outputs.spread
            };
        }

        internal static void Throw(int status, string what)
        {
            if (status == 0) return;
            string text = what + ": " + Marshal.PtrToStringAnsi(Native.sinew_status_text(status));
            if (status == Native.ERROR_CANCELLED) throw new CancelledException(text);
            throw new SinewException(text, status);
        }

        static void CheckKept(BindSettings settings, int vertices, Skin skin)
        {
            if (settings.Influences < 1 || settings.Influences > 12)
                throw new ArgumentException("BindSettings.Influences: expected 1 to 12");
            if (settings.Locked != null && settings.Locked.Length != vertices)
                throw new ArgumentException("BindSettings.Locked: expected a number a vertex");
            if (settings.Hints != null && settings.Hints.Length != vertices)
                throw new ArgumentException("BindSettings.Hints: expected a number a vertex");
            if (settings.Locked == null && settings.Hints == null) return;
            Skin keep = settings.Keep;
            if (keep == null || keep.Influences != settings.Influences || keep.Joints.Length != skin.Joints.Length ||
                keep.Weights.Length != skin.Weights.Length)
                throw new ArgumentException("BindSettings.Keep: expected rows of as many influences for every vertex");
            Array.Copy(keep.Joints, skin.Joints, skin.Joints.Length);
            Array.Copy(keep.Weights, skin.Weights, skin.Weights.Length);
        }

        internal static Native.sinew_skeleton View(Skeleton skeleton, Pins pins, Up up = Up.Auto)
        {
            return new Native.sinew_skeleton
            {
                struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_skeleton)), joint_count = (uint)skeleton.JointCount,
                positions = pins.Of(skeleton.Positions), parents = pins.Of(skeleton.Parents), flags = pins.Of(skeleton.Flags),
                names = pins.Of(skeleton.Names), up = (uint)up
            };
        }

        internal static Native.sinew_mesh View(Mesh mesh, Pins pins)
        {
            return new Native.sinew_mesh
            {
                positions = pins.Of(mesh.Positions), vertex_count = (uint)mesh.VertexCount,
                face_offsets = pins.Of(mesh.FaceOffsets), face_vertices = pins.Of(mesh.FaceVertices),
                face_count = (uint)(mesh.FaceOffsets != null ? mesh.FaceOffsets.Length - 1 : mesh.FaceVertices.Length / 3),
                corner_count = (uint)mesh.FaceVertices.Length
            };
        }
    }

    /// <summary>A progress function for C. Its exceptions are rethrown when the call returns.</summary>
    sealed class Watch
    {
        readonly Func<float, bool> progress_;
        Exception thrown_;
        readonly Native.sinew_progress report_;  // kept for as long as C may call it

        public Watch(Func<float, bool> progress)
        {
            progress_ = progress;
            if (progress != null) report_ = Report;
        }

        public IntPtr Callback
        {
            get { return report_ == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(report_); }
        }

        // Unity's IL2CPP wants a static method with MonoPInvokeCallback here; see README.md.
        int Report(IntPtr user, uint permille)
        {
            try
            {
                return progress_(permille / 1000f) ? 1 : 0;
            }
            catch (Exception e)
            {
                thrown_ = e;
                return 1;
            }
        }

        public void End()
        {
            if (thrown_ != null) throw thrown_;
        }
    }

    /// <summary>Arrays pinned for the duration of a call.</summary>
    sealed class Pins : IDisposable
    {
        readonly List<GCHandle> handles_ = new List<GCHandle>();

        /// <summary>Address of an array's elements, or of a boxed struct of Native; null stays null.</summary>
        public IntPtr Of(object array)
        {
            if (array == null) return IntPtr.Zero;
            GCHandle handle = GCHandle.Alloc(array, GCHandleType.Pinned);
            handles_.Add(handle);
            return handle.AddrOfPinnedObject();
        }

        /// <summary>Address of a text, UTF-8, zero-terminated; null stays null.</summary>
        public IntPtr Of(string text)
        {
            return text == null ? IntPtr.Zero : Of((object)Encoding.UTF8.GetBytes(text + "\0"));
        }

        /// <summary>Address of an array of text addresses; null stays null.</summary>
        public IntPtr Of(string[] texts)
        {
            if (texts == null) return IntPtr.Zero;
            var addresses = new IntPtr[texts.Length];
            for (int i = 0; i < texts.Length; ++i) addresses[i] = Of(texts[i] ?? "");
            return Of((object)addresses);
        }

        public void Dispose()
        {
            foreach (GCHandle handle in handles_) handle.Free();
            handles_.Clear();
        }
    }

    /// <summary>Memory outside of the managed heap, 64-byte aligned.</summary>
    sealed class Block : IDisposable
    {
        IntPtr memory_;
        public IntPtr Address { get; private set; }

        public Block(long bytes)
        {
            const long alignment = Native.WORKSPACE_ALIGNMENT;
            memory_ = Marshal.AllocHGlobal(new IntPtr(bytes + alignment));
            Address = new IntPtr((memory_.ToInt64() + alignment - 1) / alignment * alignment);
        }

        ~Block() { Release(); }

        public void Dispose()
        {
            Release();
            GC.SuppressFinalize(this);
        }

        void Release()
        {
            Marshal.FreeHGlobal(memory_);
            memory_ = Address = IntPtr.Zero;
        }
    }
}
