/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * For C++ hosts: a hfrac_sim_def that fills itself, frees its lists, and is copied with them. Pass its address to any function
 * that takes a hfrac_sim_def. */
#ifndef HFRAC_DEFINITION_HPP
#define HFRAC_DEFINITION_HPP

#include <stdexcept>
#include <utility>

#include "def.h"

namespace hfrac {

struct Definition : hfrac_sim_def {
  Definition() : hfrac_sim_def() {
    require(hfrac_sim_def_init(this, static_cast<int32_t>(sizeof(hfrac_sim_def))));
  }
  /** The same values with lists of its own; a std::runtime_error if `from` is no definition. */
  Definition(const hfrac_sim_def &from) : Definition() { require(hfrac_sim_def_copy(&from, this)); }
  Definition(const Definition &from) : Definition(static_cast<const hfrac_sim_def &>(from)) {}
  Definition(Definition &&from) noexcept : hfrac_sim_def(from) { from.lists_gone(); }
  Definition &operator=(Definition from) noexcept {
    std::swap(static_cast<hfrac_sim_def &>(*this), static_cast<hfrac_sim_def &>(from));
    return *this;
  }
  ~Definition() { hfrac_sim_def_free(this); }

 private:
  void lists_gone() noexcept {
    lists = nullptr;
    well_count = joint_count = schedule_count = 0;
  }
  static void require(int32_t status) {
    if (status >= 0) return;
    char text[1024] = "";
    hfrac_last_error(nullptr, text, sizeof text, nullptr);
    throw std::runtime_error(text);
  }
};

}  // namespace hfrac
#endif
