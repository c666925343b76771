// SPDX-License-Identifier: MIT
// The report of a bind about one file: the numbers, the weights that it replaced and the parts that an artist should
// decide about, as lines for people and as JSON.
#ifndef SINEW_CLI_BIND_SUMMARY_HPP
#define SINEW_CLI_BIND_SUMMARY_HPP

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew::cli {

// The vertices that a joint had most weight on in the file.
struct JointChange {
  std::string joint;
  size_t vertices = 0;
  double l1 = 0;  // mean over them
};

struct WeightsReplaced {
  size_t vertices = 0;               // that had weights and got others; 0: nothing was replaced
  double l1 = 0;                     // mean over them of the sum over joints of |new - old|, 0..2
  std::vector<JointChange> changes;  // every joint that has such vertices, the largest mean first
};

// Compares rows [V] of the same joints; old ones are scaled to a sum of 1.
//   kept  [V] not 0: the vertex keeps its weights and does not count; or empty
WeightsReplaced compare_weights(const std::vector<Joint>& joints, const std::vector<std::vector<Influence>>& before,
                                const std::vector<std::vector<Influence>>& after, const std::vector<uint8_t>& kept);

// "replaced the weights of 2,338 vertices; they were L1 0.21 away"; empty when none were.
std::string replaced_text(const WeightsReplaced& replaced);
// The joints that changed most as a table, ten at most.
std::vector<std::string> change_lines(const WeightsReplaced& replaced);
// {"vertices", "l1"}, and the "joints" of the table if asked for.
nlohmann::ordered_json replaced_json(const WeightsReplaced& replaced, bool with_joints);

// The question with names instead of numbers, so that it outlives the bind.
struct PartQuestion {
  uint32_t vertex = 0;  // names the part in --answer
  uint32_t parts = 0, vertices = 0;
  std::string joint;                                         // with most of it as proposed
  double share = 0, doubt = 0, gain = 0;                     // 0 to 1; gain: doubt times share of the mesh
  std::vector<std::pair<std::string, double>> alternatives;  // as --answer takes them, and the L1 that they change
};
std::vector<PartQuestion> part_questions(const Character& character, const CharacterBind& bound);
// "part 812, 3 alike, 96 vertices: 62 % hand.L, 31 % doubt; rigid:hand.L, soft"
std::string question_text(const PartQuestion& part);
nlohmann::ordered_json question_json(const PartQuestion& part);

// Asks about each part on `out` and reads a number, an answer as --answer takes it without PART=, nothing (as proposed),
// or q (no more questions; so does the end of `in`). A picture with the part in orange is written for each:
// PICTURE.question1.png and so on.
//   picture  the output's path without its extension
std::vector<sinew_answer> ask(const Character& character, const CharacterBind& bound, const std::string& picture,
                              Axis up, std::istream& in, std::ostream& out);

// The least sure tenth of a character's vertices, and the joints that most of them went to. Relative to the character,
// because that is where looking pays: how sure the others are changes nothing.
struct Doubts {
  std::vector<size_t> vertices;     // least sure first
  double sure = 0;                  // their mean confidence, 0 to 1
  std::vector<std::string> joints;  // three at most, by falling number of vertices
};

struct BindSummary {
  std::string mesh;                 // as on the command line
  std::string name;                 // of the character
  std::string method;               // heat, bundled model, or the model's file name
  std::string output;               // "-" is standard output
  std::string png, png_confidence;  // empty: none
  size_t vertices = 0, faces = 0, joints = 0, joints_used = 0;
  unsigned influences = 0;     // at most, as asked for
  double mean_influences = 0;  // per vertex
  double seconds = 0;          // of the bind alone
  size_t workspace_bytes = 0, workspace_used_bytes = 0;
  bool symmetric = false;  // was asked for
  size_t symmetric_vertices = 0;
  size_t locked_vertices = 0;  // that keep their weights, --lock
  WeightsReplaced replaced;
  bool compare = false;  // joints that changed most were asked for
  std::string hash;      // bind_hash()
  Doubts doubts;
  std::vector<PartQuestion> questions;                             // those that were asked for
  size_t answers = 0;                                              // that the bind took
  size_t answers_by_style = 0;                                     // of those, from a style file
  std::string style;                                               // file that they were written to; empty: none
  std::vector<std::pair<std::string, std::string>> left_out;       // joints that may get no weight, and why
  nlohmann::ordered_json seams = nlohmann::ordered_json::array();  // seams_json()
  std::vector<std::string> notes;  // what the user should know about this file, one line each
};

//   confidence  [V] 0..255; weights are character.influences
// Among equally sure vertices those with the smaller largest weight come first. Empty where even the tenth is 98 %
// sure.
Doubts find_doubts(const Character& character, const std::vector<uint8_t>& confidence);
// "look first at 120 vertices (the least sure tenth; 31 % sure on average), mostly on hand.L"; empty without doubts.
std::string doubts_text(const Doubts& doubts);
// Counts of the character and of its weights.
void count_weights(const Character& character, BindSummary* summary);

// [{"joints": [NAME, NAME], "position": [x, y, z], "length": l}], longest first.
nlohmann::ordered_json seams_json(const std::vector<Joint>& joints, const Seams& seams);

std::vector<std::string> summary_lines(const BindSummary& summary);
nlohmann::ordered_json summary_json(const BindSummary& summary);

}  // namespace sinew::cli
#endif
