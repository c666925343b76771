// SPDX-License-Identifier: MIT
#include "usd/usd_transform.hpp"

#include <cmath>
#include <optional>

#include "sinew_formats/base/quaternion.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

bool is_finite(const Affine& m) {
  for (const double number : m)
    if (!std::isfinite(number)) return false;
  return true;
}

Affine rotation(const Rotation& r) { return {r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, r[6], r[7], r[8], 0}; }

Affine about_axis(char axis, double degrees) {
  return rotation(rotation_of(axis_rotation(static_cast<size_t>(axis - 'X'), degrees * kRadian)));
}

// One operation by the word behind "xformOp:"; nullopt for another one, or other numbers.
std::optional<Affine> operation(const std::string& kind, const std::vector<double>& n) {
  if (kind == "translate" && n.size() == 3) return Affine{1, 0, 0, n[0], 0, 1, 0, n[1], 0, 0, 1, n[2]};
  if (kind == "scale" && n.size() == 3) return Affine{n[0], 0, 0, 0, 0, n[1], 0, 0, 0, 0, n[2], 0};
  if (kind == "transform" && n.size() == 16) return usd_affine(n, 0);
  if (kind == "orient" && n.size() == 4) return rotation(rotation_of(normalised({n[1], n[2], n[3], n[0]})));
  if (kind.rfind("rotate", 0) != 0) return std::nullopt;
  const std::string axes = kind.substr(6);
  if (axes.empty() || axes.find_first_not_of("XYZ") != std::string::npos) return std::nullopt;
  if (axes.size() == 1 && n.size() == 1) return about_axis(axes[0], n[0]);
  if (axes.size() != 3 || n.size() != 3) return std::nullopt;
  Affine out = kIdentity;  // the first axis is turned about first
  for (const char axis : axes) out = multiply(about_axis(axis, n[static_cast<size_t>(axis - 'X')]), out);
  return out;
}

}  // namespace

Affine usd_affine(const std::vector<double>& numbers, size_t at) {
  Affine m{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 4; ++c) m[4 * r + c] = numbers[at + 4 * c + r];
  return m;
}

std::vector<Affine> usd_affines(const std::string& where, const UsdValue& value, size_t count) {
  if (value.numbers.size() != 16 * count)
    throw Error(where + ": expected " + std::to_string(count) + " matrices, found " +
                std::to_string(value.numbers.size()) + " numbers");
  std::vector<Affine> out;
  for (size_t i = 0; i < count; ++i) {
    out.push_back(usd_affine(value.numbers, 16 * i));
    if (!is_finite(out.back())) throw Error(where + ": expected finite matrices, found another");
  }
  return out;
}

UsdTransform usd_transform(const std::string& where, const UsdPrim& prim) {
  UsdTransform out;
  const UsdValue* order = find_value(prim, "xformOpOrder");
  if (order == nullptr) return out;
  for (std::string name : order->texts) {
    if (name == "!resetXformStack!") {
      out = {kIdentity, true, out.animated};
      continue;
    }
    const bool inverted = name.rfind("!invert!", 0) == 0;
    if (inverted) name = name.substr(8);
    const UsdValue* value = find_value(prim, name);
    if (value == nullptr) continue;
    out.animated = out.animated || !find_property(prim, name)->samples.empty();
    const size_t begin = name.find(':') + 1, end = name.find(':', begin);
    std::optional<Affine> one =
        operation(name.substr(begin, end == std::string::npos ? end : end - begin), value->numbers);
    if (one && inverted) one = inverse(*one);
    if (!one || !is_finite(*one))
      throw Error(where + ": expected a transform (translate, scale, rotateXYZ, orient, transform), found " +
                  in_quotes(name) + " of " + std::to_string(value->numbers.size()) + " numbers");
    out.local = multiply(out.local, *one);
  }
  return out;
}

}  // namespace sinew
