// SPDX-License-Identifier: MIT
// JPEG by libjpeg.
#include <cstdio>

#include "picture/read/decoders.hpp"
#include "sinew_formats/error.hpp"

#ifdef SINEW_HAS_JPEG
#include <jpeglib.h>

#include <csetjmp>
#endif

namespace sinew::picture {

#ifdef SINEW_HAS_JPEG
namespace {

// libjpeg reports by a callback that must not return; its state is plain data, so a jump over it leaks nothing.
struct Job {
  jpeg_decompress_struct info;
  jpeg_error_mgr errors;
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
  bool cut_off;
};

Job* job_of(j_common_ptr info) { return static_cast<Job*>(info->client_data); }

void fail(j_common_ptr info) {
  Job* job = job_of(info);
  (*info->err->format_message)(info, job->message);
  std::longjmp(job->back, 1);
}

// Warnings are what it makes up where bytes are missing.
void warn(j_common_ptr info, int level) {
  if (level >= 0) return;
  Job* job = job_of(info);
  (*info->err->format_message)(info, job->message);
  job->cut_off = true;
}

void start(Job* job) {
  job->info.err = jpeg_std_error(&job->errors);
  job->errors.error_exit = fail;
  job->errors.emit_message = warn;
  job->info.client_data = job;
}

// No destructor in the functions that setjmp() returns to.
bool read_header(Job* job, const std::vector<uint8_t>* bytes) {
  if (setjmp(job->back) != 0) return false;
  jpeg_create_decompress(&job->info);
  jpeg_mem_src(&job->info, bytes->data(), static_cast<unsigned long>(bytes->size()));
  jpeg_read_header(&job->info, TRUE);
  return true;
}

bool read_rows(Job* job, uint8_t* rgba, uint8_t* row) {
  if (setjmp(job->back) != 0) return false;
  job->info.out_color_space = JCS_RGB;
  jpeg_start_decompress(&job->info);
  while (job->info.output_scanline < job->info.output_height && !job->cut_off) {
    uint8_t* rows[1] = {row};
    uint8_t* to = rgba + size_t{job->info.output_scanline} * job->info.output_width * 4;
    jpeg_read_scanlines(&job->info, rows, 1);
    for (size_t x = 0; x < job->info.output_width; ++x) {
      to[4 * x] = row[3 * x];
      to[4 * x + 1] = row[3 * x + 1];
      to[4 * x + 2] = row[3 * x + 2];
      to[4 * x + 3] = 255;
    }
  }
  return !job->cut_off;
}

}  // namespace

Pixels decode_jpeg(const std::string& path, const std::vector<uint8_t>& bytes) {
  Job job{};
  struct Free {
    Job* job;
    ~Free() { jpeg_destroy_decompress(&job->info); }
  } const free_job{&job};
  start(&job);
  const auto refuse = [&] { return Error(path + ": cannot read this JPEG: " + job.message + "; save it again"); };
  if (!read_header(&job, &bytes)) throw refuse();
  check_sides(path, job.info.image_width, job.info.image_height);
  if (job.info.num_components == 4) throw Error(path + ": a JPEG in CMYK; save it as RGB, or as PNG");
  Pixels pixels;
  pixels.width = job.info.image_width;
  pixels.height = job.info.image_height;
  pixels.rgba.resize(size_t{pixels.width} * pixels.height * 4);
  std::vector<uint8_t> row(size_t{pixels.width} * 3);
  if (!read_rows(&job, pixels.rgba.data(), row.data())) throw refuse();
  return pixels;
}
#elif !defined(SINEW_PICTURES_BY_STB)
Pixels decode_jpeg(const std::string& path, const std::vector<uint8_t>&) {
  throw Error(
      path +
      ": this sinew was built without JPEG; install libjpeg (Debian: libjpeg-dev) and build again, or give a PNG");
}
#endif

}  // namespace sinew::picture
