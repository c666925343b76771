// SPDX-License-Identifier: MIT
// A sound rig has no errors; what is broken is found where it was broken, told once, and held against a profile.
#include "sinew_character/check/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "glb_round.hpp"
#include "sinew_character/check/check_output.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/memory_files.hpp"
#include "small_biped.hpp"

namespace sinew {
namespace {

using sinew_test::small_biped;

const RigFinding* finding_of(const RigCheck& check, const std::string& rule) {
  for (const RigFinding& f : check.findings)
    if (rule == f.rule->name) return &f;
  return nullptr;
}

TEST(Check, RulesAreToldApart) {
  std::vector<std::string> names;
  for (const CheckRule& rule : check_rules()) {
    EXPECT_EQ(&check_rule(rule.name), &rule);
    EXPECT_GT(std::string(rule.cure).size(), 5U) << rule.name;
    names.emplace_back(rule.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_THROW(check_rule("no-such-rule"), Error);
}

TEST(Check, ASoundRigHasNoErrors) {
  const RigCheck check = check_rig(small_biped(), nullptr);
  EXPECT_EQ(check.errors, 0U) << checked_line(check);
}

TEST(Check, FindsVerticesWithoutWeightAndSaysWhere) {
  Character c = small_biped();
  const Vec3 at = c.vertices[7];
  c.influences[7].clear();
  const RigCheck check = check_rig(c, nullptr, {false, {}});
  const RigFinding* const finding = finding_of(check, "unweighted");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, CheckSeverity::kError);
  EXPECT_EQ(finding->vertices, std::vector<uint32_t>{7});
  EXPECT_EQ(finding->position.x, at.x);
  EXPECT_EQ(finding->position.y, at.y);
  EXPECT_GT(finding->radius, 0);
  EXPECT_EQ(check.findings[0].severity, CheckSeverity::kError) << "errors come first";
}

TEST(Check, FindsSums) {
  Character c = small_biped();
  for (Influence& i : c.influences[3]) i.weight *= 1.5F;
  const RigCheck check = check_rig(c, nullptr, {false, {}});
  const RigFinding* const finding = finding_of(check, "weight-sum");
  ASSERT_NE(finding, nullptr);
  EXPECT_NEAR(finding->value, 0.5, 1e-3);
}

TEST(Check, BoundsAreTheCallers) {
  Character c = small_biped();
  for (Influence& i : c.influences[3]) i.weight *= 1.5F;
  EXPECT_EQ(finding_of(check_rig(c, nullptr, {false, {{"weight-sum", 0.6}}}), "weight-sum"), nullptr);
  EXPECT_NE(finding_of(check_rig(c, nullptr, {false, {{"weight-sum", 0.4}}}), "weight-sum"), nullptr);
  EXPECT_THROW(check_rig(c, nullptr, {false, {{"sums", 0.6}}}), Error);
}

uint32_t joint_of(const Character& c, const std::string& name) {
  for (uint32_t j = 0; j < c.joints.size(); ++j)
    if (c.joints[j].name == name) return j;
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

// Gives all of a joint's weight to its parent.
void kill_joint(const std::string& name, Character* c) {
  const uint32_t joint = joint_of(*c, name), parent = static_cast<uint32_t>(c->joints[joint].parent);
  for (auto& row : c->influences)
    for (Influence& i : row)
      if (i.joint == joint) i.joint = parent;
}

TEST(Check, JointsThatAreDeadOnBothSidesAreMeant) {
  Character c = small_biped();
  kill_joint("forearm.L", &c);
  const RigCheck one = check_rig(c, nullptr, {false, {}});
  ASSERT_NE(finding_of(one, "dead-joint"), nullptr);
  EXPECT_EQ(finding_of(one, "dead-joint")->severity, CheckSeverity::kWarning);
  kill_joint("forearm.R", &c);
  const RigCheck both = check_rig(c, nullptr, {false, {}});
  ASSERT_NE(finding_of(both, "dead-joint"), nullptr);
  EXPECT_EQ(finding_of(both, "dead-joint")->severity, CheckSeverity::kNote);
}

TEST(Check, NamesThatBothSidesHaveAlikeAreANote) {
  Character c = small_biped();
  const auto exchange = [&](const std::string& side) {
    std::swap(c.joints[joint_of(c, "upper_arm." + side)].name, c.joints[joint_of(c, "forearm." + side)].name);
  };
  exchange("L");
  const RigCheck one = check_rig(c, nullptr, {false, {}});
  ASSERT_NE(finding_of(one, "name-order"), nullptr);
  EXPECT_EQ(finding_of(one, "name-order")->severity, CheckSeverity::kError);
  exchange("R");
  const RigCheck both = check_rig(c, nullptr, {false, {}});
  ASSERT_NE(finding_of(both, "name-order"), nullptr);
  EXPECT_EQ(finding_of(both, "name-order")->severity, CheckSeverity::kNote);
}

TEST(Check, AFewVerticesAreANoteWhereTheirJointIsNearAndAWarningAcrossTheBody) {
  const auto given_to = [](const std::string& joint) {
    Character c = small_biped();
    const uint32_t foot = joint_of(c, "foot.L");
    float low = c.vertices[0].y;
    uint32_t lowest = 0;
    for (uint32_t v = 0; v < c.vertices.size(); ++v)
      if (c.influences[v].size() == 1 && c.influences[v][0].joint == foot && c.vertices[v].y < low)
        low = c.vertices[v].y, lowest = v;
    c.influences[lowest] = {{joint_of(c, joint), 1.0F}};
    return check_rig(c, nullptr, {false, {}});
  };
  const RigCheck near = given_to("shin.L"), far = given_to("head");
  ASSERT_NE(finding_of(near, "speck"), nullptr);
  EXPECT_EQ(finding_of(near, "speck")->severity, CheckSeverity::kNote);
  EXPECT_EQ(near.warnings, 0U) << checked_line(near);
  EXPECT_GT(far.warnings, 0U) << checked_line(far);
}

TEST(Check, AForelegMayHangOnAShoulder) {
  Character c = small_biped();
  const uint32_t arm = joint_of(c, "upper_arm.L");
  const auto about = [&](const RigCheck& check, uint32_t joint) {
    return std::any_of(check.findings.begin(), check.findings.end(), [&](const RigFinding& f) {
      return std::string(f.rule->name) == "name-order" && f.joint == static_cast<int>(joint);
    });
  };
  ASSERT_EQ(c.joints[static_cast<size_t>(c.joints[arm].parent)].name, "shoulder.L");
  c.joints[arm].name = "upper_leg.L";
  EXPECT_FALSE(about(check_rig(c, nullptr, {false, {}}), arm));
  const uint32_t forearm = joint_of(c, "forearm.L");
  c.joints[arm].name = "upper_arm.L";
  c.joints[forearm].name = "upper_leg.L";
  EXPECT_TRUE(about(check_rig(c, nullptr, {false, {}}), forearm)) << "a leg on an upper arm";
}

TEST(Check, FindsWeightsThatTwinsHaveExchanged) {
  Character c = small_biped();
  for (const auto& [left, right] : {std::pair("thigh.L", "thigh.R"), std::pair("shin.L", "shin.R")}) {
    const uint32_t a = joint_of(c, left), b = joint_of(c, right);
    for (auto& row : c.influences)
      for (Influence& i : row) i.joint = i.joint == a ? b : i.joint == b ? a : i.joint;
  }
  const RigCheck check = check_rig(c, nullptr, {false, {}});
  size_t pairs = 0;
  for (const RigFinding& f : check.findings)
    pairs +=
        f.what.find("have each other's weights") != std::string::npos && f.severity == CheckSeverity::kError ? 1 : 0;
  EXPECT_EQ(pairs, 2U) << checked_line(check);
}

TEST(Check, FindsATrunkJointOutOfTheBody) {
  Character c = small_biped();
  for (Joint& joint : c.joints)
    if (joint.name == "chest") joint.position.z += 1;
  const RigCheck check = check_rig(c, nullptr, {false, {}});
  ASSERT_NE(finding_of(check, "joint-outside"), nullptr) << checked_line(check);
  EXPECT_EQ(finding_of(check_rig(small_biped(), nullptr, {false, {}}), "joint-outside"), nullptr);
}

// A strip whose skeleton hangs under a scale, with a skin that no mesh has and a helper beside it.
TEST(Check, FindsWhatAFileHasBesideItsCharacter) {
  const RigCheck sound = check_rig(read(two_joint_strip()), nullptr, {false, {}});
  for (const char* rule : {"scaled-skin", "unused-skin", "stray-mesh"})
    EXPECT_EQ(finding_of(sound, rule), nullptr) << rule;
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][0]["translation"] = {1000, 0, 0};
  builder.document["nodes"][1]["translation"] = {0, 200, 0};
  const int armature = builder.add("nodes", {{"name", "Armature"}, {"scale", {0.01, 0.01, 0.01}}, {"children", {0}}});
  builder.document["scenes"][0]["nodes"] = {2, armature};
  builder.add("skins", {{"name", "left over"}, {"joints", {1}}});
  const int triangle = builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const nlohmann::json primitive = {{"attributes", {{"POSITION", triangle}}}};
  builder.add("meshes", {{"name", "Icosphere"}, {"primitives", nlohmann::json::array({primitive})}});
  builder.root({{"name", "Icosphere"}, {"mesh", 1}});
  const RigCheck check = check_rig(read(builder), nullptr, {false, {}});
  for (const auto& [rule, name] : {std::pair("scaled-skin", "0.01"), std::pair("unused-skin", "left over"),
                                   std::pair("stray-mesh", "Icosphere")}) {
    const RigFinding* const finding = finding_of(check, rule);
    ASSERT_NE(finding, nullptr) << rule;
    EXPECT_NE(finding->what.find(name), std::string::npos) << finding->what;
  }
}

// The strip's knee swings, about a collider of the hip.
TEST(Check, FindsWhatIsWrongWithSprings) {
  const auto checked = [](const char* at, const nlohmann::json& value) {
    GlbBuilder builder = two_joint_strip();
    const int end = builder.add("nodes", {{"name", "knee_end"}, {"translation", {0, 2, 0}}});
    builder.document["nodes"][1]["children"] = {end};
    builder.document["extensionsUsed"] = {"VRMC_springBone"};
    nlohmann::json& springs = builder.document["extensions"]["VRMC_springBone"];
    springs = {
        {"specVersion", "1.0"},
        {"colliders", {{{"node", 0}, {"shape", {{"sphere", {{"offset", {0, 0, 0}}, {"radius", 1.5}}}}}}}},
        {"colliderGroups", {{{"colliders", {0}}}}},
        {"springs", {{{"name", "tail"}, {"colliderGroups", {0}}, {"joints", {{{"node", 1}}, {{"node", end}}}}}}}};
    springs[nlohmann::json::json_pointer(at)] = value;
    return check_rig(read(builder), nullptr, {false, {}});
  };
  const nlohmann::json same = "tail";
  for (const char* rule : {"springs-broken", "springs-shared", "springs-inside", "springs-skinless"})
    EXPECT_EQ(finding_of(checked("/springs/0/name", same), rule), nullptr) << rule;
  const RigCheck broken = checked("/springs/0/colliderGroups/0", 3);
  ASSERT_NE(finding_of(broken, "springs-broken"), nullptr);
  EXPECT_NE(finding_of(broken, "springs-broken")->what.find("springs[0].colliderGroups"), std::string::npos);
  const RigCheck shared =
      checked("/springs/1", {{"name", "other"}, {"joints", {{{"node", 0}}, {{"node", 1}}, {{"node", 3}}}}});
  ASSERT_NE(finding_of(shared, "springs-shared"), nullptr);
  EXPECT_NE(finding_of(shared, "springs-shared")->what.find("tail and other"), std::string::npos);
  const RigCheck inside = checked("/colliders/0/shape/sphere/radius", 4.5);
  ASSERT_NE(finding_of(inside, "springs-inside"), nullptr);
  EXPECT_NEAR(finding_of(inside, "springs-inside")->value, 0.5 / 4.5, 1e-6);
}

TEST(CheckOutput, ManyFindingsOfOneKindAreOneLine) {
  CheckedFile file;
  file.file = "a.glb";
  file.character = small_biped();
  for (int i = 0; i < 27; ++i) {
    RigFinding finding;
    finding.rule = &check_rule("lost-volume");
    finding.severity = CheckSeverity::kWarning;
    finding.joint = i % 8;
    finding.value = i == 5 ? 1 : 0.9;
    finding.what = "bend " + std::to_string(i);
    file.check.findings.push_back(finding);
  }
  const std::string text = check_text(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_NE(text.find("bend 5; and 26 more: '"), std::string::npos) << text;
  file.check.findings.resize(3);
  EXPECT_EQ(check_text(file).find("more"), std::string::npos);
}

TEST(Check, RefusesWhatIsNoRig) {
  Character bare = small_biped();
  bare.joints.clear();
  bare.influences.clear();
  EXPECT_THROW(check_rig(bare, nullptr), Error);
  Character broken = small_biped();
  broken.vertices[2].x = NAN;
  EXPECT_THROW(check_rig(broken, nullptr), Error);
  Character wrong = small_biped();
  wrong.influences[0] = {{static_cast<uint32_t>(wrong.joints.size()), 1.0F}};
  EXPECT_THROW(check_rig(wrong, nullptr), Error);
}

TEST(Check, ASkeletonAloneIsChecked) {
  Character c = small_biped();
  c.vertices.clear();
  c.influences.clear();
  c.face_offsets = {0};
  c.face_vertices.clear();
  EXPECT_EQ(check_rig(c, nullptr).errors, 0U);
}

TEST(Check, TheSameEveryTime) {
  Character c = small_biped();
  std::rotate(c.influences.begin(), c.influences.begin() + static_cast<std::ptrdiff_t>(c.influences.size() / 3),
              c.influences.end());
  CheckedFile file;
  file.file = "a.glb";
  file.character = c;
  file.check = check_rig(c, nullptr);
  const std::string first = check_json(file);
  EXPECT_GT(file.check.findings.size(), 3U);
  file.check = check_rig(c, nullptr);
  EXPECT_EQ(check_json(file), first);
}

TEST(Check, LineOfAJob) {
  Character c = small_biped();
  RigCheck none;
  EXPECT_EQ(checked_line(none), "checked: 0 findings");
  c.influences[7].clear();
  EXPECT_NE(checked_line(check_rig(c, nullptr, {false, {}})).find("1 unweighted"), std::string::npos);
}

TEST(Check, TellsWhatIsNewAndWhatIsGone) {
  Character before = small_biped(), now = before;
  for (Influence& i : before.influences[3]) i.weight *= 1.5F;
  now.influences[7].clear();
  const CheckOptions cheap = {false, {}};
  const RigCheck old_check = check_rig(before, nullptr, cheap), new_check = check_rig(now, nullptr, cheap);
  const CheckChange change = check_change(old_check, before.joints, new_check, now.joints);
  ASSERT_EQ(change.added.size(), 1U);
  EXPECT_STREQ(new_check.findings[change.added[0]].rule->name, "unweighted");
  ASSERT_EQ(change.removed.size(), 1U);
  EXPECT_STREQ(old_check.findings[change.removed[0]].rule->name, "weight-sum");
}

CheckedFile broken_file() {
  CheckedFile file;
  file.file = "some folder/hero.glb";
  file.character = small_biped();
  file.character.influences[7].clear();
  for (Influence& i : file.character.influences[3]) i.weight *= 1.5F;
  file.check = check_rig(file.character, nullptr, {false, {}});
  return file;
}

TEST(Check, ScoreFallsAsWeightsLeaveWhatMethodsGive) {
  Character c = small_biped();
  const double whole = weight_score(c);
  std::rotate(c.influences.begin(), c.influences.begin() + static_cast<std::ptrdiff_t>(c.influences.size() / 3),
              c.influences.end());
  const double shuffled = weight_score(c);
  EXPECT_GT(whole, 50);
  EXPECT_LE(whole, 100);
  EXPECT_LT(shuffled, whole - 20);
  EXPECT_GE(shuffled, 0);
  c.influences.assign(c.vertices.size(), {});
  EXPECT_EQ(weight_score(c), 0);
}

TEST(CheckOutput, Json) {
  const auto json = nlohmann::json::parse(check_json(broken_file()));
  EXPECT_EQ(json["sinew_check"], 1);
  EXPECT_EQ(json["errors"], 1);
  EXPECT_EQ(json["findings"][0]["rule"], "unweighted");
  EXPECT_EQ(json["findings"][0]["vertices"], nlohmann::json::array({7}));
  EXPECT_EQ(json["findings"][0]["position"].size(), 3U);
  EXPECT_TRUE(json["failures"].empty());
  EXPECT_FALSE(json.contains("added"));
}

TEST(CheckOutput, Sarif) {
  const auto json = nlohmann::json::parse(check_sarif({broken_file()}));
  EXPECT_EQ(json["version"], "2.1.0");
  const auto& run = json["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), check_rules().size());
  const auto& result = run["results"][0];
  EXPECT_EQ(result["ruleId"], "unweighted");
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<size_t>()]["id"], "unweighted");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "some%20folder/hero.glb");
}

CheckGate gate_from(const std::string& text) {
  const FileBytes files = {{"gate.json", {text.begin(), text.end()}}};
  const MemoryFiles scope(&files, nullptr);
  return read_check_gate("gate.json");
}

TEST(CheckGate, CountsWhatIsNotIgnored) {
  const CheckedFile file = broken_file();
  EXPECT_EQ(check_failures(gate_from(R"({"sinew_check": 1})"), file).size(), 2U);
  EXPECT_EQ(check_failures(gate_from(R"({"sinew_check": 1, "most": {"error": 1}})"), file).size(), 1U);
  EXPECT_TRUE(
      check_failures(gate_from(R"({"sinew_check": 1, "most": {"error": 1}, "ignore": ["weight-sum"]})"), file).empty());
  EXPECT_EQ(gate_from(R"({"sinew_check": 1, "bounds": {"tear": 0.5}})").bounds.at("tear"), 0.5);
}

TEST(CheckGate, OldFindingsDoNotCount) {
  CheckedFile file = broken_file();
  file.before = file.check;
  file.joints_before = file.character.joints;
  file.change = check_change(*file.before, file.joints_before, file.check, file.character.joints);
  EXPECT_TRUE(check_failures(gate_from(R"({"sinew_check": 1})"), file).empty());
}

TEST(CheckGate, RefusesWhatItDoesNotKnow) {
  for (const char* const text :
       {"", "[]", "{}", R"({"sinew_check": 2})", R"({"sinew_check": 1, "moist": {}})",
        R"({"sinew_check": 1, "most": {"fatal": 0}})", R"({"sinew_check": 1, "most": {"error": -1}})",
        R"({"sinew_check": 1, "ignore": ["tears"]})", R"({"sinew_check": 1, "bounds": {"tear": "much"}})"}) {
    try {
      gate_from(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("gate.json: ", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace sinew
