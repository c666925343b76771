// SPDX-License-Identifier: MIT
// sinew bind asks about parts and takes answers; sinew eval --questions measures what that is worth.
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
  const size_t part = first["part"];
  for (const nlohmann::json& alternative : first["alternatives"]) {
    const std::string answer = alternative["answer"];
    const nlohmann::json bound =
        json_of(run("bind " + kRobot + " --json -o out.glb --answer '" + std::to_string(part) + "=" + answer + "'"));
    EXPECT_EQ(bound["answers"], 1);
    EXPECT_FALSE(bound.contains("questions"));
    EXPECT_NE(bound["hash"], asked["hash"]) << answer;
  }
  EXPECT_EQ(run("bind " + kRobot + " -o rigid.rig.txt --answer " + std::to_string(part) + "=rigid:chest").status, 0);
  Character character = read_character(kData + "/biped__robot.obj");
  read_skeleton((folder_ / "rigid.rig.txt").string(), true, &character);
  EXPECT_TRUE(is_rigid(character, part, first["vertices"], "chest"));
  const Outcome lines = run("bind " + kRobot + " --questions 2 -o lines.glb");
  EXPECT_NE(lines.out.find("answer with --answer " + std::to_string(part) + "=rigid:"), std::string::npos) << lines.out;
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
  refused("--never never.txt --answer 0=rigid:chest", "gets no weight", 1);
  EXPECT_EQ(run("bind " + kData + " -o bound --ask").status, 2);
  EXPECT_EQ(run("bind " + kData + " -o bound --answer 0=soft").status, 2);
}

TEST_F(Cli, EvalSaysWhatAnswersAreWorth) {
  const std::string folder = (folder_ / "set").string();
  fs::create_directories(folder);
  for (const std::string file : {"biped__robot.obj", "biped__robot.rig.txt", "bird__winged.obj", "bird__winged.rig.txt"})
    fs::copy(kData + "/" + file, folder + "/" + file);
  const Outcome outcome = run("eval set --questions 3");
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const size_t at = outcome.out.find("| mean of families | 2 | ");
  ASSERT_NE(at, std::string::npos) << outcome.out;
  double before = 0, after = 0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str() + at, "| mean of families | 2 | %lf | %lf", &before, &after), 2);
  EXPECT_LT(after, before) << "answers by the reference make nothing worse, and these characters gain";
}

}  // namespace
}  // namespace sinew
