// SPDX-License-Identifier: MIT
// The table of the published methods in engine/src/published/README.md: every claim in it is run by a test of this program, whose other files have
// them by method, or says that it has a figure alone.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (size_t at = 1, end = row.find('|', at); end != std::string::npos; at = end + 1, end = row.find('|', at))
    cells.push_back(row.substr(at, end - at));
  return cells;
}

// Rows below the heading, without the head and the line under it.
std::vector<std::vector<std::string>> table_rows() {
  const std::vector<uint8_t> file = read_file(SINEW_SOURCE_DIR "/engine/src/published/README.md");
  const std::string text(file.begin(), file.end());
  const size_t begin = text.find("\n## Published methods\n");
  EXPECT_NE(begin, std::string::npos);
  std::vector<std::vector<std::string>> rows;
  for (size_t at = text.find("\n|", begin); at != std::string::npos && text[at + 1] == '|';
       at = text.find('\n', at + 1))
    rows.push_back(cells_of(text.substr(at + 1, text.find('\n', at + 1) - at - 1)));
  return {rows.begin() + std::min<ptrdiff_t>(2, static_cast<ptrdiff_t>(rows.size())), rows.end()};
}

// Names in backquotes that begin with `beginning`.
std::set<std::string> names_in(const std::string& text, const std::string& beginning) {
  const std::regex name("`(" + beginning + "[A-Za-z0-9.]*)`");
  std::set<std::string> names;
  for (std::sregex_iterator one(text.begin(), text.end(), name), end; one != end; ++one) names.insert((*one)[1]);
  return names;
}

TEST(PublishedMethods, EveryClaimOfTheTableIsTestedAndEveryMethodIsInIt) {
  std::set<std::string> tests, suites;
  const ::testing::UnitTest& program = *::testing::UnitTest::GetInstance();
  for (int s = 0; s < program.total_test_suite_count(); ++s) {
    const ::testing::TestSuite& suite = *program.GetTestSuite(s);
    suites.insert(suite.name());
    for (int t = 0; t < suite.total_test_count(); ++t)
      tests.insert(std::string(suite.name()) + "." + suite.GetTestInfo(t)->name());
  }
  suites.erase("PublishedMethods");
  EXPECT_GE(suites.size(), 6u);
  constexpr size_t kClaim = 0, kDrawn = 1, kOurs = 2, kCommand = 4, kTest = 5, kCells = 6;
  for (const std::vector<std::string>& row : table_rows()) {
    ASSERT_EQ(row.size(), kCells) << row[kClaim];
    const auto says = [](const std::string& cell) { return cell.find_first_not_of(' ') != std::string::npos; };
    EXPECT_TRUE(says(row[kClaim]) && says(row[kCommand]) && (says(row[kDrawn]) || says(row[kOurs]))) << row[kClaim];
    const std::set<std::string> named = names_in(row[kTest], "Published");
    EXPECT_TRUE(!named.empty() || row[kTest] == " figure alone ") << row[kClaim] << "has no test";
    for (const std::string& test : named) {
      EXPECT_EQ(tests.count(test), 1u) << test << " is no test of this program";
      suites.erase(test.substr(0, test.find('.')));
    }
  }
  for (const std::string& suite : suites) ADD_FAILURE() << suite << " has no row";
}

}  // namespace
}  // namespace sinew
