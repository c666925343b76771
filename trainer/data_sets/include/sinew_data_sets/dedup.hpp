// SPDX-License-Identifier: MIT
// Which characters of a data set are the same, or the same mesh: copies teach a network nothing and make a test lie.
#ifndef SINEW_DATA_SETS_DEDUP_HPP
#define SINEW_DATA_SETS_DEDUP_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Meshes are compared after translation and scaling (not rotation), vertex by vertex in any order; weights by joints
// at the same position whatever their names.
enum class Likeness {
  kSame,           // nothing differs beyond rounding
  kNear,           // positions differ by less than 1 % of the size, weights by less than an L1 of 0.05
  kOtherWeights,   // the same mesh and skeleton
  kOtherSkeleton,  // the same mesh alone
  kDifferent
};
const char* likeness_text(Likeness likeness);

struct DuplicateGroup {
  struct Member {
    size_t index = 0;                     // in the order of add()
    Likeness likeness = Likeness::kSame;  // to the first member
    size_t like = 0;                      // index of the member it is a (near) copy of; its own when it is none
    double position = 0;                  // root mean square distance to the first member, longest side = 1
    double weights = 0;                   // mean L1 to the member it was compared with; 0 for another skeleton
  };
  std::vector<Member> members;  // ascending; at least two, all with the same mesh
};

class DuplicateFinder {
 public:
  DuplicateFinder();
  ~DuplicateFinder();
  void add(const Character& character);
  std::vector<DuplicateGroup> groups() const;

 private:
  struct Shape;
  struct Match;
  static Match compare(const Shape& a, const Shape& b);
  std::vector<std::unique_ptr<Shape>> shapes_;
};

}  // namespace sinew
#endif
