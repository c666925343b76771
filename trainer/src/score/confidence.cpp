// SPDX-License-Identifier: MIT
// Reliability of confidences and the isotonic table that calibrates them.
#include "sinew_trainer/confidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "sinew_character/page/html.hpp"
#include "sinew_data_sets/plots.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/fold_targets.hpp"
#include "weights/confidence.hpp"

namespace sinew {
namespace {

// Weight and hits of each of the 256 confidences; a family's vertices weigh 1 together.
struct Histogram {
  std::array<double, 256> weight = {}, right = {};
};

Histogram histogram(const std::vector<JudgedConfidence>& judged) {
  std::map<std::string, size_t> sizes;
  for (const JudgedConfidence& j : judged) sizes[j.family] += j.confidence.size();
  Histogram h;
  for (const JudgedConfidence& j : judged) {
    for (size_t v = 0; v < j.confidence.size(); ++v) {
      const double weight = 1.0 / static_cast<double>(sizes[j.family]);
      h.weight[j.confidence[v]] += weight;
      h.right[j.confidence[v]] += j.right[v] != 0 ? weight : 0;
    }
  }
  return h;
}

struct Pool {
  double weight = 0, right = 0;
  std::vector<double> positions;  // mean confidences of the bins pooled here
  double hits() const { return right / weight; }
};

uint16_t unorm16(double value) { return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0, 1.0) * 65535.0)); }

}  // namespace

JudgedConfidence judge_confidence(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                                  const std::vector<uint8_t>& confidence) {
  const size_t count = reference.vertices.size();
  if (reference.influences.size() != count || predicted.size() != count || confidence.size() != count) {
    throw Error(reference.name + ": weights, prediction and confidence are not of " + std::to_string(count) +
                " vertices");
  }
  const std::vector<uint32_t> fold = fold_targets(reference);
  JudgedConfidence judged;
  judged.family = family_of(reference.name);
  std::map<uint32_t, float> row;
  for (size_t v = 0; v < count; ++v) {
    float largest = 0;
    for (const Influence& i : reference.influences[v]) largest = std::max(largest, i.weight);
    if (largest <= 0) continue;
    row.clear();
    for (const Influence& i : predicted[v]) row[fold[i.joint]] += i.weight;
    const auto strongest =
        std::max_element(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    bool right = false;
    for (const Influence& i : reference.influences[v])
      right = right || (strongest != row.end() && i.joint == strongest->first && i.weight >= largest - 1e-6f);
    judged.confidence.push_back(confidence[v]);
    judged.right.push_back(right ? 1 : 0);
  }
  return judged;
}

Reliability reliability(const std::vector<JudgedConfidence>& judged) {
  const Histogram h = histogram(judged);
  Reliability r;
  r.bins.resize(10);
  double total = 0;
  for (size_t value = 0; value < 256; ++value) {
    Reliability::Bin& bin = r.bins[std::min<size_t>(9, value * 10 / 255)];
    bin.confidence += h.weight[value] * static_cast<double>(value) / 255.0;
    bin.right += h.right[value];
    bin.share += h.weight[value];
    total += h.weight[value];
  }
  if (total <= 0) return r;
  for (Reliability::Bin& bin : r.bins) {
    r.error += std::fabs(bin.confidence - bin.right) / total;
    if (bin.share > 0) {
      bin.confidence /= bin.share;
      bin.right /= bin.share;
    }
    bin.share /= total;
  }
  return r;
}

DoubtLift doubt_lift(const std::vector<JudgedConfidence>& judged) {
  DoubtLift lift;
  for (const JudgedConfidence& j : judged) {
    std::array<double, 256> count = {}, wrong = {};
    double all = 0, all_wrong = 0;
    for (size_t v = 0; v < j.confidence.size(); ++v) {
      const double miss = j.right[v] != 0 ? 0 : 1;
      ++count[j.confidence[v]];
      wrong[j.confidence[v]] += miss;
      ++all;
      all_wrong += miss;
    }
    if (all_wrong <= 0) continue;
    double left = all / 10, found = 0;
    for (size_t value = 0; value < 256 && left > 0; ++value) {
      if (count[value] <= 0) continue;
      const double taken = std::min(left, count[value]);
      found += wrong[value] * taken / count[value];
      left -= taken;
    }
    ++lift.characters;
    lift.wrong += all_wrong / all;
    lift.wrong_first += 10 * found / all;
    lift.times_average += 10 * found / all_wrong;
  }
  if (lift.characters == 0) return lift;
  for (double* mean : {&lift.wrong, &lift.wrong_first, &lift.times_average})
    *mean /= static_cast<double>(lift.characters);
  return lift;
}

ConfidenceTable fit_confidence(const std::vector<JudgedConfidence>& judged, size_t bins) {
  const Histogram h = histogram(judged);
  double total = 0;
  for (const double w : h.weight) total += w;
  if (total <= 0) throw Error("confidence: no vertex with weights to fit on");
  std::vector<Pool> pools;
  Pool bin;
  double position = 0;
  size_t next = 1;
  double passed = 0;
  for (size_t value = 0; value < 256; ++value) {
    if (h.weight[value] <= 0) continue;
    bin.weight += h.weight[value];
    bin.right += h.right[value];
    position += h.weight[value] * static_cast<double>(value) / 255.0;
    passed += h.weight[value];
    if (passed < total * static_cast<double>(next) / static_cast<double>(bins) - 1e-12) continue;
    while (passed >= total * static_cast<double>(next) / static_cast<double>(bins) - 1e-12) ++next;
    bin.positions = {position / bin.weight};
    pools.push_back(bin);
    bin = {};
    position = 0;
    while (pools.size() > 1 && pools[pools.size() - 2].hits() >= pools.back().hits()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().weight += last.weight;
      pools.back().right += last.right;
      pools.back().positions.insert(pools.back().positions.end(), last.positions.begin(), last.positions.end());
    }
  }
  ConfidenceTable table;
  for (const Pool& pool : pools) {
    // Between the first and the last entry of a pool the table is level.
    const std::array<double, 2> ends = {pool.positions.front(), pool.positions.back()};
    for (const double end : ends) {
      if (table.empty() || unorm16(end) > table.back().first) table.emplace_back(unorm16(end), unorm16(pool.hits()));
    }
  }
  if (table.size() == 1) table.emplace_back(table[0].first < 65535 ? 65535 : 0, table[0].second);
  std::sort(table.begin(), table.end());
  return table;
}

std::vector<JudgedConfidence> apply_confidence(const std::vector<JudgedConfidence>& judged,
                                               const ConfidenceTable& table) {
  std::vector<uint8_t> bytes(4 * table.size());
  for (size_t i = 0; i < table.size(); ++i) {
    store_u16(&bytes[4 * i], table[i].first);
    store_u16(&bytes[4 * i + 2], table[i].second);
  }
  sinew_model model = {};
  model.bytes = bytes.data();
  model.confidence_count = static_cast<uint32_t>(table.size());
  std::vector<JudgedConfidence> mapped = judged;
  for (JudgedConfidence& j : mapped) {
    for (uint8_t& value : j.confidence) value = calibrated_confidence(&model, value * 257u);
  }
  return mapped;
}

Reliability reliability_across_families(const std::vector<JudgedConfidence>& judged) {
  std::map<std::string, size_t> sizes;
  for (const JudgedConfidence& j : judged) sizes[j.family] += j.confidence.size();
  if (sizes.size() < 2) throw Error("confidence: calibration across families needs two families or more");
  std::vector<std::pair<size_t, std::string>> order;
  for (const auto& [family, size] : sizes) order.emplace_back(size, family);
  std::sort(order.rbegin(), order.rend());
  std::set<std::string> first;
  for (size_t i = 0; i < order.size(); ++i) {
    if (i % 4 == 0 || i % 4 == 3) first.insert(order[i].second);
  }
  std::array<std::vector<JudgedConfidence>, 2> halves;
  for (const JudgedConfidence& j : judged) halves[first.count(j.family) != 0 ? 0 : 1].push_back(j);
  std::vector<JudgedConfidence> both = apply_confidence(halves[1], fit_confidence(halves[0]));
  for (JudgedConfidence& j : apply_confidence(halves[0], fit_confidence(halves[1]))) both.push_back(std::move(j));
  return reliability(both);
}

std::vector<uint8_t> top_weights(const std::vector<std::vector<Influence>>& rows) {
  std::vector<uint8_t> top;
  top.reserve(rows.size());
  for (const auto& row : rows) {
    float sum = 0, largest = 0;
    for (const Influence& i : row) {
      sum += i.weight;
      largest = std::max(largest, i.weight);
    }
    top.push_back(sum > 0 ? static_cast<uint8_t>(std::lround(255 * largest / sum)) : 0);
  }
  return top;
}

std::string reliability_plot(const Reliability& reliability) {
  html::Series measured{"measured", {}, 0, true, true, 3.5};
  std::vector<std::pair<std::string, double>> shares;
  for (size_t b = 0; b < reliability.bins.size(); ++b) {
    const Reliability::Bin& bin = reliability.bins[b];
    // A bin with less than a thousandth of the data is noise and would draw the eye.
    if (bin.share > 1e-3) measured.points.emplace_back(bin.confidence, bin.right);
    shares.emplace_back(html::number(static_cast<double>(b) / static_cast<double>(reliability.bins.size()), 1),
                        bin.share);
  }
  html::LineOptions lines;
  lines.x_label = "confidence";
  lines.y_label = "share that is right";
  lines.y_high = 1;
  lines.diagonal = true;
  html::ColumnOptions columns;
  columns.x_label = "confidence, from";
  columns.y_label = "% of vertices";
  columns.factor = 100;
  columns.digits = 1;
  columns.numbers = false;
  return html::lines({measured}, lines) + html::columns(shares, columns);
}

}  // namespace sinew
