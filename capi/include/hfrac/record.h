/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Injection records: time, rate and pressure as a field's logger writes them, in the units that it has. A case file makes a well's
 * schedule of one ([[well]] schedule_file); here a host reads its numbers.
 */
#ifndef HFRAC_RECORD_H
#define HFRAC_RECORD_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Reads a record, a comma-separated table whose first line names its columns with their units: time_s, time_min, time_h, time_d or
 * time (ISO 8601, the first row being time 0); rate_m2_s, or rate_m3_s, rate_m3_min, rate_m3_h, rate_L_s, rate_L_min, rate_bbl_min
 * (barrels of 42 US gallons) or rate_gal_min, which are divided by `thickness` [m, above 0 to 1e6]; pressure_Pa, pressure_kPa, pressure_MPa,
 * pressure_bar or pressure_psi. Or a LAS 2.0 file with curves TIME, RATE, PRES in these units. Or a case file (a name that ends in .toml): the record that its first well with a
 * schedule_file names, by that well's schedule_thickness if it gives one; without such a well *count is 0. Copies at most `capacity` rows, three
 * numbers each: time [s], rate [m2/s], pressure [Pa], which hold until the next row; NaN for a rate or a pressure that the file does not have.
 * *count is how many rows there are, of a record 1 to 1 000 000; rows NULL: only that. What is no record is refused with file and line
 * (HFRAC_ERR_CASE_FILE). Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_read_record(const char *path, double thickness, double *rows, int64_t capacity,
                                             int64_t *count);

#ifdef __cplusplus
}
#endif

#endif
