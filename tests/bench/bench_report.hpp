// SPDX-License-Identifier: MIT
// What every row of a benchmark's CSV begins with, and the hash that ends it.
#ifndef SINEW_TESTS_BENCH_BENCH_REPORT_HPP
#define SINEW_TESTS_BENCH_BENCH_REPORT_HPP

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "sinew/sinew.h"

#if defined(__EMSCRIPTEN__)
#include <emscripten.h>
#endif

namespace sinew_bench {

inline std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  std::string family, model, name;
  for (std::string line; std::getline(file, line) && line != "";) {
    const size_t at = line.find(": ");
    if (at == std::string::npos) continue;
    const std::string value = line.substr(at + 2);
    if (line.rfind("cpu family", 0) == 0) family = value;
    if (line.rfind("model name", 0) == 0) {
      name = value;
    } else if (line.rfind("model", 0) == 0) {
      model = value;
    }
  }
  std::replace(name.begin(), name.end(), ',', ' ');
  return name.empty() ? "unknown" : name + " family " + family + " model " + model;
}

inline std::string row_start() { return machine() + "," SINEW_BENCH_COMPILER "," SINEW_BENCH_COMMIT; }

// Processor time of this thread: other work on the machine counts only where it takes caches and clock away.
// WebAssembly under node knows that of the whole process, whose other threads do nothing once everything is compiled.
#if defined(__EMSCRIPTEN__)
EM_JS(double, process_seconds, (), {
  const used = process.cpuUsage();
  return (used.user + used.system) / 1e6;
});
inline double thread_seconds() { return process_seconds(); }
#else
inline double thread_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
#endif

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

// Several contestants in turn, `repeats` times each. run(i) does what the i-th one does once; the median of its seconds goes to
// the i-th column.
template <class Run>
std::vector<double> medians_in_turn(size_t contestants, int repeats, Run run) {
  const size_t rounds = static_cast<size_t>(repeats);
  std::vector<double> seconds(contestants * rounds);
  for (size_t r = 0; r < rounds; ++r) {
    for (size_t i = 0; i < contestants; ++i) {
      const double start = thread_seconds();
      run(i);
      seconds[i * rounds + r] = thread_seconds() - start;
    }
  }
  std::vector<double> medians;
  for (size_t i = 0; i < contestants; ++i) {
    const double* const own = seconds.data() + i * rounds;
    medians.push_back(median({own, own + rounds}));
  }
  return medians;
}

// [--repeats N] [SIZES...] of a command line; what it does not say stays as it is.
inline void read_arguments(int argc, char** argv, int* repeats, std::vector<double>* sizes) {
  std::vector<double> said;
  for (int i = 1; i < argc; ++i) {
    if (i + 1 < argc && std::strcmp(argv[i], "--repeats") == 0) {
      *repeats = std::max(1, std::atoi(argv[++i]));
    } else {
      said.push_back(std::atof(argv[i]));
    }
  }
  if (!said.empty()) *sizes = said;
}

// Ends the program with a line where a call of the engine failed.
inline void check(const char* program, const char* what, sinew_status status) {
  if (status == SINEW_OK) return;
  std::fprintf(stderr, "%s: %s: %s\n", program, what, sinew_status_text(status));
  std::exit(1);
}

inline uint64_t fnv1a(uint64_t hash, const void* data, size_t bytes) {
  const unsigned char* p = static_cast<const unsigned char*>(data);
  for (size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211ull;
  return hash;
}
constexpr uint64_t kHashStart = 14695981039346656037ull;

}  // namespace sinew_bench
#endif
