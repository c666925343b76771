// SPDX-License-Identifier: MIT
// Answers about parts to text and back.
#include "sinew_character/bind/answers.hpp"

#include <algorithm>
#include <cstdlib>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

const std::string kRigid = "rigid:";
constexpr const char* kExpected = "rigid:JOINT, soft, hard, softer, host or proposed";

uint32_t parse_vertex(const std::string& text, const std::string& number, size_t vertices) {
  char* end = nullptr;
  const unsigned long long value = std::strtoull(number.c_str(), &end, 10);
  if (number.empty() || number[0] < '0' || number[0] > '9' || *end != 0)
    throw Error("answer " + text + ": expected PART=ANSWER, where PART is the number that sinew bind --questions " +
                "prints or any vertex of the part, and ANSWER " + kExpected);
  if (value >= vertices) throw Error("answer " + text + ": the mesh has vertices 0 to " + std::to_string(vertices - 1));
  return static_cast<uint32_t>(value);
}

}  // namespace

const std::vector<std::string>& answer_names() {
  static const std::vector<std::string> names = {"proposed", "rigid", "soft", "hard", "softer", "host"};
  return names;
}

std::string answer_text(const std::vector<Joint>& joints, uint16_t kind, uint16_t joint) {
  return kind == SINEW_ANSWER_RIGID ? kRigid + joints[joint].name : answer_names()[kind];
}

sinew_answer parse_answer(const std::string& text, const Character& character) {
  const size_t equals = text.find('=');
  const std::string said = equals == std::string::npos ? "" : text.substr(equals + 1);
  sinew_answer answer = {parse_vertex(text, text.substr(0, equals), character.vertices.size()), 0, 0, 0};
  if (said.rfind(kRigid, 0) == 0) {
    const std::string name = said.substr(kRigid.size());
    const auto at = std::find_if(character.joints.begin(), character.joints.end(),
                                 [&](const Joint& joint) { return joint.name == name; });
    if (at == character.joints.end())
      throw Error("answer " + text + ": the skeleton has no joint " + name + "; its joints are " +
                  character.joints.front().name + " to " + character.joints.back().name +
                  " (sinew inspect lists them)");
    answer.kind = SINEW_ANSWER_RIGID;
    answer.joint = static_cast<uint16_t>(at - character.joints.begin());
    return answer;
  }
  for (uint16_t kind = 0; kind < answer_names().size(); ++kind) {
    if (kind == SINEW_ANSWER_RIGID || said != answer_names()[kind]) continue;
    answer.kind = kind;
    return answer;
  }
  throw Error("answer " + text + ": unknown answer " + said + "; expected " + kExpected);
}

}  // namespace sinew
