// SPDX-License-Identifier: MIT
// What a bind tells about one file: the numbers, as lines for people and as JSON.
#ifndef SINEW_CLI_BIND_SUMMARY_HPP
#define SINEW_CLI_BIND_SUMMARY_HPP

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bind_questions.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_formats/character.hpp"
#include "weights_replaced.hpp"

namespace sinew::cli {

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
  std::vector<std::string> notes;  // what the user should know about this file, a line each
};

//   confidence  [V] 0..255; weights are character.influences
// Of equally sure vertices those with the smaller largest weight come first. Empty where even the tenth is 98 % sure.
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
