// SPDX-License-Identifier: MIT
// Limits as text.
#include "sinew_character/motion/joint_limits.hpp"

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kLines =
    "'hinge JOINT X Y Z MIN MAX', 'ball JOINT X Y Z X Y Z' and three MIN MAX, or 'fixed JOINT'";

class LimitLines {
 public:
  LimitLines(const std::string& path, const std::string& text, const MapRig& target)
      : target_(target), joints_(joints_by_name(target.joints)), lines_(path, text) {}

  std::vector<sinew_joint_limit> read() {
    std::vector<sinew_joint_limit> limits;
    while (lines_.next()) {
      words_ = lines_.words();
      for (size_t w = 0; w < words_.size(); ++w)
        if (words_[w][0] == '#') words_.resize(w);
      if (words_.empty()) continue;
      limits.push_back(one());
    }
    return limits;
  }

 private:
  sinew_joint_limit one() const {
    sinew_joint_limit limit = {};
    const bool ball = words_[0] == "ball", fixed = words_[0] == "fixed";
    if ((words_[0] != "hinge" && !ball && !fixed) || words_.size() != (ball ? 14u : fixed ? 2u : 7u))
      lines_.fail(kLines, lines_.line());
    const auto found = joints_.find(std::string(words_[1]));
    if (found == joints_.end())
      lines_.fail("a joint of " + target_.name + " (its first is " + target_.joints[0].name + ")", words_[1]);
    limit.joint = found->second;
    limit.kind = ball ? SINEW_LIMIT_BALL : SINEW_LIMIT_HINGE;
    limit.axis[0] = fixed ? 1.0f : 0.0f;
    if (fixed) return limit;
    take_axis(2, limit.axis);
    take_range(ball ? 8 : 5, 0, &limit);
    if (!ball) return limit;
    take_axis(5, limit.side);
    take_range(10, 1, &limit);
    take_range(12, 2, &limit);
    return limit;
  }

  float number(size_t word) const {
    const std::optional<float> value = to_finite_float(words_[word]);
    if (!value) lines_.fail("a number", words_[word]);
    return *value;
  }
  void take_axis(size_t word, float (&axis)[3]) const {
    for (size_t i = 0; i < 3; ++i) axis[i] = number(word + i);
    if (axis[0] == 0 && axis[1] == 0 && axis[2] == 0) lines_.fail("an axis that is not 0 0 0", lines_.line());
  }
  void take_range(size_t word, size_t which, sinew_joint_limit* limit) const {
    const float least = number(word), most = number(word + 1);
    if (!(least >= -180 && most <= 180 && least <= most) || (which > 0 && (least > 0 || most < 0)))
      lines_.fail(which > 0 ? "a swing with a minimum of -180 to 0 and a maximum of 0 to 180"
                            : "degrees from -180 to 180, the minimum first",
                  lines_.line());
    limit->least[which] = least;
    limit->most[which] = most;
  }

  const MapRig& target_;
  const std::map<std::string, uint32_t> joints_;
  TextLines lines_;
  std::vector<std::string_view> words_;
};

}  // namespace

std::vector<sinew_joint_limit> read_joint_limits(const std::string& path, const MapRig& target) {
  const std::string text = read_text_file(path);
  std::vector<sinew_joint_limit> limits = LimitLines(path, text, target).read();
  if (limits.empty()) throw Error(path + ": expected lines " + kLines + ", found none");
  return limits;
}

std::vector<sinew_joint_limit> joint_limits(const std::string& source, const MapRig& target, MaybeAxis up) {
  if (source == "human") return human_joint_limits(target, up);
  return has_extension(source, ".urdf") ? urdf_joint_limits(source, target) : read_joint_limits(source, target);
}

}  // namespace sinew
