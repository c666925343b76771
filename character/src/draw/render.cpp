// SPDX-License-Identifier: MIT
// A small software rasterizer: a character from one side, smooth shading with creases, soft occlusion, its skeleton on
// top. Everything is drawn at twice the size in linear light and averaged 2 x 2 at the end.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sinew_character/draw/image.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr int kSamples = 2;              // per side of a pixel
constexpr float kMargin = 0.06f;         // of the picture, on every side
constexpr float kCameraDistance = 5.0f;  // in radii of the mesh: a mild perspective
constexpr float kCreaseCosine = 0.5f;    // faces that meet at more than 60 degrees keep a hard edge

struct V3 {
  float x = 0, y = 0, z = 0;
};
V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V3 operator*(float s, V3 a) { return {s * a.x, s * a.y, s * a.z}; }
float dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V3 cross(V3 a, V3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
V3 unit(V3 a) {
  const float length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : V3{0, 0, 0};
}

// x to the right, y up, z towards the viewer; `nearness` is 1 / distance to the camera, which is linear on the screen.
struct ScreenPoint {
  float x = 0, y = 0, nearness = 0;
};

class Camera {
 public:
  Camera(const std::vector<Vec3>& vertices, const RenderOptions& options, int width, int height)
      : z_up_(options.up == Axis::kZ) {
    constexpr float degree = std::numbers::pi_v<float> / 180;
    const float yaw = options.yaw_degrees * degree, pitch = options.pitch_degrees * degree;
    towards_ = {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
    right_ = {std::cos(yaw), 0, -std::sin(yaw)};
    up_ = cross(towards_, right_);

    V3 low = upright(vertices.front()), high = low;
    for (const Vec3& vertex : vertices) {
      const V3 p = upright(vertex);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    center_ = 0.5f * (low + high);
    const float diagonal = std::sqrt(dot(high - low, high - low));
    unit_ = diagonal > 0 ? 2 / diagonal : 1;

    float left = std::numeric_limits<float>::max(), right = -left, bottom = left, top = -left;
    for (const Vec3& vertex : vertices) {
      const ScreenPoint p = project(vertex);
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      bottom = std::min(bottom, p.y);
      top = std::max(top, p.y);
    }
    constexpr float least = 1e-3f;  // a point or a line has no size to fit
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const float scale =
        (1 - 2 * kMargin) * std::min(w / std::max(right - left, least), h / std::max(top - bottom, least));
    offset_x_ = w / 2 - scale * (left + right) / 2;
    offset_y_ = h / 2 + scale * (bottom + top) / 2;
    scale_ = scale;
    if (options.focus_radius > 0) {
      const ScreenPoint at = project(options.focus);
      const float shrink = at.nearness > 0 ? kCameraDistance * at.nearness : 1;
      scale_ = (1 - 2 * kMargin) * std::min(w, h) / (2 * shrink * unit_ * options.focus_radius);
      offset_x_ = w / 2 - scale_ * at.x;
      offset_y_ = h / 2 + scale_ * at.y;
    }
  }

  // Nearness is at most 0 for points behind the camera.
  ScreenPoint operator()(const Vec3& vertex) const {
    ScreenPoint p = project(vertex);
    return {offset_x_ + scale_ * p.x, offset_y_ - scale_ * p.y, p.nearness};
  }
  V3 view_direction(V3 world) const { return {dot(world, right_), dot(world, up_), dot(world, towards_)}; }
  V3 upright(const Vec3& p) const { return z_up_ ? V3{p.x, p.z, -p.y} : V3{p.x, p.y, p.z}; }
  // World length of one pixel at the mesh's center, in radii of the mesh.
  float pixel_size() const { return 1 / scale_; }

 private:
  ScreenPoint project(const Vec3& vertex) const {
    const V3 p = unit_ * (upright(vertex) - center_);
    const float distance = kCameraDistance - dot(p, towards_);
    if (distance <= 0) return {0, 0, -1};
    const float shrink = kCameraDistance / distance;
    return {shrink * dot(p, right_), shrink * dot(p, up_), 1 / distance};
  }

  bool z_up_;
  V3 towards_, right_, up_, center_;
  float unit_ = 1, scale_ = 1, offset_x_ = 0, offset_y_ = 0;
};

struct Canvas {
  int width = 0, height = 0;
  std::vector<Linear> light;
  std::vector<float> nearness;  // 0 = background

  Canvas(int w, int h) : width(w), height(h) {
    const size_t count = static_cast<size_t>(w) * static_cast<size_t>(h);
    light.resize(count);
    nearness.assign(count, 0.0f);
    const Linear top = to_linear({236, 237, 240}), bottom = to_linear({205, 208, 214});
    for (int y = 0; y < h; ++y) {
      const float t = static_cast<float>(y) / static_cast<float>(h);
      Linear row{};
      for (size_t i = 0; i < 3; ++i) row[i] = top[i] + t * (bottom[i] - top[i]);
      std::fill_n(light.begin() + static_cast<std::ptrdiff_t>(at(0, y)), w, row);
    }
  }
  size_t at(int x, int y) const { return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x); }
};

// A key light from the upper left, a weak one from the right, and light from the sky that fades towards the ground.
float brightness(V3 normal) {
  const V3 key = unit({-0.45f, 0.62f, 0.64f}), fill = unit({0.80f, 0.10f, 0.55f});
  const float wrapped_key = std::max(0.0f, (dot(normal, key) + 0.15f) / 1.15f);
  return 0.42f + 0.12f * normal.y + 0.56f * wrapped_key + 0.14f * std::max(0.0f, dot(normal, fill));
}

struct Corner {
  ScreenPoint screen;
  V3 normal;  // view space
  Linear light;
};

void fill_triangle(const Corner& a, const Corner& b, const Corner& c, Canvas* canvas) {
  if (a.screen.nearness <= 0 || b.screen.nearness <= 0 || c.screen.nearness <= 0) return;
  const float area =
      (b.screen.x - a.screen.x) * (c.screen.y - a.screen.y) - (b.screen.y - a.screen.y) * (c.screen.x - a.screen.x);
  if (area == 0 || !std::isfinite(area)) return;
  const auto bound = [](float x, int limit) {
    return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(limit)));
  };
  const int x0 = bound(std::floor(std::min({a.screen.x, b.screen.x, c.screen.x})), canvas->width);
  const int x1 = bound(std::ceil(std::max({a.screen.x, b.screen.x, c.screen.x})) + 1, canvas->width);
  const int y0 = bound(std::floor(std::min({a.screen.y, b.screen.y, c.screen.y})), canvas->height);
  const int y1 = bound(std::ceil(std::max({a.screen.y, b.screen.y, c.screen.y})) + 1, canvas->height);
  // Screen y runs down, so a face that is counter-clockwise to the viewer has negative area.
  const bool front = area < 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const float wb =
          ((px - a.screen.x) * (c.screen.y - a.screen.y) - (py - a.screen.y) * (c.screen.x - a.screen.x)) / area;
      const float wc =
          ((b.screen.x - a.screen.x) * (py - a.screen.y) - (b.screen.y - a.screen.y) * (px - a.screen.x)) / area;
      const float wa = 1 - wb - wc;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const float nearness = wa * a.screen.nearness + wb * b.screen.nearness + wc * c.screen.nearness;
      const size_t at = canvas->at(x, y);
      if (nearness <= canvas->nearness[at]) continue;
      canvas->nearness[at] = nearness;
      V3 normal = unit(wa * a.normal + wb * b.normal + wc * c.normal);
      if (!front) normal = -1.0f * normal;
      const float shade = brightness(normal) * (front ? 1.0f : 0.8f);  // insides a little darker
      for (size_t i = 0; i < 3; ++i)
        canvas->light[at][i] = shade * (wa * a.light[i] + wb * b.light[i] + wc * c.light[i]);
    }
  }
}

// Area-weighted face normals (Newell, so that polygons need not be flat), rotated upright.
std::vector<V3> face_normals(const Character& c, const Camera& camera) {
  std::vector<V3> normals(c.face_count());
  for (size_t f = 0; f < normals.size(); ++f) {
    const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
    const V3 origin = camera.upright(c.vertices[c.face_vertices[begin]]);
    for (uint32_t k = begin; k < end; ++k) {
      const V3 p = camera.upright(c.vertices[c.face_vertices[k]]) - origin;
      const V3 q = camera.upright(c.vertices[c.face_vertices[k + 1 < end ? k + 1 : begin]]) - origin;
      normals[f] = normals[f] + cross(p, q);
    }
  }
  return normals;
}

void draw_faces(const Character& c, const std::vector<std::array<uint8_t, 3>>& colors, const Camera& camera,
                Canvas* canvas) {
  const std::vector<V3> normals = face_normals(c, camera);
  std::vector<std::vector<uint32_t>> faces_of(c.vertices.size());
  for (size_t f = 0; f < normals.size(); ++f)
    for (uint32_t k = c.face_offsets[f]; k < c.face_offsets[f + 1]; ++k)
      faces_of[c.face_vertices[k]].push_back(static_cast<uint32_t>(f));

  std::vector<Corner> corners;
  for (size_t f = 0; f < normals.size(); ++f) {
    const V3 own = unit(normals[f]);
    corners.clear();
    for (uint32_t k = c.face_offsets[f]; k < c.face_offsets[f + 1]; ++k) {
      const uint32_t v = c.face_vertices[k];
      V3 normal = normals[f];
      for (uint32_t other : faces_of[v])
        if (other != f && dot(unit(normals[other]), own) > kCreaseCosine) normal = normal + normals[other];
      corners.push_back({camera(c.vertices[v]), camera.view_direction(unit(normal)), to_linear(colors[v])});
    }
    for (size_t k = 1; k + 1 < corners.size(); ++k) fill_triangle(corners[0], corners[k], corners[k + 1], canvas);
  }
}

// Screen-space occlusion: a sample is darkened by what stands a little nearer around it (Mittring 2007, on distances
// alone). Worked out once per pixel of the final picture and blurred over 5 x 5 to hide the pattern of the taps.
void darken_occluded(const Camera& camera, Canvas* canvas) {
  constexpr int taps = 20;
  constexpr float radius = 0.11f, strength = 0.75f;  // radius in radii of the mesh
  const int width = canvas->width / kSamples, height = canvas->height / kSamples;
  const float radius_pixels = radius / camera.pixel_size();
  const auto nearness = [&](int x, int y) { return canvas->nearness[canvas->at(x, y)]; };
  std::vector<float> open(static_cast<size_t>(width) * static_cast<size_t>(height), 1.0f);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int sx = x * kSamples, sy = y * kSamples;
      const float own = nearness(sx, sy);
      if (own <= 0) continue;
      // The plane through the sample, so that a slanted flat surface does not occlude itself.
      const auto slope = [&](int dx, int dy) {
        const auto near_at = [&](int px, int py) {
          return px < 0 || py < 0 || px >= canvas->width || py >= canvas->height ? 0.0f : nearness(px, py);
        };
        const float ahead = near_at(sx + dx, sy + dy), behind = near_at(sx - dx, sy - dy);
        const float forward = ahead > 0 ? ahead - own : 0, backward = behind > 0 ? own - behind : 0;
        if (ahead <= 0 || behind <= 0) return ahead > 0 ? forward : backward;
        return std::abs(forward) < std::abs(backward) ? forward : backward;
      };
      const float slope_x = slope(1, 0), slope_y = slope(0, 1);
      const float rotation = 2.39996323f * static_cast<float>((x * 7 + y * 13) % 16);
      float blocked = 0;
      for (int t = 0; t < taps; ++t) {
        const float r = radius_pixels * (static_cast<float>(t) + 0.5f) / taps;
        const float angle = rotation + 2.39996323f * static_cast<float>(t);
        const float dx = std::round(r * std::cos(angle)), dy = std::round(r * std::sin(angle));
        const int tx = sx + static_cast<int>(dx), ty = sy + static_cast<int>(dy);
        if (tx < 0 || ty < 0 || tx >= canvas->width || ty >= canvas->height) continue;
        const float other = nearness(tx, ty);
        if (other <= 0) continue;
        const float plane = own + slope_x * dx + slope_y * dy;
        if (plane <= 0) continue;
        // Distance of the other point in front of the plane, in radii of the mesh.
        const float rise = 1 / plane - 1 / other;
        const float reach = r * camera.pixel_size();
        const float steep = rise / std::max(reach, 1e-4f);
        const float fade = std::clamp(1.5f - rise / radius, 0.0f, 1.0f);  // something far in front is another limb
        blocked += std::clamp(steep - 0.15f, 0.0f, 1.0f) * fade;
      }
      open[static_cast<size_t>(y * width + x)] = 1 - strength * std::min(1.0f, 1.6f * blocked / taps);
    }
  }
  for (int y = 0; y < canvas->height; ++y) {
    for (int x = 0; x < canvas->width; ++x) {
      const size_t at = canvas->at(x, y);
      const float own = canvas->nearness[at];
      if (own <= 0) continue;
      float sum = 0, count = 0;
      for (int by = std::max(0, y / kSamples - 2); by <= std::min(height - 1, y / kSamples + 2); ++by) {
        for (int bx = std::max(0, x / kSamples - 2); bx <= std::min(width - 1, x / kSamples + 2); ++bx) {
          const float other = nearness(bx * kSamples, by * kSamples);
          if (other <= 0 || std::abs(1 / other - 1 / own) > 0.05f) continue;
          sum += open[static_cast<size_t>(by * width + bx)];
          ++count;
        }
      }
      if (count > 0)
        for (float& x_light : canvas->light[at]) x_light *= sum / count;
    }
  }
}

float distance_to_segment(float px, float py, const ScreenPoint& a, const ScreenPoint& b) {
  const float dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const float t = squared > 0 ? std::clamp(((px - a.x) * dx + (py - a.y) * dy) / squared, 0.0f, 1.0f) : 0;
  return std::hypot(px - a.x - t * dx, py - a.y - t * dy);
}

// A line with round ends, a disc when both points are the same. Widths are half widths in samples.
void draw_capsule(const ScreenPoint& a, const ScreenPoint& b, float radius, const Linear& color, float opacity,
                  Canvas* canvas) {
  const auto bound = [](float x, int limit) {
    return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(limit)));
  };
  const int x0 = bound(std::min(a.x, b.x) - radius, canvas->width),
            x1 = bound(std::max(a.x, b.x) + radius + 1, canvas->width);
  const int y0 = bound(std::min(a.y, b.y) - radius, canvas->height),
            y1 = bound(std::max(a.y, b.y) + radius + 1, canvas->height);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      if (distance_to_segment(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, a, b) > radius) continue;
      Linear& light = canvas->light[canvas->at(x, y)];
      for (size_t i = 0; i < 3; ++i) light[i] += opacity * (color[i] - light[i]);
    }
  }
}

// Bones as light lines with a dark rim, joints as discs in their colors. Discs shrink where joints are dense
// (fingers).
void draw_skeleton(const Character& c, const std::vector<uint8_t>& red_joints, const Camera& camera, Canvas* canvas) {
  std::vector<ScreenPoint> points;
  for (const Joint& joint : c.joints) points.push_back(camera(joint.position));
  const auto parent_of = [&](size_t j) {
    const int parent = c.joints[j].parent;
    return parent >= 0 && parent < static_cast<int>(points.size()) ? static_cast<size_t>(parent) : j;
  };
  const auto visible = [&](size_t j) {
    return points[j].nearness > 0 && std::isfinite(points[j].x) && std::isfinite(points[j].y);
  };
  const float size = static_cast<float>(std::min(canvas->width, canvas->height));
  // Lower bounds keep thin lines whole in small pictures.
  const float rim = std::max(size / 700, 1.5f), line = std::max(size / 600, 1.8f);
  const Linear dark = to_linear({28, 30, 36}), bright = to_linear({250, 250, 250}), red = to_linear({225, 20, 20});
  const auto is_red = [&](size_t j) { return j < red_joints.size() && red_joints[j] != 0; };

  std::vector<float> radius(points.size(), size / 90);
  for (size_t j = 0; j < points.size(); ++j) {
    const size_t parent = parent_of(j);
    if (parent == j || !visible(j) || !visible(parent)) continue;
    const float bone = std::hypot(points[j].x - points[parent].x, points[j].y - points[parent].y);
    for (size_t end : {j, parent}) radius[end] = std::min(radius[end], std::max(size / 260, 0.22f * bone));
  }
  for (const bool outline : {true, false}) {
    for (size_t j = 0; j < points.size(); ++j) {
      const size_t parent = parent_of(j);
      if (parent == j || !visible(j) || !visible(parent)) continue;
      const float width = std::min(line, 0.8f * std::min(radius[j], radius[parent]));
      draw_capsule(points[parent], points[j], outline ? width + rim : width,
                   outline     ? dark
                   : is_red(j) ? red
                               : bright,
                   0.9f, canvas);
    }
  }
  for (size_t j = 0; j < points.size(); ++j) {
    if (!visible(j)) continue;
    draw_capsule(points[j], points[j], radius[j] + rim, dark, 1, canvas);
    draw_capsule(points[j], points[j], radius[j], bright, 1, canvas);
    draw_capsule(points[j], points[j], 0.78f * radius[j], is_red(j) ? red : to_linear(joint_color(j)), 1, canvas);
  }
}

void draw_ring(const ScreenPoint& center, float inner, float outer, const Linear& color, float opacity,
               Canvas* canvas) {
  const auto bound = [](float x, int limit) {
    return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(limit)));
  };
  for (int y = bound(center.y - outer, canvas->height); y < bound(center.y + outer + 1, canvas->height); ++y) {
    for (int x = bound(center.x - outer, canvas->width); x < bound(center.x + outer + 1, canvas->width); ++x) {
      const float r = std::hypot(static_cast<float>(x) + 0.5f - center.x, static_cast<float>(y) + 0.5f - center.y);
      if (r < inner || r > outer) continue;
      Linear& light = canvas->light[canvas->at(x, y)];
      for (size_t i = 0; i < 3; ++i) light[i] += opacity * (color[i] - light[i]);
    }
  }
}

void draw_marks(const std::vector<RenderMark>& marks, const Camera& camera, Canvas* canvas) {
  const float size = static_cast<float>(std::min(canvas->width, canvas->height));
  const float radius = std::max(size / 90, 5.0f), line = std::max(size / 260, 2.0f);
  for (const RenderMark& mark : marks) {
    const ScreenPoint at = camera(mark.position);
    if (at.nearness <= 0 || !std::isfinite(at.x) || !std::isfinite(at.y)) continue;
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    if (at.x < 0 || at.y < 0 || x >= canvas->width || y >= canvas->height) continue;
    // Half a percent of slack: the vertex lies in the surface that would hide it.
    const bool hidden = canvas->nearness[canvas->at(x, y)] > 1.005f * at.nearness;
    const float opacity = hidden ? 0.3f : 1.0f;
    draw_ring(at, radius - line, radius + line, to_linear({255, 255, 255}), 0.8f * opacity, canvas);
    draw_ring(at, radius - 0.6f * line, radius + 0.6f * line, to_linear(mark.color), opacity, canvas);
  }
}

Image average(const Canvas& canvas) {
  Image image;
  image.width = canvas.width / kSamples;
  image.height = canvas.height / kSamples;
  image.rgb.reserve(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Linear sum{};
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const Linear& light = canvas.light[canvas.at(x * kSamples + s % kSamples, y * kSamples + s / kSamples)];
        for (size_t i = 0; i < 3; ++i) sum[i] += std::min(light[i], 1.0f) / (kSamples * kSamples);
      }
      const auto rgb = to_srgb(sum);
      image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
    }
  }
  return image;
}

}  // namespace

Image render(const Character& character, const std::vector<std::array<uint8_t, 3>>& vertex_colors,
             const RenderOptions& options) {
  constexpr int largest = 8192;
  if (options.width < 1 || options.height < 1 || options.width > largest || options.height > largest) {
    throw Error("picture: the size must be 1 to " + std::to_string(largest) + " on each side, found " +
                std::to_string(options.width) + " x " + std::to_string(options.height));
  }
  if (character.vertices.empty()) throw Error(character.name + ": nothing to draw, the mesh has no vertices");
  if (vertex_colors.size() != character.vertices.size()) {
    throw Error(character.name + ": a picture needs one color per vertex, expected " +
                std::to_string(character.vertices.size()) + ", found " + std::to_string(vertex_colors.size()));
  }
  Canvas canvas(options.width * kSamples, options.height * kSamples);
  const Camera camera(character.vertices, options, canvas.width, canvas.height);
  draw_faces(character, vertex_colors, camera, &canvas);
  darken_occluded(camera, &canvas);
  if (options.draw_skeleton) draw_skeleton(character, options.red_joints, camera, &canvas);
  draw_marks(options.marks, camera, &canvas);
  return average(canvas);
}

}  // namespace sinew
