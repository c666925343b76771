// SPDX-License-Identifier: MIT
// sinew animate --vat: the option, its files and its report.
#ifndef SINEW_CLI_ANIMATE_VAT_HPP
#define SINEW_CLI_ANIMATE_VAT_HPP

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "sinew_character/jobs/vat_job.hpp"

namespace sinew::cli {

void add_vat_option(CLI::App* sub, std::string* folder);
// Throws UsageError where the folder's name is a file's.
void check_vat_folder(const std::string& folder);
// Makes the folder where it is missing. Throws Error.
void write_vat(const std::string& folder, const VatResult& vat);

// The member "vat" of formats/spec/animate.schema.json.
nlohmann::ordered_json vat_json(const std::string& folder, const VatResult& vat);
// On standard output.
//   remedy  added to the line of a clip that does not loop
void tell_vat(const std::string& folder, const VatResult& vat, const std::string& remedy);

}  // namespace sinew::cli
#endif
