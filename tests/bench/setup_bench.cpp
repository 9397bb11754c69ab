// SPDX-License-Identifier: BSD-3-Clause
// What it takes to build a model, stage by stage: seconds and resident memory per disc.
//
//     bench_setup N [relaxed|tiled|growth] [WORKERS of the packing]
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/error.hpp"
#include "flow/aperture.hpp"
#include "flow/flow_solver.hpp"
#include "geom/faces.hpp"
#include "geom/packing.hpp"
#include "model/network.hpp"
#include "solid/explicit_solver.hpp"

using namespace hfrac;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double resident_bytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  long pages = 0, resident = 0;
  if (file != nullptr) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return 4096.0 * static_cast<double>(resident);
}

class Stages {
 public:
  explicit Stages(double discs) : discs_(discs), start_(now()), last_(start_), empty_(resident_bytes()) {
    std::printf("%-28s %9s %12s %12s\n", "stage", "seconds", "bytes/disc", "peak/disc");
  }
  void done(const char* what) {
    const double t = now();
    line(what, t - last_);
    last_ = now();
  }
  void total() { line("total", now() - start_); }

 private:
  void line(const char* what, double seconds) const {
    malloc_trim(0);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("%-28s %9.2f %12.0f %12.0f\n", what, seconds, (resident_bytes() - empty_) / discs_,
                (static_cast<double>(usage.ru_maxrss) * 1024.0 - empty_) / discs_);
  }
  double discs_, start_, last_, empty_;
};

void build(std::int64_t count, PackingMethod method, int packers) {
  Options o;
  o.packing_disc_count = count;
  PackingOptions p;
  p.count = count;
  p.method = method;
  p.brick = o.packing_brick_discs;
  Stages stages(static_cast<double>(count));
  Workers packing_workers(packers);
  Packing packing = pack_discs(p, {}, &packing_workers);
  stages.done("packing");
  std::printf("  residual %.2g, mean overlap %.2g radii\n", packing.residual, packing.mean_overlap);
  ContactGraph graph =
      build_contact_graph(packing.x, packing.y, packing.radius, {{{50.0, 50.0}, 8.5}}, o.bond_gap_tolerance);
  packing = {};
  stages.done("contact graph");
  Faces faces = build_faces(graph);
  stages.done("faces");
  const auto well = face_around(graph, faces, {50.0, 50.0});
  stages.done("well's face");
  Model model;
  Assembly& assembly = model.assembly;
  assembly = build_assembly(graph, o);
  stages.done("assembly");
  graph = {};
  Network& network = model.network;
  network = build_network(std::move(faces), assembly, {well}, o);
  stages.done("network");
  Boundary boundary(model, o);
  Workers workers(1);
  ExplicitSolver solver(model, boundary, o, workers);
  stages.done("boundary, solver, temporal blocking");
  for (std::int64_t d = 1; d < network.domain_count(); ++d)
    network.stiffness[d] = d == well ? 0.0 : o.fluid_bulk_modulus / network.volume[d];
  const WellOptions hole{50.0, 50.0, 8.5, 0.0, 0.0, 0.0, WellControl::pressure};
  std::vector<double> pressure;
  calibrate_aperture(network, assembly, o, {hole}, pressure);
  stages.done("aperture calibration");
  FlowSolver flow(network, o);
  stages.done("flow matrix");
  flow.advance(network, 1e-3, {});
  stages.done("first flow step of 1 ms");
  stages.total();
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const std::string method = argc > 2 ? argv[2] : "tiled";
  const int packers = argc > 3 ? std::atoi(argv[3]) : 1;
  if (count < 1000 || count > 100000000 || packers < 1 || packers > 1000 ||
      (method != "tiled" && method != "relaxed" && method != "growth")) {
    std::fprintf(stderr,
                 "usage: bench_setup N [relaxed|tiled|growth] [WORKERS]   1 000 to 100 000 000 discs\n");
    return 2;
  }
  try {
    build(count,
          method == "tiled"    ? PackingMethod::tiled
          : method == "growth" ? PackingMethod::growth
                               : PackingMethod::relaxed,
          packers);
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_setup: %s\n", error.what());
    return 1;
  }
  return 0;
}
