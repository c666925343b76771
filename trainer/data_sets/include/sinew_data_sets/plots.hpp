// SPDX-License-Identifier: MIT
// Plots as SVG elements inside a page of html.hpp, whose style sheet colors them.
#ifndef SINEW_DATA_SETS_PLOTS_HPP
#define SINEW_DATA_SETS_PLOTS_HPP

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sinew::html {

// Step between ticks, 1, 2 or 5 times a power of ten, so that there are about five of them, and digits to print it.
double tick_step(double span);
int tick_digits(double step);

// Rows of bars, one bar per series: rows are named on the left, so names stay readable however many there are.
struct BarRow {
  std::string name;
  std::vector<std::optional<double>> values;  // one per series
};
struct BarOptions {
  int digits = 3;          // of the numbers beside the bars
  double low = 0;          // where the axis starts
  double high = 0;         // where it ends; 0 = from the values
  bool all_values = true;  // false: numbers beside the first row's bars only
};
std::string bars(const std::vector<std::string>& series, const std::vector<BarRow>& rows,
                 const BarOptions& options = {});

// A line per series (or points, when `dots`), x and y in data units.
struct Series {
  std::string label;
  std::vector<std::pair<double, double>> points;
  size_t color = 0;
  bool dots = false;
  bool line = true;
  double dot_radius = 4;
};
struct LineOptions {
  std::string x_label, y_label;
  double x_low = 0, x_high = 1;
  double y_low = 0, y_high = 0;                         // y_high 0: from the values
  std::vector<std::pair<double, std::string>> x_ticks;  // empty: chosen
  bool diagonal = false;                                // dashed y = x
  std::vector<std::pair<double, std::string>> levels;   // dashed horizontal lines with their names
};
std::string lines(const std::vector<Series>& series, const LineOptions& options);

// How many characters have a value in each of about `bins` bins. Values are whole numbers; logarithmic when asked (and
// all are above 0).
struct HistogramOptions {
  std::string x_label;
  size_t bins = 16;
  bool logarithmic = false;
};
std::string histogram(const std::vector<double>& values, const HistogramOptions& options);
// Bars over named categories; shares or counts.
struct ColumnOptions {
  std::string x_label, y_label;
  int digits = 0;       // of the numbers above the columns
  bool numbers = true;  // print them
  double factor = 1;    // of the printed numbers and of the axis
  double high = 0;      // end of the axis after the factor; 0 = from the values
};
std::string columns(const std::vector<std::pair<std::string, double>>& values, const ColumnOptions& options);

}  // namespace sinew::html
#endif
