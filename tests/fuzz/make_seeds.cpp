// SPDX-License-Identifier: MIT
// Writes the binary seeds of the corpus: models of a few hundred bytes, GLB files, and calls of the engine.
//   sinew_fuzz_seeds tests/fuzz/corpus
#include <cstdio>
#include <string>

#include "make_glb.hpp"
#include "network_fixture.hpp"
#include "numpy_bytes.hpp"
#include "sinew_formats/io.hpp"
#include "vmd_bytes.hpp"
#ifdef SINEW_HAS_MESHOPT
#include "meshopt_glb.hpp"
#endif
#ifdef SINEW_HAS_DRACO
#include "draco_glb.hpp"
#endif

namespace {

using namespace sinew;
using namespace sinew::test;

void write(const std::string& path, const std::string& bytes) { write_text_file(path, bytes); }

IntegerLinear linear(uint16_t in, uint16_t out, ValueRange range) {
  IntegerLinear p;
  p.in = p.block = in;
  p.out = out;
  p.range = range;
  p.bias.assign(out, 1 << 9);
  for (uint32_t i = 0; i < uint32_t{in} * out; ++i) p.weights.push_back(static_cast<int16_t>(i * 37 % 201) - 100);
  p.shifts.assign(out, 10);
  return p;
}
Layer layer(LayerKind kind, Region in, Region out, uint32_t parameters = 0, uint8_t flags = 0) {
  Layer l;
  l.kind = kind;
  l.flags = flags;
  l.in = in;
  l.out = out;
  l.parameters = parameters;
  return l;
}

// Every kind of layer is in one of the two.
IntegerModel pair_model(bool spectral) {
  IntegerModel m;
  m.candidate_count = 4;
  m.feature_set = kFeatureSet | (spectral ? kSpectralFlag : 0);
  const uint16_t vertex = static_cast<uint16_t>(vertex_channels(m.feature_set));
  m.buffers = {{Domain::kVertex, vertex}, {Domain::kPair, static_cast<uint16_t>(kPairFeatures)},
               {Domain::kPair, 9},        {Domain::kPair, 3},
               {Domain::kPair, 1},        {Domain::kVertex, 8}};
  m.layers = {layer(LayerKind::kLinear, {1, 0, 5}, {2, 0, 3}, 0, kLayerRelu),
              layer(LayerKind::kRingMean, {2, 0, 3}, {2, 3, 3}),
              layer(LayerKind::kCandidateMax, {2, 3, 1}, {2, 6, 1}),
              layer(LayerKind::kRingMax, {0, 0, 2}, {5, 0, 2}),
              layer(LayerKind::kPartMean, {5, 0, 2}, {5, 2, 2}),
              layer(LayerKind::kGlobalMax, {5, 1, 2}, {5, 4, 2}),
              layer(LayerKind::kGlobalMean, {0, 1, 2}, {5, 6, 2}),
              layer(LayerKind::kVertexToPair, {5, 3, 2}, {2, 7, 2}),
              layer(LayerKind::kLinear, {2, 0, 9}, {3, 0, 3}, 1, kLayerRelu | kLayerResidual),
              layer(LayerKind::kLinear, {3, 0, 3}, {4, 0, 1}, 2)};
  m.layers[8].residual = {2, 0, 3};
  m.linears = {linear(5, 3, ValueRange::kPositive), linear(9, 3, ValueRange::kPositive),
               linear(3, 1, ValueRange::kLogits)};
  m.linears[1].residual.assign(3, 1024);
  return m;
}
IntegerModel slot_model() {  // tied to its candidates
  IntegerModel m;
  m.candidate_count = 3;
  m.feature_set = kFeatureSet;
  m.buffers = {{Domain::kVertex, static_cast<uint16_t>(kVertexFeatures)},
               {Domain::kPair, static_cast<uint16_t>(kPairFeatures)},
               {Domain::kVertex, 6},
               {Domain::kVertex, 3},
               {Domain::kPair, 1}};
  m.layers = {layer(LayerKind::kPairToVertex, {1, 0, 2}, {2, 0, 6}), layer(LayerKind::kLinear, {2, 0, 6}, {3, 0, 3}, 0),
              layer(LayerKind::kVertexToSlots, {3, 0, 3}, {4, 0, 1})};
  m.linears = {linear(6, 3, ValueRange::kLogits)};
  return m;
}
IntegerModel wide_model() {  // int64 sums in blocks
  IntegerModel m = pair_model(false);
  IntegerLinear& wide = m.linears[1];
  wide.accumulator = AccumulatorClass::kWide;
  wide.block = 2;
  wide.weights.assign(wide.weights.size(), 32767);
  wide.shifts.assign(wide.out, 20);
  wide.bias.assign(wide.out, int64_t{1} << 19);
  return m;
}

void write_models(const std::string& folder) {
  const auto put = [&](const char* name, const IntegerModel& model) { write_file(folder + name, write_model(model)); };
  put("/pair.sinew", pair_model(false));
  put("/spectral.sinew", pair_model(true));
  put("/slots.sinew", slot_model());
  put("/wide.sinew", wide_model());
}

void write_glbs(const std::string& folder) {
  write(folder + "/strip.glb", two_joint_strip().glb());
  write(folder + "/seam.glb", two_joint_strip(true).glb());
  GlbBuilder bare;
  bare.add("meshes",
           {{"primitives",
             nlohmann::json::array({{{"attributes", {{"POSITION", bare.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}})}});
  bare.root({{"mesh", 0}, {"scale", {2, 2, 2}}});
  write(folder + "/bare.glb", bare.glb());
  GlbBuilder moving = two_joint_strip();
  const std::vector<float> times = {0, 0.5f, 1}, turns = {0, 0, 0, 1, 0, 0, 0.6f, 0.8f, 0, 0.6f, 0, 0.8f};
  const std::vector<float> positions = {0, 0, 0, 10, 0, 0, 1, 0,  0, 1, 0, 0, 11, 2,
                                        0, 0, 0, 0,  0, 0, 0, 10, 0, 5, 0, 0, 0};
  moving.add("animations", {{"channels",
                             {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}},
                              {{"sampler", 1}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                            {"samplers",
                             {{{"input", moving.accessor(times, "SCALAR")}, {"output", moving.accessor(turns, "VEC4")}},
                              {{"input", moving.accessor(times, "SCALAR")},
                               {"output", moving.accessor(positions, "VEC3")},
                               {"interpolation", "CUBICSPLINE"}}}}});
  write(folder + "/moving.glb", moving.glb());
#ifdef SINEW_HAS_MESHOPT
  write(folder + "/meshopt.glb", meshopt_packed(two_joint_strip()).glb());
#endif
#ifdef SINEW_HAS_DRACO
  write(folder + "/draco.glb", draco_packed(two_joint_strip()).glb());
#endif
}

void write_motion_files(const std::string& folder) {
  std::vector<float> poses(2 * 72, 0.1f), positions;
  for (int j = 0; j < 2 * 17; ++j)
    positions.insert(positions.end(),
                     {static_cast<float>(j % 5), static_cast<float>(j % 17), static_cast<float>(j % 3)});
  const std::string poses_npy = npy_of("(2, 72)", poses), trans = npy_of("(2, 3)", std::vector<double>(6, 1)),
                    rate = npy_of("()", std::vector<double>{60});
  const ZipFiles amass = {{"poses.npy", poses_npy}, {"trans.npy", trans}, {"mocap_framerate.npy", rate}};
  write(folder + "/numpy/amass.npz", zip_of(amass));
  write(folder + "/numpy/deflated.npz", zip_of(amass, true));
  write(folder + "/numpy/places.npy", npy_of("(2, 17, 3)", positions));
  write(folder + "/vmd/finger.vmd", vmd_of({{"\x8d\xb6\x90\x6c\x8e\x77\x82\x50", 2, {}, {0, 0, 0.6f, 0.8f}}}));
  write(folder + "/vmd/ik.vmd", vmd_of({{"\x89\x45\x91\xab\x82\x68\x82\x6a", 0}}));
  write(folder + "/vmd/two.vmd",
        vmd_of({{"\x83\x5a\x83\x93\x83\x5e\x81\x5b", 0},
                {"\x8d\xb6\x82\xd0\x82\xb4", 3, {1, 2, 3}, {0.6f, 0, 0, 0.8f}, {127, 0, 127, 0}},
                {"\x89\x45\x91\xab\x82\x68\x82\x6a", 0}}));
}

// Writes calls: given bytes, then random ones.
struct Calls {
  std::string folder;
  Random random;
  void operator()(const char* name, std::string start, size_t length) {
    while (start.size() < length) start += static_cast<char>(random.below(256));
    write(folder + name, start);
  }
};

// Calls as bind_fuzz.cpp reads them: shape, extras, counts, then options, joints and positions; zeros behind the end.
void write_binds(const std::string& folder) {
  Calls call{folder, Random(5)};
  call("/triangles", {'\x00', '\x00', 30, 5, 40}, 340);
  call("/heat", {'\x00', '\x02', 30, 5, 40}, 340);
  call("/polygons", {'\x48', '\x10', 20, 8, 20}, 300);
  call("/symmetric_unorm8", {'\x00', '\x11', 24, 4, 30, 0, 3, 8, 0, 0, 1, 1, 0, 0, 0}, 300);
  call("/float_hints", {'\x00', '\x19', 16, 4, 30, 0, 2, 4, 0, 1, 2, 0, 1, 3, 1}, 400);
  call("/locked", {'\x00', '\x06', 16, 4, 30}, 300);
  call("/cancelled", {'\x00', '\x80', 16, 4, 30, 9}, 250);
  call("/short", {'\x00', '\x20', 16, 4, 30, 9}, 250);
  call("/raw_floats", {'\x05', '\x00', 12, 3, 12}, 300);
  call("/any_offsets", {'\x20', '\x00', 12, 3, 12}, 300);
  call("/empty", {'\x00', '\x00', 0, 0, 0}, 5);
}

// Calls as skeleton_fuzz.cpp reads them: shape, extras, counts, then options and positions; zeros behind the end.
void write_rigs(const std::string& folder) {
  Calls call{folder, Random(6)};
  call("/triangles", {'\x00', '\x00', 30, 40}, 330);
  call("/polygons", {'\x08', '\x01', 20, 20, 0, 0, 1, 0, 0, 0, 0, 0}, 260);
  call("/no_faces", {'\x00', '\x00', 40, 0}, 250);
  call("/flat", {'\x40', '\x00', 20, 30}, 250);
  call("/one_place", {'\x00', '\x00', 12, 12}, 4);
  call("/cancelled", {'\x00', '\x80', 16, 30, 3}, 200);
  call("/short", {'\x00', '\x20', 16, 30, 9, 0}, 200);
  call("/misaligned", {'\x00', '\x40', 16, 30, 9}, 200);
  call("/raw_floats", {'\x04', '\x00', 12, 12}, 260);
  call("/any_offsets", {'\x20', '\x00', 12, 12}, 260);
  call("/beyond", {'\x10', '\x00', 12, 40}, 260);
  call("/empty", {'\x00', '\x00', 0, 0}, 4);
}

// Calls as motion_fuzz.cpp reads them: extras, counts, then options, rigs, bodies and poses; zeros behind the end.
void write_motions(const std::string& folder) {
  Calls call{folder, Random(7)};
  call("/bodies", {'\x80', 11, 20, 3, 30, 36}, 1500);
  call("/rotations", {'\x84', 11, 20, 2, 30, 36}, 1500);
  call("/no_body", {'\x88', 11, 20, 4, 30, 36}, 1500);
  call("/options", {'\xC0', 11, 20, 2, 30, 36, 0, 1, 2, 1, 0, 30, 1, 0, 1, 13, 0}, 1500);
  call("/cancelled", {'\x90', 11, 12, 3, 20, 20, 2}, 900);
  call("/short", {'\x20', 5, 12, 3, 20, 20}, 900);
  call("/any_index", {'\x02', 5, 12, 3, 20, 20}, 900);
  call("/raw_floats", {'\x01', 5, 12, 3, 20, 20}, 1500);
  call("/empty", {'\x00', 0, 0, 0, 0, 0}, 6);
}

// As map_fuzz.cpp reads them: shape, extras, options, pins, then two rigs: a count, positions, parents, names and ends, up.
void write_maps(const std::string& folder) {
  Calls call{folder, Random(7)};
  call("/places", {'\x00', '\x00', 24}, 520);
  call("/names", {'\x18', '\x00', 30}, 640);
  call("/branches", {'\x10', '\x01', 2, 0, 20}, 460);
  call("/pins", {'\x18', '\x02', 2, 3, 5, 4, 7, 24}, 560);
  call("/up", {'\x30', '\x00', 16}, 400);
  call("/raw_floats", {'\x01', '\x00', 12}, 380);
  call("/any_parents", {'\x02', '\x00', 16}, 400);
  call("/short", {'\x00', '\x20', 9, 0, 16}, 380);
  call("/one_place", {'\x00', '\x00', 12}, 3);
  call("/empty", {'\x00', '\x00', 0}, 3);
}

// As transfer_fuzz.cpp reads them: shape, extras, options, then two bodies (counts, joints, vertices, faces) and rows.
void write_transfers(const std::string& folder) {
  Calls call{folder, Random(8)};
  call("/auto", {'\x00', '\x00', 28, 5, 36}, 1100);
  call("/same", {'\x00', '\x02', 28, 5, 36}, 800);
  call("/nearest", {'\x00', '\x01', 0, 1, 3, 0, 0, 0, 0, 0, 0, 0, 2, 28, 5, 36}, 1100);
  call("/biharmonic", {'\x00', '\x07', 0, 2, 4, 0, 0, 0, 0, 0, 0, 0, 2, 30, 4, 40}, 900);
  call("/rebind", {'\x00', '\x01', 0, 3, 4, 1, 0, 0, 0, 0, 0, 0, 2, 24, 5, 36}, 1000);
  call("/garment", {'\x00', '\x03', 0, 0, 4, 0, 0, 0, 0, 1, 0, 0, 3, 24, 5, 36}, 900);
  call("/model", {'\x00', '\x10', 24, 5, 36}, 900);
  call("/locked", {'\x00', '\x08', 20, 4, 30}, 900);
  call("/cancelled", {'\x00', '\x80', 3, 20, 4, 30}, 800);
  call("/short", {'\x00', '\x20', 9, 0, 20, 4, 30}, 800);
  call("/raw_floats", {'\x05', '\x00', 10, 3, 10}, 600);
  call("/any_offsets", {'\x20', '\x00', 12, 3, 12}, 700);
  call("/empty", {'\x00', '\x00', 0, 0, 0}, 5);
}

// As deform_fuzz.cpp reads them: shape, extras, counts, options, then joints, vertices, faces, rows and matrices.
void write_deforms(const std::string& folder) {
  Calls call{folder, Random(9)};
  call("/volume", {'\x00', '\x00', 30, 4, 40}, 560);
  call("/as_drawn", {'\x00', '\x01', 30, 4, 40, 0, 1, 2, 4, 0, 5, 0, 0, 0}, 580);
  call("/delta_mush", {'\x00', '\x01', 30, 4, 40, 0, 2, 0, 4, 0, 0, 0, 0, 0}, 580);
  call("/contact", {'\x00', '\x01', 36, 5, 44, 0, 0, 3, 5, 0, 2, 1, 0, 0}, 640);
  call("/polygons", {'\x08', '\x00', 24, 3, 20}, 500);
  call("/any_matrices", {'\x00', '\x04', 24, 4, 30}, 700);
  call("/raw_matrices", {'\x00', '\x0C', 20, 4, 30}, 800);
  call("/raw_floats", {'\x05', '\x00', 12, 3, 12}, 400);
  call("/any_offsets", {'\x20', '\x00', 12, 3, 12}, 400);
  call("/short", {'\x00', '\x20', 16, 3, 20, 9, 0}, 400);
  call("/no_faces", {'\x00', '\x00', 20, 3, 0}, 400);
  call("/one_place", {'\x00', '\x00', 12, 2, 12}, 5);
  call("/empty", {'\x00', '\x00', 0, 0, 0}, 5);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sinew_fuzz_seeds CORPUS_FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  write_models(folder + "/model");
  write_glbs(folder + "/glb");
  write_motion_files(folder);
  write_binds(folder + "/bind");
  write_rigs(folder + "/skeleton");
  write_motions(folder + "/motion");
  write_maps(folder + "/map");
  write_transfers(folder + "/transfer");
  write_deforms(folder + "/deform");
  return 0;
}
