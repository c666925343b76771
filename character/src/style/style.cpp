// SPDX-License-Identifier: MIT
// Answers to rules, and rules to the answers for another character.
#include "sinew_character/style/style.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "names/joint_name.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

// Features further apart than this are not alike; one unit is a part four times as large, twice as wide, or a quarter of
// the character away.
constexpr double kFarthest = 0.6;
constexpr double kOtherJoint = 0.2;     // for parts whose joints have other names; where a rule names a joint, 1
constexpr double kMirrored = 0.05;      // a part on the same side comes first
constexpr double kOfBody = 0.5;         // how far apart the bodies of two characters are counted
constexpr double kSamePosition = 0.15;  // of a joint in two characters

// Without sides: a mirrored part belongs to the other one.
uint64_t words(const std::string& name) { return names::read_joint_name(name.c_str()).stem; }

Point3 mirrored(Point3 position, bool mirror) {
  if (mirror) position[0] = -position[0];
  return position;
}

// Positions in a character's box: from its middle, in longest sides, with y up.
class Positions {
 public:
  Positions(const Character& character, Axis up_axis)
      : box_(box_of(character.vertices)),
        side_(std::max(1e-20, static_cast<double>(box_.longest_side()))),
        z_up_(up_axis == Axis::kZ) {}
  Point3 of(const Vec3& p) const {
    const double x = (p.x - 0.5 * (box_.low.x + box_.high.x)) / side_;
    const double y = (p.y - 0.5 * (box_.low.y + box_.high.y)) / side_;
    const double z = (p.z - 0.5 * (box_.low.z + box_.high.z)) / side_;
    return z_up_ ? Point3{x, z, -y} : Point3{x, y, z};
  }

 private:
  Box box_;
  double side_;
  bool z_up_;
};

double away(const Point3& a, const Point3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// Looks of all parts; `joint` is left empty.
std::vector<PartFeatures> part_features(const Character& character, const BindQuestions& asked) {
  const std::vector<uint32_t>& vertex_parts = asked.vertex_parts;
  const Positions positions(character, asked.up_axis);
  uint32_t count = 0;
  for (const uint32_t part : vertex_parts) count = std::max(count, part + 1);
  std::vector<PartFeatures> features(count);
  std::vector<double> vertices(count, 0);
  for (size_t v = 0; v < vertex_parts.size(); ++v) {
    const Point3 position = positions.of(character.vertices[v]);
    vertices[vertex_parts[v]] += 1;
    for (size_t i = 0; i < 3; ++i) features[vertex_parts[v]].position[i] += position[i];
  }
  for (uint32_t p = 0; p < count; ++p) {
    features[p].size = vertices[p] / static_cast<double>(vertex_parts.size());
    for (double& x : features[p].position) x /= std::max(1.0, vertices[p]);
  }
  for (size_t v = 0; v < vertex_parts.size(); ++v) {
    PartFeatures& one = features[vertex_parts[v]];
    one.radius += away(positions.of(character.vertices[v]), one.position) / vertices[vertex_parts[v]];
  }
  if (count > 0) {
    const auto largest = std::max_element(vertices.begin(), vertices.end());
    features[static_cast<size_t>(largest - vertices.begin())].body = true;
  }
  return features;
}

double ratio(double a, double b) { return std::fabs(std::log((a + 1e-6) / (b + 1e-6))); }

// `mirror`: with b on the other side.
double difference(const StyleRule& rule, const PartFeatures& b, bool mirror) {
  const PartFeatures& a = rule.part;
  if (a.body != b.body) return 2 * kFarthest;
  const double other = rule.kind == SINEW_ANSWER_RIGID ? 1 : kOtherJoint;
  const double names = words(a.joint) == words(b.joint) ? 0 : other;
  const double looks = std::max({ratio(a.size, b.size) / std::log(4.0), ratio(a.radius, b.radius) / std::log(2.0),
                                 away(a.position, mirrored(b.position, mirror)) / 0.25});
  return names + (a.body ? kOfBody : 1) * looks;
}

using Joints = std::vector<std::pair<std::string, Point3>>;

// Whether at least two thirds of both rigs' joints have a namesake in the other, no further away than `farthest`.
bool same_kind(const Joints& a, const Joints& b, double farthest) {
  std::map<std::string, Point3> at;
  for (const auto& [name, position] : b) at.emplace(name, position);
  size_t found = 0;
  for (const auto& [name, position] : a) {
    const auto other = at.find(name);
    found += other != at.end() && away(position, other->second) < farthest ? 1 : 0;
  }
  return 3 * found >= 2 * std::max(a.size(), b.size());
}

Joints joints_of(const Character& character, Axis up_axis) {
  const Positions positions(character, up_axis);
  Joints joints;
  for (const Joint& joint : character.joints) joints.emplace_back(joint.name, positions.of(joint.position));
  return joints;
}

// -1 if no joint that may get weight is at the position of the rule's joint.
//   joints  joints_of() the character
int find_joint(const Character& character, const Joints& joints, const std::vector<uint8_t>& flags,
               const StyleRule& rule, bool mirror, uint16_t own) {
  const auto off = [&](size_t j) { return away(mirrored(joints[j].second, mirror), rule.joint_position); };
  const auto there = [&](size_t j) {
    return (flags.empty() || (flags[j] & SINEW_JOINT_NEVER) == 0) && off(j) < kSamePosition;
  };
  if (rule.steps_up == 0 && there(own)) return own;
  const uint64_t wanted = words(rule.joint);
  int named = -1, nearest = -1;
  double least = kSamePosition;
  for (size_t j = 0; j < joints.size(); ++j) {
    if (!there(j)) continue;
    if (!mirror && joints[j].first == rule.joint) named = static_cast<int>(j);
    if (words(joints[j].first) != wanted || off(j) >= least) continue;
    least = off(j);
    nearest = static_cast<int>(j);
  }
  if (named >= 0) return named;
  if (nearest >= 0 || rule.steps_up < 0) return nearest;
  int above = own;
  for (int step = 0; step < rule.steps_up && above >= 0; ++step)
    above = character.joints[static_cast<size_t>(above)].parent;
  return above >= 0 && there(static_cast<size_t>(above)) ? above : -1;
}

// A question that a rule may answer.
struct Match {
  double off;  // how far the features are apart
  size_t question, rule;
  bool mirror;
};

int steps_up(const Character& character, uint16_t from, uint16_t to) {
  int joint = from;
  for (int steps = 0; joint >= 0; ++steps, joint = character.joints[static_cast<size_t>(joint)].parent)
    if (joint == to) return steps;
  return -1;
}

}  // namespace

StyleSheet learn_style(const Character& character, const BindQuestions& asked,
                       const std::vector<sinew_answer>& answers) {
  StyleSheet sheet;
  sheet.joints = joints_of(character, asked.up_axis);
  if (asked.questions.empty()) return sheet;
  const std::vector<PartFeatures> features = part_features(character, asked);
  for (const sinew_answer& answer : answers) {
    const uint32_t part = asked.vertex_parts[answer.vertex];
    for (const sinew_question& question : asked.questions) {
      if (asked.vertex_parts[question.vertex] != part) continue;
      StyleRule rule;
      rule.part = features[part];
      rule.part.joint = character.joints[question.joint].name;
      rule.kind = answer.kind;
      if (answer.kind == SINEW_ANSWER_RIGID) {
        std::tie(rule.joint, rule.joint_position) = sheet.joints[answer.joint];
        rule.steps_up = steps_up(character, question.joint, answer.joint);
      }
      sheet.rules.push_back(std::move(rule));
    }
  }
  return sheet;
}

std::vector<sinew_answer> answer_by_style(const Style& style, const Character& character, const BindQuestions& asked,
                                          const std::vector<uint8_t>& flags) {
  std::vector<sinew_answer> answers;
  if (asked.questions.empty()) return answers;
  std::vector<StyleRule> rules;
  const Joints joints = joints_of(character, asked.up_axis);
  for (const StyleSheet& sheet : style.sheets) {
    const bool same_names = same_kind(sheet.joints, joints, HUGE_VAL);
    const bool same_positions = same_kind(sheet.joints, joints, kSamePosition);
    for (const StyleRule& rule : sheet.rules)
      if (rule.kind == SINEW_ANSWER_RIGID ? same_positions : same_names) rules.push_back(rule);
  }
  const std::vector<PartFeatures> features = part_features(character, asked);
  std::vector<Match> matches;
  for (size_t q = 0; q < asked.questions.size(); ++q) {
    PartFeatures part = features[asked.vertex_parts[asked.questions[q].vertex]];
    part.joint = character.joints[asked.questions[q].joint].name;
    for (const bool mirror : {false, true}) {
      for (size_t r = 0; r < rules.size(); ++r) {
        const double d = difference(rules[r], part, mirror) + (mirror ? kMirrored : 0);
        if (d < kFarthest) matches.push_back({d, q, r, mirror});
      }
    }
  }
  // A rule is about one part, and parts alike are one question: the best pairs find each other.
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.off < b.off; });
  std::vector<bool> answered(asked.questions.size(), false), used(rules.size(), false);
  for (const Match& match : matches) {
    if (answered[match.question] || used[match.rule]) continue;
    const sinew_question& question = asked.questions[match.question];
    const StyleRule& rule = rules[match.rule];
    sinew_answer answer = {question.vertex, rule.kind, 0, 0};
    if (rule.kind == SINEW_ANSWER_RIGID) {
      const int joint = find_joint(character, joints, flags, rule, match.mirror, question.joint);
      if (joint < 0) continue;
      answer.joint = static_cast<uint16_t>(joint);
    }
    answered[match.question] = used[match.rule] = true;
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace sinew
