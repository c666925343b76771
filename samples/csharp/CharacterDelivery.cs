// SPDX-License-Identifier: MIT
// Output of characters (Character.cs) for other programs: names of profiles and rules, controls, levels of detail.
// sinew/character.h is the reference.
using System;
using System.Runtime.InteropServices;

namespace Sinew
{
    /// <summary>A copy with fewer triangles, and its error relative to the whole character, in shares of the height.</summary>
    public sealed class LevelOfDetail
    {
        public Character Character;
        public int TriangleCount;
        /// <summary>Largest distance at rest; the largest and the mean in the worst test pose.</summary>
        public double RestError, PosedError, MeanError;
    }

    public sealed partial class Character
    {
        /// <summary>Names for ProfileSettings.Profile.</summary>
        public static string[] Profiles { get { return Text(Native.sinew_character_profiles()).Split(' '); } }

        /// <summary>Joints of an animator's controls: JSON (formats/spec/controls.md) of the skeleton as it would be saved, as `--controls`
        /// writes it.</summary>
        public string Controls
        {
            get
            {
                var text = new IntPtr[1];
                using (var pins = new Pins()) Check(Native.sinew_character_controls(Handle, pins.Of(text)), handle_, "controls");
                return Text(text[0]);
            }
        }

        /// <summary>Copies of a bound character with fewer and fewer triangles, each to be disposed of.</summary>
        /// <param name="levels">1 to 8</param>
        /// <param name="ratio">triangles of a level as a share of the level before, 0.05 to 0.95</param>
        /// <param name="fewerJoints">reduces joints: level 2 as Simplify(), later ones as its low level</param>
        public LevelOfDetail[] Levels(int levels = 3, double ratio = 0.5, bool fewerJoints = false)
        {
            if (levels < 1 || levels > Native.MAX_LOD_LEVELS) throw new ArgumentException("levels: expected 1 to " + Native.MAX_LOD_LEVELS);
            var handles = new IntPtr[levels];
            var figures = new Native.sinew_character_lod_level[levels];
            using (var pins = new Pins())
                Check(Native.sinew_character_lod(Handle, pins.Of(new Native.sinew_character_lod_options
                {
                    struct_size = Size<Native.sinew_character_lod_options>(), level_count = (uint)levels, ratio = ratio, fewer_joints = fewerJoints ? 1u : 0
                }), pins.Of((object)handles), pins.Of(figures)), handle_, "lod");
            var result = new LevelOfDetail[levels];
            for (int i = 0; i < levels; ++i)
                result[i] = new LevelOfDetail
                {
                    Character = new Character(handles[i]), TriangleCount = (int)figures[i].triangle_count, RestError = figures[i].rest_error,
                    PosedError = figures[i].posed_error, MeanError = figures[i].mean_error
                };
            return result;
        }

        /// <summary>Names for CheckSettings.Bounds.</summary>
        public static string[] CheckRules { get { return Text(Native.sinew_character_check_rules()).Split(' '); } }
    }
}
