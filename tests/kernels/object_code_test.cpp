// SPDX-License-Identifier: MIT
// Reads the vector kernels' object code: the multiply-add loops keep their sums in registers, and no function of such a
// file can be taken by the linker for code that runs on every processor.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "output_of.hpp"

namespace {

struct Instruction {
  unsigned long address = 0;
  std::string text;
};
using Function = std::vector<Instruction>;

// Functions of one member of the library. objdump prints "member.o: file format", "<name>:" and "address: instruction".
std::vector<Function> functions_of(const std::string& member) {
  std::vector<Function> functions;
  std::istringstream lines(sinew_test::output_of("objdump -d --no-show-raw-insn " SINEW_ENGINE_LIBRARY));
  bool wanted = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("file format") != std::string::npos) {
      wanted = line.rfind(member, 0) == 0;
    } else if (wanted && line.find(">:") != std::string::npos) {
      functions.emplace_back();
    } else if (wanted && !functions.empty()) {
      char* end = nullptr;
      const unsigned long address = std::strtoul(line.c_str(), &end, 16);
      if (end == line.c_str() || *end != ':') continue;
      functions.back().push_back({address, end + 1});
    }
  }
  return functions;
}

// Innermost loops: from the target of a backward jump to the jump, without another such jump inside.
std::vector<Function> inner_loops(const Function& function) {
  std::vector<Function> loops;
  size_t after_last_jump = 0;
  for (size_t i = 0; i < function.size(); ++i) {
    std::istringstream words(function[i].text);
    std::string name, target;
    words >> name >> target;
    if (name.empty() || name[0] != 'j') continue;
    char* end = nullptr;
    const unsigned long to = std::strtoul(target.c_str(), &end, 16);
    if (end == target.c_str() || to >= function[i].address || to < function.front().address) continue;
    size_t first = i;
    while (first > 0 && function[first].address > to) --first;
    if (first >= after_last_jump)
      loops.emplace_back(function.begin() + static_cast<long>(first), function.begin() + static_cast<long>(i) + 1);
    after_last_jump = i + 1;
  }
  return loops;
}

bool has(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

// Loops that multiply, and the most multiply-adds that one of them has. Fails on a vector register that goes to or
// comes from the stack in one.
size_t check_loops(const std::string& member, const char* multiply, size_t* widest) {
  size_t loops = 0;
  for (const Function& function : functions_of(member)) {
    for (const Function& loop : inner_loops(function)) {
      size_t products = 0;
      std::string spill;
      for (const Instruction& i : loop) {
        products += has(i.text, multiply);
        const bool vector = has(i.text, "%zmm") || has(i.text, "%ymm");
        if (vector && (has(i.text, "(%rsp") || has(i.text, "(%rbp"))) spill = i.text;
      }
      if (products == 0) continue;
      ++loops;
      *widest = products > *widest ? products : *widest;
      EXPECT_EQ(spill, "") << member << ": a loop of " << products << " " << multiply << " spills";
    }
  }
  return loops;
}

TEST(ObjectCode, VnniLoopsKeepSumsInRegisters) {
  size_t widest = 0;
  EXPECT_GE(check_loops("linear_s16_vnni.cpp.o", "vpdpwssd", &widest), 16u) << "4 group counts x 4 row counts";
  EXPECT_EQ(widest, 24u);  // 6 rows x 4 registers
}

TEST(ObjectCode, Avx2LoopsKeepSumsInRegisters) {
  size_t widest = 0;
  EXPECT_GE(check_loops("linear_s16_avx2.cpp.o", "vpmaddwd", &widest), 4u);
  EXPECT_EQ(widest, 12u);  // 6 rows x 2 registers
}

TEST(ObjectCode, AvxVnniLoopsKeepSumsInRegisters) {
  size_t widest = 0;
  EXPECT_GE(check_loops("linear_s16_avxvnni.cpp.o", "vpdpwssd", &widest), 4u);
  EXPECT_EQ(widest, 12u);
}

// An inline function of a header that is compiled into such a file as a weak symbol could be the copy that the linker
// keeps for the whole program: an illegal instruction on an older processor.
TEST(ObjectCode, VectorFilesShareNoFunction) {
  std::istringstream lines(sinew_test::output_of("nm -A " SINEW_ENGINE_LIBRARY));
  size_t seen = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!has(line, "_avx2.cpp.o:") && !has(line, "vnni.cpp.o:") && !has(line, "_avx512.cpp.o:")) continue;
    ++seen;
    const size_t at = line.rfind(' ');
    ASSERT_GT(at, 1u);
    EXPECT_EQ(std::string("WVu").find(line[at - 1]), std::string::npos) << line;
  }
  EXPECT_GT(seen, 10u);
}

}  // namespace
