/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The whole of hfrac's C interface. Start at sim.h; the shortest program is examples/c/first.c.
 */
#ifndef HFRAC_H
#define HFRAC_H

#include "base.h"
#include "catalogue.h"
#include "crack.h"
#include "def.h"
#include "exchange.h"
#include "field.h"
#include "grid.h"
#include "heat.h"
#include "lab.h"
#include "linear_solver.h"
#include "record.h"
#include "sim.h"
#include "slip.h"
#include "state.h"

#endif
