// SPDX-License-Identifier: MIT
// Acclaim's pair of files: the skeleton (.asf) with bones as directions and lengths, and the frames (.amc). A bone
// rotates about its own begin, by angles in axes of its own.
#include <algorithm>
#include <filesystem>
#include <map>
#include <numbers>

#include "motion/person.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/lower_case.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kAcclaimFps = 120,
                 kInch = 0.0254;  // frames per second and unit of the CMU captures: the files say neither

// A bone; the root is the first, without length.
struct AcclaimBone {
  std::string name;
  Point3 direction{};
  double length = 0;
  Quaternion axes = kNoRotation4;     // of its angles, against the world at rest
  std::vector<std::string> channels;  // "rx", "tz": the order of its numbers in a frame
  int parent = -1;
};

// Rotations about the axes in `order`, the first letter first.
Quaternion rotation_in_order(const std::string& order, const Point3& radians) {
  Quaternion out = kNoRotation4;
  for (const char axis : order) {
    if (axis < 'x' || axis > 'z') continue;
    const size_t i = static_cast<size_t>(axis - 'x');
    out = multiply(axis_rotation(i, radians[i]), out);
  }
  return out;
}

// Lines of a file in which '#' begins a comment, with the errors of both files.
class AcclaimLines {
 public:
  AcclaimLines(const std::string& path, std::string_view text) : lines_(path, text) {}

  // The next line with words; false at the end.
  bool next() {
    while (lines_.next())
      if (!lines_.words().empty() && lines_.words()[0][0] != '#') return true;
    return false;
  }
  size_t count() const { return lines_.words().size(); }
  std::string word(size_t i) const { return i < count() ? std::string(lines_.words()[i]) : ""; }
  double number(size_t i, const std::string& what) const {
    const std::optional<double> value = to_finite_double(word(i));
    if (!value) fail("a finite number as " + what, word(i));
    return *value;
  }
  Point3 point(size_t i, const std::string& what) const {
    return {number(i, what), number(i + 1, what), number(i + 2, what)};
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const { lines_.fail(expected, found); }

 private:
  TextLines lines_;
};

struct AcclaimSkeleton {
  std::vector<AcclaimBone> bones;
  double to_radians = std::numbers::pi / 180, to_meters = kInch;
};

class AsfReader {
 public:
  AsfReader(const std::string& path, std::string_view text) : path_(path), lines_(path, text) {}

  AcclaimSkeleton read() {
    skeleton_.bones.push_back({"root", {}, 0, kNoRotation4, {}, -1});
    std::string section;
    while (lines_.next()) {
      const std::string word = lower_case(lines_.word(0));
      if (word[0] == ':')
        section = word;
      else if (section == ":units")
        read_unit(word);
      else if (section == ":root")
        read_root(word);
      else if (section == ":bonedata")
        read_bone(word);
      else if (section == ":hierarchy" && word != "begin" && word != "end")
        read_children();
    }
    if (skeleton_.bones.size() < 2)
      throw Error(path_ + ": expected an Acclaim skeleton with ':bonedata', found no bone");
    return std::move(skeleton_);
  }

 private:
  void read_unit(const std::string& word) {
    if (word == "length") {
      const double length = lines_.number(1, "a length");
      if (!(length > 0)) lines_.fail("a length above 0", lines_.word(1));
      skeleton_.to_meters = kInch / length;
    }
    if (word == "angle" && lower_case(lines_.word(1)).rfind("rad", 0) == 0) skeleton_.to_radians = 1;
  }

  void read_root(const std::string& word) {
    AcclaimBone& root = skeleton_.bones[0];
    if (word == "order")
      for (size_t i = 1; i < lines_.count(); ++i) root.channels.push_back(lower_case(lines_.word(i)));
    if (word == "axis") root_order_ = lower_case(lines_.word(1));
    if (word == "orientation")
      root.axes = rotation_in_order(root_order_, skeleton_.to_radians * lines_.point(1, "an angle"));
  }

  void read_bone(const std::string& word) {
    if (word == "begin") skeleton_.bones.emplace_back();
    if (word == "begin" || word == "end") return;
    if (skeleton_.bones.size() < 2) lines_.fail("'begin' of a bone", lines_.word(0));
    AcclaimBone& bone = skeleton_.bones.back();
    if (word == "name") bone.name = lines_.word(1);
    if (word == "direction") bone.direction = unit(lines_.point(1, "a direction"));
    if (word == "length") bone.length = lines_.number(1, "a length");
    if (word == "axis")
      bone.axes = rotation_in_order(lines_.count() > 4 ? lower_case(lines_.word(4)) : "xyz",
                                    skeleton_.to_radians * lines_.point(1, "an angle"));
    if (word == "dof")
      for (size_t i = 1; i < lines_.count(); ++i) bone.channels.push_back(lower_case(lines_.word(i)));
  }

  // A parent, then its children.
  void read_children() {
    const size_t parent = bone_named(lines_.word(0));
    for (size_t i = 1; i < lines_.count(); ++i) {
      const size_t child = bone_named(lines_.word(i));
      for (int up = static_cast<int>(parent); up >= 0; up = skeleton_.bones[static_cast<size_t>(up)].parent)
        if (static_cast<size_t>(up) == child)
          lines_.fail("a tree of bones", lines_.word(i) + ", which is above itself");
      skeleton_.bones[child].parent = static_cast<int>(parent);
    }
  }
  size_t bone_named(const std::string& name) const {
    for (size_t b = 0; b < skeleton_.bones.size(); ++b)
      if (skeleton_.bones[b].name == name) return b;
    lines_.fail("a bone of ':bonedata'", name);
  }

  const std::string& path_;
  AcclaimLines lines_;
  AcclaimSkeleton skeleton_;
  std::string root_order_ = "xyz";
};

// NAME.asf, the .asf whose name NAME begins with up to a '_' (a subject of CMU's), or the only one of the folder.
std::string asf_beside(const std::string& amc) {
  const std::filesystem::path folder = std::filesystem::path(amc).parent_path();
  const std::string stem = stem_of(amc);
  for (size_t end = stem.size(); end != std::string::npos && end > 0; end = stem.rfind('_', end - 1)) {
    const std::string asf = (folder / (stem.substr(0, end) + ".asf")).string();
    if (is_file(asf)) return asf;
  }
  std::vector<std::string> others;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, ignored))
    if (has_extension(entry.path().string(), ".asf")) others.push_back((folder / entry.path().filename()).string());
  if (others.size() == 1) return others[0];
  throw Error(amc + ": expected its skeleton beside it, " + stem + ".asf, found " +
              (others.empty() ? "none" : std::to_string(others.size()) + " others") +
              "; copy the matching .asf there under this name");
}

class AmcReader {
 public:
  AmcReader(const std::string& path, std::string_view text, const AcclaimSkeleton& skeleton)
      : path_(path), lines_(path, text), skeleton_(skeleton), to_radians_(skeleton.to_radians) {}

  Motion read() {
    motion_.name = stem_of(path_);
    add_joints();
    Clip clip = {motion_.name, 1 / kAcclaimFps, {}};
    while (lines_.next()) {
      const std::string word = lower_case(lines_.word(0));
      if (word == ":radians") to_radians_ = 1;
      if (word == ":degrees") to_radians_ = std::numbers::pi / 180;
      if (word[0] == ':') continue;
      if (lines_.count() == 1 && to_integer(word))
        clip.frames.push_back(begin_frame());
      else if (clip.frames.empty())
        lines_.fail("the number of a frame", lines_.word(0));
      else
        read_bone(&clip.frames.back());
    }
    if (clip.frames.empty()) throw Error(path_ + ": expected frames, found none");
    motion_.clips.push_back(std::move(clip));
    motion_.notes.push_back(
        print("no frame rate in the file; %g frames per second were assumed, so the speed may be wrong", kAcclaimFps));
    return std::move(motion_);
  }

 private:
  // A joint where each bone begins, and ends of the last ones.
  void add_joints() {
    const auto tip = [&](const AcclaimBone& bone) { return skeleton_.to_meters * bone.length * bone.direction; };
    std::vector<char> has_child(skeleton_.bones.size(), 0);
    for (const AcclaimBone& bone : skeleton_.bones) {
      const bool root = motion_.joints.empty();
      if (!root && bone.parent < 0)
        throw Error(path_ + ": expected a parent of each bone in ':hierarchy' of its .asf, found none of " +
                    in_quotes(bone.name));
      const size_t parent = root ? 0 : static_cast<size_t>(bone.parent);
      if (!root) has_child[parent] = 1;
      motion_.joints.push_back({bone.name, bone.parent, root ? Point3{} : tip(skeleton_.bones[parent])});
      numbers_.emplace(bone.name, numbers_.size());
    }
    for (size_t b = 0; b < skeleton_.bones.size(); ++b)
      if (has_child[b] == 0)
        motion_.joints.push_back(
            {skeleton_.bones[b].name + "_end", static_cast<int>(b), tip(skeleton_.bones[b]), true});
    motion_.joints[0].offset = {0, -lowest_at_rest(motion_), 0};
  }

  MotionFrame begin_frame() {
    if (++frame_count_ > kMostRotations / motion_.joints.size())
      lines_.fail("at most " + std::to_string(kMostRotations) + " frames times joints", "more");
    MotionFrame frame;
    for (const MotionJoint& joint : motion_.joints) {
      frame.rotations.push_back(kNoRotation4);
      frame.translations.push_back(joint.offset);
    }
    return frame;
  }

  void read_bone(MotionFrame* frame) const {
    const auto at = numbers_.find(lines_.word(0));
    if (at == numbers_.end()) lines_.fail("a bone of the .asf", lines_.word(0));
    const AcclaimBone& bone = skeleton_.bones[at->second];
    if (lines_.count() != bone.channels.size() + 1)
      lines_.fail(std::to_string(bone.channels.size()) + " numbers of " + bone.name,
                  std::to_string(lines_.count() - 1) + " numbers");
    Point3 angles{}, position{};
    std::string order;
    for (size_t i = 0; i < bone.channels.size(); ++i) {
      const std::string& channel = bone.channels[i];
      const double value = lines_.number(i + 1, "a channel");
      if (channel.size() != 2 || channel[1] < 'x' || channel[1] > 'z') continue;  // "l": a length that changes
      const size_t axis = static_cast<size_t>(channel[1] - 'x');
      if (channel[0] == 't') position[axis] = skeleton_.to_meters * value;
      if (channel[0] != 'r') continue;
      angles[axis] = to_radians_ * value;
      order += channel[1];
    }
    const Quaternion turn = rotation_in_order(order, angles);
    frame->rotations[at->second] = normalized(multiply(multiply(bone.axes, turn), conjugate(bone.axes)));
    if (at->second == 0) frame->translations[0] = position;
  }

  const std::string& path_;
  AcclaimLines lines_;
  const AcclaimSkeleton& skeleton_;
  double to_radians_;
  Motion motion_;
  std::map<std::string, size_t> numbers_;  // of joints
  size_t frame_count_ = 0;
};

}  // namespace

Motion read_amc(const std::string& path) {
  const std::string skeleton_path = asf_beside(path);
  const std::vector<uint8_t> skeleton = read_file(skeleton_path), frames = read_file(path);
  const auto text = [](const std::vector<uint8_t>& bytes) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const AcclaimSkeleton bones = AsfReader(skeleton_path, text(skeleton)).read();
  return AmcReader(path, text(frames), bones).read();
}

}  // namespace sinew
