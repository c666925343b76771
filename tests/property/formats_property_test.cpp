// SPDX-License-Identifier: MIT
// Write then read is the identity: OBJ to the bit, rig.txt to its digits, GLB to half a unit of its weights.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "random_character.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

using namespace sinew;

namespace {

bool same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

double distance(const Vec3& a, const Vec3& b) {
  return std::sqrt(std::pow(static_cast<double>(a.x - b.x), 2) + std::pow(static_cast<double>(a.y - b.y), 2) +
                   std::pow(static_cast<double>(a.z - b.z), 2));
}

double scale_of(const Character& c) {
  double scale = 1e-12;
  for (const Vec3& p : c.vertices) scale = std::max(scale, distance(p, {}));
  for (const Joint& j : c.joints) scale = std::max(scale, distance(j.position, {}));
  return scale;
}

std::map<std::string, double> named_row(const Character& c, size_t v) {
  std::map<std::string, double> row;
  for (const Influence& i : c.influences[v]) row[c.joints[i.joint].name] += static_cast<double>(i.weight);
  return row;
}

double difference(std::map<std::string, double> a, const std::map<std::string, double>& b) {
  double largest = 0;
  for (const auto& [name, weight] : b) a[name] -= weight;
  for (const auto& [name, weight] : a) largest = std::max(largest, std::fabs(weight));
  return largest;
}

TEST(WriteRead, ObjIsTheSameToTheBit) {
  EXPECT_TRUE(rc::check("obj", [](uint64_t seed) {
    const Character a = RandomCharacter(seed).make();
    const TempFolder folder;
    write_obj(folder.file("a.obj"), a);
    const Character b = read_obj(folder.file("a.obj"));
    RC_ASSERT(a.vertices.size() == b.vertices.size());
    for (size_t v = 0; v < a.vertices.size(); ++v) RC_ASSERT(same(a.vertices[v], b.vertices[v]));
    RC_ASSERT(a.face_offsets == b.face_offsets);
    RC_ASSERT(a.face_vertices == b.face_vertices);
    RC_ASSERT(a.corner_uvs == b.corner_uvs);
    RC_ASSERT(a.corner_normals.size() == b.corner_normals.size());
    for (size_t k = 0; k < a.corner_normals.size(); ++k) RC_ASSERT(same(a.corner_normals[k], b.corner_normals[k]));
    RC_ASSERT(a.material_names == b.material_names);
    RC_ASSERT(a.face_materials == b.face_materials);
    RC_ASSERT(a.group_names == b.group_names);
    RC_ASSERT(a.face_groups == b.face_groups);
  }));
}

TEST(WriteRead, RigIsTheSameToItsDigits) {
  EXPECT_TRUE(rc::check("rig", [](uint64_t seed) {
    Character a = RandomCharacter(seed).make();
    const TempFolder folder;
    write_rig(folder.file("a.rig.txt"), a);
    Character b = a;
    read_skeleton(folder.file("a.rig.txt"), true, &b);
    RC_ASSERT(a.joints.size() == b.joints.size());
    for (size_t j = 0; j < a.joints.size(); ++j) {
      RC_ASSERT(a.joints[j].name == b.joints[j].name);
      RC_ASSERT(a.joints[j].parent == b.joints[j].parent);
      RC_ASSERT(distance(a.joints[j].position, b.joints[j].position) <= 1e-8 + 1e-7 * scale_of(a));
    }
    for (size_t v = 0; v < a.vertices.size(); ++v) RC_ASSERT(difference(named_row(a, v), named_row(b, v)) <= 5.1e-7);
    write_rig(folder.file("b.rig.txt"), b);
    RC_ASSERT(folder.text_of("a.rig.txt") == folder.text_of("b.rig.txt"));
  }));
}

TEST(WriteRead, GlbKeepsShapeSkeletonAndWeights) {
  EXPECT_TRUE(rc::check("glb", [](uint64_t seed) {
    const Character a = RandomCharacter(seed).make();
    const TempFolder folder;
    const bool unorm8 = seed % 2 == 1;
    write_glb(folder.file("a.glb"), a, {unorm8});
    const Character b = read_gltf(folder.file("a.glb"));
    const double scale = scale_of(a);
    RC_ASSERT(b.joints.size() == a.joints.size() || b.joints.empty());
    for (size_t j = 0; j < b.joints.size(); ++j) {
      RC_ASSERT(b.joints[j].name == a.joints[j].name);
      RC_ASSERT(b.joints[j].parent == a.joints[j].parent);
      RC_ASSERT(distance(b.joints[j].position, a.joints[j].position) <= 1e-6 * scale);
    }
    size_t triangles = 0;
    for (size_t f = 0; f < a.face_count(); ++f) triangles += a.face_offsets[f + 1] - a.face_offsets[f] - 2;
    RC_ASSERT(b.face_count() == triangles);
    RC_ASSERT(b.corner_uvs.empty() == a.corner_uvs.empty());
    if (!b.joints.empty()) {
      // A vertex without weights in a bound mesh goes to the first root; others come back within the rounding of the
      // format.
      for (size_t v = 0; v < a.vertices.size(); ++v) {
        if (a.influences[v].empty()) continue;
        double nearest = 1e30;
        for (size_t w = 0; w < b.vertices.size(); ++w)
          if (distance(a.vertices[v], b.vertices[w]) <= 1e-5 * scale)
            nearest = std::min(nearest, difference(named_row(a, v), named_row(b, w)));
        bool in_a_face = false;
        for (const uint32_t u : a.face_vertices) in_a_face = in_a_face || u == v;
        if (in_a_face) RC_ASSERT(nearest <= (unorm8 ? 10.0 / 255 : 10.0 / 65535));
      }
    }
    write_glb(folder.file("b.glb"), b, {unorm8});
    const Character c = read_gltf(folder.file("b.glb"));
    write_glb(folder.file("c.glb"), c, {unorm8});
    RC_ASSERT(folder.text_of("b.glb") == folder.text_of("c.glb"));
  }));
}

TEST(Decimate, AnyCharacterStaysSound) {
  EXPECT_TRUE(rc::check("decimate", [](uint64_t seed) {
    RandomCharacter random(seed);
    const Character a = random.make();
    const Character b = decimate(a, 0.3 + 0.7 * static_cast<double>(random.below(100)) / 100);
    const CheckReport report = check_character(b);
    RC_ASSERT(report.isolated_vertices == 0u);
    RC_ASSERT(report.duplicate_faces == 0u || report.duplicate_faces < b.face_count());
    RC_ASSERT(b.vertices.size() <= a.vertices.size());
    RC_ASSERT(b.influences.size() == b.vertices.size());
    for (size_t v = 0; v < b.vertices.size(); ++v) {
      bool found = false;
      for (size_t w = 0; w < a.vertices.size() && !found; ++w)
        found = same(a.vertices[w], b.vertices[v]) && difference(named_row(a, w), named_row(b, v)) == 0;
      RC_ASSERT(found);
    }
  }));
}

}  // namespace
