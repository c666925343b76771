// SPDX-License-Identifier: MIT
// Clips of one skeleton for another, by the engine (sinew/motion.h).
#ifndef SINEW_FORMATS_RETARGET_HPP
#define SINEW_FORMATS_RETARGET_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sinew/sinew.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

class Retargeter {
 public:
  //   target   joints of the character; clips made are poses of motion_of(target)
  //   map      [target] joint of the source, or -1
  //   classes  [target] sinew_joint_class
  // Throws Error naming `source.name` for what the engine refuses.
  Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
             const std::vector<uint8_t>& classes, const RetargetSettings& settings = {});

  // Before each frame `keep_going` is asked; false ends with an Error that says so.
  Clip run(const Clip& clip, const std::function<bool()>& keep_going = {});

 private:
  void check(sinew_status status) const;

  std::string name_;
  size_t source_count_, target_count_;
  RetargetPlan plan_;
};

}  // namespace sinew
#endif
