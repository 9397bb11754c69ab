/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Status codes, versions and the rules every call follows.
 *
 * - Every function returns an int32_t status: 0 good, negative an error, positive a note (HFRAC_STOPPED).
 *   Results come back through pointers. After an error of kind ARGUMENT nothing has changed.
 * - Callbacks return. What one throws ends the call with HFRAC_ERR_CALLBACK: the state is that of the last whole step, and the
 *   simulation can be used on. A callback must not leave by longjmp or by ending its thread: the library's locks and memory of
 *   that call are lost then, and the simulation answers HFRAC_ERR_BUSY to everything but reading. What stood at a whole step
 *   can still be saved (hfrac_state_save) and restored into a new simulation.
 * - The library never ends the process, prints, changes directory, locale or signal handlers, and keeps no
 *   process-wide state. Different simulations may be used from different threads at once; one simulation belongs
 *   to one thread at a time: a call that finds another thread in it changes nothing and returns HFRAC_ERR_BUSY.
 * - SI units everywhere, unit thickness (1 m) out of the plane, compression positive for stress and pressure,
 *   tension positive for bond forces.
 * - Texts are copied into the caller's buffer: at most `capacity` bytes including the final 0, cut if too long;
 *   `needed` (may be NULL) gets the full size with the 0.
 */
#ifndef HFRAC_BASE_H
#define HFRAC_BASE_H

#include <stdint.h>

#if defined(__GNUC__)
#define HFRAC_API __attribute__((visibility("default")))
#else
#define HFRAC_API
#endif

/* Every function's comment ends with its mark. A stable function keeps its meaning until it is deprecated; an unstable
 * one may change with any minor version, so a host says that it knows: it defines HFRAC_ENABLE_UNSTABLE before the first
 * header of hfrac. Without, a call of one does not compile (GCC 12, clang), or names the fix when it is generated. */
#if defined(HFRAC_ENABLE_UNSTABLE) || !defined(__has_attribute)
#define HFRAC_UNSTABLE_API HFRAC_API
#elif __has_attribute(unavailable)
#define HFRAC_UNSTABLE_API \
  HFRAC_API __attribute__((unavailable("unstable: define HFRAC_ENABLE_UNSTABLE before including hfrac/hfrac.h")))
#elif __has_attribute(error)
#define HFRAC_UNSTABLE_API \
  HFRAC_API __attribute__((error("unstable: define HFRAC_ENABLE_UNSTABLE before including hfrac/hfrac.h")))
#else
#define HFRAC_UNSTABLE_API HFRAC_API
#endif

#define HFRAC_VERSION_MAJOR 0
#define HFRAC_VERSION_MINOR 2
#define HFRAC_VERSION_PATCH 0
/** Grows when, and only when, a compiled client would break; it is the SONAME's number. */
#define HFRAC_ABI_VERSION 0

/** The one list of status codes: X(name, value, text). Values are never renumbered. */
#define HFRAC_STATUS_LIST(X)                                                                    \
  X(HFRAC_OK, 0, "good")                                                                        \
  X(HFRAC_STOPPED, 1, "stopped by a callback; the simulation is at its last good step")         \
  X(HFRAC_NOT_AT_REST, 2, "mechanics did not come to rest within stepping.max_cycles")          \
  X(HFRAC_STOP_CONDITION, 3, "stop.extent_fraction or stop.cracks is reached; hfrac_set_stop lets the run go on") \
  X(HFRAC_ERR_ARGUMENT, -1, "an argument is NULL, not finite or out of range")                  \
  X(HFRAC_ERR_BAD_HANDLE, -2, "the handle was never created or is destroyed")                   \
  X(HFRAC_ERR_STRUCT_SIZE, -3, "struct_size is not set by the init function or unknown")        \
  X(HFRAC_ERR_UNKNOWN_KEY, -4, "no option of that name")                                        \
  X(HFRAC_ERR_CASE_FILE, -5, "the case file cannot be read or holds an invalid value")          \
  X(HFRAC_ERR_MODEL, -6, "the model cannot be built from these options")                        \
  X(HFRAC_ERR_DIVERGED, -7, "the solution left the range of finite numbers; state as before the step") \
  X(HFRAC_ERR_MEMORY, -8, "out of memory")                                                      \
  X(HFRAC_ERR_BUSY, -9, "called from inside a callback of the same simulation, or while another thread is in it") \
  X(HFRAC_ERR_POISONED, -10, "an earlier error left the simulation unusable; only last_error and destroy work") \
  X(HFRAC_ERR_FILE, -11, "a file cannot be written, cannot be read, or is not what it should be") \
  X(HFRAC_ERR_CALLBACK, -12, "a callback threw an exception; the simulation is at its last whole step") \
  X(HFRAC_ERR_COLLAPSED, -13, "the rock fell apart: it does not bear its load, or a disc left its place in a step; state as before the step") \
  X(HFRAC_ERR_EXCHANGE, -14, "another rank of the simulation failed, or does not answer")             \
  X(HFRAC_ERR_DEVICE, -15, "the device of run.device is not there, or failed; state as before the step") \
  X(HFRAC_ERR_INTERNAL, -99, "an error of the library itself; please report it")

#define HFRAC_STATUS_ENUM_(name, value, text) name = value,
enum hfrac_status { HFRAC_STATUS_LIST(HFRAC_STATUS_ENUM_) HFRAC_STATUS_END_ = 0x7fffffff };
#undef HFRAC_STATUS_ENUM_

#ifdef __cplusplus
extern "C" {
#endif

/** How much a message matters. A callback gets the messages of its level and more important ones. */
enum hfrac_log_level {
  HFRAC_LOG_ERROR = 1,   /**< a call failed; the text is that of hfrac_last_error */
  HFRAC_LOG_WARNING = 2, /**< the result may not be what was wanted: not at rest, bonds broken before injection */
  HFRAC_LOG_INFO = 3,    /**< what was built, new cracks, settings changed, states saved and restored */
  HFRAC_LOG_DETAIL = 4   /**< every step */
};

/** Takes one message, a sentence without a line end, on the thread of the call it is about; `message` is valid during the
 * call only. It may read from the simulation; calls that would change it return HFRAC_ERR_BUSY. Return 0: the result is not
 * used. */
typedef int32_t (*hfrac_log_fn)(void *user, int32_t level, const char *message);

/** One simulation: the model, its state and its clock. Opaque. */
typedef struct hfrac_sim hfrac_sim;

/** Version of the library that runs (not of the header it was compiled against). Stable since 0.1. */
HFRAC_API int32_t hfrac_version(int32_t *major, int32_t *minor, int32_t *patch);

/** ABI number of the library that runs; compare with HFRAC_ABI_VERSION. Stable since 0.1. */
HFRAC_API int32_t hfrac_abi_version(int32_t *abi);

/** Compiler, build type and the instruction set the kernels chose on this machine, as one line. Stable since 0.1. */
HFRAC_API int32_t hfrac_build_info(char *buffer, int32_t capacity, int32_t *needed);

/** The cards that run.device = "gpu" can use: how many, and a line of text each with its name and memory; with none, a line that says
 * why. Looks for the driver anew each time. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_devices(int32_t *count, char *buffer, int32_t capacity, int32_t *needed);

/** What a status code means, as one sentence. Unknown codes give HFRAC_ERR_ARGUMENT. Stable since 0.1. */
HFRAC_API int32_t hfrac_status_text(int32_t status, char *buffer, int32_t capacity, int32_t *needed);

/** The text of the last error of `sim`, with the value at fault, the allowed range and the fix. With sim NULL:
 * the last error on this thread of a call that had no simulation (options, create), or found another thread in it
 * (HFRAC_ERR_BUSY). Empty if there was none.
 * Stable since 0.1. */
HFRAC_API int32_t hfrac_last_error(const hfrac_sim *sim, char *buffer, int32_t capacity, int32_t *needed);

#ifdef __cplusplus
}
#endif
#endif
