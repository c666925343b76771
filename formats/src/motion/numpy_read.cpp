// SPDX-License-Identifier: MIT
// Motions in NumPy files: rotations of SMPL, SMPL-H and SMPL-X, joints with positions and rotations, HumanML3D's
// features, or keypoints alone. No body model is needed.
#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/keypoint_layouts.hpp"
#include "motion/named_skeletons.hpp"
#include "motion/npy.hpp"
#include "motion/person.hpp"
#include "motion/posed_joints.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/keypoints_stream.hpp"
#include "sinew_formats/print.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

Quaternion of_axis_angle(const double* v) {
  const double angle = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const double s = angle > 1e-12 ? std::sin(angle / 2) / angle : 0.5;
  return normalized({s * v[0], s * v[1], s * v[2], std::cos(angle / 2)});
}
// The first two columns of the matrix, one behind the other (Zhou et al. 2019).
Quaternion of_six(const double* v) {
  return quaternion_of(rotation_part({v[0], v[3], 0, 0, v[1], v[4], 0, 0, v[2], v[5], 0, 0}));
}
Quaternion of_matrix(const double* v) {  // row by row
  return quaternion_of(rotation_part({v[0], v[1], v[2], 0, v[3], v[4], v[5], 0, v[6], v[7], v[8], 0}));
}

constexpr size_t kFeatures = 263, kFeatureJoints = 22;  // of HumanML3D

class NumpyReader {
 public:
  NumpyReader(const std::string& path, const std::string& layout)
      : path_(path), layout_(layout), file_(read_npy_file(path)) {}

  Motion read() {
    if (layout_.empty() && has_rotations())
      read_rotations();
    else if (layout_.empty() && posed_rotations() != nullptr)
      read_posed_joints();
    else if (const NpyArray* features = features_array())
      read_features(*features);
    else
      read_keypoints();
    motion_.name = stem_of(path_);
    Clip& clip = motion_.clips[0];
    clip.name = motion_.name;
    return std::move(motion_);
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": expected " + expected + ", found " + found);
  }

  const NpyArray* look_up(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto at = file_.arrays.find(name); at != file_.arrays.end()) return &at->second;
    return nullptr;
  }
  // An array whose numbers are used. Those of the others may be anything: captures mark what they did not see with NaN.
  const NpyArray* find(std::initializer_list<const char*> names) const {
    const NpyArray* const array = look_up(names);
    if (array != nullptr) check_numbers(*array);
    return array;
  }
  void check_numbers(const NpyArray& array) const {
    for (size_t i = 0; i < array.values.size(); ++i)
      if (!std::isfinite(array.values[i]))
        throw Error(path_ + (array.name.empty() ? "" : ": " + in_quotes(array.name)) +
                    ": expected finite numbers, found another at " + std::to_string(i));
  }
  std::string arrays_text() const {
    std::string text;
    for (const auto& [name, array] : file_.arrays) {
      std::string sides;
      for (const size_t side : array.shape) sides += (sides.empty() ? "" : ", ") + std::to_string(side);
      text += (text.empty() ? "" : ", ") + (name.empty() ? std::string() : in_quotes(name) + " ") + "[" + sides + "]";
      if (text.size() > 300) return text + ", ...";
    }
    return text.empty() ? "no numbers" : text;
  }
  bool has_rotations() const { return look_up({"poses", "smpl_poses", "global_orient", "root_orient"}) != nullptr; }

  double frame_time(double fps) {
    const NpyArray* const rate = find({"mocap_framerate", "mocap_frame_rate", "fps", "frame_rate"});
    if (rate != nullptr && rate->values.size() == 1)
      fps = rate->values[0];
    else
      motion_.notes.push_back(
          print("no frame rate in the file; %g frames per second were assumed, so the speed may be wrong", fps));
    if (!(fps > 0.1 && fps < 1e5)) fail("a frame rate", print("%g", fps));
    return 1 / fps;
  }

  // [frames x numbers] of one frame's rotations, from one array or several side by side.
  std::vector<const NpyArray*> rotation_arrays() const {
    if (const NpyArray* poses = find({"poses", "smpl_poses"})) return {poses};
    const NpyArray* const root = find({"global_orient", "root_orient"});
    const NpyArray* const body = find({"body_pose", "pose_body"});
    if (body == nullptr) fail("'body_pose' beside 'global_orient'", arrays_text());
    std::vector<const NpyArray*> all = {root, body};
    const NpyArray* const both = find({"pose_hand"});
    const NpyArray* const left = find({"left_hand_pose"});
    const NpyArray* const right = find({"right_hand_pose"});
    if (both != nullptr)
      all.push_back(both);
    else if (left != nullptr && right != nullptr)
      all.insert(all.end(), {left, right});
    return all;
  }

  void read_rotations() {
    const std::vector<const NpyArray*> arrays = rotation_arrays();
    const size_t frames = arrays[0]->rows();
    size_t width = 0;
    for (const NpyArray* array : arrays) {
      if (array->shape.empty() || array->rows() != frames || frames == 0)
        fail("rotations of as many frames in all arrays", arrays_text());
      width += array->width();
    }
    const auto [model, numbers] = model_of(width, arrays);
    if (frames > kMostRotations / model->joints.size())
      fail("at most " + std::to_string(kMostRotations) + " frames times joints", std::to_string(frames) + " frames");
    const NpyArray* const moves = find({"trans", "transl", "smpl_trans"});
    if (moves != nullptr && (moves->rows() != frames || moves->width() != 3))
      fail("'trans' of 3 numbers per frame", arrays_text());
    const double scale = body_scale();
    motion_.joints = person_joints(model->joints);
    Clip clip;
    clip.frame_time = frame_time(look_up({"smpl_poses"}) != nullptr ? 60 : 30);
    std::vector<double> row;
    for (size_t f = 0; f < frames; ++f) {
      row.clear();
      for (const NpyArray* array : arrays) {
        const auto begin = array->values.begin() + static_cast<std::ptrdiff_t>(f * array->width());
        row.insert(row.end(), begin, begin + static_cast<std::ptrdiff_t>(array->width()));
      }
      clip.frames.push_back(frame_of(row, numbers));
      if (moves == nullptr) continue;
      const double* const v = &moves->values[3 * f];
      clip.frames.back().translations[0] = (1 / scale) * Point3{v[0], v[1], v[2]};
    }
    motion_.notes.push_back(
        print("%s, %zu numbers per rotation%s; bone lengths are those of a built-in person, not of a body model",
              model->name, numbers, numbers == 6 ? " (two columns of the matrix)" : ""));
    motion_.clips.push_back(std::move(clip));
    stand_up();
  }

  // AIST++ divides its positions by how many units of 'smpl_trans' are a meter.
  double body_scale() const {
    const NpyArray* const scaling = find({"smpl_scaling"});
    if (scaling == nullptr) return 1;
    if (scaling->values.size() != 1 || !(scaling->values[0] > 0))
      fail("'smpl_scaling' of one number above 0", arrays_text());
    return scaling->values[0];
  }

  // By the number of values per frame, which is unique for each model and form. Separate keypoints give the number
  // per rotation.
  std::pair<const BodyModel*, size_t> model_of(size_t width, const std::vector<const NpyArray*>& arrays) const {
    const size_t said = arrays.size() > 1 ? arrays[0]->width() : 0;
    for (const BodyModel& model : body_models())
      for (const size_t numbers : {3u, 6u, 9u})
        if (model.joints.size() * numbers == width && (said == 0 || said == numbers)) return {&model, numbers};
    fail("rotations of 22 (SMPL without hands), 24 (SMPL), 52 (SMPL-H) or 55 joints (SMPL-X), 3, 6 or 9 numbers each",
         arrays_text());
  }

  MotionFrame frame_of(const std::vector<double>& row, size_t numbers) const {
    MotionFrame frame;
    for (size_t j = 0; j < motion_.joints.size(); ++j) {
      const double* const v = &row[numbers * j];
      const Quaternion q = numbers == 3 ? of_axis_angle(v) : numbers == 6 ? of_six(v) : of_matrix(v);
      frame.rotations.push_back(motion_.joints[j].end ? kNoRotation4 : q);
      frame.translations.push_back(motion_.joints[j].offset);
    }
    return frame;
  }

  // The rest pose has y up; the clip's world may have z up, as AMASS.
  void stand_up() {
    Point3 up{};
    for (const MotionFrame& frame : motion_.clips[0].frames) up = up + rotate(frame.rotations[0], {0, 1, 0});
    const Quaternion turn = turn_to_y_up(up);
    if (turn == kNoRotation4) return;
    motion_.notes.push_back("the body is upright along " + axis_name(up) +
                            ", so that axis was taken as up; correct it with --from-up");
    for (MotionFrame& frame : motion_.clips[0].frames) {
      frame.rotations[0] = normalized(multiply(turn, frame.rotations[0]));
      frame.translations[0] = rotate(turn, frame.translations[0]);
    }
  }

  // The array of keypoints: by its name, else the only one of that shape.
  const NpyArray* keypoints_array() const {
    const auto fits = [](const NpyArray& a) { return a.shape.size() == 3 && (a.shape[2] == 3 || a.shape[2] == 4); };
    for (const char* name :
         {"posed_joints", "joints", "joints3d", "joints_3d", "positions", "keypoints", "keypoints3d", "motion", ""})
      if (const NpyArray* array = look_up({name}); array != nullptr && fits(*array)) return array;
    const NpyArray* only = nullptr;
    for (const auto& [name, array] : file_.arrays) {
      if (!fits(array)) continue;
      if (only != nullptr) return nullptr;
      only = &array;
    }
    return only;
  }

  const KeypointsLayout& layout_of(const std::vector<std::vector<Point3>>& keypoints) {
    const size_t count = keypoints[0].size();
    if (layout_.empty()) return guessed_layout(keypoints);
    for (const KeypointsLayout& layout : keypoint_layouts()) {
      if (layout_ != layout.name) continue;
      if (layout.count != count)
        fail(std::to_string(layout.count) + " joints of " + layout.name, std::to_string(count));
      return layout;
    }
    fail("a layout (" + motion_layouts() + ")", in_quotes(layout_));
  }

  const KeypointsLayout& guessed_layout(const std::vector<std::vector<Point3>>& keypoints) {
    const size_t count = keypoints[0].size();
    std::string misfits;
    if (const KeypointsLayout* layout = recognize_layout(keypoints, &misfits)) {
      motion_.notes.push_back(print(
          "%zu keypoints per frame that fit the layout %s, so the layout %s was assumed; choose another with --layout",
          count, layout->name, layout->name));
      return *layout;
    }
    if (!misfits.empty())
      fail(print("%zu keypoints that fit one known layout", count),
           "misfits of " + misfits +
               " (bones that change their lengths, unequal sides, proportions); choose one with --layout NAME");
    fail("as many keypoints per frame as a known layout (" + motion_layouts() + ")", std::to_string(count));
  }

  void check_frames(size_t frames, size_t joints) const {
    if (frames == 0 || frames > kMostRotations / joints)
      fail("1 to " + std::to_string(kMostRotations / joints) + " frames", std::to_string(frames));
  }

  // [frames][joints] of an array [frames, joints, 3 or 4]; the fourth number is left out.
  std::vector<std::vector<Point3>> rows_of(const NpyArray& array) const {
    check_numbers(array);
    const size_t frames = array.shape[0], count = array.shape[1], width = array.shape[2];
    if (count == 0) fail("keypoints [frames, joints, 3]", arrays_text());
    check_frames(frames, count);
    std::vector<std::vector<Point3>> rows(frames);
    for (size_t f = 0; f < frames; ++f)
      for (size_t j = 0; j < count; ++j) {
        const double* const v = &array.values[(f * count + j) * width];
        rows[f].push_back({v[0], v[1], v[2]});
        for (const double x : rows[f].back())
          if (!(std::abs(x) < 1e6)) fail("keypoints within a million of the origin", print("%g in frame %zu", x, f));
      }
    return rows;
  }

  void take(Motion found, double fps) {
    found.notes.insert(found.notes.begin(), motion_.notes.begin(), motion_.notes.end());
    motion_ = std::move(found);
    motion_.clips[0].frame_time = frame_time(fps);
  }

  void read_keypoints() {
    const NpyArray* const array = keypoints_array();
    if (array == nullptr)
      fail("'poses' or 'global_orient' and 'body_pose' of a body model, or keypoints [frames, joints, 3]",
           arrays_text());
    const std::vector<std::vector<Point3>> keypoints = rows_of(*array);
    const KeypointsLayout& layout = layout_of(keypoints);
    take(motion_of_keypoints(layout, keypoints), layout.fps);
  }

  // Rotations in the world beside keypoints, [frames, joints, 3, 3]; or null.
  const NpyArray* posed_rotations() const {
    const NpyArray* const rotations = look_up({"global_rot_mats", "global_rotations", "global_rots"});
    const NpyArray* const positions = keypoints_array();
    if (rotations == nullptr || positions == nullptr) return nullptr;
    const std::vector<size_t> shape = {positions->shape[0], positions->shape[1], 3, 3};
    return rotations->shape == shape ? rotations : nullptr;
  }

  void read_posed_joints() {
    const NpyArray& rotations = *posed_rotations();
    check_numbers(rotations);
    PosedJoints joints = {rows_of(*keypoints_array()), {}};
    const double* matrix = rotations.values.data();
    for (const std::vector<Point3>& row : joints.positions) {
      std::vector<Quaternion>& own = joints.rotations.emplace_back();
      for (size_t j = 0; j < row.size(); ++j, matrix += 9) own.push_back(of_matrix(matrix));
    }
    take(motion_of_posed_joints(path_, joints), 30);
    stand_up();
  }

  // HumanML3D's features, [frames, 263]; or null.
  const NpyArray* features_array() const {
    for (const auto& [name, array] : file_.arrays)
      if (array.shape.size() == 2 && array.shape[1] == kFeatures) return &array;
    return nullptr;
  }

  // Per frame: the root's rotation about y and its step to the next frame in its own axes (x, z), its height, then
  // the other joints' positions in its axes. What follows (rotations, velocities, contacts) says the same once more.
  void read_features(const NpyArray& features) {
    check_numbers(features);
    check_frames(features.rows(), kFeatureJoints);
    std::vector<std::vector<Point3>> rows;
    double angle = 0;  // of half the rotation
    Point3 root{};
    for (size_t f = 0; f < features.rows(); ++f) {
      const double* const v = &features.values[f * kFeatures];
      if (f > 0) {
        const double* const before = v - kFeatures;
        angle += before[0];
        root = root + rotate(axis_rotation(1, -2 * angle), {before[1], 0, before[2]});
      }
      const Quaternion turn = axis_rotation(1, -2 * angle);
      root[1] = v[3];
      std::vector<Point3>& row = rows.emplace_back(1, root);
      for (size_t j = 1; j < kFeatureJoints; ++j) {
        const double* const at = v + 4 + 3 * (j - 1);
        row.push_back(rotate(turn, {at[0], at[1], at[2]}) + Point3{root[0], 0, root[2]});
      }
    }
    const KeypointsLayout& layout = layout_of(rows);
    motion_.notes.insert(motion_.notes.begin(),
                         print("%zu numbers per frame were read as HumanML3D features", kFeatures));
    take(motion_of_keypoints(layout, rows), layout.fps);
  }

  const std::string path_, layout_;
  const NpyFile file_;
  Motion motion_;
};

}  // namespace

Motion read_numpy_motion(const std::string& path, const std::string& layout) {
  return NumpyReader(path, layout).read();
}

}  // namespace sinew
