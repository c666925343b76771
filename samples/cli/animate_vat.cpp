// SPDX-License-Identifier: MIT
#include "animate_vat.hpp"

#include <cstdio>
#include <filesystem>
#include <vector>

#include "options.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void add_vat_option(CLI::App* sub, std::string* folder) {
  sub->add_option("--vat", *folder,
                  "Write all clips as vertex animation textures for crowds. Shaders play them without a skeleton: "
                  "NAME.vat.json, its textures, and a mesh that reads them (samples/crowd has the shaders)")
      ->type_name("DIR");
}

void check_vat_folder(const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
    throw UsageError("--vat " + folder + ": is a file, expected a folder for the textures");
}

void write_vat(const std::string& folder, const VatResult& vat) {
  make_folder(folder);
  std::vector<NamedBytes> files = vat.files;
  for (NamedBytes& file : files) file.path = (fs::path(folder) / file.path).string();
  write_files(files);
}

Json vat_json(const std::string& folder, const VatResult& vat) {
  const auto distance = [&](const VatDistance& of) {
    const auto share = [&](double meters) { return vat.height > 0 ? meters / vat.height : 0; };
    return Json{
        {"max", of.largest}, {"mean", of.mean}, {"max_share", share(of.largest)}, {"mean_share", share(of.mean)}};
  };
  Json json = {{"folder", folder},          {"layout", vat.files.back().path}, {"vertices", vat.layout.vertices},
               {"width", vat.layout.width}, {"height", vat.layout.height()},   {"character_height", vat.height},
               {"clips", Json::array()}};
  for (const VatClip& clip : vat.clips)
    json["clips"].push_back(
        {{"name", clip.name},
         {"frames", clip.frames},
         {"bytes", clip.bytes},
         {"loop", clip.loops},
         {"gap", clip.gap},
         {"error", {{"frames", distance(clip.at_frames)}, {"between", distance(clip.between_frames)}}},
         {"normal_degrees", clip.normal_angle}});
  return json;
}

void tell_vat(const std::string& folder, const VatResult& vat, const std::string& remedy) {
  std::printf("  textures of %u x %u for %u vertices, %u frames\n", vat.layout.width, vat.layout.height(),
              vat.layout.vertices, vat.layout.frames);
  for (const VatClip& clip : vat.clips) {
    const auto share = [&](double meters) { return vat.height > 0 ? 100 * meters / vat.height : 0; };
    std::printf(
        "  %s: %.2f MB; at frames at most %.3f mm (%.4f %% of the height) off skinning, mean %.3f mm; halfway between "
        "frames %.2f mm (%.3f %%), mean %.3f mm; %s\n",
        printable(clip.name).c_str(), static_cast<double>(clip.bytes) / 1e6, 1000 * clip.at_frames.largest,
        share(clip.at_frames.largest), 1000 * clip.at_frames.mean, 1000 * clip.between_frames.largest,
        share(clip.between_frames.largest), 1000 * clip.between_frames.mean,
        clip.loops ? "loops"
                   : print("does not loop: its ends are %.0f mm apart%s", 1000 * clip.gap, remedy.c_str()).c_str());
  }
  for (const NamedBytes& file : vat.files)
    std::printf("wrote %s\n", printable((fs::path(folder) / file.path).string()).c_str());
}

}  // namespace sinew::cli
