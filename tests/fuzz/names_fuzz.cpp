// SPDX-License-Identifier: MIT
// Fuzz target: names of joints from strangers. What is read is in its documented range, a side that is exchanged twice is
// the name again, and a second run with another content of the workspace says the same.
#include <algorithm>

#include "fuzz.hpp"
#include "sinew/names.h"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace {

using namespace sinew::test;

struct Verdicts {
  std::vector<uint8_t> classes, roles;
  std::vector<int32_t> numbers, partners, images;
  sinew_status status = SINEW_OK;

  Verdicts(const sinew_skeleton& skeleton, const uint8_t* follows, uint8_t fill)
      : classes(skeleton.joint_count),
        roles(classes),
        numbers(skeleton.joint_count),
        partners(numbers),
        images(numbers) {
    size_t bytes = 0;
    demand(sinew_joint_classes_workspace_size(skeleton.joint_count, &bytes) == SINEW_OK, "a size for every count");
    sinew::Workspace workspace(bytes);
    std::fill_n(static_cast<uint8_t*>(workspace.data()), bytes, fill);
    sinew_joint_verdicts out = SINEW_INIT(sinew_joint_verdicts);
    out.classes = classes.data();
    out.roles = roles.data();
    out.numbers = numbers.data();
    out.partners = partners.data();
    out.images = images.data();
    status = sinew_joint_classes(&skeleton, follows, workspace.data(), workspace.size(), &out);
  }
  bool operator==(const Verdicts& o) const = default;
};

void check_side(const std::string& name) {
  const int32_t side = sinew_joint_side(name.c_str());
  std::vector<char> other(name.size() + 8), back(name.size() + 16);
  if (side == 0 || sinew_joint_other_side(name.c_str(), other.data(), other.size()) != SINEW_OK) return;
  demand(sinew_joint_side(other.data()) == -side, "the other side is the other side: " + name + " and " + other.data());
  demand(sinew_joint_other_side(other.data(), back.data(), back.size()) == SINEW_OK &&
             sinew_joint_side(back.data()) == side,
         "and back");
}

}  // namespace

// A count and a shape; then a parent, what follows, a length and that many bytes of name for each joint.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Bytes in(data, size);
  const uint32_t count = 1 + in.below(24);
  const uint8_t shape = in.u8();
  std::vector<std::string> names(count);
  std::vector<const char*> texts;
  std::vector<int32_t> parents;
  std::vector<uint8_t> follows;
  std::vector<float> positions;
  for (uint32_t j = 0; j < count; ++j) {
    parents.push_back(j == 0 ? -1 : static_cast<int32_t>(in.below(j + 1)) - 1);
    follows.push_back(static_cast<uint8_t>(in.below(3)));
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(in.u8()) / 16.0f);
    for (uint32_t left = in.below(40); left > 0; --left) names[j] += static_cast<char>(in.u8());
    check_side(names[j].c_str());
  }
  for (const std::string& name : names) texts.push_back(name.c_str());
  sinew_skeleton skeleton = sinew_test::skeleton_of(positions.data(), parents.data(), count);
  skeleton.names = texts.data();
  const uint8_t* const told = (shape & 1) != 0 ? follows.data() : nullptr;
  const Verdicts first(skeleton, told, 0), second(skeleton, told, 0xA5);
  demand(first.status == SINEW_OK, "every name is read");
  demand(first == second, "the workspace's content says nothing");
  for (uint32_t j = 0; j < count; ++j) {
    demand(first.classes[j] <= SINEW_CLASS_PROP && first.roles[j] <= SINEW_ROLE_HELPER, "a class and a role");
    demand(first.partners[j] >= -1 && first.partners[j] < static_cast<int32_t>(count), "a partner is a joint");
    demand(first.images[j] >= -1 && first.images[j] < static_cast<int32_t>(count), "an image is a joint");
    demand(first.numbers[j] >= -1, "a number");
    if (told != nullptr && follows[j] == SINEW_FOLLOWS_SOME)
      demand(first.roles[j] != SINEW_ROLE_END, "what owns weight is no end");
  }
  return 0;
}
