// SPDX-License-Identifier: MIT
// Gaits as data: what the files of gaits/ say, and what a sum of waves, curves and couplings is at a phase of the cycle.
#ifndef SINEW_CHARACTER_CLIPS_GAIT_HPP
#define SINEW_CHARACTER_CLIPS_GAIT_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/predict/skeleton_template.hpp"

namespace sinew::clips {

struct Key {
  double phase, value;  // phases rise from 0 and stay below 1
};
// A smooth curve through keys that repeats after 1 and never leaves the range of two neighbors (Fritsch, Carlson 1980): equal
// neighbors are a level.
double curve(const std::vector<Key>& keys, double phase);

struct Term {
  enum class Shape { kConstant, kWave, kArc, kSignal } shape = Shape::kConstant;
  double gain = 0;
  double late = 0;          // a wave or a signal comes later by this share of the cycle
  double cycles = 1;        // of a wave
  double from = 0, to = 1;  // an arc is a body's flight: 0 at both, 1 half way, 0 elsewhere
  std::string signal;
};

struct Sum {
  std::vector<Term> terms;
  std::vector<Key> keys;  // one curve, added to the terms
};

// "turn LeftArm LeftForeArm x 4 22*swing@.03 z -80" has a verb, names and two values.
struct Line {
  std::string verb;
  std::vector<std::string> names;
  std::vector<std::pair<std::string, Sum>> values;

  const Sum* find(const std::string& value) const;
  // The number of a constant value.
  double number(const std::string& value, double otherwise) const;
};

// A kind of body, a clip or a variant, and the lines below it.
struct Block {
  Line head;
  std::vector<Line> lines;
};

// A kind of body: what all clips share, then the clips. gaits/README.md is the grammar. Throws Error with file and line.
std::vector<Block> read_gaits(const std::string& file, const std::string& text);

// gaits/*.txt as they were when the library was built, kinds in the order in which they are tried, then the variants; a null
// name ends them.
const TemplateText* gait_texts();

// Values that couplings refer to: "let" lines by name, later ones instead of earlier ones, then those of a variant.
class Signals {
 public:
  void add(const std::vector<Line>& lines);   // let NAME is SUM
  void vary(const std::vector<Line>& lines);  // scale NAME... is NUMBER, shift NAME... is NUMBER
  // Throws Error for a name that no line defines, and for signals that refer to each other in a ring.
  double value(const Sum& sum, double phase) const { return value(sum, phase, 0); }

 private:
  struct Signal {
    Sum sum;
    double scale = 1, shift = 0;
  };
  double value(const Sum& sum, double phase, int depth) const;

  std::map<std::string, Signal> signals_;
};

}  // namespace sinew::clips
#endif
