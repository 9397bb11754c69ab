// SPDX-License-Identifier: BSD-3-Clause
// V10: a hydraulic fracture grows along the larger far-field stress.
//
// Source     Hubbert and Willis (1957): fractures open against the smallest stress, so they run along sigma_Hmax.
// Set-up     Six packings of 2 000 discs, rigid walls at effective stresses of 8 and 0 MPa, well held at 45 MPa net, 60
//            sub-steps of 10 ms. The azimuth is that of the longest spread of the fracture's crack ends about the well.
// Tolerance  Mean azimuth of the six within 15 degrees of sigma_Hmax; each one nearer to sigma_Hmax than to sigma_hmin.
#include "support.hpp"

namespace V10_growth {

// Mean azimuth [degrees] of the packings' fractures.
double grow(int packings) {
  verification::Curves curves("V10", "Direction of the fracture against sigma_Hmax; six packings",
                              "packing,azimuth (degrees)");
  constexpr double degree = 57.29577951308232;
  double sum = 0.0;
  for (int seed = 1; seed <= packings; ++seed) {
    hfrac::Definition def = verification::paper_rock(seed);
    def.stress_sigma_Hmax = 8e6;
    def.stepping_flow_step = 1e-2;
    def.wells[0].pressure = 45e6;
    hfrac_sim* sim = nullptr;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
    EXPECT_GE(hfrac_step(sim, 60), 0);
    hfrac_fracture fracture{};
    int64_t count = 0;
    EXPECT_EQ(hfrac_fractures(sim, sizeof fracture, &fracture, 1, &count), HFRAC_OK);
    EXPECT_GT(count, 0);
    std::printf("  packing %d: %2d cracks, %.1f m, azimuth %.1f degrees\n", seed,
                static_cast<int>(fracture.crack_count), fracture.length, fracture.azimuth * degree);
    EXPECT_EQ(fracture.well, 0);
    EXPECT_LT(std::abs(fracture.azimuth * degree), 45.0);
    sum += fracture.azimuth * degree;
    curves.point("fracture", {static_cast<double>(seed), fracture.azimuth * degree});
    curves.point("sigma_Hmax", {static_cast<double>(seed), 0.0});
    hfrac_sim_destroy(&sim);
  }
  return sum / packings;
}

TEST(V10GrowthSmoke, OneFractureRunsNearerToTheLargerStress) {
  verification::report_absolute("azimuth of the fracture, degrees", grow(1), 0.0, 45.0);
}

TEST(V10Growth, FracturesRunAlongTheLargerStress) {
  verification::report_absolute("azimuth, mean of six packings, degrees", grow(6), 0.0, 15.0);
}

}  // namespace V10_growth
