// SPDX-License-Identifier: MIT
// The yardstick: how far predicted skin weights are from reference weights or from another result, in random poses as well,
// and how much of those a network could reach. Same numbers as weights_eval.py to 1e-4.
#ifndef SINEW_TRAINER_EVALUATE_HPP
#define SINEW_TRAINER_EVALUATE_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// One character, or a mean over several (counts are then sums). r and p are a vertex's reference and predicted weights,
// rows of sum 1; an influence is a weight above 1e-4. A predicted row without weight stays 0: it counts L1 = 1 and does
// not move.
struct Metrics {
  double precision = 0, recall = 0;  // of influences, over all pairs of vertex and joint
  double l1 = 0;                     // mean over vertices of sum_j |r - p|, 0..2
  double l1_file = 0;                // the same with end joints as they lie in the file: what is on them is wrong
  double avg_dist = 0;      // distance between the vertices skinned with r and with p: mean over vertices and poses,
  double max_dist = 0;      //   mean over poses of the largest,
  double max_dist_all = 0;  //   largest of all; linear blend, 10 random poses, longest side of the mesh = 1
  double argmax = 0;        // share of vertices whose strongest joint agrees; either joint of a tie in r does
  double kl = 0;            // mean over vertices of sum_j r log(r / p), both at least 1e-4
  double bad = 0;           // share of vertices with L1 > 0.5
  double l1_area = 0;       // L1 weighted by vertex area
  double influences = 0;    // predicted influences per vertex
  double unweighted = 0;    // share of vertices without predicted weight
  size_t vertices = 0, unbound = 0, joints = 0;  // unbound: vertices without reference weights, left out of everything
  double seconds = 0;                            // run time, set by the caller; 0 = not timed; of a mean the median
};

// Compares predicted influences with the character's own. End joints (unbound leaves) of the prediction are folded into
// their parents (everywhere but in l1_file), rows normalized, vertices without reference weights left out. `name` seeds
// the poses. vertex_l1, when given, gets [V] L1 per vertex (0 for left-out vertices); pose_distance [poses] the mean
// distance of a vertex.
Metrics measure(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                const std::string& name, int poses = 10, std::vector<float>* vertex_l1 = nullptr,
                std::vector<double>* pose_distance = nullptr);

// The baseline nearest bone: every vertex rigid to the joint whose bone is nearest. A joint's bones are the segments to
// its children; a leaf's is a stub along its parent's bone, half as long and at most a tenth of the longest side of the
// joints' box. Where a bone ends, the joint there is as near as the one that moves the bone: it goes to the deeper
// joint, then to the lower index. `deforms` [J] marks the joints that may be bound to (0 = not); empty: all.
std::vector<std::vector<Influence>> nearest_bone(const Character& character, const std::vector<uint8_t>& deforms = {});

struct Scores {
  std::vector<std::pair<std::string, Metrics>> characters;  // by name
  std::map<std::string, Metrics> families;                  // mean of each family's characters
  Metrics all;                                              // mean over characters
  Metrics family_mean;                                      // mean over families
  std::map<std::string, std::string> failures;              // name -> one line
};
Scores summarize(std::vector<std::pair<std::string, Metrics>> characters);
// Characters on which `other` has the lower L1, worst loss first: (name, difference). Those that either lacks are
// skipped.
std::vector<std::pair<std::string, double>> beaten_by(const Scores& scores, const Scores& other);
// Markdown table as the yardstick prints it; JSON with every number.
std::string scores_markdown(const std::string& label, const Scores& scores);
std::string scores_json(const std::string& label, const Scores& scores);
// Text in tables of Markdown, where a bar would end the cell.
inline std::string markdown_cell(std::string text) {
  for (size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

// Random poses of the yardstick (numpy's default_rng seeded with crc32(name), axis normal, angle uniform, limit 30..60
// degrees): [poses][joints] skinning matrices; `positions` scaled as the caller wants. Same draws as weights_eval.py.
std::vector<std::vector<Affine>> random_poses(const Character& character, const std::string& name,
                                              const std::vector<std::array<double, 3>>& positions, int poses = 10);

// For each K of `ks` (1..SINEW_MAX_CANDIDATES): the mean over bound vertices of the share of reference weight on
// the K candidates the network would choose from, end markers counted as their parents. `grid` is the voxel grid's
// longest side. Throws Error when the character cannot be bound or has no weights.
std::vector<double> candidate_recall(const Character& character, const std::vector<uint32_t>& ks, uint32_t grid);

// Counts over (vertex, joint) pairs that have weight in at least one of two results, each row rounded to whole 255ths
// that sum to 255.
struct WeightDifference {
  static constexpr size_t kSteps = 8;
  std::array<size_t, kSteps> steps = {};  // pairs that differ by 0, 1, 2, 3, 4..7, 8..15, 16..31, 32 and more 255ths
  size_t vertices = 0, flips = 0;         // flips: the strongest joint differs
  void add(const std::vector<std::vector<Influence>>& a, const std::vector<std::vector<Influence>>& b);
  size_t weights() const;      // pairs
  double close_share() const;  // share of pairs that differ by at most 1/255; 1 for none
  double flip_share() const;   // of the vertices
  static const char* step_name(size_t step);
};

// A row as whole 255ths with the exact sum, largest remainders rounded up; empty for an empty row.
std::map<uint32_t, int> row_unorm8(const std::vector<Influence>& row);
// Joint with the largest weight, the lowest index among equals; UINT32_MAX for an empty row.
uint32_t strongest_joint(const std::vector<Influence>& row);

}  // namespace sinew
#endif
