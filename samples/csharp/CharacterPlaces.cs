// SPDX-License-Identifier: MIT
// Characters (Character.cs) of places alone, as cameras and captures tell them, and the frames that come.
using System;

namespace Sinew
{
    public sealed partial class Character
    {
        int placesJoints_ = -1;  // of PlacesFrame(), once it was called

        /// <summary>Places of a person's joints alone, as a motion: its skeleton is learnt from these frames, which are its clip; a second or two are
        /// best. With its Skeleton as a RetargetStream's source, PlacesFrame() makes what RetargetStream.Frame() takes.</summary>
        /// <param name="layout">"smpl24", "humanml3d22", "coco17" or "mediapipe33"</param>
        /// <param name="frames">[frames][3 x places of the layout] any unit</param>
        public static Character OpenPlaces(string layout, float[][] frames)
        {
            CheckLibrary();
            if (frames == null || frames.Length == 0 || frames[0] == null) throw new ArgumentException("frames: expected one or more");
            int length = frames[0].Length;
            var places = new float[frames.Length * length];
            for (int f = 0; f < frames.Length; ++f)
            {
                if (frames[f] == null || frames[f].Length != length || length % 3 != 0)
                    throw new ArgumentException("frames: expected as many places in each, three numbers a place");
                frames[f].CopyTo(places, f * length);
            }
            IntPtr handle;
            using (var pins = new Pins())
                Check(Native.sinew_character_open_places(pins.Of(layout), pins.Of(places), (uint)(length / 3), (uint)frames.Length, out handle),
                    IntPtr.Zero, "open");
            return new Character(handle);
        }

        /// <summary>Local rotations [4 x joints] and translations [3 x joints] in the frame of these places [3 x places].</summary>
        public void PlacesFrame(float[] places, float[] rotations, float[] translations)
        {
            if (placesJoints_ < 0) placesJoints_ = Skeleton.JointCount;
            int joints = placesJoints_;
            if (places == null || places.Length % 3 != 0) throw new ArgumentException("places: expected three numbers a place");
            if (rotations == null || rotations.Length != 4 * joints) throw new ArgumentException("rotations: expected " + 4 * joints + " numbers");
            if (translations == null || translations.Length != 3 * joints)
                throw new ArgumentException("translations: expected " + 3 * joints + " numbers");
            using (var pins = new Pins())
                Check(Native.sinew_character_places_frame(Handle, pins.Of(places), (uint)(places.Length / 3), pins.Of(rotations),
                    pins.Of(translations)), handle_, "places");
        }
    }
}
