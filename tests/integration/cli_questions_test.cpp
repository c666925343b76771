// SPDX-License-Identifier: MIT
// sinew bind asks about parts and takes answers.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

const std::string kRobot = kData + "/biped__robot.obj --skeleton " + kData + "/biped__robot.rig.txt";

nlohmann::json json_of(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  return nlohmann::json::parse(outcome.out);
}

// Whether every vertex of the part is bound to the joint alone.
bool is_rigid(const Character& character, size_t first, size_t count, const std::string& joint) {
  for (size_t v = first; v < first + count; ++v) {
    const std::vector<Influence>& row = character.influences[v];
    if (row.size() != 1 || character.joints[row[0].joint].name != joint) return false;
  }
  return true;
}

TEST_F(Cli, BindListsQuestionsAndTakesTheirAnswers) {
  const nlohmann::json asked = json_of(run("bind " + kRobot + " --questions 2 --json -o asked.glb"));
  ASSERT_EQ(asked["questions"].size(), 2u);
  const nlohmann::json& first = asked["questions"][0];
  EXPECT_GE(first["gain"], asked["questions"][1]["gain"]);
  // Answers to one of a joint that has weight in the end: that of bone ends goes to their parents.
  const std::string owner = first["joint"];
  const nlohmann::json& kept = asked["questions"][owner.find("_end") != std::string::npos ? 1 : 0];
  for (const nlohmann::json& alternative : kept["alternatives"]) {
    const std::string answer = alternative["answer"];
    const nlohmann::json bound = json_of(run("bind " + kRobot + " --json -o out.glb --answer '" +
                                             std::to_string(size_t{kept["part"]}) + "=" + answer + "'"));
    EXPECT_EQ(bound["answers"], 1);
    EXPECT_FALSE(bound.contains("questions"));
    EXPECT_NE(bound["hash"], asked["hash"]) << answer;
  }
  const size_t part = first["part"];
  EXPECT_EQ(run("bind " + kRobot + " -o rigid.rig.txt --answer " + std::to_string(part) + "=rigid:chest").status, 0);
  Character character = read_character(kData + "/biped__robot.obj");
  read_skeleton((folder_ / "rigid.rig.txt").string(), true, &character);
  EXPECT_TRUE(is_rigid(character, part, first["vertices"], "chest"));
  const Outcome lines = run("bind " + kRobot + " --questions 2 -o lines.glb");
  EXPECT_NE(lines.out.find("answer with --answer " + std::to_string(part) + "=rigid:"), std::string::npos) << lines.out;
}

TEST_F(Cli, SoftIsWhatHeatSays) {
  const std::string snake = "bind " + kSnake + " --skeleton " + kSnakeRig + " --json -o out.glb ";
  EXPECT_EQ(json_of(run(snake + "--answer 5=soft --answer 712=soft --answer 794=soft"))["hash"],
            json_of(run(snake + "--method heat"))["hash"]);
}

TEST_F(Cli, AskReadsAnswersAndDrawsEveryPart) {
  // A number that there is not, a joint that there is not, then the second alternative; as proposed; no third.
  const Outcome asked = run("bind " + kRobot + " --ask --json -o out.glb", "99\nrigid:nose\n2\n\nq\n");
  const nlohmann::json bound = json_of(asked);
  EXPECT_EQ(bound["answers"], 2);
  EXPECT_NE(asked.error.find("expected 1 to"), std::string::npos) << asked.error;
  EXPECT_NE(asked.error.find("the skeleton has no joint nose"), std::string::npos) << asked.error;
  for (const std::string number : {"1", "2", "3"})
    EXPECT_EQ(slurp(folder_ / ("out.question" + number + ".png")).substr(1, 3), "PNG");
  const nlohmann::json plain = json_of(run("bind " + kRobot + " --json -o plain.glb"));
  EXPECT_NE(bound["hash"], plain["hash"]);
  EXPECT_EQ(json_of(run("bind " + kRobot + " --ask --json -o out.glb", ""))["hash"], plain["hash"]) << "no answer";
}

TEST_F(Cli, AnswersThatMakeNoSenseAreRefused) {
  const auto refused = [&](const std::string& options, const std::string& says, int status) {
    const Outcome outcome = run("bind " + kRobot + " -o out.glb " + options);
    EXPECT_EQ(outcome.status, status) << options;
    EXPECT_NE(outcome.error.find(says), std::string::npos) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_FALSE(fs::exists(folder_ / "out.glb"));
  };
  refused("--answer 0=blurry", "unknown answer blurry", 1);
  refused("--answer soft", "expected PART=ANSWER", 1);
  refused("--answer -1=soft", "expected PART=ANSWER", 1);
  refused("--answer 1116=soft", "vertices 0 to 1115", 1);
  refused("--answer 0=rigid:nose", "no joint nose", 1);
  put(folder_ / "never.txt", "chest\n");
  refused("--never never.txt --answer 0=rigid:chest", "excludes this joint", 1);
  EXPECT_EQ(run("bind " + kData + " -o bound --ask").status, 2);
  EXPECT_EQ(run("bind " + kData + " -o bound --answer 0=soft").status, 2);
}

TEST_F(Cli, AnswersBecomeAStyleForTheNextCharacterOfTheKind) {
  const nlohmann::json first =
      json_of(run("bind " + kRobot +
                  " --json -o first.glb --answer 0=rigid:chest --answer 1008=rigid:shin.R --save-style studio.style"));
  EXPECT_EQ(first["answers"], 2);
  EXPECT_EQ(first["style"], "studio.style");
  const nlohmann::json again = json_of(run("bind " + kRobot + " --json -o again.glb --style studio.style"));
  EXPECT_EQ(again["answers_by_style"], 2);
  EXPECT_EQ(again["hash"], first["hash"]) << "the same character";
  // The same robot ten times as large, and elsewhere.
  Character twin = read_character(kData + "/biped__robot.obj");
  for (Vec3& p : twin.vertices) p = {10 * p.x + 3, 10 * p.y, 10 * p.z - 7};
  for (Joint& joint : twin.joints)
    joint.position = {10 * joint.position.x + 3, 10 * joint.position.y, 10 * joint.position.z - 7};
  twin.influences.clear();
  write_obj((folder_ / "twin.obj").string(), twin);
  write_rig((folder_ / "twin.rig.txt").string(), twin);
  EXPECT_EQ(json_of(run("bind twin.obj --skeleton twin.rig.txt --json -o twin.glb --style studio.style"))["answers"],
            2);
  // Another rig is left alone, and an answer of one's own comes after the style's.
  const nlohmann::json snake =
      json_of(run("bind " + kSnake + " --skeleton " + kSnakeRig + " --json -o s.glb --style studio.style"));
  EXPECT_FALSE(snake.contains("answers"));
  EXPECT_EQ(run("bind " + kRobot + " -o own.rig.txt --style studio.style --answer 0=rigid:hips").status, 0);
  Character own = read_character(kData + "/biped__robot.obj");
  read_skeleton((folder_ / "own.rig.txt").string(), true, &own);
  EXPECT_TRUE(is_rigid(own, 0, 56, "hips"));
  // A second character's answers join the first's; a folder is bound with them.
  EXPECT_EQ(
      run("bind " + kCaped + " -o c.glb --style studio.style --save-style studio.style --answer 2040=soft").status, 0);
  // An answer about a whole body is for no other character.
  EXPECT_EQ(
      run("bind " + kSnake + " --skeleton " + kSnakeRig + " -o s.glb --save-style snake.style --answer 0=soft").status,
      1);
  EXPECT_EQ(nlohmann::json::parse(slurp(folder_ / "studio.style"))["characters"].size(), 2u);
  const Outcome folder = run("bind " + kData + " -o bound --json --style studio.style");
  EXPECT_EQ(folder.status, 0) << folder.error;
  EXPECT_NE(folder.out.find("answers_by_style"), std::string::npos);
}

TEST_F(Cli, StyleFilesThatMakeNoSenseAreRefused) {
  const auto refused = [&](const std::string& text, const std::string& says) {
    put(folder_ / "bad.style", text);
    const Outcome outcome = run("bind " + kRobot + " -o out.glb --style bad.style");
    EXPECT_EQ(outcome.status, 1) << text;
    EXPECT_NE(outcome.error.find("bad.style: "), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find(says), std::string::npos) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  };
  refused("", "expected a style file");
  refused("{}", "sinew_style");
  refused("[1]", "expected a style file");
  refused(R"({"sinew_style": 2, "characters": []})", "version 2");
  const auto rule = [](const std::string& text) {
    return R"({"sinew_style": 1, "characters": [{"joints": [], "rules": [)" + text + "]}]}";
  };
  refused(rule(R"({"answer": "blurry"})"), "blurry");
  refused(rule(R"({"answer": "soft"})"), "part");
  refused(rule(R"({"answer": "soft", "part": {"size": 7, "radius": 0, "place": [0, 0, 0], "joint": ""}})"), "size");
  refused(rule(R"({"answer": "soft", "part": {"size": 1, "radius": 0, "place": [0, 1e9, 0], "joint": ""}})"), "place");
  EXPECT_EQ(run("bind " + kRobot + " -o out.glb --style missing.style").status, 1);
  EXPECT_EQ(run("bind " + kRobot + " -o out.glb --save-style out.txt --answer 0=soft").status, 2);
  EXPECT_EQ(run("bind " + kRobot + " -o out.glb --save-style out.style").status, 1) << "no answer to save";
  EXPECT_FALSE(fs::exists(folder_ / "out.style"));
}

}  // namespace
}  // namespace sinew
