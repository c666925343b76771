// SPDX-License-Identifier: MIT
// Reads the files of gaits/ and evaluates their sums.
#include "clips/gait.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew::clips {
namespace {

const std::set<std::string, std::less<>> kBlocks = {"kind", "clip", "variant"};
const std::set<std::string, std::less<>> kLines = {"without", "splice", "like", "leg",   "let",  "turn",
                                                   "move",    "steady", "foot", "scale", "shift"};
const std::set<std::string, std::less<>> kValues = {"x",     "y",     "z",     "roll",   "pitch",  "hock",   "stance",
                                                    "front", "lift",  "phase", "frames", "travel", "sides",  "later",
                                                    "grow",  "share", "is",    "heel",   "tempo",  "mirror", "toes"};

double wrapped(double phase) { return phase - std::floor(phase); }

// "Spine1..3" are Spine1, Spine2 and Spine3, whatever follows.
void expand(std::string_view word, std::vector<std::string>* names) {
  const size_t dots = word.find("..");
  if (dots == std::string_view::npos || dots == 0 || dots + 2 >= word.size()) return names->emplace_back(word), void();
  for (char digit = word[dots - 1]; digit <= word[dots + 2]; ++digit)
    names->push_back(std::string(word.substr(0, dots - 1)) + digit + std::string(word.substr(dots + 3)));
}

std::optional<double> number_of(std::string_view word) { return to_finite_double(word); }

// GAIN, GAIN~CYCLES, GAIN*SIGNAL, both with @LATE, GAIN^FROM:TO, or PHASE:VALUE.
bool add_term(std::string_view word, Sum* sum) {
  Term term;
  if (const size_t at = word.find('@'); at != std::string_view::npos) {
    const auto late = number_of(word.substr(at + 1));
    if (!late) return false;
    term.late = *late;
    word = word.substr(0, at);
  }
  const size_t mark = word.find_first_of("~*^:");
  const auto first = number_of(word.substr(0, mark));
  if (!first) return false;
  term.gain = *first;
  const std::string_view rest = mark == std::string_view::npos ? "" : word.substr(mark + 1);
  if (mark == std::string_view::npos) {
    sum->terms.push_back(term);
    return true;
  }
  if (word[mark] == '*') {
    term.shape = Term::Shape::kSignal;
    term.signal = rest;
    sum->terms.push_back(term);
    return !rest.empty();
  }
  const size_t colon = rest.find(':');
  const auto second = number_of(rest.substr(0, colon));
  if (!second) return false;
  if (word[mark] == ':') {
    const double before = sum->keys.empty() ? -1e-9 : sum->keys.back().phase;
    sum->keys.push_back({*first, *second});
    return *first > before && *first < 1;
  }
  if (word[mark] == '~') {
    term.shape = Term::Shape::kWave;
    term.cycles = *second;
  } else {
    const auto third = number_of(colon == std::string_view::npos ? "" : rest.substr(colon + 1));
    if (!third || *third <= *second) return false;
    term.shape = Term::Shape::kArc;
    term.from = *second;
    term.to = *third;
  }
  sum->terms.push_back(term);
  return true;
}

Line line_of(const TextLines& lines) {
  Line line;
  line.verb = lines.words()[0];
  for (size_t w = 1; w < lines.words().size(); ++w) {
    const std::string_view word = lines.words()[w];
    if (kValues.count(word) != 0) {
      if (line.names.empty() || line.find(std::string(word)) != nullptr)
        lines.fail("names, then each value once", word);
      line.values.emplace_back(word, Sum{});
    } else if (line.values.empty()) {
      expand(word, &line.names);
    } else if (!add_term(word, &line.values.back().second)) {
      lines.fail("a number, GAIN~CYCLES, GAIN*SIGNAL, GAIN^FROM:TO or PHASE:VALUE in rising order", word);
    }
  }
  return line;
}

}  // namespace

double curve(const std::vector<Key>& k, double phase) {
  const size_t count = k.size();
  size_t above = 0;
  while (above < count && k[above].phase <= phase) ++above;
  const auto key = [&](size_t i) {  // counted from the first key of the cycle before
    return Key{k[i % count].phase + static_cast<double>(i / count), k[i % count].value};
  };
  const size_t first = above + count - 1;
  const double t = phase + 1;
  const auto slope = [&](size_t i) { return (key(i + 1).value - key(i).value) / (key(i + 1).phase - key(i).phase); };
  const auto tangent = [&](size_t i) {  // the harmonic mean; none at a peak
    const double a = slope(i - 1), b = slope(i);
    return a * b > 0 ? 2 * a * b / (a + b) : 0.0;
  };
  const Key from = key(first), to = key(first + 1);
  const double span = to.phase - from.phase, s = (t - from.phase) / span, s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * from.value + (s3 - 2 * s2 + s) * span * tangent(first) + (3 * s2 - 2 * s3) * to.value +
         (s3 - s2) * span * tangent(first + 1);
}

const Sum* Line::find(const std::string& value) const {
  for (const auto& [name, sum] : values)
    if (name == value) return &sum;
  return nullptr;
}

double Line::number(const std::string& value, double otherwise) const {
  const Sum* sum = find(value);
  return sum == nullptr || sum->terms.empty() ? otherwise : sum->terms[0].gain;
}

std::vector<Block> read_gaits(const std::string& file, const std::string& text) {
  std::vector<Block> blocks;
  TextLines lines(file, text);
  while (lines.next()) {
    if (lines.words().empty() || lines.words()[0][0] == '#') continue;
    const std::string_view verb = lines.words()[0];
    if (kBlocks.count(verb) != 0)
      blocks.push_back({line_of(lines), {}});
    else if (kLines.count(verb) != 0 && !blocks.empty())
      blocks.back().lines.push_back(line_of(lines));
    else
      lines.fail("kind, clip, variant or a line of one", verb);
  }
  return blocks;
}

void Signals::add(const std::vector<Line>& lines) {
  for (const Line& line : lines)
    if (line.verb == "let" && line.find("is") != nullptr)
      for (const std::string& name : line.names) signals_[name].sum = *line.find("is");
}

void Signals::vary(const std::vector<Line>& lines) {
  for (const Line& line : lines)
    for (const std::string& name : line.names) {
      if (line.verb == "scale") signals_[name].scale = line.number("is", 1);
      if (line.verb == "shift") signals_[name].shift = line.number("is", 0);
    }
}

double Signals::value(const Sum& sum, double phase, int depth) const {
  double total = sum.keys.empty() ? 0 : curve(sum.keys, wrapped(phase));
  for (const Term& term : sum.terms) {
    const double t = phase - term.late;
    double one = 1;
    if (term.shape == Term::Shape::kWave) {
      one = std::sin(2 * std::numbers::pi * term.cycles * t);
    } else if (term.shape == Term::Shape::kArc) {
      const double s = (wrapped(t) - term.from) / (term.to - term.from);
      one = std::max(0.0, 4 * s * (1 - s));
    } else if (term.shape == Term::Shape::kSignal) {
      const auto found = signals_.find(term.signal);
      if (found == signals_.end() || depth > 8)
        throw Error("gaits: expected a signal, found " + in_quotes(term.signal));
      one = found->second.scale * value(found->second.sum, t, depth + 1) + found->second.shift;
    }
    total += term.gain * one;
  }
  return total;
}

}  // namespace sinew::clips
