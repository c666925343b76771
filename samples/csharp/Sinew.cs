// SPDX-License-Identifier: MIT
// The engine of sinew for C#: skin weights and skeletons over the shared library (libsinew.so, sinew.dll, libsinew.dylib),
// by P/Invoke. One file without dependencies, C# 7, for Mono, .NET and Unity. The C headers in engine/include/sinew are
// the reference of every struct and status.
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace Sinew
{
    /// <summary>What the engine says against a call, in one line. Status is the sinew_status.</summary>
    public class SinewException : Exception
    {
        public int Status { get; }
        public SinewException(string message, int status = 0) : base(message) { Status = status; }
    }

    /// <summary>The progress function asked to stop. Nothing was changed.</summary>
    public sealed class CancelledException : SinewException
    {
        public CancelledException(string message) : base(message, Native.Cancelled) { }
    }

    /// <summary>The C interface as it is. Structs have the names and the layout of C.</summary>
    public static class Native
    {
        public const string Library = "sinew";
        public const int Cancelled = -8;
        public const uint MaxRigJoints = 192, JointNameBytes = 32, WorkspaceAlignment = 64;
        public const byte JointNever = 1, JointDeforms = 2;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        public delegate int Progress(IntPtr user, uint donePermille);

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_mesh
        {
            public IntPtr positions;
            public uint vertex_count;
            public IntPtr face_offsets, face_vertices;
            public uint face_count, corner_count;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_skeleton
        {
            public uint struct_size, joint_count;
            public IntPtr positions, parents, flags, ends, names, rotations;
            public uint up, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_model
        {
            public IntPtr bytes;
            public UIntPtr size_bytes;
            public IntPtr packed;
            public uint format_version, candidate_count, grid_size, feature_set, fixed_candidates, layer_count,
                parameter_count, checksum, confidence_offset, confidence_count, task, input_count;
            [MarshalAs(UnmanagedType.ByValArray, SizeConst = 14)] public uint[] reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_options
        {
            public uint struct_size, method, influence_count, weight_format, candidate_count, grid_size,
                surface_vertices, symmetric, rigid_parts, softness_percent, weights_in_place, kernel, thread_count, reserved;
            public IntPtr locked, hints, parallel_for, parallel_user;
            public Progress progress;
            public IntPtr progress_user, answers;
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
        public struct sinew_rig_options
        {
            public uint struct_size, up, mirror, spine_count, no_toes, no_ends, weights_in_place, kernel;
            public Progress progress;
            public IntPtr progress_user;
            public uint method, reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct sinew_rig_outputs
        {
            public uint struct_size, joint_count;
            public IntPtr positions, parents, flags, joint_classes, partners, confidence, parent_confidence, names;
            public uint mirrored, facing;
            public float plane, spread;
            public UIntPtr used_bytes;
        }

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_status_text(int status);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr sinew_version();
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_model_open(IntPtr bytes, UIntPtr size, out sinew_model model);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_model_open(IntPtr bytes, UIntPtr size, out sinew_model model);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_bind_workspace_size(IntPtr model, uint vertices, uint faces, uint corners,
            uint joints, ref sinew_options options, out UIntPtr size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_bind(IntPtr model, ref sinew_mesh mesh, ref sinew_skeleton skeleton,
            ref sinew_options options, IntPtr workspace, UIntPtr bytes, ref sinew_bind_outputs outputs);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig_workspace_size(IntPtr model, uint vertices, uint faces, uint corners,
            ref sinew_rig_options options, out UIntPtr size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int sinew_rig(IntPtr model, ref sinew_mesh mesh, ref sinew_rig_options options,
            IntPtr workspace, UIntPtr bytes, ref sinew_rig_outputs outputs);
    }

    /// <summary>A model file (.sinew) in memory. Any number of calls may use it at once.</summary>
    public sealed class Model : IDisposable
    {
        readonly Block bytes_, model_;

        /// <param name="file">Bytes of a model for skin weights, such as sinew_default.sinew.</param>
        /// <exception cref="SinewException">The engine refuses the bytes.</exception>
        public static Model ForWeights(byte[] file) { return new Model(file, Native.sinew_model_open, "skin weights"); }
        /// <param name="file">Bytes of a model for skeletons, such as sinew_rig.sinew.</param>
        public static Model ForSkeletons(byte[] file)
        {
            return new Model(file, Native.sinew_rig_model_open, "skeletons");
        }

        delegate int Open(IntPtr bytes, UIntPtr size, out Native.sinew_model model);

        Model(byte[] file, Open open, string what)
        {
            if (file == null) throw new ArgumentNullException(nameof(file));
            bytes_ = new Block(file.Length);
            Marshal.Copy(file, 0, bytes_.Address, file.Length);
            Native.sinew_model model;
            int status;
            try
            {
                status = open(bytes_.Address, (UIntPtr)file.Length, out model);
            }
            catch
            {
                bytes_.Dispose();
                throw;
            }
            if (status != 0)
            {
                bytes_.Dispose();
                Engine.Throw(status, "model for " + what);
            }
            model_ = new Block(Marshal.SizeOf(typeof(Native.sinew_model)));
            Marshal.StructureToPtr(model, model_.Address, false);
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
        /// <summary>[faces + 1] where each face begins in FaceVertices; null: all are triangles.</summary>
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
        /// <summary>[joints] Native.JointNever and others, or null.</summary>
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

    public enum RigidParts { Auto = 0, Always = 1, Never = 2 }

    /// <summary>What a bind is asked to do. What is not set is the engine's default.</summary>
    public sealed class BindSettings
    {
        /// <summary>1 to 12 joints a vertex.</summary>
        public int Influences = 4;
        public bool ZUp, Symmetric;
        public RigidParts RigidParts;
        /// <summary>25 to 400: 200 blends twice as softly.</summary>
        public int SoftnessPercent = 100;
        /// <summary>[vertices] non-zero: the vertex keeps its row of Keep; or null.</summary>
        public byte[] Locked;
        /// <summary>[vertices] non-zero: the vertex keeps its row of Keep, and its surroundings follow; or null.</summary>
        public byte[] Hints;
        /// <summary>Rows of locked and hinted vertices, of as many influences.</summary>
        public Skin Keep;
        /// <summary>Gets a share of work done, 0 to 1, on the calling thread. Returns false to stop.</summary>
        public Func<float, bool> Progress;
    }

    /// <summary>Skin weights: for every vertex so many joints by falling weight; a row sums to exactly 65535.</summary>
    public sealed class Skin
    {
        public int Influences;
        /// <summary>[vertices x Influences]</summary>
        public ushort[] Joints, Weights;
        /// <summary>[vertices] how sure the strongest joint is, 0 to 255 = 0 to 100 %.</summary>
        public byte[] Confidence;
    }

    public enum Mirror { Auto = 0, Always = 1, Never = 2 }

    public sealed class RigSettings
    {
        public bool ZUp, NoToes, NoEnds;
        public Mirror Mirror;
        /// <summary>1 to 16 joints between pelvis and neck; 0 as the model says.</summary>
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
        /// <summary>[joints] how sure the place is, 0 to 1.</summary>
        public float[] Confidence;
        public bool Mirrored;
        /// <summary>How far off the joints are thought to be, share of the longest side: above 0.09 is a guess.</summary>
        public float Spread;
    }

    public static class Engine
    {
        public static string Version { get { return Marshal.PtrToStringAnsi(Native.sinew_version()); } }

        /// <summary>Predicts skin weights: the bytes that the command gives for the same character and settings.</summary>
        /// <exception cref="ArgumentException">An array has another length than it says.</exception>
        /// <exception cref="SinewException">The engine refuses the call.</exception>
        /// <exception cref="CancelledException">Progress returned false.</exception>
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
                var options = new Native.sinew_options
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_options)),
                    influence_count = (uint)settings.Influences,
                    symmetric = settings.Symmetric ? 1u : 0, rigid_parts = (uint)settings.RigidParts,
                    softness_percent = (uint)settings.SoftnessPercent, locked = pins.Of(settings.Locked),
                    hints = pins.Of(settings.Hints), progress = watch.Callback
                };
                Native.sinew_mesh view = View(mesh, pins);
                var bones = new Native.sinew_skeleton
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_skeleton)), up = settings.ZUp ? 3u : 2u,
                    positions = pins.Of(skeleton.Positions), parents = pins.Of(skeleton.Parents),
                    flags = pins.Of(skeleton.Flags), joint_count = (uint)skeleton.JointCount
                };
                var outputs = new Native.sinew_bind_outputs
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_bind_outputs)),
                    joint_indices = pins.Of(skin.Joints), weights = pins.Of(skin.Weights),
                    confidence = pins.Of(skin.Confidence)
                };
                UIntPtr size;
                Throw(Native.sinew_bind_workspace_size(model.Address, view.vertex_count, view.face_count,
                    view.corner_count, bones.joint_count, ref options, out size), "bind");
                using (var workspace = new Block((long)size))
                {
                    int status = Native.sinew_bind(model.Address, ref view, ref bones, ref options, workspace.Address,
                        size, ref outputs);
                    watch.End();
                    Throw(status, "bind");
                }
                GC.KeepAlive(watch);
            }
            GC.KeepAlive(model);
            return skin;
        }

        /// <summary>Predicts a skeleton for a bare mesh. What it gives, Bind takes as it is.</summary>
        public static RiggedSkeleton Rig(Model model, Mesh mesh, RigSettings settings = null)
        {
            if (model == null) throw new ArgumentNullException(nameof(model));
            settings = settings ?? new RigSettings();
            mesh.Check();
            const int most = (int)Native.MaxRigJoints, room = (int)Native.JointNameBytes;
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
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_rig_options)), up = settings.ZUp ? 3u : 2u,
                    mirror = (uint)settings.Mirror, spine_count = (uint)settings.SpineCount,
                    no_toes = settings.NoToes ? 1u : 0, no_ends = settings.NoEnds ? 1u : 0, progress = watch.Callback
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
                UIntPtr size;
                Throw(Native.sinew_rig_workspace_size(model.Address, view.vertex_count, view.face_count,
                    view.corner_count, ref options, out size), "rig");
                using (var workspace = new Block((long)size))
                {
                    int status = Native.sinew_rig(model.Address, ref view, ref options, workspace.Address, size,
                        ref outputs);
                    watch.End();
                    Throw(status, "rig");
                }
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
            if (status == Native.Cancelled) throw new CancelledException(text);
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

        static Native.sinew_mesh View(Mesh mesh, Pins pins)
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

    /// <summary>A progress function as C calls it. What it throws is thrown when the call is over.</summary>
    sealed class Watch
    {
        readonly Func<float, bool> progress_;
        Exception thrown_;
        public readonly Native.Progress Callback;

        public Watch(Func<float, bool> progress)
        {
            progress_ = progress;
            if (progress != null) Callback = Report;
        }

        // Unity's IL2CPP wants a static method with MonoPInvokeCallback here; see README.md.
        int Report(IntPtr user, uint permille)
        {
            try
            {
                return progress_(permille / 1000f) ? 0 : 1;
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

    /// <summary>Arrays that stay where they are for the time of a call.</summary>
    sealed class Pins : IDisposable
    {
        readonly List<GCHandle> handles_ = new List<GCHandle>();

        public IntPtr Of(Array array)
        {
            if (array == null) return IntPtr.Zero;
            GCHandle handle = GCHandle.Alloc(array, GCHandleType.Pinned);
            handles_.Add(handle);
            return handle.AddrOfPinnedObject();
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
            const long alignment = Native.WorkspaceAlignment;
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
