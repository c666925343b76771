// SPDX-License-Identifier: MIT
// Fuzz target: the BVH reader; what it accepts is a sound motion that is written and read back.
#include "clip_checks.hpp"
#include "sinew_formats/io.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace sinew;
  using namespace sinew::test;
  const std::string path = input_file(data, size, "input.bvh");
  Motion motion;
  try {
    motion = read_bvh(path);
  } catch (const Error& error) {
    check_refusal(error.what(), path);
    return 0;
  }
  Character skeleton;
  read_skeleton(path, false, &skeleton);
  demand(skeleton.joints.size() == motion.joints.size() && !motion.joints.empty(), "a BVH is a skeleton");
  std::set<std::string> names;
  for (size_t j = 0; j < motion.joints.size(); ++j) {
    demand(motion.joints[j].parent < static_cast<int>(j), "parents come first");
    demand(names.insert(motion.joints[j].name).second, "joint names are unique");
    demand(!motion.joints[j].end || motion.joints[j].parent >= 0, "an end has a joint");
  }
  for (const Clip& clip : motion.clips) {
    check_clip(motion, clip);
    const std::string again = input_file(nullptr, 0, "again.bvh");
    write_bvh(again, motion, clip);
    const Motion second = read_bvh(again);  // an Error here is a finding
    demand(second.clips.size() == 1 && second.clips[0].frames.size() == clip.frames.size(), "frames are written");
    demand(second.joints.size() >= motion.joints.size(), "joints are written");
  }
  return 0;
}
