// SPDX-License-Identifier: MIT
// Characters (Character.cs) of keypoints alone, as cameras and captures tell them, and the frames that come.
using System;

namespace Sinew
{
    public sealed partial class Character
    {
        int keypointJoints_ = -1;  // of KeypointsFrame(), once it was called

        /// <summary>Keypoints of a person's joints alone, as a motion: its skeleton is learned from these frames, which are its clip; a second or two are
        /// best. With its Skeleton as a RetargetStream's source, KeypointsFrame() makes what RetargetStream.Frame() takes.</summary>
        /// <param name="layout">"smpl24", "humanml3d22", "lafan22", "smplh52", "smplx55", "coco17", "h36m17", "h36m32", "kinect25", "openpose25" or "mediapipe33"</param>
        /// <param name="frames">[frames][3 x keypoints of the layout] any unit</param>
        public static Character OpenKeypoints(string layout, float[][] frames)
        {
            CheckLibrary();
            if (frames == null || frames.Length == 0 || frames[0] == null) throw new ArgumentException("frames: expected one or more");
            int length = frames[0].Length;
            var keypoints = new float[frames.Length * length];
            for (int f = 0; f < frames.Length; ++f)
            {
                if (frames[f] == null || frames[f].Length != length || length % 3 != 0)
                    throw new ArgumentException("frames: expected as many keypoints in each, three numbers a keypoint");
                frames[f].CopyTo(keypoints, f * length);
            }
            IntPtr handle;
            using (var pins = new Pins())
                Check(Native.sinew_character_open_keypoints(pins.Of(layout), pins.Of(keypoints), (uint)(length / 3), (uint)frames.Length, out handle),
                    IntPtr.Zero, "open");
            return new Character(handle);
        }

        /// <summary>Local rotations [4 x joints] and translations [3 x joints] in the frame of these keypoints [3 x keypoints].</summary>
        public void KeypointsFrame(float[] keypoints, float[] rotations, float[] translations)
        {
            if (keypointJoints_ < 0) keypointJoints_ = Skeleton.JointCount;
            int joints = keypointJoints_;
            if (keypoints == null || keypoints.Length % 3 != 0) throw new ArgumentException("keypoints: expected three numbers a keypoint");
            if (rotations == null || rotations.Length != 4 * joints) throw new ArgumentException("rotations: expected " + 4 * joints + " numbers");
            if (translations == null || translations.Length != 3 * joints)
                throw new ArgumentException("translations: expected " + 3 * joints + " numbers");
            using (var pins = new Pins())
                Check(Native.sinew_character_keypoints_frame(Handle, pins.Of(keypoints), (uint)(keypoints.Length / 3), pins.Of(rotations),
                    pins.Of(translations)), handle_, "keypoints");
        }
    }
}
