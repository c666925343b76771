// SPDX-License-Identifier: MIT
// Tables and plots of the report; report.cpp puts them on the page.
#ifndef SINEW_TRAINER_SCORE_REPORT_PARTS_HPP
#define SINEW_TRAINER_SCORE_REPORT_PARTS_HPP

#include <string>
#include <vector>

#include "sinew_trainer/report.hpp"

namespace sinew {

// All families of all variants, sorted.
std::vector<std::string> report_families(const ReportData& data);
std::vector<std::string> variant_labels(const ReportData& data);
const Metrics* family_metrics(const ReportVariant& variant, const std::string& family);
const std::pair<std::string, Metrics>* worst_character(const Scores& scores);

std::string variant_table(const ReportData& data);
// One figure of every family and variant, the best of a row bold.
std::string family_table(const ReportData& data, double Metrics::*figure, int digits, double factor,
                         bool lower_is_better);
std::string worst_table(const ReportData& data, size_t count);
std::string character_table(const ReportVariant& variant);
std::string failure_table(const ReportData& data);  // empty when nothing failed
std::string beaten_table(const ReportData& data);

std::string family_bars(const ReportData& data, double Metrics::*figure, int digits, double factor = 1);
std::string bits_plot(const ReportData& data);  // empty for fewer than two variants with bits
std::string sorted_plot(const ReportData& data);
std::string deformation_plot(const ReportData& data);  // empty without distances per pose
std::string difference_plot(const WeightDifference& difference);

}  // namespace sinew
#endif
