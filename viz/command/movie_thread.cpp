// SPDX-License-Identifier: BSD-3-Clause
#include "command/movie_thread.hpp"

#include <hfrac/viz.h>

#include "command/drawing.hpp"

namespace hfrac::command {
namespace {

int32_t stop_if_told(void* give_up, double, const char*) {
  return static_cast<const std::atomic<bool>*>(give_up)->load() ? 1 : 0;
}

std::string draw(const std::filesystem::path& folder, std::atomic<bool>& give_up) {
  std::error_code error;
  std::filesystem::create_directories(folder / "pictures", error);
  if (error) return "cannot make '" + (folder / "pictures").string() + "': " + error.message();
  hfrac_viz_options options{};
  hfrac_viz_options_init(&options, sizeof options);
  options.movie_follow = 1;
  const int32_t status = hfrac_viz_render_movie(folder.c_str(), (folder / "pictures" / "movie.mp4").c_str(),
                                                &options, stop_if_told, &give_up);
  if (status == HFRAC_STOPPED) return "the run failed before it could be finished";
  return status < 0 ? drawing_error() : "";
}

}  // namespace

MovieThread::MovieThread(const std::filesystem::path& folder)
    : folder_(folder), thread_([this] { failure_ = draw(folder_, give_up_); }) {}

MovieThread::~MovieThread() {
  give_up_ = true;
  if (thread_.joinable()) thread_.join();
}

std::string MovieThread::finish() {
  if (thread_.joinable()) thread_.join();
  return failure_;
}

}  // namespace hfrac::command
