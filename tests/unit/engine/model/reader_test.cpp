// SPDX-License-Identifier: MIT
// Opening a model: every truncation and every changed byte is refused, so are well-sealed files that contradict themselves,
// and bounds are proven to the last unit.
#include "model/reader.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "network_fixture.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::test {
namespace {

sinew_status open(const std::vector<uint8_t>& bytes, sinew_model* out = nullptr) {
  AlignedBytes file(bytes);
  sinew_model model;
  std::memset(&model, 0x5A, sizeof(model));
  const sinew_model untouched = model;
  const sinew_status status = sinew_model_open(file.data(), bytes.size(), &model);
  if (status != SINEW_OK) {
    EXPECT_EQ(std::memcmp(&model, &untouched, sizeof(model)), 0) << "*model is untouched on failure";
  }
  if (out != nullptr) *out = model;
  return status;
}

IntegerLinear linear(uint16_t in, uint16_t out, ValueRange range) {
  IntegerLinear p;
  p.in = p.block = in;
  p.out = out;
  p.range = range;
  p.bias.assign(out, 1 << 9);
  p.weights.assign(size_t{in} * out, 3);
  p.shifts.assign(out, 10);
  return p;
}
Layer layer(LayerKind kind, Region in, Region out, uint32_t parameters = 0) {
  Layer l;
  l.kind = kind;
  l.in = in;
  l.out = out;
  l.parameters = parameters;
  return l;
}

// Small model with every table and a residual: pair state (relu), ring mean beside it, residual state, logits.
IntegerModel small_model() {
  IntegerModel m;
  m.candidate_count = 4;
  m.feature_set = kFeatureSet;
  m.buffers = {{Domain::kVertex, static_cast<uint16_t>(kVertexFeatures)},
               {Domain::kPair, static_cast<uint16_t>(kPairFeatures)},
               {Domain::kPair, 6},
               {Domain::kPair, 3},
               {Domain::kPair, 1}};
  m.layers = {layer(LayerKind::kLinear, {1, 0, 5}, {2, 0, 3}, 0), layer(LayerKind::kRingMean, {2, 0, 3}, {2, 3, 3}),
              layer(LayerKind::kLinear, {2, 0, 6}, {3, 0, 3}, 1), layer(LayerKind::kLinear, {3, 0, 3}, {4, 0, 1}, 2)};
  m.layers[0].flags = kLayerRelu;
  m.layers[2].flags = kLayerRelu | kLayerResidual;
  m.layers[2].residual = {2, 0, 3};
  m.linears = {linear(5, 3, ValueRange::kPositive), linear(6, 3, ValueRange::kPositive),
               linear(3, 1, ValueRange::kLogits)};
  m.linears[1].residual.assign(3, 1024);
  return m;
}

TEST(ModelReader, OpensAndFillsTheModel) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  sinew_model model;
  ASSERT_EQ(open(bytes, &model), SINEW_OK);
  EXPECT_EQ(model.size_bytes, bytes.size());
  EXPECT_EQ(model.format_version, kModelFormat);
  EXPECT_EQ(model.candidate_count, 4u);
  EXPECT_EQ(model.grid_size, 64u);
  EXPECT_EQ(model.feature_set, kFeatureSet);
  EXPECT_EQ(model.layer_count, 4u);
  EXPECT_EQ(model.parameter_count, 5u * 3 + 3 + 6 * 3 + 3 + 3 + 1);
  EXPECT_EQ(model.checksum, model_checksum(bytes.data(), bytes.size()));
}

TEST(ModelReader, ChecksumIsTheCommonCrc32) {
  const char* text = "123456789";
  EXPECT_EQ(crc32(0, reinterpret_cast<const uint8_t*>(text), 9), 0xCBF43926u);
}

TEST(ModelReader, EveryTruncationIsRefused) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  for (size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_EQ(open({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}), SINEW_ERROR_MODEL_TRUNCATED)
        << size;
  }
  std::vector<uint8_t> longer = bytes;
  longer.resize(bytes.size() + 8);
  EXPECT_EQ(open(longer), SINEW_ERROR_MODEL_TRUNCATED);
}

TEST(ModelReader, EveryChangedByteIsRefused) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  for (size_t i = 0; i < bytes.size(); ++i) {
    for (uint32_t change = 1; change < 512; change = change == 255 ? 512 : change * 2 > 255 ? 255 : change * 2) {
      std::vector<uint8_t> changed = bytes;
      changed[i] = static_cast<uint8_t>(changed[i] ^ change);
      const sinew_status status = open(changed);
      const sinew_status want = i < 8    ? SINEW_ERROR_MODEL_MAGIC
                                : i < 12 ? SINEW_ERROR_MODEL_VERSION
                                : i < 16 ? SINEW_ERROR_MODEL_CHECKSUM
                                : i < 24 ? SINEW_ERROR_MODEL_TRUNCATED
                                         : SINEW_ERROR_MODEL_CHECKSUM;
      ASSERT_EQ(status, want) << "byte " << i << " xor " << change;
    }
  }
}

// The checks behind the checksum: a changed byte whose checksum was made right again is refused too, or describes a
// model that is legal in itself (another weight, say). Sanitizers watch that none is read out of bounds.
TEST(ModelReader, EveryResealedByteIsJudged) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  const size_t tables = tables_bytes(5, 4, 3);
  size_t accepted = 0;
  for (size_t i = 24; i < bytes.size(); ++i) {
    for (const int change : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      std::vector<uint8_t> changed = bytes;
      changed[i] = static_cast<uint8_t>(changed[i] ^ change);
      seal_model(&changed);
      const sinew_status status = open(changed);
      if (i >= tables || status != SINEW_OK) continue;
      ++accepted;
      // Inside the tables only these leave a legal model: K and the grid, a wider unused buffer, a signed or relu
      // switch that needs two bytes is not among them, a region moved to other channels of the inputs.
      const bool header = i == kHeaderCandidates || i == kHeaderGrid;
      const bool buffer = i >= kHeaderBytes && i < kHeaderBytes + 5 * kBufferBytes && (i % 8 == 2 || i % 8 == 3);
      const bool region = i >= kHeaderBytes + 5 * kBufferBytes && i < kHeaderBytes + 5 * kBufferBytes + 4 * kLayerBytes;
      const bool accumulator = i >= tables - 3 * kLinearBytes;
      EXPECT_TRUE(header || buffer || region || accumulator) << "byte " << i << " xor " << change;
    }
  }
  EXPECT_GT(accepted, 0u);
}

TEST(ModelReader, UnalignedIsRefused) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  AlignedBytes file(bytes.size() + 16);
  sinew_model model;
  for (size_t shift = 1; shift < 8; ++shift) {
    std::copy(bytes.begin(), bytes.end(), file.data() + shift);
    EXPECT_EQ(sinew_model_open(file.data() + shift, bytes.size(), &model), SINEW_ERROR_MODEL_ALIGNMENT);
  }
  std::copy(bytes.begin(), bytes.end(), file.data() + 8);
  EXPECT_EQ(sinew_model_open(file.data() + 8, bytes.size(), &model), SINEW_OK);
}

TEST(ModelReader, FeatureFlags) {
  IntegerModel with_spectral = small_model();
  with_spectral.feature_set |= kSpectralFlag;
  with_spectral.buffers[0].channels = static_cast<uint16_t>(vertex_channels(kSpectralFlag));
  sinew_model model;
  ASSERT_EQ(open(write_model(with_spectral), &model), SINEW_OK);
  EXPECT_EQ(model.feature_set, kFeatureSet | kSpectralFlag);
}

struct Contradiction {
  const char* name;
  std::function<void(IntegerModel&)> make;
  sinew_status want = SINEW_ERROR_MODEL_LAYOUT;
};

TEST(ModelReader, ContradictionsAreRefused) {
  const std::vector<Contradiction> list = {
      {"no candidates", [](IntegerModel& m) { m.candidate_count = 0; }},
      {"17 candidates", [](IntegerModel& m) { m.candidate_count = 17; }},
      {"grid 1", [](IntegerModel& m) { m.grid_size = 1; }},
      {"grid 15", [](IntegerModel& m) { m.grid_size = 15; }},
      {"grid 129", [](IntegerModel& m) { m.grid_size = 129; }},
      {"feature set", [](IntegerModel& m) { m.feature_set = kFeatureSet + 1; }, SINEW_ERROR_MODEL_VERSION},
      {"unknown feature flag", [](IntegerModel& m) { m.feature_set |= 1u << 17; }, SINEW_ERROR_MODEL_VERSION},
      {"spectral flag without its channels", [](IntegerModel& m) { m.feature_set |= kSpectralFlag; },
       SINEW_ERROR_MODEL_VERSION},
      {"spectral channels without the flag",
       [](IntegerModel& m) { m.buffers[0].channels = static_cast<uint16_t>(vertex_channels(kSpectralFlag)); },
       SINEW_ERROR_MODEL_VERSION},
      {"vertex inputs", [](IntegerModel& m) { ++m.buffers[0].channels; }, SINEW_ERROR_MODEL_VERSION},
      {"pair inputs", [](IntegerModel& m) { ++m.buffers[1].channels; }, SINEW_ERROR_MODEL_VERSION},
      {"empty buffer",
       [](IntegerModel& m) {
         m.buffers.push_back({Domain::kPair, 0});
       }},
      {"wide buffer",
       [](IntegerModel& m) {
         m.buffers.push_back({Domain::kPair, kMaxChannels + 1});
       }},
      {"unknown domain",
       [](IntegerModel& m) {
         m.buffers.push_back({static_cast<Domain>(2), 4});
       }},
      {"too many buffers",
       [](IntegerModel& m) {
         m.buffers.resize(kMaxBuffers + 1, {Domain::kPair, 1});
       }},
      {"no layers",
       [](IntegerModel& m) {
         m.layers.clear();
         m.linears.clear();
       }},
      {"inputs swapped", [](IntegerModel& m) { std::swap(m.buffers[0].domain, m.buffers[1].domain); }},
      {"unknown kind", [](IntegerModel& m) { m.layers[1].kind = static_cast<LayerKind>(kLayerKindCount + 1); }},
      {"kind 0", [](IntegerModel& m) { m.layers[1].kind = static_cast<LayerKind>(0); }},
      {"unknown flag", [](IntegerModel& m) { m.layers[0].flags |= 4; }},
      {"flag on a mean", [](IntegerModel& m) { m.layers[1].flags = kLayerRelu; }},
      {"parameters on a mean", [](IntegerModel& m) { m.layers[1].parameters = 1; }},
      {"parameters twice", [](IntegerModel& m) { m.layers[2].parameters = 0; }},
      {"region behind its buffer",
       [](IntegerModel& m) { m.layers[0].in.offset = static_cast<uint16_t>(kPairFeatures - 4); }},
      {"region wraps", [](IntegerModel& m) { m.layers[0].in.offset = 65535; }},
      {"unknown buffer", [](IntegerModel& m) { m.layers[0].in.buffer = 5; }},
      {"writes an input",
       [](IntegerModel& m) {
         m.layers.insert(m.layers.begin() + 1, layer(LayerKind::kCopy, {2, 0, 3}, {1, 0, 3}));
       }},
      {"written twice",
       [](IntegerModel& m) {
         m.layers.insert(m.layers.begin() + 2, layer(LayerKind::kCopy, {1, 0, 2}, {2, 4, 2}));
       }},
      {"written twice over",
       [](IntegerModel& m) {
         m.layers[1].out = {2, 2, 3};
       }},
      {"read before written", [](IntegerModel& m) { std::swap(m.layers[1].in, m.layers[1].out); }},
      {"never written", [](IntegerModel& m) { m.layers.erase(m.layers.begin() + 1); }},
      {"reads itself",
       [](IntegerModel& m) {
         m.layers[1].in = {2, 3, 3};
       }},
      {"domain", [](IntegerModel& m) { m.buffers[2].domain = Domain::kVertex; }},
      {"mean changes channels", [](IntegerModel& m) { m.layers[1].in.channels = 2; }},
      {"vertex to pair from pair", [](IntegerModel& m) { m.layers[1].kind = LayerKind::kVertexToPair; }},
      {"pair to vertex into pair", [](IntegerModel& m) { m.layers[1].kind = LayerKind::kPairToVertex; }},
      {"slots into pair from pair", [](IntegerModel& m) { m.layers[1].kind = LayerKind::kVertexToSlots; }},
      {"candidate max over vertices",
       [](IntegerModel& m) {
         m.buffers.push_back({Domain::kVertex, 2});
         m.layers.insert(m.layers.begin(), layer(LayerKind::kCandidateMax, {0, 0, 2}, {5, 0, 2}));
       }},
      {"slots of another K",
       [](IntegerModel& m) {
         m.buffers.push_back({Domain::kVertex, 3});
         m.layers.insert(m.layers.begin(), layer(LayerKind::kPairToVertex, {1, 0, 1}, {5, 0, 3}));
       }},
      {"weights of another shape", [](IntegerModel& m) { m.linears[0] = linear(4, 3, ValueRange::kPositive); }},
      {"outputs of another shape", [](IntegerModel& m) { m.linears[0] = linear(5, 2, ValueRange::kPositive); }},
      {"residual of another shape", [](IntegerModel& m) { m.layers[2].residual.channels = 2; }},
      {"residual not written",
       [](IntegerModel& m) {
         m.layers[2].residual = {3, 0, 3};
       }},
      {"residual without factors", [](IntegerModel& m) { m.linears[1].residual.clear(); }},
      {"factors without residual", [](IntegerModel& m) { m.linears[0].residual.assign(3, 1); }},
      {"residual region without flag",
       [](IntegerModel& m) {
         m.layers[0].residual = {1, 0, 3};
       }},
      {"signed with relu", [](IntegerModel& m) { m.linears[0].range = ValueRange::kSigned; }},
      {"relu range without relu", [](IntegerModel& m) { m.layers[0].flags = 0; }},
      {"unknown range", [](IntegerModel& m) { m.linears[2].range = static_cast<ValueRange>(3); }},
      {"unknown class", [](IntegerModel& m) { m.linears[2].accumulator = static_cast<AccumulatorClass>(2); }},
      {"narrow in blocks", [](IntegerModel& m) { m.linears[0].block = 4; }},
      {"empty blocks",
       [](IntegerModel& m) {
         m.linears[0].accumulator = AccumulatorClass::kWide;
         m.linears[0].block = 0;
       }},
      {"shift 0", [](IntegerModel& m) { m.linears[0].shifts[1] = 0; }},
      {"shift 32", [](IntegerModel& m) { m.linears[0].shifts[1] = 32; }},
      {"wide shift 48",
       [](IntegerModel& m) {
         m.linears[0].accumulator = AccumulatorClass::kWide;
         m.linears[0].shifts[1] = 48;
       }},
      {"weight -32768", [](IntegerModel& m) { m.linears[0].weights[7] = INT16_MIN; }},
      {"spare linear", [](IntegerModel& m) { m.linears.push_back(linear(3, 1, ValueRange::kLogits)); }},
      {"missing linear", [](IntegerModel& m) { m.linears.pop_back(); }},
      {"logits of the activation range", [](IntegerModel& m) { m.linears[2].range = ValueRange::kSigned; }},
      {"two logits",
       [](IntegerModel& m) {
         m.buffers[4].channels = 2;
         m.layers[3].out.channels = 2;
         m.linears[2] = linear(3, 2, ValueRange::kLogits);
       }},
      {"ends with a mean",
       [](IntegerModel& m) {
         m.buffers.push_back({Domain::kPair, 1});
         m.layers.push_back(layer(LayerKind::kRingMean, {4, 0, 1}, {5, 0, 1}));
       }},
      {"bias out of int32", [](IntegerModel& m) { m.linears[0].bias[0] = int64_t{1} << 31; },
       SINEW_ERROR_MODEL_OVERFLOW},
      {"sum out of int32", [](IntegerModel& m) { m.linears[0].weights.assign(15, 32767); }, SINEW_ERROR_MODEL_OVERFLOW},
      {"block out of int32",
       [](IntegerModel& m) {
         m.linears[0].accumulator = AccumulatorClass::kWide;
         m.linears[0].weights.assign(15, 32767);
       },
       SINEW_ERROR_MODEL_OVERFLOW},
      {"wide bias out of 2^62",
       [](IntegerModel& m) {
         m.linears[0].accumulator = AccumulatorClass::kWide;
         m.linears[0].bias[2] = INT64_MIN;
       },
       SINEW_ERROR_MODEL_OVERFLOW},
  };
  for (const Contradiction& item : list) {
    IntegerModel model = small_model();
    item.make(model);
    EXPECT_EQ(open(write_model(model)), item.want) << item.name;
  }
}

TEST(ModelReader, WideLayerWithProvenBlocksOpens) {
  IntegerModel m = small_model();
  m.linears[0].accumulator = AccumulatorClass::kWide;
  m.linears[0].block = 2;
  m.linears[0].weights.assign(15, 32767);
  EXPECT_EQ(open(write_model(m)), SINEW_OK);
}

// |bias + sum| < 2^31 for every input, to the last unit, with the range of each input region.
TEST(ModelReader, ProofIsExact) {
  const int64_t limit = int64_t{1} << 31;
  IntegerModel m = small_model();
  IntegerLinear& first = m.linears[0];  // reads features: -16384..16383
  first.weights.assign(15, 0);
  first.weights[0] = 1000;
  first.weights[1] = -500;
  const int64_t high = 1000 * int64_t{16383} + 500 * int64_t{16384},
                low = -(1000 * int64_t{16384} + 500 * int64_t{16383});
  first.bias[0] = limit - 1 - high;
  EXPECT_EQ(open(write_model(m)), SINEW_OK);
  ++first.bias[0];
  EXPECT_EQ(open(write_model(m)), SINEW_ERROR_MODEL_OVERFLOW);
  first.bias[0] = -limit + 1 - low;
  EXPECT_EQ(open(write_model(m)), SINEW_OK);
  --first.bias[0];
  EXPECT_EQ(open(write_model(m)), SINEW_ERROR_MODEL_OVERFLOW);

  m = small_model();
  IntegerLinear& second = m.linears[1];  // reads a relu region and its ring mean: 0..16383, residual likewise
  second.weights.assign(18, -700);
  second.residual[2] = 300;
  second.bias[2] = limit - 1 - 300 * int64_t{16383};
  EXPECT_EQ(open(write_model(m)), SINEW_OK);
  ++second.bias[2];
  EXPECT_EQ(open(write_model(m)), SINEW_ERROR_MODEL_OVERFLOW);
  second.bias[2] = -limit + 1 + 6 * 700 * int64_t{16383};
  EXPECT_EQ(open(write_model(m)), SINEW_OK);
  --second.bias[2];
  EXPECT_EQ(open(write_model(m)), SINEW_ERROR_MODEL_OVERFLOW);
}

// Padding, reserved fields and moved tables, with the checksum made right.
TEST(ModelReader, ReservedBytesMustBeZero) {
  const std::vector<uint8_t> bytes = write_model(small_model());
  std::vector<size_t> reserved;
  for (size_t i = kHeaderReserved; i < kHeaderBytes; ++i) reserved.push_back(i);
  const size_t buffers = kHeaderBytes, layers = buffers + 5 * kBufferBytes, linears = layers + 4 * kLayerBytes;
  for (const size_t i : {1, 4, 5, 6, 7}) reserved.push_back(buffers + 2 * kBufferBytes + i);
  for (const size_t i : {2, 3, 22, 23, 28, 31}) reserved.push_back(layers + kLayerBytes + i);
  for (size_t i = 24; i < 32; ++i) reserved.push_back(linears + kLinearBytes + i);
  const ModelTables tables(bytes.data());
  const LinearRecord first = tables.linear(0), second = tables.linear(1);
  reserved.push_back(first.weights + 30);   // 15 weights, padded to 32 bytes
  reserved.push_back(second.residual + 6);  // 3 factors
  reserved.push_back(first.shifts + 3);     // 3 shifts
  for (const size_t i : reserved) {
    std::vector<uint8_t> changed = bytes;
    ASSERT_EQ(changed[i], 0) << i;
    changed[i] = 1;
    seal_model(&changed);
    EXPECT_EQ(open(changed), SINEW_ERROR_MODEL_LAYOUT) << "byte " << i;
  }
}

TEST(ModelReader, BytesReadTheSameWithoutPlainLoads) {
  // What a big-endian host does, byte by byte, against what this host does.
  const std::vector<uint8_t> bytes = write_model(random_model(3, 4));
  AlignedBytes file(bytes);
  const ModelTables tables(file.data());
  for (uint32_t i = 0; i < tables.linear_count(); ++i) {
    const LinearRecord r = tables.linear(i);
    for (uint32_t n = 0; n < uint32_t{r.in} * r.out; ++n) {
      ASSERT_EQ(file_int16(tables.int16_at(r.weights), n),
                static_cast<int16_t>(load_u16(file.data() + r.weights + 2 * n)));
    }
  }
}

// A file may end with a confidence table; any other tail is refused.
TEST(ModelReader, ConfidenceSection) {
  const std::vector<uint8_t> plain = write_model(small_model());
  sinew_model model;
  ASSERT_EQ(open(plain, &model), SINEW_OK);
  EXPECT_EQ(model.confidence_count, 0u);
  EXPECT_EQ(model.confidence_offset, 0u);
  const std::vector<uint8_t> good = with_confidence(plain, {{6553, 20000}, {30000, 20000}, {65535, 60000}});
  ASSERT_EQ(open(good, &model), SINEW_OK);
  EXPECT_EQ(model.confidence_count, 3u);
  EXPECT_EQ(model.confidence_offset, plain.size() + 16);
  EXPECT_EQ(with_confidence(good, {}), plain) << "taking the table out gives the file it was put into";
  EXPECT_EQ(with_confidence(good, {{1, 1}, {2, 2}}), with_confidence(plain, {{1, 1}, {2, 2}}));
  const std::vector<std::vector<ConfidenceEntry>> wrong = {
      {{1, 1}}, {{2, 1}, {2, 3}}, {{2, 5}, {3, 4}}, std::vector<ConfidenceEntry>(65, ConfidenceEntry{9, 9})};
  for (const auto& entries : wrong) EXPECT_THROW(with_confidence(plain, entries), Error) << entries.size();

  for (size_t at = plain.size(); at < good.size(); ++at) {  // tag, size, count, zeros: every byte of the frame counts
    const bool entry = at >= plain.size() + 16 && at < plain.size() + 28;
    if (entry) continue;
    std::vector<uint8_t> bad = good;
    bad[at] ^= 0x40;
    seal_model(&bad);
    EXPECT_EQ(open(bad), SINEW_ERROR_MODEL_LAYOUT) << "byte " << at - plain.size();
  }
  for (size_t size = plain.size() + 1; size < good.size(); ++size) {
    std::vector<uint8_t> bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    store_u64(bad.data() + kHeaderSize, size);
    seal_model(&bad);
    EXPECT_EQ(open(bad), SINEW_ERROR_MODEL_LAYOUT) << size;
  }
}

}  // namespace
}  // namespace sinew::test
