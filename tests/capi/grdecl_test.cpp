// SPDX-License-Identifier: BSD-3-Clause
// The Eclipse include file, read back as Eclipse reads it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "sim_support.hpp"

namespace grdecl_test {

using namespace testing_capi;

// Keywords with their values; comments and repeats as the format has them.
std::map<std::string, std::vector<double>> read_grdecl(const std::string& path) {
  std::map<std::string, std::vector<double>> found;
  std::ifstream file(path);
  std::string line, keyword;
  while (std::getline(file, line)) {
    EXPECT_LE(line.size(), 128U);
    std::istringstream words(line.substr(0, line.find("--")));
    for (std::string word; words >> word;) {
      if (keyword.empty()) {
        EXPECT_LE(word.size(), 8U);
        keyword = word;
      } else if (word == "/") {
        keyword.clear();
      } else {
        const auto star = word.find('*');
        const long run = star == std::string::npos ? 1 : std::stol(word.substr(0, star));
        const double value = std::stod(star == std::string::npos ? word : word.substr(star + 1));
        found[keyword].insert(found[keyword].end(), static_cast<std::size_t>(run), value);
      }
    }
  }
  EXPECT_TRUE(keyword.empty()) << keyword << " does not end";
  return found;
}

class Grdecl : public testing::Test {
 protected:
  Grdecl() : sim_(cracking_def()) {
    EXPECT_GE(hfrac_step(sim_, 3), 0);
    grid_.struct_size = sizeof grid_;
    grid_.nx = 6;
    grid_.ny = 5;
    grid_.origin[0] = -25.0;
    grid_.dx = 25.0;
    grid_.dy = 20.0;
    EXPECT_EQ(hfrac_set_grid(sim_, &grid_), HFRAC_OK);
    cells_.resize(30);
    int64_t count = 0;
    EXPECT_EQ(hfrac_grid_cells(sim_, HFRAC_UPSCALE_FLOW, sizeof(hfrac_cell), cells_.data(), 30, &count),
              HFRAC_OK);
  }
  Sim sim_;
  hfrac_grid grid_{};
  std::vector<hfrac_cell> cells_;
  TemporaryFolder folder_;
};

constexpr double millidarcy = 9.869233e-16;

TEST_F(Grdecl, PermeabilitiesComeBackInEclipsesOrder) {
  const std::string path = folder_.file();
  ASSERT_EQ(hfrac_write_grdecl(sim_, path.c_str(), HFRAC_UPSCALE_FLOW, HFRAC_GRDECL_PERM, 2, 0.1, 5e-15),
            HFRAC_OK)
      << last_error(sim_);
  auto read = read_grdecl(path);
  ASSERT_EQ(read.size(), 3U);
  for (const char* name : {"PERMX", "PERMY", "PORO"}) ASSERT_EQ(read[name].size(), 60U) << name;
  for (std::size_t k = 0; k < 60; ++k) {
    const hfrac_cell& cell = cells_[k % 30];
    const double x = std::max(5e-15, 5e-15 + cell.permeability[0]),
                 y = std::max(5e-15, 5e-15 + cell.permeability[1]);
    EXPECT_NEAR(read["PERMX"][k] * millidarcy, x, 1e-5 * x) << k;
    EXPECT_NEAR(read["PERMY"][k] * millidarcy, y, 1e-5 * y) << k;
    EXPECT_NEAR(read["PORO"][k], 0.1 + cell.fracture_porosity, 1e-6) << k;
  }
  EXPECT_GT(*std::max_element(read["PERMX"].begin(), read["PERMX"].end()) * millidarcy, 5.5e-15);
  std::ifstream text(path);
  std::string first;
  std::getline(text, first);
  EXPECT_EQ(first.rfind("-- Written by hfrac 0.2.0", 0), 0U) << first;
}

TEST_F(Grdecl, MultipliersAreThoseOfTheFaces) {
  const std::string path = folder_.file();
  ASSERT_EQ(hfrac_write_grdecl(sim_, path.c_str(), HFRAC_UPSCALE_FLOW, HFRAC_GRDECL_MULT, 1, 0.1, 5e-15),
            HFRAC_OK);
  auto read = read_grdecl(path);
  ASSERT_EQ(read["MULTX"].size(), 30U);
  ASSERT_EQ(read["MULTY"].size(), 30U);
  const auto whole = [&](std::size_t c, std::size_t axis) {
    return std::max(5e-15, 5e-15 + cells_[c].permeability[axis]);
  };
  double most = 0.0;
  for (std::size_t c = 0; c < 30; ++c) {
    const double x = c % 6 == 5 ? 1.0 : 2.0 / (5e-15 / whole(c, 0) + 5e-15 / whole(c + 1, 0)),
                 y = c >= 24 ? 1.0 : 2.0 / (5e-15 / whole(c, 1) + 5e-15 / whole(c + 6, 1));
    EXPECT_NEAR(read["MULTX"][c], x, 1e-5 * x) << c;
    EXPECT_NEAR(read["MULTY"][c], y, 1e-5 * y) << c;
    EXPECT_NEAR(read["MULTPV"][c], 1.0 + cells_[c].fracture_porosity / 0.1, 1e-5) << c;
    most = std::max(most, x);
  }
  EXPECT_GT(most, 1.1);
}

TEST_F(Grdecl, OfATurnedGridRunsAlongItsOwnAxes) {
  const std::string path = folder_.file();
  auto straight = grid_;
  straight.nx = straight.ny = 1;
  straight.origin[0] = straight.origin[1] = 0.0;
  straight.dx = straight.dy = 100.0;
  ASSERT_EQ(hfrac_set_grid(sim_, &straight), HFRAC_OK);
  ASSERT_EQ(hfrac_write_grdecl(sim_, path.c_str(), HFRAC_UPSCALE_ODA, HFRAC_GRDECL_PERM, 1, 0.0, 0.0),
            HFRAC_OK);
  auto plain = read_grdecl(path);
  auto turned = straight;  // the same square, i along y
  turned.origin[0] = 100.0;
  turned.angle = 1.5707963267948966;
  ASSERT_EQ(hfrac_set_grid(sim_, &turned), HFRAC_OK);
  ASSERT_EQ(hfrac_write_grdecl(sim_, path.c_str(), HFRAC_UPSCALE_ODA, HFRAC_GRDECL_PERM, 1, 0.0, 0.0),
            HFRAC_OK);
  auto swapped = read_grdecl(path);
  EXPECT_NEAR(swapped["PERMX"][0], plain["PERMY"][0], 1e-4 * plain["PERMY"][0]);
  EXPECT_NEAR(swapped["PERMY"][0], plain["PERMX"][0], 1e-4 * plain["PERMX"][0]);
  EXPECT_GT(std::abs(plain["PERMX"][0] / plain["PERMY"][0] - 1.0), 0.01) << "or the test shows nothing";
}

TEST_F(Grdecl, AFailedWriteLeavesTheEarlierFile) {
  const std::string path = folder_.file();
  { std::ofstream(path) << "earlier"; }
  EXPECT_EQ(hfrac_write_grdecl(sim_, (path + "/below.grdecl").c_str(), 0, 0, 1, 0.0, 0.0), HFRAC_ERR_FILE);
  EXPECT_NE(last_error(sim_).find("below.grdecl"), std::string::npos);
  EXPECT_EQ(hfrac_write_grdecl(sim_, folder_.path().c_str(), 0, 0, 1, 0.0, 0.0), HFRAC_ERR_FILE);
  std::string text;
  std::getline(std::ifstream(path), text);
  EXPECT_EQ(text, "earlier");
}

}  // namespace grdecl_test
