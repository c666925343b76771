// SPDX-License-Identifier: MIT
// A bind from joints to weights by heat: hints, answers, styles, and what goes wrong leaves the character as it was.
#include "sinew_character/jobs/bind_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "expect_error.hpp"

namespace sinew {
namespace {

// A square bar along x from `from` to `to`, `rings` + 1 rings of four vertices, open at both ends.
void add_bar(Character* c, float from, float to, float y, float half, uint32_t rings) {
  const auto base = static_cast<uint32_t>(c->vertices.size());
  for (uint32_t r = 0; r <= rings; ++r) {
    const float x = from + (to - from) * static_cast<float>(r) / static_cast<float>(rings);
    for (const auto& [dy, dz] : {std::pair{half, half}, {-half, half}, {-half, -half}, {half, -half}})
      c->vertices.push_back({x, y + dy, dz});
  }
  for (uint32_t r = 0; r < rings; ++r)
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t a = base + 4 * r + i, b = base + 4 * r + (i + 1) % 4;
      c->face_vertices.insert(c->face_vertices.end(), {a, b, b + 4, a + 4});
      c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
    }
}

constexpr size_t kBarVertices = 36;

// A bar with two bones of length 1, and a buckle that floats over the middle joint.
Character buckled_bar() {
  Character c;
  c.name = "bar";
  add_bar(&c, 0, 2, 0, 0.1f, 8);
  add_bar(&c, 0.9f, 1.1f, 0.2f, 0.04f, 2);
  c.joints = {{"low", {0, 0, 0}, -1}, {"middle", {1, 0, 0}, 0}, {"high", {2, 0, 0}, 1}};
  return c;
}

struct Kept {
  explicit Kept(const Character& c) : vertices(c.vertices), influences(c.influences), joints(c.joints.size()) {}
  void expect(const Character& c) const {
    ASSERT_EQ(c.vertices.size(), vertices.size());
    for (size_t v = 0; v < vertices.size(); ++v) EXPECT_EQ(c.vertices[v].x, vertices[v].x);
    ASSERT_EQ(c.influences.size(), influences.size());
    for (size_t v = 0; v < influences.size(); ++v) EXPECT_EQ(c.influences[v].size(), influences[v].size());
    EXPECT_EQ(c.joints.size(), joints);
  }
  std::vector<Vec3> vertices;
  std::vector<std::vector<Influence>> influences;
  size_t joints;
};

bool has_note(const Character& c, const std::string& part) {
  return std::any_of(c.notes.begin(), c.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

float weight_for(const std::vector<Influence>& row, uint32_t joint) {
  float sum = 0;
  for (const Influence& i : row) sum += i.joint == joint ? i.weight : 0;
  return sum;
}

TEST(PrepareJoints, AFlatListGetsAHierarchyAndANote) {
  Character c = buckled_bar();
  c.joints.clear();
  for (int j = 0; j < 5; ++j)
    c.joints.push_back({"bone" + std::to_string(j), {0.5f * static_cast<float>(j), 0, 0}, -1});
  (void)prepare_joints(JointsFrom::kAll, false, &c);
  EXPECT_EQ(std::count_if(c.joints.begin(), c.joints.end(), [](const Joint& joint) { return joint.parent < 0; }), 1);
  EXPECT_TRUE(has_note(c, "4 joints had no parent"));
  Character sound = buckled_bar();
  (void)prepare_joints(JointsFrom::kAll, false, &sound);
  EXPECT_TRUE(sound.notes.empty());
}

TEST(PrepareJoints, ASkeletonOfAnotherSizeIsAWarningOrMended) {
  Character warned = buckled_bar();
  for (Joint& joint : warned.joints) joint.position.x *= 100;
  Character mended = warned;
  (void)prepare_joints(JointsFrom::kAll, false, &warned);
  EXPECT_EQ(warned.joints[2].position.x, 200) << "left as it is";
  EXPECT_TRUE(has_note(warned, "warning: "));
  EXPECT_TRUE(has_note(warned, "correct it with --fit"));
  (void)prepare_joints(JointsFrom::kAll, true, &mended);
  EXPECT_NEAR(mended.joints[2].position.x, 2, 0.1f);
  EXPECT_FALSE(has_note(mended, "warning: "));
}

TEST(PrepareJoints, WithoutASkeletonIsAnError) {
  Character c = buckled_bar();
  c.joints.clear();
  EXPECT_ERROR((void)prepare_joints(JointsFrom::kAuto, false, &c), "bar", "no skeleton");
}

TEST(BindByJob, LeavesTheCharacterAloneUntilItIsApplied) {
  Character c = buckled_bar();
  BindJob job({}, {}, &c);
  const Kept before(c);
  CharacterBind bound = job.bind({}, 0);
  before.expect(c);
  ASSERT_EQ(bound.influences.size(), c.vertices.size());
  job.apply(&bound);
  ASSERT_EQ(c.influences.size(), c.vertices.size());
  EXPECT_EQ(bound.confidence.size(), c.vertices.size());
  EXPECT_TRUE(c.confidence.empty());
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    float sum = 0;
    for (const Influence& i : c.influences[v]) sum += i.weight;
    EXPECT_NEAR(sum, 1, 1e-4f) << v;
    EXPECT_LE(c.influences[v].size(), 4u);
  }
  EXPECT_GT(weight_for(c.influences[0], 0), 0.9f) << "at the low end";
  EXPECT_TRUE(has_note(c, "checked: "));
}

TEST(BindByJob, TheSameEveryTimeAndForEveryNumberOfThreads) {
  std::vector<std::string> hashes;
  for (const uint32_t threads : {1u, 1u, 3u}) {
    Character c = buckled_bar();
    BindJobOptions options;
    options.thread_count = threads;
    BindJob job(options, {}, &c);
    hashes.push_back(bind_hash(job.bind({}, 0).influences, 4));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

// Vertices of the first ring are painted for the highest joint, joints of the hints are numbered otherwise.
BindHints painted() {
  BindHints hints;
  hints.name = "paint.rig.txt";
  hints.joints = {{"high", {}, -1}, {"low", {}, -1}};
  hints.influences.resize(buckled_bar().vertices.size());
  for (size_t v = 0; v < 4; ++v) hints.influences[v] = {{0, 1.0f}};
  return hints;
}

TEST(BindByJob, HintsKeepTheirRowsAndSteerOthersByName) {
  Character plain = buckled_bar(), c = buckled_bar();
  BindJobOptions options;
  options.joints = JointsFrom::kAll;
  BindJob usual(options, {}, &plain);
  const BindHints hints = painted();
  options.hints = &hints;
  BindJob job(options, {}, &c);
  const auto without = usual.bind({}, 0).influences, with = job.bind({}, 0).influences;
  for (size_t v = 0; v < 4; ++v) EXPECT_EQ(weight_for(with[v], 2), 1) << "as painted";
  float change = 0;
  for (size_t v = 4; v < 12; ++v) change += weight_for(with[v], 2) - weight_for(without[v], 2);
  EXPECT_GT(change, 0) << "those beside follow";
}

TEST(BindByJob, WrongHintsAreOneLineWithTheirFile) {
  Character c = buckled_bar();
  BindHints hints = painted();
  hints.joints[0].name = "tail";
  BindJobOptions options;
  options.hints = &hints;
  EXPECT_ERROR(BindJob(options, {}, &c), "paint.rig.txt", "vertex 0", "tail");
  hints = painted();
  for (auto& row : hints.influences) row.clear();
  EXPECT_ERROR(BindJob(options, {}, &c), "paint.rig.txt", "has weights of no vertex");
}

sinew_answer rigid(uint32_t vertex, uint16_t joint) { return {vertex, SINEW_ANSWER_RIGID, joint, 1}; }

TEST(BindByJob, AnAnswerHoldsItsPartAndBringsItsJointBack) {
  Character c = buckled_bar();
  BindJobOptions options;
  JointChoice choice = prepare_joints(JointsFrom::kAll, false, &c);
  choice.flags[2] = SINEW_JOINT_NEVER;
  choice.left_out = {{2, "a test"}};
  options.choice = &choice;
  BindJob job(options, {}, &c);
  for (const auto& row : job.bind({}, 0).influences) EXPECT_EQ(weight_for(row, 2), 0);
  const auto rows = job.bind({rigid(kBarVertices, 2)}, 0).influences;
  for (size_t v = kBarVertices; v < c.vertices.size(); ++v) EXPECT_EQ(weight_for(rows[v], 2), 1) << v;
  EXPECT_TRUE(job.choice().left_out.empty());
  for (const auto& row : job.bind({}, 0).influences) EXPECT_EQ(weight_for(row, 2), 0) << "without the answer again";
  EXPECT_EQ(job.choice().left_out.size(), 1u);
}

TEST(BindByJob, AnAnswerForAJointThatTheUserForbidsIsAnError) {
  Character c = buckled_bar();
  BindJobOptions options;
  options.joint_flags = {0, 0, SINEW_JOINT_NEVER};
  BindJob job(options, {}, &c);
  const Kept before(c);
  EXPECT_ERROR((void)job.bind({rigid(kBarVertices, 2)}, 0), "rigid:high", "excludes this joint");
  before.expect(c);
}

TEST(BindByJob, ARestPoseThatIsNoneLeavesTheCharacterAsItWas) {
  Character c = buckled_bar();
  BindJobOptions options;
  options.to_pose = "no_such_pose.glb";
  BindJob job(options, {}, &c);
  const Kept before(c);
  CharacterBind bound = job.bind({}, 0);
  EXPECT_ERROR(job.apply(&bound), "no_such_pose.glb");
  before.expect(c);
}

TEST(BindByJob, WhatIsProposedIsAskedOnce) {
  Character c = buckled_bar();
  BindJob job({}, {}, &c);
  const CharacterBind& first = job.proposed();
  EXPECT_EQ(&first, &job.proposed());
  EXPECT_EQ(bind_hash(first.influences, 4), bind_hash(job.bind({}, 0).influences, 4)) << "the bind without answers";
  ASSERT_EQ(first.vertex_parts.size(), c.vertices.size());
  EXPECT_NE(first.vertex_parts[0], first.vertex_parts[kBarVertices]);
  EXPECT_FALSE(first.questions.empty());
}

TEST(BindByJob, AnswersBecomeAStyleThatGivesThemBack) {
  Character c = buckled_bar();
  BindJob job({}, {}, &c);
  EXPECT_ERROR((void)job.learned({}, {}, "studio.style"), "studio.style: ", "no answer to save");
  Style before;
  before.sheets.resize(1);
  before.sheets[0].joints = {{"a wheel", {}}};
  ASSERT_FALSE(job.proposed().questions.empty());
  const uint32_t asked = job.proposed().questions[0].vertex;
  const Style style = job.learned(before, {rigid(asked, 0)}, "studio.style");
  ASSERT_EQ(style.sheets.size(), 2u);
  EXPECT_EQ(style.sheets[0].joints[0].first, "a wheel") << "rules of before come first";
  ASSERT_EQ(style.sheets[1].rules.size(), 1u);
  EXPECT_EQ(style.sheets[1].rules[0].joint, "low");
  Character again = buckled_bar();
  BindJob next({}, {}, &again);
  const std::vector<sinew_answer> answers = next.answers_of(style);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].kind, SINEW_ANSWER_RIGID);
  EXPECT_EQ(answers[0].joint, 0);
  EXPECT_EQ(next.proposed().vertex_parts[answers[0].vertex], next.proposed().vertex_parts[asked]);
  EXPECT_TRUE(next.answers_of(before).empty()) << "of another rig";
}

TEST(BindNotes, TellHowManyAndWhy) {
  const Character c = buckled_bar();
  EXPECT_TRUE(bind_notes(c, {}, {}).empty());
  JointChoice choice;
  choice.left_out = {{1, "slot"}, {0, "root"}, {2, "slot"}};
  CharacterBind bound;
  bound.folded_tips = 7;
  bound.kept_meshes = 2;
  const std::vector<std::string> notes = bind_notes(c, choice, bound);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[0].find("3 joints"), std::string::npos);
  EXPECT_NE(notes[0].find("slot: middle, high; root: low"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("7 joints"), std::string::npos);
  EXPECT_NE(notes[2].find("2 attached meshes"), std::string::npos);
}

TEST(BindNotes, OfVeryManyJointsNameTheFirst) {
  Character c = buckled_bar();
  JointChoice choice;
  for (size_t j = 0; j < 300; ++j) {
    c.joints.push_back({"bone" + std::to_string(j), {}, 0});
    choice.left_out.push_back({3 + j, "control"});
  }
  const std::vector<std::string> notes = bind_notes(c, choice, {});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("300 joints"), std::string::npos);
  EXPECT_NE(notes[0].find("bone199 and 100 more"), std::string::npos) << notes[0].substr(notes[0].size() - 80);
}

}  // namespace
}  // namespace sinew
