// SPDX-License-Identifier: BSD-3-Clause
// What happens when something is wrong: a negative status, a text that says what, nothing printed, nothing
// left.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <random>

#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Errors : public VizTest {
 protected:
  std::string content(const std::string& name) const {
    std::ifstream stream(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  void replace(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary | std::ios::trunc) << bytes;
  }
  // Renders the last stage and expects a reading error that names the file.
  void expect_unreadable(const std::string& name) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const Result result = render_picture(HFRAC_VIZ_STAGE, file("picture.png"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(result.status, HFRAC_VIZ_ERR_READ) << result.text;
    EXPECT_NE(result.text.find(name), std::string::npos) << result.text;
    EXPECT_FALSE(std::filesystem::exists(file("picture.png")));
    EXPECT_EQ(leftovers(folder()), 0);
  }
};

// Lets no file grow beyond some bytes while it lives, as a full disk would.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limited = before_;
    limited.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(Errors, MissingFolder) {
  EXPECT_EQ(hfrac_viz_render_run("/no/such/run", nullptr, nullptr, nullptr), HFRAC_VIZ_ERR_READ);
  EXPECT_NE(last_error().find("/no/such/run"), std::string::npos);
}

TEST_F(Errors, FolderThatIsNoRun) {
  const Result result = render_run();
  EXPECT_EQ(result.status, HFRAC_VIZ_ERR_READ);
  EXPECT_NE(result.text.find("discs.pvd"), std::string::npos);
}

TEST_F(Errors, Arguments) {
  write_run(folder(), run);
  EXPECT_EQ(hfrac_viz_render_run(nullptr, nullptr, nullptr, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_viz_options_init(nullptr, 48), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_viz_snapshot_count(folder().c_str(), nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE | HFRAC_VIZ_GROWTH, file("picture.png")).status,
            HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.jpg")).status, HFRAC_ERR_ARGUMENT);
  options.formats = 8;
  EXPECT_EQ(render_run().status, HFRAC_ERR_ARGUMENT);
  hfrac_viz_options_init(&options, sizeof options);
  options.width = 100000;
  const Result result = render_picture(HFRAC_VIZ_STAGE, file("picture.png"));
  EXPECT_EQ(result.status, HFRAC_ERR_ARGUMENT);
  EXPECT_NE(result.text.find("width"), std::string::npos);
  hfrac_viz_options_init(&options, sizeof options);
  options.snapshot = 77;
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status, HFRAC_ERR_ARGUMENT);
  options.struct_size = 0;
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status, HFRAC_ERR_STRUCT_SIZE);
}

TEST_F(Errors, TextIsThatOfTheLastCallOnThisThread) {
  EXPECT_EQ(hfrac_viz_render_run("/no/such/run", nullptr, nullptr, nullptr), HFRAC_VIZ_ERR_READ);
  std::string elsewhere = "?";
  std::thread([&] { elsewhere = last_error(); }).join();
  EXPECT_EQ(elsewhere, "");
  write_run(folder(), run);
  std::int32_t count = 0;
  EXPECT_EQ(hfrac_viz_snapshot_count(folder().c_str(), &count), HFRAC_OK);
  EXPECT_EQ(last_error(), "");
}

TEST_F(Errors, TextIsCutToTheBuffer) {
  std::array<char, 8> text{};
  std::int32_t needed = 0;
  hfrac_viz_render_run("/no/such/run", nullptr, nullptr, nullptr);
  hfrac_viz_last_error(text.data(), text.size(), &needed);
  EXPECT_EQ(std::string(text.data()).size(), 7U);
  EXPECT_GT(needed, 8);
}

TEST_F(Errors, TruncatedFiles) {
  write_run(folder(), run);
  for (const char* name : {"discs_00002.vtu", "cracks_00002.vtu", "bonds_00002.vtu", "flow_00002.vtu"}) {
    const std::string whole = content(name);
    replace(name, whole.substr(0, whole.size() / 2));
    expect_unreadable(name);
    replace(name, "");
    expect_unreadable(name);
    replace(name, whole);
  }
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status, HFRAC_OK);
}

TEST_F(Errors, MissingFileOfASeries) {
  write_run(folder(), run);
  std::filesystem::remove(file("discs_00002.vtu"));
  expect_unreadable("discs_00002.vtu");
}

TEST_F(Errors, CellsThatPointOutside) {
  write_run(folder(), run);
  replace(
      "bonds_00002.vtu",
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid><Piece NumberOfPoints=\"2\" "
      "NumberOfCells=\"1\"><CellData><DataArray type=\"Int32\" Name=\"state\" format=\"ascii\">0</DataArray>"
      "</CellData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0"
      "</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 "
      "123456789"
      "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">2</DataArray><DataArray "
      "type=\"UInt8\" Name=\"types\" "
      "format=\"ascii\">3</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>");
  expect_unreadable("bonds_00002.vtu");
}

TEST_F(Errors, BrokenCollectionAndSummary) {
  write_run(folder(), run);
  const std::string collection = content("discs.pvd");
  replace("discs.pvd", "<VTKFile><Collec");
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status, HFRAC_VIZ_ERR_READ);
  replace("discs.pvd", collection);
  replace("summary.json", "{\"title\": ");
  expect_unreadable("summary.json");
  replace("summary.json", "{\"title\": 7, \"model\": [], \"wells\": {\"x_m\": \"a\"}}");
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status, HFRAC_OK);
}

// Damage anywhere must never end the process; most of it must be noticed.
TEST_F(Errors, RandomDamage) {
  run.columns = 10;
  write_run(folder(), run);
  options.width = 320;
  std::mt19937 random(7);
  for (const char* name : {"discs_00002.vtu", "bonds_00002.vtu", "cracks_00002.vtu", "flow_00002.vtu"}) {
    const std::string whole = content(name);
    for (int round = 0; round < 15; ++round) {
      std::string damaged = whole;
      for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>('!' + random() % 90);
      replace(name, damaged);
      const Result result = render_picture(HFRAC_VIZ_STAGE, file("picture.png"));
      EXPECT_TRUE(result.status == HFRAC_OK || result.status == HFRAC_VIZ_ERR_READ)
          << result.status << result.text;
      EXPECT_EQ(result.status == HFRAC_OK, result.text.empty());
    }
    replace(name, whole);
  }
}

TEST_F(Errors, FolderToWriteToDoesNotExist) {
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_STAGE, file("no/such/folder/picture.png"));
  EXPECT_EQ(result.status, HFRAC_VIZ_ERR_WRITE);
  EXPECT_NE(result.text.find("picture.png"), std::string::npos);
  EXPECT_EQ(render_movie(file("no/such/folder/movie.mp4")).status, HFRAC_VIZ_ERR_WRITE);
}

TEST_F(Errors, PicturesIsAFile) {
  write_run(folder(), run);
  replace("pictures", "in the way");
  EXPECT_EQ(render_run().status, HFRAC_VIZ_ERR_WRITE);
}

TEST_F(Errors, ReadOnlyFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is read-only for root";
  write_run(folder(), run);
  std::filesystem::permissions(folder(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const Result result = render_run();
  std::filesystem::permissions(folder(), std::filesystem::perms::owner_all);
  EXPECT_EQ(result.status, HFRAC_VIZ_ERR_WRITE);
  EXPECT_NE(result.text.find("pictures"), std::string::npos);
}

TEST_F(Errors, FullDiskLeavesNothingAndKeepsTheOldFile) {
  write_run(folder(), run);
  options.movie_width = 640;
  replace("picture.png", "old");
  Result picture;
  Result movie;
  {
    const FileSizeLimit limit(2000);
    picture = render_picture(HFRAC_VIZ_STAGE, file("picture.png"));
    movie = render_movie(file("movie.mp4"));
  }
  EXPECT_EQ(picture.status, HFRAC_VIZ_ERR_WRITE) << picture.text;
  EXPECT_NE(picture.text.find("picture.png"), std::string::npos);
  EXPECT_EQ(movie.status, HFRAC_VIZ_ERR_WRITE) << movie.text;
  EXPECT_EQ(content("picture.png"), "old");
  EXPECT_FALSE(std::filesystem::exists(file("movie.mp4")));
  EXPECT_EQ(leftovers(folder()), 0);
}

int32_t stop_at_movie(void* /*user*/, double fraction, const char* what) {
  EXPECT_GE(fraction, 0.0);
  EXPECT_LE(fraction, 1.0);
  return std::string(what) == "movie.mp4" && fraction > 0.5 ? 1 : 0;
}

TEST_F(Errors, StopLeavesNoHalfMovie) {
  write_run(folder(), run);
  options.width = 400;
  options.movie_width = 320;
  EXPECT_EQ(render_run(stop_at_movie).status, HFRAC_STOPPED);
  EXPECT_TRUE(std::filesystem::exists(file("pictures") / "growth.png"));
  EXPECT_FALSE(std::filesystem::exists(file("pictures") / "movie.mp4"));
  EXPECT_EQ(leftovers(file("pictures")), 0);
}

int32_t call_back(void* user, double /*fraction*/, const char* /*what*/) {
  *static_cast<std::int32_t*>(user) = hfrac_viz_renderer_info(nullptr, 0, nullptr);
  return 1;
}

TEST_F(Errors, CallFromInsideACallbackIsRefused) {
  write_run(folder(), run);
  std::int32_t inner = 0;
  EXPECT_EQ(render_run(call_back, &inner).status, HFRAC_STOPPED);
  EXPECT_EQ(inner, HFRAC_ERR_BUSY);
}

}  // namespace
}  // namespace hfrac::viz_test
