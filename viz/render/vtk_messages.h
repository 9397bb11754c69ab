// SPDX-License-Identifier: BSD-3-Clause
// VTK reports errors by printing them. While one of these lives, what VTK says on this thread is kept
// instead, so that it can become the text of an error; messages of other threads still go where they went
// before.
#pragma once

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace hfrac::viz {

class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  // The errors since the last call, in one line each without source positions; empty if there were none.
  std::string take_errors();
  // Throws Failure(HFRAC_VIZ_ERR_DRAW) if there were any.
  void demand_none();

 private:
  class Keeper;
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkSmartPointer<Keeper> keeper_;
  int previous_verbosity_ = 0;
};

}  // namespace hfrac::viz
