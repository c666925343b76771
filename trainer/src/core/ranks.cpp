// SPDX-License-Identifier: MIT
// Data-parallel training over MPI; one rank where mpirun did not start the program or the build has no MPI.
#include "sinew_trainer/ranks.hpp"

#include <cstdlib>
#include <numeric>

#ifdef SINEW_TRAINER_MPI
#include <mpi.h>
#endif

namespace sinew {
namespace {

// What Open MPI and the launchers of MPICH and of clusters set; without them MPI is not started at all.
uint32_t launched_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* value = std::getenv(name);
    if (value != nullptr) return static_cast<uint32_t>(std::strtoul(value, nullptr, 10));
  }
  return 1;
}

}  // namespace

void Ranks::together(const std::function<void()>& work) {
  if (size_ == 1) return work();
  try {
    work();
    round("");
  } catch (const RanksError&) {
    throw;
  } catch (const std::exception& error) {
    round(error.what());
  }
}

#ifdef SINEW_TRAINER_MPI

Ranks::Ranks() {
  if (launched_ranks() <= 1) return;
  int provided = 0, rank = 0, size = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  rank_ = static_cast<uint32_t>(rank);
  size_ = static_cast<uint32_t>(size);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &size);
  local_size_ = static_cast<uint32_t>(size);
  MPI_Comm_free(&machine);
}

Ranks::~Ranks() {
  if (launched_ranks() > 1) MPI_Finalize();
}

// Every exchange starts with it: has anybody failed? The lowest rank that has sends its text.
void Ranks::round(const std::string& failure) {
  int mine = failure.empty() ? static_cast<int>(size_) : static_cast<int>(rank_), first = mine;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first == static_cast<int>(size_)) return;
  std::string text = first == 0 ? failure : "rank " + std::to_string(first) + ": " + failure;
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, first, MPI_COMM_WORLD);
  text.resize(static_cast<size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, first, MPI_COMM_WORLD);
  throw RanksError(text);
}

void Ranks::maximum(std::vector<double>* values) {
  if (size_ == 1) return;
  round("");
  MPI_Allreduce(MPI_IN_PLACE, values->data(), static_cast<int>(values->size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}

namespace {

template <class T>
std::vector<T> gather_values(const std::vector<T>& mine, const std::vector<size_t>& counts, MPI_Datatype type) {
  std::vector<int> lengths, offsets;
  size_t total = 0;
  for (const size_t count : counts) {
    lengths.push_back(static_cast<int>(count));
    offsets.push_back(static_cast<int>(total));
    total += count;
  }
  std::vector<T> all(total);
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), type, all.data(), lengths.data(), offsets.data(), type,
                 MPI_COMM_WORLD);
  return all;
}

}  // namespace

std::vector<float> Ranks::gather(const std::vector<float>& mine, const std::vector<size_t>& counts) {
  if (size_ == 1) return mine;
  const bool fits = std::accumulate(counts.begin(), counts.end(), size_t{0}) <= INT32_MAX;
  round(fits ? "" : "a batch has too many gradients for MPI; use a smaller batch");
  return gather_values(mine, counts, MPI_FLOAT);
}

std::vector<double> Ranks::gather(const std::vector<double>& mine, const std::vector<size_t>& counts) {
  if (size_ == 1) return mine;
  round("");
  return gather_values(mine, counts, MPI_DOUBLE);
}

void Ranks::require_same(uint64_t value, const std::string& what) {
  if (size_ == 1) return;
  round("");
  uint64_t first = value;
  MPI_Bcast(&first, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  round(first == value ? "" : "has " + what + " unlike rank 0's; all ranks need the same files");
}

#else

Ranks::Ranks() {
  if (launched_ranks() > 1) {
    throw RanksError("mpirun started " + std::to_string(launched_ranks()) +
                     " processes, but this program was built without MPI; configure with -DSINEW_TRAINER_MPI=ON");
  }
}
Ranks::~Ranks() = default;
void Ranks::round(const std::string&) {}
void Ranks::maximum(std::vector<double>*) {}
std::vector<float> Ranks::gather(const std::vector<float>& mine, const std::vector<size_t>&) { return mine; }
std::vector<double> Ranks::gather(const std::vector<double>& mine, const std::vector<size_t>&) { return mine; }
void Ranks::require_same(uint64_t, const std::string&) {}

#endif

}  // namespace sinew
