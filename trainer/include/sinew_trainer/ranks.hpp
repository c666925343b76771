// SPDX-License-Identifier: MIT
// The processes of one training run that mpirun started, and the little they say to each other.
#ifndef SINEW_TRAINER_RANKS_HPP
#define SINEW_TRAINER_RANKS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sinew_formats/error.hpp"

namespace sinew {

// A rank failed; every rank throws it with the same text.
class RanksError : public Error {
 public:
  using Error::Error;
};

// One object per process, before and after all else of MPI. Calls come from the thread that made it, on all ranks in
// the same order. Alone (not started by mpirun) there is one rank and nothing costs anything.
class Ranks {
 public:
  // Throws RanksError when mpirun started several processes of a program that was built without SINEW_TRAINER_MPI.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  uint32_t rank() const { return rank_; }
  uint32_t size() const { return size_; }
  uint32_t local_size() const { return local_size_; }  // ranks on this machine

  // Runs work() on every rank. What any rank throws in it, all throw as RanksError: the others at their next call
  // below, or at the end of it. Nobody waits for a rank that failed.
  void together(const std::function<void()>& work);
  // Each value becomes the largest of all ranks.
  void maximum(std::vector<double>* values);
  // All ranks' values, rank 0's first. counts: how many each rank has.
  std::vector<float> gather(const std::vector<float>& mine, const std::vector<size_t>& counts);
  std::vector<double> gather(const std::vector<double>& mine, const std::vector<size_t>& counts);
  // Throws RanksError unless `value` is the same on all ranks; `what` names it.
  void require_same(uint64_t value, const std::string& what);

 private:
  void round(const std::string& failure);

  uint32_t rank_ = 0, size_ = 1, local_size_ = 1;
};

}  // namespace sinew
#endif
