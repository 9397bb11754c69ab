// SPDX-License-Identifier: BSD-3-Clause
#include "step/exterior_rock.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "flow/aperture.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Displacements of the block's discs by their places.
using Places = std::map<std::pair<double, double>, Vec2>;

Places places_of(const Assembly& block) {
  Places places;
  for (std::int64_t i = 0; i < block.disc_count(); ++i)
    places[{block.x[i], block.y[i]}] = {block.ux[i], block.uy[i]};
  return places;
}

// Of the model's rim: the same discs, by other numbers.
std::vector<Vec2> rest_of_rim(const Places& block, const Assembly& a, const Exterior& exterior) {
  std::vector<Vec2> rest;
  for (const auto& at : exterior.rim()) {
    const auto same = block.find({a.x[at.disc], a.y[at.disc]});
    if (same == block.end())
      throw Error(
          ErrorKind::model,
          "boundary.kind = \"infinite\": a disc of the outer boundary is not bonded to the packing without "
          "wells; bond the outermost discs, or use boundary.kind = \"stress\".");
    rest.push_back(same->second);
  }
  return rest;
}

}  // namespace

void begin_exterior(Engine& e, RockBlock* block, RockAtRest& told, SetupReport& report) {
  const Options& o = e.options;
  const Assembly& a = e.model.assembly;
  PlaneElasticity rock{o.boundary_exterior_modulus,
                       o.boundary_exterior_poisson_ratio / (1.0 - o.boundary_exterior_poisson_ratio)};
  const Places places = block != nullptr ? places_of(block->assembly()) : Places{};
  if (rock.modulus == 0.0) {
    if (block != nullptr)
      rock = block->measure();
    else
      rock = {told.modulus, told.poisson};
    told.modulus = rock.modulus;
    told.poisson = rock.poisson;
  }
  auto exterior = std::make_unique<Exterior>(a, e.model.network, rock);
  if (block != nullptr) told.rim = rest_of_rim(places, a, *exterior);
  exterior->rest_at(told.rim);
  e.boundary->engage(std::move(exterior));
  e.mechanics->refresh_stiffness();
  report.exterior_modulus = rock.modulus;
  report.exterior_poisson_ratio = rock.poisson / (1.0 + rock.poisson);
}

void put_rock_beyond_pipes(Engine& e, double permeability) {
  const Options& o = e.options;
  if (!(o.boundary_flow_distance > 0.0)) return;
  Network& n = e.model.network;
  const Assembly& a = e.model.assembly;
  double around = 0.0;  // m
  for (const auto pipe : n.outer_pipe) around += a.length(pipe);
  const double radius = std::sqrt(o.model_width * o.model_height / std::numbers::pi);
  const double whole =
      2.0 * std::numbers::pi * permeability / o.fluid_viscosity / std::log(o.boundary_flow_distance / radius);
  n.beyond.assign(n.left.size(), 0.0);
  for (const auto pipe : n.outer_pipe)
    n.beyond[static_cast<std::size_t>(pipe)] = whole * a.length(pipe) / around;
  update_apertures(n, a, o);
}

}  // namespace hfrac
