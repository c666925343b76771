// SPDX-License-Identifier: MIT
// Finger joints by position and by name.
#include "sinew_trainer/hand_score.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sinew_character/predict/predict_details.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

double distance(const Point3& a, const Point3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

struct HandPoint {
  Point3 at;
  uint32_t finger, order;  // order kEnd: the bone end
};
constexpr uint32_t kEnd = 9;

int nearest_hand(const PredictedSkeleton& predicted, const Point3& wrist, double reach) {
  int best = -1;
  for (size_t j = 0; j < predicted.joints.size(); ++j) {
    if (predicted.classes[j] != SINEW_CLASS_HAND || predicted.ends[j] != 0) continue;
    const double d = distance(point(predicted.joints[j].position), wrist);
    if (d >= reach) continue;
    reach = d;
    best = static_cast<int>(j);
  }
  return best;
}

std::vector<HandPoint> fingers_of(const PredictedSkeleton& predicted, int hand) {
  std::vector<HandPoint> points;
  for (size_t j = 0; j < predicted.joints.size() && hand >= 0; ++j) {
    if (!is_finger_class(predicted.classes[j])) continue;
    uint32_t order = 0;
    int above = predicted.joints[j].parent;
    for (; above >= 0 && is_finger_class(predicted.classes[static_cast<size_t>(above)]);
         above = predicted.joints[static_cast<size_t>(above)].parent)
      ++order;
    if (above != hand) continue;
    points.push_back({point(predicted.joints[j].position), uint32_t{predicted.classes[j]} - SINEW_CLASS_THUMB,
                      predicted.ends[j] != 0 ? kEnd : order});
  }
  return points;
}

size_t near(const std::vector<HandPoint>& points, const std::vector<HandPoint>& others, double tolerance) {
  size_t count = 0;
  for (const HandPoint& one : points) {
    for (const HandPoint& other : others) {
      if (distance(one.at, other.at) > tolerance) continue;
      ++count;
      break;
    }
  }
  return count;
}

size_t finger_count(const std::vector<HandPoint>& points) {
  size_t count = 0;
  for (const HandPoint& one : points) count += one.order == 0 ? 1 : 0;
  return count;
}

}  // namespace

void HandScore::add(const HandScore& o) {
  hands += o.hands;
  exact += o.exact;
  bare += o.bare;
  bare_wrong += o.bare_wrong;
  unclear += o.unclear;
  joints += o.joints;
  found += o.found;
  predicted += o.predicted;
  right += o.right;
  same += o.same;
  distance += o.distance;
}

HandScore score_hands(const Character& character, const PredictedSkeleton& predicted) {
  HandScore score;
  for (const TargetHand& hand : target_hands(character)) {
    if (!hand.clear) {
      ++score.unclear;
      continue;
    }
    const Point3 wrist = point(character.joints[hand.joint].position);
    const std::vector<HandPoint> made = fingers_of(predicted, nearest_hand(predicted, wrist, hand.length));
    if (hand.fingers.empty()) {
      ++score.bare;
      score.bare_wrong += made.empty() ? 0 : 1;
      continue;
    }
    std::vector<HandPoint> points;
    for (const TargetFinger& finger : hand.fingers) {
      for (size_t k = 0; k < finger.positions.size(); ++k)
        points.push_back({finger.positions[k], finger.finger, static_cast<uint32_t>(k)});
      if (finger.end) points.push_back({*finger.end, finger.finger, kEnd});
    }
    ++score.hands;
    score.exact += finger_count(made) == hand.fingers.size() ? 1 : 0;
    score.joints += points.size();
    score.found += near(points, made, kFingerTolerance * hand.length);
    score.predicted += made.size();
    score.right += near(made, points, kFingerTolerance * hand.length);
    for (const HandPoint& a : points) {
      for (const HandPoint& b : made) {
        if (a.finger != b.finger || a.order != b.order) continue;
        ++score.same;
        score.distance += distance(a.at, b.at) / hand.length;
      }
    }
  }
  return score;
}

std::string hand_scores_markdown(const std::vector<std::pair<std::string, HandScore>>& characters) {
  std::map<std::string, HandScore> families;
  HandScore all;
  for (const auto& [name, score] : characters) {
    families[family_of(name)].add(score);
    all.add(score);
  }
  std::string text =
      "| family | hands | same number of fingers | distance, % of the hand | precision % | recall % | hands without | "
      "of "
      "these with fingers |\n|---|---|---|---|---|---|---|---|\n";
  const auto row = [&](const std::string& name, const HandScore& s) {
    text += print("| %s | %zu | %zu | %.1f | %.1f | %.1f | %zu | %zu |\n", name.c_str(), s.hands, s.exact,
                  100 * s.mean_distance(), 100 * s.precision(), 100 * s.recall(), s.bare, s.bare_wrong);
  };
  for (const auto& [name, score] : families)
    if (score.hands + score.bare > 0) row(name, score);
  row("all", all);
  return text;
}

std::string hand_scores_json(const std::vector<std::pair<std::string, HandScore>>& characters) {
  nlohmann::ordered_json json;
  HandScore all;
  const auto figures = [](const HandScore& s) {
    return nlohmann::ordered_json{{"hands", s.hands},           {"exact", s.exact},     {"bare", s.bare},
                                  {"bare_wrong", s.bare_wrong}, {"unclear", s.unclear}, {"distance", s.mean_distance()},
                                  {"precision", s.precision()}, {"recall", s.recall()}};
  };
  json["characters"] = nlohmann::ordered_json::object();
  for (const auto& [name, score] : characters) {
    json["characters"][name] = figures(score);
    all.add(score);
  }
  json["all"] = figures(all);
  return json.dump(1);
}

}  // namespace sinew
