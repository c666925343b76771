// SPDX-License-Identifier: MIT
// The sinew command as a user meets it: every subcommand on the sample data, wrong usage, rubbish input, outputs left
// alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

TEST_F(Cli, KernelFromTheEnvironmentChangesNoByteAndRubbishIsRefused) {
  const auto bind = [&](const std::string& kernel, const std::string& file) {
    ASSERT_EQ(setenv("SINEW_KERNEL", kernel.c_str(), 1), 0);
    good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o " + file);
  };
  bind("", "auto.rig.txt");
  bind("ref", "ref.rig.txt");
  EXPECT_EQ(slurp(in("auto.rig.txt")), slurp(in("ref.rig.txt")));
  setenv("SINEW_KERNEL", "avx1024", 1);
  const Outcome outcome = bad(1, "bind " + kSnake + " --skeleton " + kSnakeRig + " -o no.rig.txt");
  unsetenv("SINEW_KERNEL");
  EXPECT_NE(outcome.error.find("SINEW_KERNEL=avx1024"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("auto, ref"), std::string::npos) << outcome.error;
}

TEST_F(Cli, HelpHasAnExampleEverywhere) {
  for (const char* command : {"", "bind", "eval", "train", "quantize", "dataset", "dataset check", "dataset stats",
                              "dataset dedup", "dataset split", "dataset target", "dataset convert", "dataset decimate",
                              "dataset synthesize", "inspect", "pose"}) {
    const Outcome outcome = good(std::string(command) + " --help");
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << command;
    EXPECT_NE(outcome.out.find(program_of(command) + " " + command), std::string::npos) << command;
    EXPECT_EQ(outcome.error, "") << command;
  }
  EXPECT_EQ(good("--version").out.rfind("sinew ", 0), 0u);
}

TEST_F(Cli, AnUnknownCommandIsNamed) {
  EXPECT_NE(bad(2, "frob").error.find("no such command: frob; see sinew --help"), std::string::npos);
  EXPECT_NE(bad(2, "dataset frob").error.find("no such command: dataset frob; see sinew-lab dataset --help"),
            std::string::npos);
}

TEST_F(Cli, CrossvalComparesAndRefuses) {
  const std::string family =
      R"({"family":"a","group":"a","fold":1,"characters":1,"l1":0.2,"argmax":0.9,"distance":0.1,)"
      R"("heat_l1":0.4,"heat_argmax":0.8,"heat_distance":0.2})";
  put(folder_ / "a.json", R"({"crossval":1,"label":"wide","config":{},"folds":2,"apart":[],"seeds":[{"seed":1,)"
                          R"("families":[)" +
                              family + R"(],"val":[]}]})");
  EXPECT_NE(good("crossval --compare a.json a.json").out.find("| wide | 1 | 0.2000 | 50.0 % |"), std::string::npos);
  bad(2, "crossval");
  bad(2, "crossval " + kData + " --folds 1");
  bad(2, "crossval " + kData + " --steps 5 --minutes 1");
  bad(2, "crossval " + kData + " --compare a.json");
  bad(1, "crossval --compare none.json");
  EXPECT_NE(bad(1, "crossval " + kData + " --folds 9").error.find("9 folds need at least as many groups"),
            std::string::npos);
  bad(2, "train " + kData + " --cache-only");
  bad(2, "train " + kData + " --cache-only --cache c --shard 0/2");
  bad(2, "train " + kData + " --cache c --shard 1/2 -o a.ckpt");
}

TEST_F(Cli, WrongUsageExitsTwoAndWritesNothing) {
  const std::string pair = kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  const std::vector<std::string> wrong = {
      "",
      "nonsense",
      "bind",
      "bind " + pair + "--nonsense",
      "bind " + pair + "--influences 0",
      "bind " + pair + "--influences 13",
      "bind " + pair + "--influences many",
      "bind " + pair + "--up x",
      "bind " + pair + "-o out.dae",
      "bind " + pair + "-o out",
      "bind " + pair + "--png out.jpg",
      "bind " + pair + "--png -",
      "bind " + pair + "--model m.sinew",
      "bind " + pair + "-o - --json",
      "bind " + kSnakeRig + " --skeleton " + kSnake,
      "bind " + kSnake + " --skeleton " + kSnake,
      "bind " + kSnake + " " + kSnakeRig,
      "bind " + pair + "--threads 0",
      "eval",
      "eval " + kData + " --method magic",
      "eval " + kData + " --method heat --model x",
      "eval " + kData + " --method heat --report r.txt",
      "eval " + kData + " --method heat -o r.txt",
      "eval " + kData + " --checkpoint x --known",
      "eval " + kData + " --checkpoint x --rigid-parts always",
      "eval " + kData + " --method nearest --rigid-parts never",
      "eval " + kData + " --method heat --softness 2",
      "eval " + kData + " --method heat --rigid-parts often",
      "eval " + kData + " --method heat --jobs 0",
      "eval confidence " + kData + " --checkpoint x",
      "eval confidence " + kData + " --method heat --model x",
      "bind " + pair + "--png-confidence out.jpg",
      "train",
      "train " + kData,
      "train " + kData + " -o x.doc",
      "train " + kData + " -o x.ckpt --resume --init y.ckpt",
      "train " + kData + " -o x.ckpt --minutes -1",
      "quantize",
      "quantize x",
      "quantize x --calibrate " + kData,
      "quantize x --calibrate " + kData + " -o m.bin",
      "dataset",
      "dataset nonsense",
      "dataset check",
      "dataset stats",
      "dataset convert " + kSnake,
      "dataset convert " + kSnake + " x.stl",
      "dataset decimate " + kSnake + " x.obj",
      "dataset decimate " + kSnake + " x.obj --ratio 2",
      "dataset synthesize",
      "dataset synthesize --plan dragon -o x",
      "dataset synthesize --count 2 --plan bird -o x.obj",
      "dataset synthesize -o x.obj",
      "dataset synthesize --resolution 8 -o x",
      "inspect",
      "pose",
      "pose " + kSnake + " -o x.obj",
      "pose " + kSnake + " --random 1",
      "pose " + kSnake + " --random 1 -o x.glb",
      "pose " + kSnake + " --random 1 --joint head=0,0,0 -o x.obj",
      "pose " + kSnake + " --random 1 --matrices a.pose -o x.obj",
      "pose " + kSnake + " --random 1 --deform melt -o x.obj",
      "pose " + kSnake + " --random 1 --deform none -o x.obj",
      "pose " + kSnake + " --random 1 --deform volume --cells 3 -o x.obj",
      "pose " + kSnake + " --random 1 --cells 32 -o x.obj",
      "pose " + kSnake + " --random 1 --body-contact -o x.obj",
      "pose " + kSnake + " --random 1 --deform delta-mush --body-contact -o x.obj",
      "pose " + kSnake + " --random 1 --deform volume --no-smoothing -o x.obj",
      "pose " + kSnake + " --random 1 --deform volume --stiffness 1 -o x.obj",
      "pose " + kSnake + " --random 1 --deform xpbd --stiffness 0 -o x.obj",
      "pose " + kSnake + " --random 1 --deform xpbd --tet-weights bone -o x.obj",
      "pose " + kSnake + " --random 1 --deform volume --as-drawn -o x.obj",
      "pose " + kSnake + " --random 1 --deform xpbd --as-drawn --body-contact -o x.obj",
      "animate " + kSnake + " --motion builtin:walk --as-drawn -o x.glb",
      "pose " + kSnake + " --joint head=1,2 -o x.obj",
      "pose " + kSnake + " --joint head -o x.obj",
      "pose " + kSnake + " --joint head=1,2,3x -o x.obj",
      "pose " + kSnake + " --joint head=1,2,nan -o x.obj"};
  for (const std::string& arguments : wrong) {
    const Outcome outcome = bad(2, arguments);
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.error.find("--help"), std::string::npos) << arguments;
  }
  EXPECT_EQ(files(), 0u);
  EXPECT_NE(bad(2, "bind " + kSnakeRig + " --skeleton " + kSnake).error.find("mesh first"), std::string::npos);
}

TEST_F(Cli, BindWritesWhatIsAsked) {
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  good(pair);
  EXPECT_TRUE(fs::exists(in("snake__long.bound.glb")));
  good(pair + "-o out.rig.txt --png view.png --influences 2");
  EXPECT_EQ(slurp(in("view.png")).substr(1, 3), "PNG");
  Character character = read_obj(kSnake);
  read_skeleton(in("out.rig.txt"), true, &character);
  expect_bound(character, 2);

  const Outcome json = good(pair + "-o out.glb --json");
  for (const char* key :
       {"\"vertices\": 850", "\"joints\": 18", "\"seconds\"", "\"workspace_bytes\"", "\"influences\": 4", "out.glb"}) {
    EXPECT_NE(json.out.find(key), std::string::npos) << key << "\n" << json.out;
  }
  expect_bound(read_character(in("out.glb")), 4);
  good(pair + "-o text.gltf");
  EXPECT_TRUE(fs::exists(in("text.bin")));
  expect_bound(read_character(in("text.gltf")), 4);
  EXPECT_NE(bad(1, pair + "-o out.vrm").error.find("VRM"), std::string::npos);
  EXPECT_NE(bad(2, pair + "-o out.dae").error.find("write .glb"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("out.vrm")));
}

TEST_F(Cli, BindTellsWhatTheReaderLeftOut) {
  put(in("snake.obj"), "mtllib gone.mtl\nusemtl scales\n" + slurp(kSnake));
  const std::string bind = "bind snake.obj --skeleton " + kSnakeRig + " --method heat ";
  EXPECT_NE(good(bind).out.find("'gone.mtl' were not found"), std::string::npos);
  EXPECT_NE(good(bind + "--json").out.find("\"notes\""), std::string::npos);
}

TEST_F(Cli, BindReadsAndWritesStreams) {
  const Outcome direct = good("bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat -o out.rig.txt");
  const Outcome stream = good("bind - --skeleton " + kSnakeRig + " --method heat -o -", slurp(kSnake));
  EXPECT_TRUE(stream.out == slurp(in("out.rig.txt")));
  EXPECT_NE(stream.error.find("850 vertices"), std::string::npos) << "the summary goes to stderr";
}

TEST_F(Cli, BindTakesTheSkeletonOfAGltf) {
  good("bind " + kCaped + " --method heat -o out.glb");
  const Character before = read_character(kCaped), after = read_character(in("out.glb"));
  EXPECT_EQ(before.joints.size(), after.joints.size());
  expect_bound(after, 4);
  good("bind " + in("out.glb") + " --method heat -o again.glb");
  expect_bound(read_character(in("again.glb")), 4);
}

TEST_F(Cli, ThreadsDoNotChangeBytes) {
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  good(pair + "--threads 1 -o one.glb");
  good(pair + "--threads 4 -o four.glb");
  EXPECT_TRUE(slurp(in("one.glb")) == slurp(in("four.glb")));
}

TEST_F(Cli, BindObeysJointAndVertexLists) {
  Character truth = read_character(kSnake);
  put(in("never.txt"), "# not these\nspine_3\n  spine_4 \r\n");
  put(in("deform.txt"), "spine_1\nspine_6\n");
  put(in("lock.txt"), "0\n5\n849\n");
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  const auto joint = [&](const std::string& name) {
    for (uint32_t j = 0; j < truth.joints.size(); ++j) {
      if (truth.joints[j].name == name) return j;
    }
    return 0xFFFFFFFFu;
  };
  const auto bound = [&](const std::string& file) {
    Character character = read_obj(kSnake);
    read_skeleton(in(file), true, &character);
    return character.influences;
  };
  good(pair + "--never never.txt -o never.rig.txt");
  for (const auto& row : bound("never.rig.txt")) {
    for (const Influence& i : row) ASSERT_TRUE(i.joint != joint("spine_3") && i.joint != joint("spine_4"));
  }
  good(pair + "--joints deform.txt -o deform.rig.txt");
  for (const auto& row : bound("deform.rig.txt")) {
    for (const Influence& i : row) ASSERT_TRUE(i.joint == joint("spine_1") || i.joint == joint("spine_6"));
  }
  good(pair + "--lock lock.txt -o lock.rig.txt");
  const auto locked = bound("lock.rig.txt");
  for (size_t v : {0u, 5u, 849u}) {
    ASSERT_EQ(locked[v].size(), truth.influences[v].size()) << v;
    for (size_t i = 0; i < locked[v].size(); ++i) {
      EXPECT_EQ(locked[v][i].joint, truth.influences[v][i].joint);
      EXPECT_NEAR(locked[v][i].weight, truth.influences[v][i].weight, 2e-5f);
    }
  }
  good(pair + "--lock all -o kept.rig.txt");
  const auto kept = bound("kept.rig.txt");
  for (size_t v = 0; v < kept.size(); ++v) {
    ASSERT_EQ(kept[v].size(), truth.influences[v].size()) << v;
    for (const Influence& own : truth.influences[v]) {
      const auto found = std::find_if(kept[v].begin(), kept[v].end(), [&](auto& i) { return i.joint == own.joint; });
      // Rows are whole 65535ths; the strongest of up to four gets what is left.
      ASSERT_TRUE(found != kept[v].end() && std::abs(found->weight - own.weight) < 4.0f / 65535) << v;
    }
  }
  put(in("bad_joint.txt"), "spine_1\nelbow\n");
  EXPECT_NE(bad(1, pair + "--joints bad_joint.txt").error.find("line 2"), std::string::npos);
  put(in("bad_vertex.txt"), "850\n");
  EXPECT_NE(bad(1, pair + "--lock bad_vertex.txt").error.find("0..849"), std::string::npos);
  put(in("negative.txt"), "-1\n");
  bad(1, pair + "--lock negative.txt");
}

TEST_F(Cli, BindTakesHints) {
  const Character truth = read_character(kSnake);
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  Character painted = truth;
  for (size_t v = 0; v < painted.influences.size(); ++v) {
    painted.influences[v].clear();
    if (v % 20 == 0) painted.influences[v].push_back({0, 1.0f});
  }
  write_rig(in("painted.rig.txt"), painted);
  good(pair + "-o plain.rig.txt");
  good(pair + "--hints painted.rig.txt -o hinted.rig.txt");
  const auto weight_of_0 = [&](const std::string& file, bool hinted) {
    Character c = read_obj(kSnake);
    read_skeleton(in(file), true, &c);
    double sum = 0;
    for (size_t v = 0; v < c.influences.size(); ++v) {
      if ((v % 20 == 0) != hinted) continue;
      for (const Influence& i : c.influences[v]) sum += i.joint == 0 ? static_cast<double>(i.weight) : 0;
    }
    return sum;
  };
  EXPECT_NEAR(weight_of_0("hinted.rig.txt", true), static_cast<double>((truth.vertices.size() + 19) / 20), 1e-3);
  EXPECT_GT(weight_of_0("hinted.rig.txt", false), weight_of_0("plain.rig.txt", false) + 50.0);

  for (auto& row : painted.influences) row.clear();
  write_rig(in("empty.rig.txt"), painted);
  EXPECT_NE(bad(1, pair + "--hints empty.rig.txt").error.find("has weights of no vertex"), std::string::npos);
  painted.influences[3].push_back({0, 1.0f});
  painted.joints[0].name = "elsewhere";
  write_rig(in("stranger.rig.txt"), painted);
  EXPECT_NE(bad(1, pair + "--hints stranger.rig.txt").error.find("elsewhere"), std::string::npos);
}

TEST_F(Cli, BindMirrors) {
  const std::string robot = "bind " + kData + "/biped__robot.obj --skeleton " + kData + "/biped__robot.rig.txt ";
  const Outcome outcome = good(robot + "--method heat --symmetric -o out.rig.txt");
  EXPECT_NE(outcome.out.find("1116 of 1116 vertices mirrored"), std::string::npos) << outcome.out;
  Character c = read_obj(kData + "/biped__robot.obj");
  read_skeleton(in("out.rig.txt"), true, &c);
  // Left joints hold as much as right ones, and each left weight is some right one.
  std::map<std::string, std::multiset<float>> weights;
  for (const auto& row : c.influences) {
    for (const Influence& i : row) weights[c.joints[i.joint].name].insert(i.weight);
  }
  size_t pairs = 0;
  for (const auto& [name, left] : weights) {
    const size_t at = name.rfind(".L");
    if (at == std::string::npos) continue;
    ++pairs;
    EXPECT_TRUE(left == weights[name.substr(0, at) + ".R"]) << name;
  }
  EXPECT_GE(pairs, 5u);
  const Outcome snake = good("bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat --symmetric -o s.glb");
  EXPECT_NE(snake.out.find("not symmetric"), std::string::npos) << snake.out;
}

Character with_skin(const std::string& mesh, const std::string& rig) {
  Character character = read_mesh(mesh);
  read_skeleton(rig, true, &character);
  return character;
}

TEST_F(Cli, BindTellsWhereToLook) {
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat ";
  const Outcome plain = good(pair + "-o plain.glb");
  const Outcome told = good(pair + "-o told.glb --confidence --png-confidence doubts.png");
  EXPECT_NE(told.out.find("check first: "), std::string::npos) << told.out;
  EXPECT_NE(told.out.find(" vertices (the least certain tenth; "), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("doubts.png"), std::string::npos) << told.out;
  EXPECT_EQ(slurp(in("doubts.png")).substr(1, 3), "PNG");
  EXPECT_NE(slurp(in("told.glb")).find("_CONFIDENCE"), std::string::npos);
  EXPECT_EQ(slurp(in("plain.glb")).find("_CONFIDENCE"), std::string::npos);
  const Outcome json = good(pair + "-o out.glb --json");
  EXPECT_NE(json.out.find("\"to_look_at\""), std::string::npos) << json.out;
}

// Vertices whose strongest joint is not the artist's are three times as many among those to look at as elsewhere.
TEST_F(Cli, WrongVerticesAreAmongThoseToLookAtFirst) {
  const auto best = [](const Character& c, size_t v) {
    const auto less = [](const Influence& a, const Influence& b) { return a.weight < b.weight; };
    return c.joints[std::max_element(c.influences[v].begin(), c.influences[v].end(), less)->joint].name;
  };
  size_t vertices = 0, all = 0, shown = 0, wrong_shown = 0;
  for (const char* const sample : {"biped__robed", "bird__winged", "many-legged__plated", "quadruped__tailed"}) {
    const std::string name = kData + "/" + sample;
    const Outcome told = good("bind " + name + ".obj --skeleton " + name + ".rig.txt -o bound.rig.txt --json");
    const Character artist = read_character(name + ".obj"), bound = with_skin(name + ".obj", in("bound.rig.txt"));
    const auto wrong = [&](size_t v) { return best(artist, v) != best(bound, v); };
    for (size_t v = 0; v < artist.vertices.size(); ++v) all += wrong(v) ? 1 : 0;
    vertices += artist.vertices.size();
    const std::vector<size_t> first = nlohmann::json::parse(told.out)["to_look_at"]["first"];
    EXPECT_EQ(first.size(), (artist.vertices.size() + 9) / 10);
    shown += first.size();
    for (const size_t v : first) wrong_shown += wrong(v) ? 1 : 0;
  }
  EXPECT_GE(wrong_shown, 1u);
  EXPECT_GE(wrong_shown * vertices, 3 * all * shown);
}

TEST_F(Cli, EvalStudies) {
  fs::create_directories(in("set"));
  for (const char* file : {"snake__long.obj", "snake__long.rig.txt"}) fs::copy(kData + "/" + file, in("set"));
  EXPECT_NE(bad(1, "eval confidence set --method heat").error.find("famil"), std::string::npos);
  const Outcome confidence = good("eval confidence " + kData + " --method heat");
  EXPECT_NE(confidence.out.find("calibration error"), std::string::npos) << confidence.out;
  fs::create_directories(in("empty"));
  for (const char* study : {"weights", "confidence"}) bad(1, std::string("eval ") + study + " empty --method heat");
}

TEST_F(Cli, BundledModelBindsOrSaysThatThereIsNone) {
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " -o out.glb";
  if (fs::exists(kData + "/sinew_default.sinew")) {
    good("inspect bundled");
    good(pair);
    expect_bound(read_character(in("out.glb")), 4);
  } else {
    EXPECT_NE(bad(1, pair).error.find("--method heat"), std::string::npos);
    EXPECT_EQ(files(), 0u);
  }
}

TEST_F(Cli, EvalScoresTheSamples) {
  const Outcome two =
      good("eval " + kData + " --method heat --save-predictions out -o figures.json --report report.html --jobs 2");
  EXPECT_NE(two.out.find("| heat | 7 |"), std::string::npos) << two.out;
  for (const char* name : {"biped__robed", "biped__caped", "snake__long"})
    EXPECT_TRUE(fs::exists(in("out/" + std::string(name) + ".rig.txt")));
  EXPECT_NE(slurp(in("out/status.json")).find("\"biped__robed\""), std::string::npos);
  EXPECT_NE(slurp(in("figures.json")).find("\"l1\""), std::string::npos);
  const std::string html = slurp(in("report.html"));
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_EQ(html.find("http://"), html.find("http://www.w3.org")) << "the page must need no network";
  good("eval " + kData + " --method heat --save-predictions out1 --jobs 1");
  EXPECT_TRUE(slurp(in("out/quadruped__tailed.rig.txt")) == slurp(in("out1/quadruped__tailed.rig.txt")));
  EXPECT_EQ(good("eval " + kData + " --method heat --known --json").out[0], '{');
  EXPECT_NE(html.find("sinew-lab eval " + kData + " --method heat --report report.html"), std::string::npos);
  EXPECT_NE(html.find("Confidence: the largest weight of a vertex"), std::string::npos);
  EXPECT_NE(html.find("<h3>cloth: biped__caped"), std::string::npos);
  EXPECT_NE(html.find("nearest bone"), std::string::npos);
  // The same page whatever the number of jobs, with the other run's predictions as a column.
  good("eval " + kData + " --method heat --report report.html --jobs 1");
  EXPECT_TRUE(slurp(in("report.html")) == html);
  const Outcome nearest = good("eval " + kData + " --method nearest --with heat=out1 -o with.json");
  EXPECT_NE(nearest.out.find("| nearest | 7 |"), std::string::npos) << nearest.out;
  EXPECT_NE(slurp(in("with.json")).find("\"heat\""), std::string::npos);
  EXPECT_NE(good("eval " + kData + " --method heat --against-nearest").out.find("nearest bone is better than heat on"),
            std::string::npos);
  bad(2, "eval " + kData + " --method heat --with nothing");
  EXPECT_NE(good("eval " + kData + " --method nearest --known --json").out,
            good("eval " + kData + " --method nearest --json").out);
  bad(1, "eval " + kData + " --method heat --with other=nowhere");
}

TEST_F(Cli, EvalBindsInTheStyleThatIsAskedFor) {
  const std::string heat = "eval " + kData + " --method heat";
  const std::string usual = good(heat + " --json --save-predictions usual").out;
  EXPECT_NE(good(heat + " --rigid-parts always --json --save-predictions rigid --report rigid.html").out, usual);
  EXPECT_NE(slurp(in("rigid.html")).find(heat + " --rigid-parts always --report"), std::string::npos);
  // The predictions are those of bind.
  const std::string pair = kSnake + " --skeleton " + kSnakeRig;
  good("bind " + pair + " --method heat --rigid-parts always -o bound.rig.txt");
  const std::string name = std::filesystem::path(kSnake).stem().string() + ".rig.txt";
  EXPECT_TRUE(slurp(in("rigid/" + name)) == slurp(in("bound.rig.txt")));
  EXPECT_FALSE(slurp(in("usual/" + name)) == slurp(in("bound.rig.txt")));
}

TEST_F(Cli, EvalReportsFailuresAndGoesOn) {
  fs::create_directories(in("set"));
  for (const char* file : {"snake__long.obj", "snake__long.rig.txt"}) fs::copy(kData + "/" + file, in("set"));
  put(in("set/broken__one.obj"), "v 0 0 zero\n");
  put(in("set/broken__one.rig.txt"), "joints a 0 0 0\nroot a\n");
  const Outcome outcome = bad(1, "eval set --method heat --save-predictions out");
  EXPECT_NE(outcome.error.find("1 of 2"), std::string::npos);
  EXPECT_TRUE(fs::exists(in("out/snake__long.rig.txt")));
  EXPECT_NE(slurp(in("out/status.json")).find("\"ok\": false"), std::string::npos);
  fs::create_directories(in("empty"));
  bad(1, "eval empty --method heat");
  bad(1, "eval nowhere --method heat");
}

TEST_F(Cli, TrainQuantizeEvalBind) {
  good("dataset synthesize --plan snake --count 2 --resolution 24 -o set");
  put(in("config.json"),
      R"({"steps": 4, "validate_every": 2, "variants": 0, "synthetic": 0, "field": {"width": 8, "rounds": 1}})");
  good("train set --val set --config config.json -o run.ckpt --quiet");
  good("train set --val set --resume -o run.ckpt --quiet");  // with the configuration of the checkpoint
  EXPECT_NE(good("inspect run.ckpt").out.find("4 steps"), std::string::npos);
  const Outcome table = good("quantize run.ckpt --calibrate set -o run.sinew");
  EXPECT_NE(table.out.find("|accumulator|"), std::string::npos);
  EXPECT_NE(good("inspect run.sinew").out.find("int16 model"), std::string::npos);
  good("eval set --model run.sinew");
  const Outcome bits = good("eval set --checkpoint run.ckpt --report bits.html -o bits.json");
  for (const char* label : {"float checkpoint", "int16 model", "12 bits", "10 bits", "8 bits", "heat"}) {
    EXPECT_NE(bits.out.find(label), std::string::npos) << label;
    EXPECT_NE(slurp(in("bits.json")).find(label), std::string::npos) << label;
  }
  good("bind " + kSnake + " --skeleton " + kSnakeRig + " --model run.sinew -o out.glb");
  expect_bound(read_character(in("out.glb")), 4);

  const Outcome fitted = good("quantize run.ckpt --calibrate set --calibrate-confidence " + kData + " -o sure.sinew");
  EXPECT_NE(fitted.out.find("confidence fitted on 7 characters"), std::string::npos) << fitted.out;
  EXPECT_GT(fs::file_size(in("sure.sinew")), fs::file_size(in("run.sinew")));
  EXPECT_NE(good("eval confidence " + kData + " --model sure.sinew").out.find("the model's table"), std::string::npos);

  put(in("wrong.json"), R"({"stepz": 4})");
  EXPECT_NE(bad(1, "train set --config wrong.json -o x.ckpt").error.find("stepz"), std::string::npos);
  bad(2, "quantize run.sinew --calibrate set -o x.sinew");  // a model: its table is all that can change
  good("quantize run.sinew --calibrate-confidence " + kData + " -o refitted.sinew");
  EXPECT_TRUE(slurp(in("refitted.sinew")) == slurp(in("sure.sinew")));
  bad(1, "eval set --model run.ckpt");
  bad(1, "eval set --checkpoint run.sinew");
  std::string broken = slurp(in("run.sinew"));
  broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 1);
  put(in("broken.sinew"), broken);
  EXPECT_NE(bad(1, "inspect broken.sinew").error.find("broken.sinew"), std::string::npos);
  put(in("short.sinew"), broken.substr(0, 100));
  bad(1, "bind " + kSnake + " --skeleton " + kSnakeRig + " --model short.sinew");
  put(in("short.ckpt"), slurp(in("run.ckpt")).substr(0, 1000));
  bad(1, "inspect short.ckpt");
  EXPECT_FALSE(fs::exists(in("x.sinew")));
  EXPECT_FALSE(fs::exists(in("x.ckpt")));
}

TEST_F(Cli, DatasetCommands) {
  EXPECT_NE(good("dataset check " + kData).out.find("biped__robed"), std::string::npos);
  const std::string checks = good("dataset check " + kData + " --json").out;
  EXPECT_EQ(std::count(checks.begin(), checks.end(), '\n'), 7) << "a line a character";
  EXPECT_EQ(checks.rfind("{\"sinew_dataset\":1,\"about\":\"check\",\"file\":", 0), 0u);
  put(in("cycle.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("cycle.rig.txt"),
      "joints a 0 0 0\njoints b 0 1 0\nroot a\nhier a b\nhier b a\nskin 0 a 1\nskin 1 a 1\nskin 2 b 1\n");
  bad(1, "dataset check cycle.obj");

  const Outcome stats = good("dataset stats " + kData);
  EXPECT_NE(stats.out.find("many-legged"), std::string::npos);
  EXPECT_EQ(good("dataset stats " + kData + " --json").out[0], '{');

  good("dataset convert " + kSnake + " snake.glb");
  good("dataset convert snake.glb -o snake.obj");
  const Character original = read_character(kSnake), back = read_character(in("snake.obj"));
  EXPECT_EQ(original.joints.size(), back.joints.size());
  EXPECT_EQ(original.vertices.size(), back.vertices.size());
  good("dataset decimate " + kSnake + " small.obj --ratio 0.5");
  const Character small = read_character(in("small.obj"));
  EXPECT_LT(small.vertices.size(), 0.6 * double(original.vertices.size()));
  EXPECT_GT(small.vertices.size(), 0.4 * double(original.vertices.size()));
  expect_bound(small, 4);

  good("dataset synthesize --plan all --seed 3 --resolution 24 -o made");
  EXPECT_EQ(list_characters(in("made")).size(), 13u);
  good("dataset synthesize --plan snake --seed 3 --resolution 24 -o one.obj");
  EXPECT_TRUE(slurp(in("one.obj")) == slurp(in("made/snake__0003.obj")));
  EXPECT_TRUE(slurp(in("one.rig.txt")) == slurp(in("made/snake__0003.rig.txt")));
}

TEST_F(Cli, DatasetShowsFindsCopiesAndDivides) {
  good("dataset synthesize --plan snake --count 3 --resolution 24 -o set");
  good("dataset synthesize --plan bird --count 2 --resolution 24 -o set");
  const Outcome stats = good("dataset stats set -o page.html --picture-size 64 --jobs 2");
  EXPECT_NE(stats.out.find("recall@16"), std::string::npos) << stats.out;
  const std::string page = slurp(in("page.html"));
  EXPECT_NE(page.find("data:image/png"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
  good("dataset stats set -o again.html --picture-size 64 --jobs 1");
  EXPECT_TRUE(page == slurp(in("again.html")));
  EXPECT_EQ(good("dataset stats set --no-recall --json").out.find("recall"), std::string::npos);

  fs::copy(in("set/bird__0001.obj"), in("set/parrot__one.obj"));
  fs::copy(in("set/bird__0001.rig.txt"), in("set/parrot__one.rig.txt"));
  const Outcome copies = good("dataset dedup set -o unique");
  EXPECT_NE(copies.out.find("drop  set/parrot__one.obj  same"), std::string::npos) << copies.out;
  EXPECT_EQ(list_characters(in("unique")).size(), 5u);
  EXPECT_EQ(list_characters(in("set")).size(), 6u) << "nothing is deleted";
  EXPECT_EQ(good("dataset dedup set --json")
                .out.rfind("{\"sinew_dataset\":1,\"about\":\"dedup\",\"members\":[{\"file\":\"set/bird__0001.obj\"", 0),
            0u);
  bad(1, "dataset dedup set -o unique");  // never replaces

  put(in("groups.json"), R"({"groups": {"flying": ["bird", "parrot"]}})");
  good("dataset split set --val-share 0.5 --groups groups.json -o two");
  const size_t train = list_characters(in("two/train")).size(), val = list_characters(in("two/val")).size();
  EXPECT_EQ(train, 3u);
  EXPECT_EQ(val, 3u);
  EXPECT_EQ(fs::exists(in("two/val/bird__0001.obj")), fs::exists(in("two/val/parrot__one.obj")));
  bad(1, "dataset split set --val-share 0.5 -o two");
  good("dataset split set --val-share 0.2 --by character --lists -o lists");
  EXPECT_EQ(slurp(in("lists/val.txt")).find('\n'), slurp(in("lists/val.txt")).size() - 1) << "one of six";
  bad(2, "dataset split set --by character --groups groups.json -o x");
  bad(1, "dataset split unique --groups nothing.json -o x");

  std::string rig = slurp(in("set/bird__0001.rig.txt"));
  const size_t at = rig.find("skin 5 ");
  rig.replace(at, rig.find('\n', at) - at, "skin 5 foot.L 1");
  put(in("set/bird__0001.rig.txt"), rig);
  good("dataset check set/bird__0001.obj --pictures suspicious");
}

TEST_F(Cli, InspectAndPose) {
  EXPECT_NE(good("inspect " + kSnake).out.find("spine_3"), std::string::npos);
  EXPECT_NE(good("inspect " + kSnakeRig).out.find("spine_3"), std::string::npos);
  EXPECT_NE(good("inspect " + kCaped).out.find("upper_arm.L"), std::string::npos);
  put(in("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NE(good("inspect mesh.obj").out.find("mesh.obj: mesh"), std::string::npos);

  good("pose " + kSnake + " --random 4 -o a.obj");
  good("pose " + kSnake + " --random 4 -o b.obj");
  EXPECT_TRUE(slurp(in("a.obj")) == slurp(in("b.obj")));
  good("pose " + kSnake + " --random 4 --deform dual-quaternion -o c.obj");
  EXPECT_FALSE(slurp(in("a.obj")) == slurp(in("c.obj")));
  good("pose " + kSnake + " --joint head=0,40,0 --joint spine_2=10,0,5 -o d.png");
  EXPECT_EQ(slurp(in("d.png")).substr(1, 3), "PNG");
  bad(1, "pose " + kSnake + " --joint elbow=0,0,0 -o e.obj");
  bad(1, "pose mesh.obj --random 1 -o e.obj");
  // Nothing turned: nothing moves.
  good("pose " + kSnake + " --random 1 --limit 0 -o still.obj");
  const Character rest = read_obj(kSnake), still = read_obj(in("still.obj"));
  for (size_t v = 0; v < rest.vertices.size(); ++v) ASSERT_NEAR(rest.vertices[v].y, still.vertices[v].y, 1e-5f);
}

TEST_F(Cli, WeightsByDistanceNeedNoModel) {
  const std::string call = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method ";
  EXPECT_NE(good(call + "distance -o distance.rig.txt").out.find("bound with distance"), std::string::npos);
  good(call + "heat -o heat.rig.txt");
  EXPECT_FALSE(slurp(in("distance.rig.txt")) == slurp(in("heat.rig.txt")));
  bad(2, call + "distance --model bundled -o no.rig.txt");
  bad(2, call + "distance --softness 2 -o no.rig.txt");
}

TEST_F(Cli, PosesAreCorrectedAndReadFromMatrices) {
  const std::string turned = "pose " + kSnake + " --joint spine_2=0,0,70";
  std::set<std::string> results;
  for (const char* method : {"linear", "dual-quaternion", "volume", "xpbd", "delta-mush"}) {
    const std::string name = std::string(method) + ".obj";
    good(turned + " --deform " + method + " -o " + name);
    results.insert(slurp(in(name)));
  }
  EXPECT_EQ(results.size(), 5u);
  good(turned + " -o plain.obj");
  EXPECT_TRUE(slurp(in("plain.obj")) == slurp(in("linear.obj")));
  good(turned + " --deform volume --cells 16 --rounds 3 -o coarse.obj");
  EXPECT_FALSE(slurp(in("coarse.obj")) == slurp(in("volume.obj")));

  // An arm that is lowered to the body touches it.
  const std::string lowered = "pose " + kData + "/biped__robed.obj --joint upper_arm.L=0,0,-65 --deform volume";
  good(lowered + " -o inside.obj");
  good(lowered + " --body-contact -o outside.obj");
  EXPECT_FALSE(slurp(in("inside.obj")) == slurp(in("outside.obj")));

  // A quarter turn of everything: joints that are left out stay, so only the root's line and its children's would move all.
  std::string pose = "# a comment\n\n";
  const Character snake = read_character(kSnake);
  for (const Joint& joint : snake.joints) pose += "pose " + joint.name + " 0 -1 0 5 1 0 0 0 0 0 1 0\n";
  put(in("quarter.pose"), pose);
  good("pose " + kSnake + " --matrices quarter.pose --deform volume -o quarter.obj");
  const Character rest = read_obj(kSnake), moved = read_obj(in("quarter.obj"));
  for (size_t v = 0; v < rest.vertices.size(); ++v) {
    ASSERT_NEAR(moved.vertices[v].x, 5 - rest.vertices[v].y, 1e-5f);
    ASSERT_NEAR(moved.vertices[v].y, rest.vertices[v].x, 1e-5f);
  }
  // Scales that differ are said to be skinned plainly.
  put(in("scaled.pose"), "pose head 2 0 0 0 0 2 0 0 0 0 2 0\n");
  EXPECT_NE(good("pose " + kSnake + " --matrices scaled.pose --deform volume -o scaled.obj").error.find("linear"),
            std::string::npos);
  put(in("keep.obj"), "kept");
  for (const char* broken : {"", "pose tail_9 1 0 0 0 0 1 0 0 0 0 1 0\n", "pose head 1 0 0 0 0 1 0 0 0 0 1\n",
                             "pose head 1 0 0 0 0 nan 0 0 0 0 1 0\n", "turn head 1\n",
                             "pose head 1 0 0 0 0 1 0 0 0 0 1 0\npose head 1 0 0 0 0 1 0 0 0 0 1 0\n"}) {
    put(in("broken.pose"), broken);
    EXPECT_NE(bad(1, "pose " + kSnake + " --matrices broken.pose -o keep.obj").error.find("broken.pose"),
              std::string::npos)
        << broken;
  }
  bad(1, "pose " + kSnake + " --matrices missing.pose -o keep.obj");
  EXPECT_EQ(slurp(in("keep.obj")), "kept");
}

TEST_F(Cli, RubbishGivesOneLineAndLeavesOutputsAlone) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", rig = "joints a 0 0 0\nroot a\n";
  put(in("good.rig.txt"), rig);
  put(in("empty.obj"), "");
  put(in("nan.obj"), "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("word.obj"), "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("range.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  put(in("noise.obj"), std::string("\x7f"
                                   "ELF\x02\x01\x01\0\0\xff\xfe",
                                   11));
  put(in("triangle.obj"), triangle);
  put(in("empty.rig.txt"), "");
  put(in("nan.rig.txt"), "joints a 0 nan 0\nroot a\n");
  put(in("cycle.rig.txt"), "joints a 0 0 0\njoints b 0 1 0\nroot a\nhier a b\nhier b a\n");
  put(in("cut.rig.txt"), "joints a 0 0\n");
  std::string million;
  for (int i = 0; i < 1000000; ++i) million += "joints j" + std::to_string(i) + " 0 0 0\n";
  put(in("million.rig.txt"), million + "root j0\n");
  fs::create_directories(in("folder.obj"));
  put(in("empty.glb"), "");
  put(in("cut.gltf"), slurp(kCaped).substr(0, 5000));
  good("dataset convert " + kSnake + " whole.glb");
  put(in("cut.glb"), slurp(in("whole.glb")).substr(0, 20000));
  put(in("keep.glb"), "keep me");
  put(in("keep.png"), "keep me too");

  const size_t before = files();
  const std::string outputs = " --method heat -o keep.glb --png keep.png";
  for (const char* mesh : {"empty.obj", "nan.obj", "word.obj", "range.obj", "noise.obj", "missing.obj"}) {
    bad(1, std::string("bind ") + mesh + " --skeleton good.rig.txt" + outputs);
    bad(1, std::string("inspect ") + mesh);
  }
  bad(2, "bind folder.obj --skeleton good.rig.txt" + outputs);  // a folder, and these outputs are for one mesh
  bad(1, "inspect folder.obj");
  for (const char* mesh : {"empty.glb", "cut.gltf", "cut.glb"}) {
    bad(1, std::string("bind ") + mesh + outputs);
    bad(1, std::string("inspect ") + mesh);
    bad(1, std::string("bind triangle.obj --skeleton ") + mesh + outputs);
  }
  for (const char* skeleton :
       {"empty.rig.txt", "nan.rig.txt", "cycle.rig.txt", "cut.rig.txt", "million.rig.txt", "missing.rig.txt"}) {
    bad(1, std::string("bind triangle.obj --skeleton ") + skeleton + outputs);
  }
  bad(1, "bind triangle.obj" + outputs);
  bad(1, "bind - --skeleton good.rig.txt" + outputs, "");
  bad(1, "bind triangle.obj --skeleton good.rig.txt --method heat -o nowhere/out.glb");
  bad(1, "dataset convert cut.glb keep.glb");
  bad(1, "pose cut.glb --random 1 -o keep.png");
  EXPECT_EQ(slurp(in("keep.glb")), "keep me");
  EXPECT_EQ(slurp(in("keep.png")), "keep me too");
  EXPECT_EQ(files(), before) << "a failing job left something behind";

  // Poor but legal: one triangle, and points without faces, are bound.
  good("bind triangle.obj --skeleton good.rig.txt --method heat -o tri.rig.txt");
  put(in("points.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  good("bind points.obj --skeleton good.rig.txt --method heat -o points.rig.txt");
  bad(1, "bind points.obj --skeleton good.rig.txt --method heat -o keep.glb");  // a GLB needs faces
  EXPECT_EQ(slurp(in("keep.glb")), "keep me");
}

}  // namespace
}  // namespace sinew
