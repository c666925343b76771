// SPDX-License-Identifier: MIT
// Reads the symbol tables of the engine's libraries: no allocator, no unwinder, no libm, no writable data, no recursion
// into stdio; the shared library exports what the headers declare.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "output_of.hpp"

namespace {

struct Symbol {
  std::string object;
  char type = '?';
  std::string name;
};

// `nm -A` prints library:object:address type name.
std::vector<Symbol> engine_symbols() {
  std::vector<Symbol> symbols;
  std::istringstream lines(sinew_test::output_of("nm -A " SINEW_ENGINE_LIBRARY));
  for (std::string line; std::getline(lines, line);) {
    const size_t name_at = line.rfind(' ');
    if (name_at == std::string::npos || name_at < 2) continue;
    const size_t object_at = line.find(".a:");
    const size_t object_end = object_at == std::string::npos ? std::string::npos : line.find(':', object_at + 3);
    symbols.push_back({object_end == std::string::npos ? "" : line.substr(object_at + 3, object_end - object_at - 3),
                       line[name_at - 1], line.substr(name_at + 1)});
  }
  return symbols;
}

TEST(EngineSymbols, NeedsNothingButMemoryRoutines) {
  const std::vector<Symbol> symbols = engine_symbols();
  ASSERT_GT(symbols.size(), 20u) << "nm found no symbols in " << SINEW_ENGINE_LIBRARY;
  for (const Symbol& symbol : symbols) {
    if (symbol.type != 'U') continue;
    const bool own = symbol.name.find("sinew") != std::string::npos;
    const bool memory =
        symbol.name == "memcpy" || symbol.name == "memset" || symbol.name == "memmove" || symbol.name == "memcmp";
    const bool toolchain = symbol.name == "_GLOBAL_OFFSET_TABLE_" || symbol.name == "__stack_chk_fail";
    EXPECT_TRUE(own || memory || toolchain) << symbol.object << " needs " << symbol.name;
  }
}

TEST(EngineSymbols, HasNoWritableData) {
  for (const Symbol& symbol : engine_symbols()) {
    // .data.rel.ro holds constant tables of pointers; nm calls it 'd' as well, so it is told apart by section below.
    EXPECT_EQ(std::string("BbCDGgSs").find(symbol.type == 'd' ? '-' : symbol.type), std::string::npos)
        << symbol.object << " has the variable " << symbol.name;
  }
  std::istringstream sections(sinew_test::output_of("size -A " SINEW_ENGINE_LIBRARY));
  for (std::string line; std::getline(sections, line);) {
    std::istringstream words(line);
    std::string section;
    size_t bytes = 0;
    words >> section >> bytes;
    if (section == ".data" || section == ".bss" || section == ".tdata" || section == ".tbss") {
      EXPECT_EQ(bytes, 0u) << section;
    }
  }
}

#if defined(SINEW_ENGINE_SHARED)
// Names of the functions that the headers declare.
std::set<std::string> declared_functions() {
  std::set<std::string> names;
  for (const auto& header : std::filesystem::directory_iterator(SINEW_SOURCE_DIR "/engine/include/sinew")) {
    if (header.path().extension() != ".h") continue;
    std::ifstream file(header.path());
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::regex declaration("\n(?:SINEW_API )?(?!static)[a-z][a-z0-9_* ]* \\*?(sinew_[a-z0-9_]+)\\(");
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
      names.insert((*match)[1]);
  }
  return names;
}

TEST(SharedLibrary, ExportsWhatTheHeadersDeclareAndNothingElse) {
  std::set<std::string> exported;
  std::istringstream lines(sinew_test::output_of("nm -D --defined-only " SINEW_ENGINE_SHARED));
  for (std::string line; std::getline(lines, line);) exported.insert(line.substr(line.rfind(' ') + 1));
  EXPECT_EQ(exported, declared_functions());
  EXPECT_EQ(exported.count("sinew_bind"), 1u);
}

TEST(SharedLibrary, NeedsTheCLibraryAlone) {
  std::istringstream lines(sinew_test::output_of("objdump -p " SINEW_ENGINE_SHARED));
  bool named = false;
  for (std::string line; std::getline(lines, line);) {
    named = named || line.find("SONAME") != std::string::npos;
    if (line.find("NEEDED") != std::string::npos) {
      EXPECT_NE(line.find("libc."), std::string::npos) << line;
    }
  }
  EXPECT_TRUE(named) << "it has no SONAME";
}
#endif

#if defined(SINEW_TEXT_BUDGET)
// Functions and constants of the whole library with the kernels of all instruction sets. What is needed and larger:
// raise the number in budget.cmake, with the reason in the commit.
TEST(EngineSymbols, TextIsInsideItsBudget) {
  std::istringstream sections(sinew_test::output_of("size -A " SINEW_ENGINE_LIBRARY));
  size_t text = 0;
  for (std::string line; std::getline(sections, line);) {
    std::istringstream words(line);
    std::string section;
    size_t bytes = 0;
    words >> section >> bytes;
    for (const char* const kind : {".text", ".rodata", ".data.rel.ro"}) {
      if (section.rfind(kind, 0) == 0) text += bytes;
    }
  }
  RecordProperty("text_bytes", static_cast<int>(text));
  EXPECT_GT(text, 100000u) << "size found no sections in " << SINEW_ENGINE_LIBRARY;
  EXPECT_LE(text, size_t{SINEW_TEXT_BUDGET});
}
#endif

}  // namespace
