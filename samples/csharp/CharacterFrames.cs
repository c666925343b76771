// SPDX-License-Identifier: MIT
// Motion that arrives frame by frame: keypoints as a camera records them, and springs that swing behind any pose.
using System;

namespace Sinew
{
    public sealed partial class Character
    {
        int frameJoints_ = -1;  // joint count, once a frame arrived

        void CheckPose(float[] rotations, float[] translations)
        {
            if (frameJoints_ < 0) frameJoints_ = Skeleton.JointCount;
            if (rotations == null || rotations.Length != 4 * frameJoints_)
                throw new ArgumentException("rotations: expected " + 4 * frameJoints_ + " numbers");
            if (translations == null || translations.Length != 3 * frameJoints_)
                throw new ArgumentException("translations: expected " + 3 * frameJoints_ + " numbers");
        }

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
            if (keypoints == null || keypoints.Length % 3 != 0) throw new ArgumentException("keypoints: expected three numbers a keypoint");
            CheckPose(rotations, translations);
            using (var pins = new Pins())
                Check(Native.sinew_character_keypoints_frame(Handle, pins.Of(keypoints), (uint)(keypoints.Length / 3), pins.Of(rotations),
                    pins.Of(translations)), handle_, "keypoints");
        }

        /// <summary>Swings the joints of chains behind the next frame of a motion. The springs are those of Springs(), or those that it would keep. The
        /// first frame shows the pose as it is.</summary>
        /// <param name="seconds">since the frame before; ignored in the first frame</param>
        /// <param name="rotations">[4 x joints] local, as RetargetStream.Frame() writes them; changed in place</param>
        /// <param name="translations">[3 x joints]</param>
        public void SpringsFrame(float seconds, float[] rotations, float[] translations)
        {
            CheckPose(rotations, translations);
            using (var pins = new Pins())
            {
                IntPtr pose = pins.Of(rotations);
                Check(Native.sinew_character_springs_frame(Handle, seconds, pose, pins.Of(translations), pose), handle_, "springs");
            }
        }

        /// <summary>Forgets all motion: the next SpringsFrame() is the first.</summary>
        public void SpringsRestart() { Check(Native.sinew_character_springs_restart(Handle), handle_, "springs"); }
    }
}
