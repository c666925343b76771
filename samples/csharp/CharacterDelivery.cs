// SPDX-License-Identifier: MIT
// Of characters (Character.cs) what another program and a pipeline ask for: where they stand, profiles, controls, levels of detail, whether
// the rig holds. sinew/character.h is the reference.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Sinew
{
    /// <summary>`--turn`, `--height` and `--floor`, in this order.</summary>
    public sealed class PlaceSettings
    {
        /// <summary>Quarters about the origin, one after the other: "x", "-x", "y", ...</summary>
        public string[] Turns = new string[0];
        /// <summary>Metres along up; 0: as it is.</summary>
        public double Height;
        /// <summary>The lowest vertex is at 0 along up.</summary>
        public bool Floor;
        /// <summary>Afterwards; Auto: y.</summary>
        public Up Up;
    }

    /// <summary>`--for`: what another program wants of a file.</summary>
    public sealed class ProfileSettings
    {
        /// <summary>One of Character.Profiles; null: files as they were read.</summary>
        public string Profile;
        /// <summary>Axes, names and roots of the skeleton stay as they are.</summary>
        public bool KeepAxes;
        /// <summary>A glTF says in its extras what Character.Controls says.</summary>
        public bool Controls;
        /// <summary>Of a VRM, which has an author at least; Licence in the words of its format, null: nothing is allowed.</summary>
        public string[] Authors = new string[0];
        public string Licence, Title;
    }

    /// <summary>A copy with fewer triangles, and how far it is from the whole character, shares of the height.</summary>
    public sealed class LevelOfDetail
    {
        public Character Character;
        public int TriangleCount;
        /// <summary>Largest distance at rest; the largest and the mean in the worst of the poses that bodies are bent in.</summary>
        public double RestError, PosedError, MeanError;
    }

    /// <summary>`sinew check`.</summary>
    public sealed class CheckSettings
    {
        /// <summary>The mesh is not posed; animations are not looked at.</summary>
        public bool NoPoses, NoClips;
        /// <summary>Also how near the weights are to those of three methods.</summary>
        public bool Score;
        /// <summary>Rules that get other bounds than the library's; or null.</summary>
        public Dictionary<string, double> Bounds;
    }

    /// <summary>Something that is wrong with a rig.</summary>
    public sealed class Finding
    {
        /// <summary>Rule: one of Character.CheckRules. Pose, Clip: in which it shows, "" for none.</summary>
        public string Rule, What, Cure, Pose, Clip;
        public CheckSeverity Severity;
        /// <summary>What was measured, and above which it is a finding; Seconds: in the clip.</summary>
        public double Value, Bound, Seconds;
        /// <summary>That it is about, and that it is compared with; -1: none. Mesh: where all its vertices lie in one, or -1.</summary>
        public int Joint, Other, Mesh;
        /// <summary>Ascending; empty where it is about joints or clips.</summary>
        public int[] Vertices;
        /// <summary>Where to look, x y z, and how far around it, the mesh's units.</summary>
        public float[] Position;
        public float Radius;
    }

    public sealed class CheckResult
    {
        /// <summary>Errors first.</summary>
        public Finding[] Findings;
        /// <summary>"checked: 0 findings"</summary>
        public string Line;
        /// <summary>0 to 100; null where it was not asked for.</summary>
        public double? Score;
    }

    public sealed partial class Character
    {
        /// <summary>Turns and scales the character as a whole: mesh, joints, the file's own animations. Weights stay.</summary>
        public void Place(PlaceSettings settings)
        {
            using (var pins = new Pins())
                Check(Native.sinew_character_place(Handle, pins.Of(new Native.sinew_character_place_options
                {
                    struct_size = Size<Native.sinew_character_place_options>(), turn_count = (uint)settings.Turns.Length, turns = pins.Of(settings.Turns),
                    height = settings.Height, floor = One(settings.Floor), up = (uint)settings.Up
                })), handle_, "place");
        }

        /// <summary>What Save() and Write() write from now on. The rest pose stays: that is ToPose of Bind() and Rig().</summary>
        public void SetProfile(ProfileSettings settings)
        {
            using (var pins = new Pins())
                Check(Native.sinew_character_set_profile(Handle, pins.Of(new Native.sinew_character_profile_options
                {
                    struct_size = Size<Native.sinew_character_profile_options>(), keep_axes = One(settings.KeepAxes), profile = pins.Of(settings.Profile),
                    licence = pins.Of(settings.Licence), title = pins.Of(settings.Title), author_count = (uint)settings.Authors.Length,
                    authors = pins.Of(settings.Authors), controls = One(settings.Controls)
                })), handle_, "profile");
        }

        /// <summary>Names for ProfileSettings.Profile.</summary>
        public static string[] Profiles { get { return Text(Native.sinew_character_profiles()).Split(' '); } }

        /// <summary>Which joints an animator's controls move: JSON (formats/spec/controls.md) of the skeleton as it would be saved, as `--controls`
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
        /// <param name="ratio">triangles of a level, as a share of the one before, 0.05 to 0.95</param>
        /// <param name="fewerJoints">level 2 has the joints of Simplify(), further ones of its low level</param>
        public LevelOfDetail[] Levels(int levels = 3, double ratio = 0.5, bool fewerJoints = false)
        {
            if (levels < 1 || levels > Native.MAX_LOD_LEVELS) throw new ArgumentException("levels: expected 1 to " + Native.MAX_LOD_LEVELS);
            var handles = new IntPtr[levels];
            var figures = new Native.sinew_character_lod_level[levels];
            using (var pins = new Pins())
                Check(Native.sinew_character_lod(Handle, pins.Of(new Native.sinew_character_lod_options
                {
                    struct_size = Size<Native.sinew_character_lod_options>(), level_count = (uint)levels, ratio = ratio, fewer_joints = One(fewerJoints)
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

        /// <summary>What is wrong with the skeleton, the weights, the matrices and the animations. Changes nothing.</summary>
        public CheckResult Check(CheckSettings settings = null)
        {
            settings = settings ?? new CheckSettings();
            var bounds = settings.Bounds ?? new Dictionary<string, double>();
            var rules = new List<string>(bounds.Keys);
            using (var pins = new Pins())
            {
                IntPtr at = pins.Of(new Native.sinew_character_check_result { struct_size = Size<Native.sinew_character_check_result>() });
                Check(Native.sinew_character_check(Handle, pins.Of(new Native.sinew_character_check_options
                {
                    struct_size = Size<Native.sinew_character_check_options>(), no_poses = One(settings.NoPoses), no_clips = One(settings.NoClips),
                    score = One(settings.Score), bound_count = (uint)rules.Count, bound_rules = pins.Of(rules.ToArray()),
                    bounds = pins.Of(rules.ConvertAll(rule => bounds[rule]).ToArray())
                }), at), handle_, "check");
                var told = Read<Native.sinew_character_check_result>(at);
                var findings = new Finding[told.finding_count];
                int size = Marshal.SizeOf(typeof(Native.sinew_character_finding));
                for (int i = 0; i < findings.Length; ++i)
                    findings[i] = FindingOf(Read<Native.sinew_character_finding>(new IntPtr(told.findings.ToInt64() + i * size)));
                return new CheckResult { Findings = findings, Line = Text(told.line), Score = settings.Score ? told.score : (double?)null };
            }
        }

        /// <summary>Names for CheckSettings.Bounds.</summary>
        public static string[] CheckRules { get { return Text(Native.sinew_character_check_rules()).Split(' '); } }

        static Finding FindingOf(Native.sinew_character_finding f)
        {
            return new Finding
            {
                Rule = Text(f.rule), What = Text(f.what), Cure = Text(f.cure), Pose = Text(f.pose), Clip = Text(f.clip),
                Severity = (CheckSeverity)f.severity, Value = f.value, Bound = f.bound, Seconds = f.seconds, Joint = f.joint, Other = f.other,
                Mesh = f.mesh, Vertices = Ints(f.vertices, f.vertex_count), Position = new[] { f.position_0, f.position_1, f.position_2 },
                Radius = f.radius
            };
        }
    }
}
