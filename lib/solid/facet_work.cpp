// SPDX-License-Identifier: BSD-3-Clause
// What facets in explicit motion add to the ledger: works and friction from cycle to cycle, and what is released where the list changes.
#include <algorithm>
#include <utility>

#include "solid/bond_law.hpp"
#include "solid/facet_motion.hpp"

namespace hfrac {

// What was stored before, with the contacts of bonds that have become facets, is stored now, was taken up by the fluid where its pores got
// another volume, or is gone.
void FacetMotion::book_change(bool restored) {
  const auto known = std::move(bonds_);
  bonds_.clear();
  for (const Facet& f : facets_) bonds_.push_back(f.bond);
  measure();
  for (std::size_t k = 0; k < items_.size(); ++k) {
    items_[k].shear = shear_of(k);
    items_[k].slide = facet_slide(assembly_, *start_, facets_[k]);
  }
  const double stored = energy();
  if (restored) return;
  double released = stored_ - stored;
  for (const auto bond : bonds_)
    if (!std::binary_search(known.begin(), known.end(), bond))
      released += view_bond(assembly_, options_, bond).contact_energy;
  for (auto& pore : pores_) {
    const double work = pore.pressure * (volume_change(pore) - pore.volume);
    network_.volume_change[pore.domain] = volume_change(pore);
    energies_.fluid += work;
    released += work;
  }
  energies_.fracture += released;
  stored_ = stored;
}

double FacetMotion::shear_of(std::size_t k) const {
  const double opening = items_[k].apart + items_[k].push / start_->stiffness;
  return opening < 0.0 ? closed_facet(assembly_, options_, *start_, facets_[k], opening).shear : 0.0;
}

double FacetMotion::energy() const {
  double sum = -network_.facet_pushed;
  for (std::size_t k = 0; k < items_.size(); ++k)
    sum += facet_energy(assembly_, options_, *start_, facets_[k], items_[k].push);
  for (const auto& [bond, force] : pushes_) sum += push_energy(assembly_, *start_, bond, force);
  return sum;
}

void FacetMotion::count_work() {
  for (auto& pore : pores_) {
    const double volume = volume_change(pore);
    double& worked = network_.facet_worked[pore.domain];
    energies_.fluid += 0.5 * (worked + pore.pressure) * (volume - pore.volume);
    worked = pore.pressure;
    pore.volume = volume;
  }
  if (!far_apart_.empty()) {
    const Vec2 apart = assembly_.position(far_apart_[1]) - assembly_.position(far_apart_[0]);
    energies_.held -= dot(couple_, apart - apart_);
    apart_ = apart;
  }
  const double k_s = options_.contact_shear_stiffness;
  for (std::size_t k = 0; k < items_.size(); ++k) {
    Item& item = items_[k];
    const double shear = shear_of(k), slide = facet_slide(assembly_, *start_, facets_[k]);
    if (k_s > 0.0)
      energies_.friction += 0.5 * (item.shear + shear) * (slide - item.slide - (shear - item.shear) / k_s);
    item.shear = shear;
    item.slide = slide;
  }
}

}  // namespace hfrac
