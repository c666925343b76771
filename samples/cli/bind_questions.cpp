// SPDX-License-Identifier: MIT
// Questions as text, JSON and pictures, and answers from a terminal.
#include <istream>
#include <ostream>

#include "bind_summary.hpp"
#include "sinew_character/bind/answers.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr std::array<uint8_t, 3> kAsked = {240, 120, 20}, kRest = {170, 175, 185};

void draw_question(const Character& character, const CharacterBind& bound, size_t number, Axis up,
                   const std::string& path) {
  std::vector<std::array<uint8_t, 3>> colors(character.vertices.size(), kRest);
  RenderOptions front, back;
  for (size_t v = 0; v < colors.size(); ++v)
    if (bound.vertex_questions[v] == number) colors[v] = kAsked;
  front.up = back.up = up;
  back.yaw_degrees += 180.0f;
  write_file(path, encode_png(beside({render(character, colors, front), render(character, colors, back)})));
}

// Parses a typed answer; false if it is invalid, with the reason on `out`.
bool read_answer(const Character& character, const PartQuestion& part, const std::string& typed, std::ostream& out,
                 sinew_answer* answer) {
  std::string said = typed.empty() ? "proposed" : typed;
  const bool is_number = said.find_first_not_of("0123456789") == std::string::npos;
  if (is_number) {
    const size_t number = said.size() < 4 ? std::stoul(said) : 0;
    if (number == 0 || number > part.alternatives.size()) {
      out << "expected 1 to " << part.alternatives.size() << "\n";
      return false;
    }
    said = part.alternatives[number - 1].first;
  }
  try {
    *answer = parse_answer(std::to_string(part.vertex) + "=" + said, character);
    return true;
  } catch (const Error& error) {
    out << error.what() << "\n";
    return false;
  }
}

}  // namespace

std::vector<PartQuestion> part_questions(const Character& character, const CharacterBind& bound) {
  std::vector<PartQuestion> parts;
  for (const sinew_question& question : bound.questions) {
    PartQuestion part;
    part.vertex = question.vertex;
    part.parts = question.part_count;
    part.vertices = question.vertex_count;
    part.joint = character.joints[question.joint].name;
    part.share = question.share / 65535.0;
    part.doubt = question.doubt / 65536.0;
    part.gain = question.gain / 65536.0;
    for (uint32_t a = 0; a < question.alternative_count; ++a) {
      const sinew_alternative& alternative = question.alternatives[a];
      part.alternatives.emplace_back(answer_text(character.joints, alternative.kind, alternative.joint),
                                     alternative.change / 65536.0);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

std::string question_text(const PartQuestion& part) {
  std::string text = print("part %u", part.vertex);
  if (part.parts > 1) text += print(", %u equal ones", part.parts);
  text += print(", %u vertices: %.0f %% %s, %.0f %% in doubt; ", part.vertices, 100 * part.share, part.joint.c_str(),
                100 * part.doubt);
  for (size_t a = 0; a < part.alternatives.size(); ++a) text += (a == 0 ? "" : ", ") + part.alternatives[a].first;
  return text;
}

nlohmann::ordered_json question_json(const PartQuestion& part) {
  nlohmann::ordered_json json = {{"part", part.vertex}, {"parts", part.parts}, {"vertices", part.vertices},
                                 {"joint", part.joint}, {"share", part.share}, {"doubt", part.doubt},
                                 {"gain", part.gain}};
  for (const auto& [answer, change] : part.alternatives)
    json["alternatives"].push_back({{"answer", answer}, {"change", change}});
  return json;
}

std::vector<sinew_answer> ask(const Character& character, const CharacterBind& bound, const std::string& picture,
                              Axis up, std::istream& in, std::ostream& out) {
  std::vector<sinew_answer> answers;
  const std::vector<PartQuestion> parts = part_questions(character, bound);
  for (size_t q = 0; q < parts.size(); ++q) {
    const PartQuestion& part = parts[q];
    const std::string path = picture + ".question" + std::to_string(q + 1) + ".png";
    draw_question(character, bound, q, up, path);
    out << print("\nquestion %zu of %zu, orange in %s: %u vertices", q + 1, parts.size(), path.c_str(), part.vertices);
    if (part.parts > 1) out << print(" in %u equal parts", part.parts);
    out << print("\nproposed: %.0f %% %s. What does it move with?\n", 100 * part.share, part.joint.c_str());
    for (size_t a = 0; a < part.alternatives.size(); ++a)
      out << print("  %zu  %s\n", a + 1, part.alternatives[a].first.c_str());
    sinew_answer answer;
    std::string typed;
    do {
      out << "number, rigid:JOINT for any joint, Enter = as proposed, q = no more questions: " << std::flush;
      if (!std::getline(in, typed) || typed == "q") {
        out << "\n";
        return answers;
      }
    } while (!read_answer(character, part, typed, out, &answer));
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace sinew::cli
