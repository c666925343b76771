// SPDX-License-Identifier: MIT
// The plot of a reliability and the confidence of binders that tell none.
#include "sinew_trainer/reliability_plot.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_character/page/html.hpp"
#include "sinew_data_sets/plots.hpp"

namespace sinew {

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
