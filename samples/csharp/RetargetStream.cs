// SPDX-License-Identifier: MIT
// Streaming retargeting (sinew/motion_stream.h), for captures and games.
using System;
using System.Runtime.InteropServices;

namespace Sinew
{
    /// <summary>Options of a stream. Unset members have the engine's defaults.</summary>
    public sealed class StreamSettings
    {
        /// <summary>Frames per second.</summary>
        public float Fps = 30;
        /// <summary>Height of a standing ankle of the source; null: its own at rest.</summary>
        public float? Ground;
        /// <summary>False: no contacts with the floor; knees and elbows may leave their natural range.</summary>
        public bool Contacts = true, Range = true;
        /// <summary>The target stays above its rest position.</summary>
        public bool InPlace;
        /// <summary>Target length per source length; 0: from the legs.</summary>
        public float Scale;
        /// <summary>Degrees, -90..90, by which both arms are lifted away from the body, or brought nearer if below 0.</summary>
        public float ArmSpread;
        /// <summary>[target joints] sinew_joint_class; null: derived from names, from those of the sources or from a human body.</summary>
        public byte[] Classes;
        /// <summary>The target's mesh (triangles) with its weights, for contacts of its skin with the floor and hands;
        /// null: its joints.</summary>
        public Mesh Body;
        public Skin BodySkin;
        /// <summary>The source's mesh, with the same vertices, for contacts of hands with the body. null: none.</summary>
        public Mesh SourceBody;
        public Skin SourceBodySkin;
    }

    /// <summary>A frame of the source in, a frame of the target out. One thread at a time.</summary>
    public sealed class RetargetStream : IDisposable
    {
        readonly Pins kept_ = new Pins();
        readonly Block memory_;
        readonly IntPtr stream_;
        readonly int source_, target_;

        /// <param name="map">[target joints] joint of the source, or -1.</param>
        /// <exception cref="ArgumentException">An array has another length than it says.</exception>
        /// <exception cref="SinewException">The engine rejects the call.</exception>
        public RetargetStream(Skeleton source, Skeleton target, int[] map, StreamSettings settings = null)
        {
            settings = settings ?? new StreamSettings();
            source.Check();
            target.Check();
            source_ = source.JointCount;
            target_ = target.JointCount;
            if (map == null || map.Length != target_) throw new ArgumentException("map: expected a number a joint of the target");
            if (settings.Classes != null && settings.Classes.Length != target_)
                throw new ArgumentException("StreamSettings.Classes: expected a number a joint of the target");
            Engine.CheckLibrary();
            try
            {
                using (var pins = new Pins())
                {
                    IntPtr from = pins.Of(Engine.View(source, pins)), to = pins.Of(Engine.View(target, pins));
                    IntPtr sources = pins.Of(map), classes = pins.Of(settings.Classes ?? ClassesOf(from, to, sources));
                    IntPtr plan = pins.Of(Options.Plan(settings)), body = BodyOf(settings.Body, settings.BodySkin, "Body");
                    IntPtr moving = BodyOf(settings.SourceBody, settings.SourceBodySkin, "SourceBody");
                    IntPtr live = pins.Of(Options.Live(settings, moving));
                    UIntPtr size;
                    uint vertices = settings.Body == null ? 0 : (uint)settings.Body.VertexCount;
                    uint triangles = settings.Body == null ? 0 : (uint)(settings.Body.FaceVertices.Length / 3);
                    Engine.Throw(Native.sinew_retarget_stream_workspace_size((uint)source_, (uint)target_, vertices, triangles, out size),
                        "retarget");
                    memory_ = new Block((long)size);
                    Engine.Throw(Native.sinew_retarget_stream_create(from, to, sources, classes, plan, body, live, memory_.Address, size,
                        out stream_), "retarget");
                }
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>The next frame: local rotations (x y z w) and translations, in the parents' axes.</summary>
        public void Frame(float[] rotations, float[] translations, float[] outRotations, float[] outTranslations)
        {
            Expect(rotations, 4 * source_, nameof(rotations));
            Expect(translations, 3 * source_, nameof(translations));
            Expect(outRotations, 4 * target_, nameof(outRotations));
            Expect(outTranslations, 3 * target_, nameof(outTranslations));
            if (memory_.Address == IntPtr.Zero) throw new ObjectDisposedException(nameof(RetargetStream));
            using (var pins = new Pins())
            {
                Engine.Throw(Native.sinew_retarget_stream_frame(stream_, pins.Of(rotations), pins.Of(translations),
                    pins.Of(outRotations), pins.Of(outTranslations)), "retarget");
            }
        }

        /// <summary>Resets the stream: the next frame is its first.</summary>
        public void Restart()
        {
            if (memory_.Address == IntPtr.Zero) throw new ObjectDisposedException(nameof(RetargetStream));
            Engine.Throw(Native.sinew_retarget_stream_restart(stream_), "retarget");
        }

        public void Dispose()
        {
            if (memory_ != null) memory_.Dispose();
            kept_.Dispose();
        }

        static void Expect(float[] array, int length, string name)
        {
            if (array == null || array.Length != length) throw new ArgumentException(name + ": expected " + length + " numbers");
        }

        byte[] ClassesOf(IntPtr from, IntPtr to, IntPtr sources)
        {
            var classes = new byte[target_];
            UIntPtr size;
            Engine.Throw(Native.sinew_limb_classes_workspace_size((uint)target_, (uint)source_, out size), "retarget");
            using (var pins = new Pins())
            using (var workspace = new Block((long)size))
                Engine.Throw(Native.sinew_limb_classes(to, from, sources, workspace.Address, size, pins.Of(classes)), "retarget");
            return classes;
        }

        // The engine borrows it until the stream is disposed of.
        IntPtr BodyOf(Mesh mesh, Skin skin, string name)
        {
            if (mesh == null) return IntPtr.Zero;
            mesh.Check();
            if (mesh.FaceOffsets != null) throw new ArgumentException("StreamSettings." + name + ": expected triangles, found FaceOffsets");
            if (skin == null || skin.Joints.Length != skin.Influences * mesh.VertexCount || skin.Weights.Length != skin.Joints.Length)
                throw new ArgumentException("StreamSettings." + name + "Skin: expected a row for every vertex of " + name);
            return kept_.Of(new Native.sinew_motion_body
            {
                positions = kept_.Of(mesh.Positions), triangles = kept_.Of(mesh.FaceVertices),
                skin = new Native.sinew_skin
                {
                    joint_indices = kept_.Of(skin.Joints), weights = kept_.Of(skin.Weights), influence_count = (uint)skin.Influences
                },
                vertex_count = (uint)mesh.VertexCount, triangle_count = (uint)(mesh.FaceVertices.Length / 3)
            });
        }

        static class Options
        {
            internal static Native.sinew_retarget_options Plan(StreamSettings settings)
            {
                return new Native.sinew_retarget_options
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_retarget_options)),
                    in_place = settings.InPlace ? 1u : 0, scale = settings.Scale, arm_spread = settings.ArmSpread
                };
            }

            internal static Native.sinew_retarget_stream_options Live(StreamSettings settings, IntPtr moving)
            {
                return new Native.sinew_retarget_stream_options
                {
                    struct_size = (uint)Marshal.SizeOf(typeof(Native.sinew_retarget_stream_options)),
                    fps = settings.Fps, has_ground = settings.Ground.HasValue ? 1u : 0, ground = settings.Ground ?? 0,
                    without = (settings.Contacts ? 0 : Native.WITHOUT_CONTACTS) | (settings.Range ? 0 : Native.WITHOUT_RANGE),
                    source = moving
                };
            }
        }
    }
}
