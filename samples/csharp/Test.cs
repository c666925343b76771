// SPDX-License-Identifier: MIT
// The binding against the C compiler's sizes, the command's weights, and what may go wrong.
//   Test.exe sizes                     prints sizes and offsets of every struct, for csharp_test.sh to compare
//   Test.exe bind MODEL NAME.obj       the hash of the weights, as sinew bind --json prints it
//   Test.exe rig MODEL NAME.obj        joints as lines: name, x, y, z, parent
//   Test.exe errors MODEL NAME.obj     checks what is refused, and progress
//   Test.exe character JOB IN OUT [MOTION]   a job of Character with its defaults, saved; 1 and the library's line where it fails
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Sinew;

static class Test
{
    static void Require(bool fine, string what)
    {
        if (!fine) throw new Exception("failed: " + what);
    }

    static void Sizes()
    {
        foreach (Type type in typeof(Native).GetNestedTypes())
        {
            if (!type.IsValueType || !type.Name.StartsWith("sinew_")) continue;
            Console.WriteLine("{0} {1}", type.Name, Marshal.SizeOf(type));
            foreach (var field in type.GetFields())
                Console.WriteLine("{0}.{1} {2}", type.Name, Regex.Replace(field.Name, "_([0-9]+)$", "[$1]"), Marshal.OffsetOf(type, field.Name));
        }
    }

    static Mesh ReadMesh(string path)
    {
        var positions = new List<float>();
        var corners = new List<uint>();
        var offsets = new List<uint> { 0 };
        foreach (string line in File.ReadLines(path))
        {
            string[] words = line.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length > 3 && words[0] == "v")
                for (int i = 1; i < 4; ++i) positions.Add((float)double.Parse(words[i], CultureInfo.InvariantCulture));
            if (words.Length > 3 && words[0] == "f")
            {
                for (int i = 1; i < words.Length; ++i) corners.Add(uint.Parse(words[i].Split('/')[0]) - 1);
                offsets.Add((uint)corners.Count);
            }
        }
        return new Mesh { Positions = positions.ToArray(), FaceVertices = corners.ToArray(), FaceOffsets = offsets.ToArray() };
    }

    static Skeleton ReadSkeleton(string path)
    {
        var names = new List<string>();
        var positions = new List<float>();
        var parents = new Dictionary<string, string>();
        foreach (string line in File.ReadLines(path))
        {
            string[] words = line.Split(' ');
            if (words[0] == "joints")
            {
                names.Add(words[1]);
                for (int i = 2; i < 5; ++i) positions.Add((float)double.Parse(words[i], CultureInfo.InvariantCulture));
            }
            if (words[0] == "hier") parents[words[2]] = words[1];
        }
        var above = new int[names.Count];
        for (int j = 0; j < above.Length; ++j) above[j] = parents.ContainsKey(names[j]) ? names.IndexOf(parents[names[j]]) : -1;
        return new Skeleton { Positions = positions.ToArray(), Parents = above, Names = names.ToArray() };
    }

    static string Hash(Skin skin)
    {
        ulong value = 1469598103934665603;
        foreach (ushort[] part in new[] { skin.Joints, skin.Weights })
            foreach (ushort number in part)
                foreach (int one in new[] { number & 255, number >> 8 }) value = (value ^ (ulong)one) * 1099511628211;
        return value.ToString("x16");
    }

    static void Expect<T>(string part, Action call) where T : Exception
    {
        try
        {
            call();
        }
        catch (T e)
        {
            Require(e.Message.Contains(part) && !(e is SinewException && e.Message.Contains("\n")), part + " in: " + e.Message);
            return;
        }
        Require(false, "expected " + typeof(T).Name + " with: " + part);
    }

    // A skeleton on itself, frame by frame, is itself; on its own body it stays on the floor.
    static void Stream(Mesh mesh, Skeleton skeleton, Skin skin)
    {
        int count = skeleton.JointCount;
        var map = new int[count];
        float[] rotations = new float[4 * count], translations = new float[3 * count], to = new float[4 * count], at = new float[3 * count];
        for (int j = 0; j < count; ++j)
        {
            map[j] = j;
            rotations[4 * j + 3] = 1;
            for (int i = 0; i < 3; ++i)
                translations[3 * j + i] = skeleton.Positions[3 * j + i] - (skeleton.Parents[j] < 0 ? 0 : skeleton.Positions[3 * skeleton.Parents[j] + i]);
        }
        var triangles = new Mesh { Positions = mesh.Positions, FaceVertices = new uint[] { 0, 1, 2 } };
        foreach (Mesh body in new[] { null, triangles })
        {
            var settings = new StreamSettings { Body = body, BodySkin = skin, SourceBody = body, SourceBodySkin = skin };
            using (var stream = new RetargetStream(skeleton, skeleton, map, settings))
            {
                stream.Frame(rotations, translations, to, at);
                stream.Restart();
                for (int i = 0; i < 3 * count; ++i) Require(Math.Abs(at[i] - translations[i]) < 1e-4, "a skeleton moves as itself");
                Expect<ArgumentException>("rotations", () => stream.Frame(new float[3], translations, to, at));
                translations[0] = float.NaN;
                Expect<SinewException>("retarget", () => stream.Frame(rotations, translations, to, at));
                translations[0] = skeleton.Positions[0];
                stream.Dispose();
                Expect<ObjectDisposedException>("RetargetStream", () => stream.Frame(rotations, translations, to, at));
            }
        }
        Expect<ArgumentException>("map", () => new RetargetStream(skeleton, skeleton, new int[1]));
        Expect<SinewException>("retarget", () => new RetargetStream(skeleton, skeleton, map, new StreamSettings { Fps = 0.1f }));
    }

    // A person that stands, then one that has moved aside.
    static void Keypoints()
    {
        float[] keypoints =
        {
            0, .95f, 0, .1f, .9f, 0, -.1f, .9f, 0, 0, 1.05f, 0, .1f, .5f, 0, -.1f, .5f, 0, 0, 1.2f, 0, .1f, .1f, 0, -.1f, .1f, 0, 0, 1.3f, 0,
            .1f, .02f, .1f, -.1f, .02f, .1f, 0, 1.5f, 0, .06f, 1.4f, 0, -.06f, 1.4f, 0, 0, 1.6f, 0, .2f, 1.4f, 0, -.2f, 1.4f, 0, .5f, 1.4f, 0,
            -.5f, 1.4f, 0, .75f, 1.4f, 0, -.75f, 1.4f, 0
        };
        using (Character person = Character.OpenKeypoints("humanml3d22", new[] { keypoints }))
        {
            int joints = person.Skeleton.JointCount;
            Require(joints == 22, "keypoints are joints");
            float[] rotations = new float[4 * joints], translations = new float[3 * joints];
            var aside = (float[])keypoints.Clone();
            for (int i = 0; i < aside.Length; i += 3) aside[i] += 1;
            person.KeypointsFrame(keypoints, rotations, translations);
            var before = (float[])rotations.Clone();
            Require(translations[0] == 0, "the hips are where they are");
            person.KeypointsFrame(aside, rotations, translations);
            Require(Math.Abs(translations[0] - 1) < 1e-5, "the hips go aside");
            for (int i = 0; i < 4 * joints; ++i) Require(Math.Abs(rotations[i] - before[i]) < 1e-5, "and nothing turns");
            Expect<ArgumentException>("rotations", () => person.KeypointsFrame(aside, new float[3], translations));
            Expect<SinewException>("expected 22 keypoints", () => person.KeypointsFrame(new float[6], rotations, translations));
        }
        Expect<SinewException>("h36m", () => Character.OpenKeypoints("h36m", new[] { keypoints }));
        Expect<ArgumentException>("frames", () => Character.OpenKeypoints("humanml3d22", new float[0][]));
    }

    // A tail that stays behind hips that move aside, and hangs as the pose has it when they have stood still.
    static void Springs(string robed)
    {
        using (Character person = Character.Open(robed))
        {
            int joints = person.Skeleton.JointCount;
            var rotations = new float[4 * joints];
            var translations = new float[3 * joints];
            for (int j = 0; j < joints; ++j)
            {
                rotations[4 * j + 3] = 1;
                int parent = person.Skeleton.Parents[j];
                for (int c = 0; c < 3; ++c)
                    translations[3 * j + c] = person.Skeleton.Positions[3 * j + c] - (parent < 0 ? 0 : person.Skeleton.Positions[3 * parent + c]);
            }
            float turned = 0;
            for (int frame = 0; frame < 30; ++frame)
            {
                var pose = (float[])rotations.Clone();
                person.SpringsFrame(1 / 30f, pose, translations);
                turned = 0;
                for (int j = 0; j < joints; ++j) turned = Math.Max(turned, 1 - Math.Abs(pose[4 * j + 3]));
                if (frame == 0) Require(turned == 0, "the first frame is as it is");
                for (int j = 0; j < joints; ++j)
                    if (person.Skeleton.Parents[j] < 0) translations[3 * j] += 0.05f;
            }
            Require(turned > 1e-3f, "the tail stays behind");
            person.SpringsRestart();
            var again = (float[])rotations.Clone();
            person.SpringsFrame(1 / 30f, again, translations);
            Require(again[3] == 1, "and forgets after a restart");
            Expect<ArgumentException>("rotations", () => person.SpringsFrame(0, new float[3], translations));
            Expect<SinewException>("seconds", () => person.SpringsFrame(-1, again, translations));
        }
    }

    static void Errors(byte[] file, Mesh mesh, Skeleton skeleton)
    {
        Expect<SinewException>("not a sinew model", () => Model.ForWeights(new byte[1000]));
        Expect<SinewException>("task", () => Model.ForSkeletons(file));
        byte[] damaged = (byte[])file.Clone();
        damaged[damaged.Length / 2] ^= 1;
        Expect<SinewException>("checksum", () => Model.ForWeights(damaged));
        using (Model model = Model.ForWeights(file))
        {
            float last = -1;
            int reports = 0;
            Skin plain = Engine.Bind(model, mesh, skeleton);
            Skin told = Engine.Bind(model, mesh, skeleton, new BindSettings
            {
                Progress = done =>
                {
                    Require(done >= last && done <= 1, "progress rises to 1");
                    last = done;
                    ++reports;
                    return false;
                }
            });
            Require(reports > 3 && Hash(plain) == Hash(told), "progress changes nothing");
            for (int v = 0; v < mesh.VertexCount; ++v)
            {
                int sum = 0;
                for (int i = 0; i < 4; ++i) sum += plain.Weights[4 * v + i];
                Require(sum == 65535, "rows sum to 65535");
            }
            Expect<CancelledException>("bind", () => Engine.Bind(model, mesh, skeleton, new BindSettings { Progress = d => d >= 0.5f }));
            Expect<InvalidOperationException>("mine", () => Engine.Bind(model, mesh, skeleton, new BindSettings
            {
                Progress = d => { throw new InvalidOperationException("mine"); }
            }));
            // A locked vertex keeps its row.
            var locked = new byte[mesh.VertexCount];
            locked[5] = 1;
            var keep = new Skin { Influences = 4, Joints = (ushort[])plain.Joints.Clone(), Weights = (ushort[])plain.Weights.Clone() };
            for (int i = 0; i < 4; ++i)
            {
                keep.Joints[20 + i] = 0;
                keep.Weights[20 + i] = (ushort)(i == 0 ? 65535 : 0);
            }
            Skin kept = Engine.Bind(model, mesh, skeleton, new BindSettings { Locked = locked, Keep = keep });
            Require(kept.Joints[20] == 0 && kept.Weights[20] == 65535, "a locked vertex keeps its row");
            Expect<ArgumentException>("Keep", () => Engine.Bind(model, mesh, skeleton, new BindSettings { Locked = locked }));
            Expect<ArgumentException>("Influences", () => Engine.Bind(model, mesh, skeleton, new BindSettings { Influences = 13 }));
            Expect<ArgumentException>("Positions", () => Engine.Bind(model, new Mesh { Positions = new float[4], FaceVertices = new uint[0] }, skeleton));
            Expect<ArgumentException>("Parents", () => Engine.Bind(model, mesh, new Skeleton()));
            var broken = new Mesh { Positions = (float[])mesh.Positions.Clone(), FaceVertices = mesh.FaceVertices, FaceOffsets = mesh.FaceOffsets };
            broken.Positions[7] = float.NaN;
            Expect<SinewException>("NaN", () => Engine.Bind(model, broken, skeleton));
            model.Dispose();
            Expect<ObjectDisposedException>("Model", () => Engine.Bind(model, mesh, skeleton));
            Stream(mesh, skeleton, plain);
        }
    }

    static int Job(string job, string input, string output, string other)
    {
        using (Character one = Character.Open(input))
        using (Character two = other == null ? null : Character.Open(other))
        {
            if (job == "bind") Console.WriteLine(one.Bind().Hash);
            if (job == "rig") one.Rig();
            if (job == "simplify") one.Simplify();
            if (job == "transfer") one.Transfer(two);
            if (job == "bake") one.Bake(new BakeSettings { Poses = 60, Shapes = 2 });
            if (job == "animate")
            {
                File.WriteAllText(output + ".map", one.Map(two).Text);
                Require(one.Animate(two).ClipCount == one.ClipCount && one.Clip(0).Rotations.Length > 0, "clips");
            }
            one.Save(output);
            Require(one.Write(Path.GetFileName(output))[0].Bytes.Length == new FileInfo(output).Length, "Write() is Save() in memory");
            if (job != "bind" || one.Skin == null) return 0;
            // Arrays out and in: the same weights again.
            using (Character again = Character.Create(one.Mesh, one.Skeleton))
            {
                again.SetSkin(one.Skin);
                Require(Hash(again.Skin) == Hash(one.Skin), "arrays make the same character");
                Require(again.JointClasses.Length == again.Skeleton.JointCount, "classes");
                using (Character posed = one.Pose(new PoseSettings { Angles = new double[3 * one.Skeleton.JointCount] }))
                    Require(posed.Mesh.VertexCount == one.Mesh.VertexCount, "a pose");
            }
            Expect<CancelledException>("bind", () => one.Bind(new CharacterBindSettings { Progress = d => true }));
            Expect<ArgumentException>("Locked", () => one.Bind(new CharacterBindSettings { Locked = new byte[1] }));
            return 0;
        }
    }

    // Placed, bound and saved as `bind --turn y --height 2 --floor --controls` does; then two levels of detail, LEVEL1 and LEVEL2.
    static int Deliver(string input, string output, string[] levelFiles)
    {
        using (Character one = Character.Open(input))
        {
            one.Transform(new TransformSettings { Turns = new[] { "y" }, Height = 2, Floor = true });
            one.Bind();
            one.SetProfile(new ProfileSettings { Controls = true });
            one.Save(output);
            File.WriteAllText(output + ".json", one.Controls);
            CheckResult told = one.Check(new CheckSettings { Poses = false, Score = true });
            Require(told.Line.StartsWith("checked: ") && told.Score > 0 && told.Score <= 100, "a check says its line and a score: " + told.Line);
            Require(one.Check(new CheckSettings { Poses = false }).Score == null, "no score where none is asked for");
            var bounds = new Dictionary<string, double> { { "speck", -1 }, { "far-weight", -1 } };
            CheckResult strict = one.Check(new CheckSettings { Poses = false, Bounds = bounds });
            Require(strict.Findings.Length > told.Findings.Length, "bounds of the user's own");
            foreach (Finding finding in strict.Findings)
                Require(Array.IndexOf(Character.CheckRules, finding.Rule) >= 0 && finding.What != "" && finding.Position.Length == 3, "a finding says what and where");
            Expect<SinewException>("unknown rule", () => one.Check(new CheckSettings { Bounds = new Dictionary<string, double> { { "none", 1 } } }));
            Expect<SinewException>("expected x, y, z", () => one.Transform(new TransformSettings { Turns = new[] { "up" } }));
            Expect<SinewException>("unknown profile", () => one.SetProfile(new ProfileSettings { Profile = "none" }));
            Require(Array.IndexOf(Character.Profiles, "mixamo") >= 0, "profiles");
        }
        using (Character one = Character.Open(output))
        {
            LevelOfDetail[] levels = one.Levels(levelFiles.Length);
            for (int i = 0; i < levels.Length; ++i)
            {
                levels[i].Character.Save(levelFiles[i]);
                levels[i].Character.Dispose();
                Require(levels[i].PosedError >= levels[i].RestError && levels[i].MeanError > 0, "figures of a level");
                Require(i == 0 || levels[i].TriangleCount < levels[i - 1].TriangleCount, "fewer triangles");
            }
            Expect<ArgumentException>("levels", () => one.Levels(9));
        }
        return 0;
    }

    // The clip of its class, then the outline that was found as a user's own, cut at the middle.
    static int Picture(string input, string output)
    {
        using (Character one = Character.OpenPicture(input, new PictureSettings { Pixels = true, BodyClass = BodyClass.Biped }))
        {
            Require(one.Picture.BodyClass == BodyClass.Found && one.Picture.Width > 0, "not rigged yet");
            Require(one.Animate(null).ClipCount == 1, "a clip of its class");
            Require(one.Picture.BodyClass == BodyClass.Biped && one.Picture.View == PictureView.Front, "class and view");
            one.Save(output);
            float[][] outline = one.Picture.Outline;
            foreach (float[] line in outline)
                for (int i = 0; i < line.Length; i += 2) line[i] = Math.Max(line[i], one.Picture.Width / 2);
            using (Character half = Character.OpenPicture(input, new PictureSettings { Outline = outline }))
                Require(half.Mesh.VertexCount > 100, "an outline of the user's own");
        }
        Expect<SinewException>("figure", () => Character.OpenPicture(input, new PictureSettings { Figure = 2 }));
        return 0;
    }

    static int Main(string[] args)
    {
        try
        {
            if (args[0] == "sizes")
            {
                Sizes();
                return 0;
            }
            if (args[0] == "picture") return Picture(args[1], args[2]);
            if (args[0] == "deliver") return Deliver(args[1], args[2], new[] { args[3], args[4] });
            if (args[0] == "character") return Job(args[1], args[2], args[3], args.Length > 4 ? args[4] : null);
            byte[] file = File.ReadAllBytes(args[1]);
            Mesh mesh = ReadMesh(args[2]);
            if (args[0] == "rig")
            {
                using (Model model = Model.ForSkeletons(file))
                {
                    RiggedSkeleton rig = Engine.Rig(model, mesh);
                    for (int j = 0; j < rig.Skeleton.JointCount; ++j)
                        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "joints {0} {1:F8} {2:F8} {3:F8}", rig.Skeleton.Names[j],
                            rig.Skeleton.Positions[3 * j], rig.Skeleton.Positions[3 * j + 1], rig.Skeleton.Positions[3 * j + 2]));
                }
                return 0;
            }
            Skeleton skeleton = ReadSkeleton(Path.ChangeExtension(args[2], ".rig.txt"));
            if (args[0] == "errors")
            {
                Keypoints();
                Springs(args[2]);
                Errors(file, mesh, skeleton);
                Console.WriteLine("errors and progress: as they should be, sinew {0}", Engine.Version);
                return 0;
            }
            using (Model model = Model.ForWeights(file)) Console.WriteLine(Hash(Engine.Bind(model, mesh, skeleton)));
            return 0;
        }
        catch (Exception e)
        {
            Console.Error.WriteLine("{0}: {1}", e.GetType().Name, e.Message);
            return 1;
        }
    }
}
