/* SPDX-License-Identifier: BSD-3-Clause */
/* A disk that fails, for a program that does not know: preloaded (LD_PRELOAD), it stands before the calls that open, write,
 * sync and rename, counts those that concern files below HFRAC_DISK_FOLDER, and lets one go wrong.
 *
 *   HFRAC_DISK_FAULT   none    nothing, only count
 *                      kill    the process dies at call HFRAC_DISK_AT; in a write, after HFRAC_DISK_SHARE % of the bytes;
 *                              in another call, before it if that is below 50, else after it
 *                      eio     call HFRAC_DISK_AT fails with EIO, once; a write after that share of the bytes
 *                      full    from that call on writes take that share of their bytes at most once more, then ENOSPC
 *                      short   every write takes a part of its bytes only
 *   HFRAC_DISK_LOG     file that gets "calls N" at the end, "fault NAME" when it happens, and "outside PATH" for whatever is
 *                      opened to be written outside the folder
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { most_files = 4096 };
enum fault { fault_none, fault_kill, fault_eio, fault_full, fault_short };

static char watched[most_files]; /* descriptors of files below the folder */
static enum fault fault;
static long at, share, calls;
static char folder[4096];
static int log_file = -1;
static unsigned long dice = 88172645463325252UL;

static ssize_t (*real_write)(int, const void*, size_t);

static void note(const char* what, const char* which) {
  char line[4300];
  const int length = snprintf(line, sizeof line, "%s %s\n", what, which);
  if (log_file >= 0 && length > 0) real_write(log_file, line, (size_t)length);
}

__attribute__((constructor)) static void begin(void) {
  real_write = (ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  const char *name = getenv("HFRAC_DISK_FAULT"), *where = getenv("HFRAC_DISK_FOLDER"),
             *log = getenv("HFRAC_DISK_LOG");
  if (where == NULL || name == NULL) return;
  snprintf(folder, sizeof folder, "%s", where);
  const char* names[] = {"none", "kill", "eio", "full", "short"};
  for (int k = 0; k < 5; ++k)
    if (strcmp(name, names[k]) == 0) fault = (enum fault)k;
  at = getenv("HFRAC_DISK_AT") != NULL ? atol(getenv("HFRAC_DISK_AT")) : 0;
  share = getenv("HFRAC_DISK_SHARE") != NULL ? atol(getenv("HFRAC_DISK_SHARE")) : 0;
  dice += (unsigned long)(at * 7919 + share);
  int (*real_open)(const char*, int, ...) = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, "open");
  if (log != NULL) log_file = real_open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
}

__attribute__((destructor)) static void end(void) {
  char text[32];
  snprintf(text, sizeof text, "%ld", calls);
  note("calls", text);
}

/* Whether this call, the next one that counts, is the one that goes wrong. */
static int is_hit(void) {
  ++calls;
  return fault != fault_none && fault != fault_short && calls == at;
}

static void die(const char* where) {
  note("fault", where);
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

static int is_inside(const char* path) {
  const size_t length = strlen(folder);
  return length > 0 && strncmp(path, folder, length) == 0;
}

static int open_watched(const char* path, int flags, mode_t mode, const char* symbol) {
  int (*real)(const char*, int, ...) = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, symbol);
  const int writes = (flags & O_ACCMODE) != O_RDONLY;
  if (folder[0] == 0) return real(path, flags, mode);
  if (writes && !is_inside(path) && strncmp(path, "/dev/", 5) != 0 && strncmp(path, "/proc/", 6) != 0)
    note("outside", path);
  const int counts = is_inside(path) && writes;
  const int hit = counts && is_hit();
  if (hit && fault == fault_kill && share < 50) die("kill before open");
  if (hit && fault != fault_kill) {
    note("fault", "open");
    errno = fault == fault_full ? ENOSPC : EIO;
    return -1;
  }
  const int file = real(path, flags, mode);
  if (file >= 0 && file < most_files) watched[file] = (char)is_inside(path);
  if (hit) die("kill after open");
  return file;
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_watched(path, flags, mode, "open");
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_watched(path, flags, mode, "open64");
}

int close(int file) {
  int (*real)(int) = (int (*)(int))dlsym(RTLD_NEXT, "close");
  if (file >= 0 && file < most_files) watched[file] = 0;
  return real(file);
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (file < 0 || file >= most_files || !watched[file]) return real_write(file, bytes, count);
  const size_t part = count * (size_t)share / 100;
  if (fault == fault_short && count > 1) {
    ++calls;
    dice ^= dice << 13;
    dice ^= dice >> 7;
    dice ^= dice << 17;
    return real_write(file, bytes, 1 + dice % (count < 9000 ? count : 9000));
  }
  const int hit = is_hit();
  if (hit && fault == fault_kill) {
    if (part > 0) real_write(file, bytes, part);
    die("kill in write");
  }
  if (hit || (fault == fault_full && at > 0 && calls > at)) {
    if (hit) note("fault", "write");
    if (hit && part > 0) return real_write(file, bytes, part); /* the rest fails in the next call */
    errno = fault == fault_full ? ENOSPC : EIO;
    return -1;
  }
  if (fault == fault_eio && calls == at + 1 && share > 0) {
    errno = EIO;
    return -1;
  }
  return real_write(file, bytes, count);
}

int fsync(int file) {
  int (*real)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
  if (file < 0 || file >= most_files || !watched[file]) return real(file);
  const int hit = is_hit();
  if (hit && fault == fault_kill && share < 50) die("kill before fsync");
  if (hit && fault != fault_kill) {
    note("fault", "fsync");
    errno = fault == fault_full ? ENOSPC : EIO;
    return -1;
  }
  const int status = real(file);
  if (hit) die("kill after fsync");
  return status;
}

int rename(const char* from, const char* to) {
  int (*real)(const char*, const char*) = (int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename");
  if (!is_inside(to)) return real(from, to);
  const int hit = is_hit();
  if (hit && fault == fault_kill && share < 50) die("kill before rename");
  if (hit && fault != fault_kill) {
    note("fault", "rename");
    errno = fault == fault_full ? ENOSPC : EIO;
    return -1;
  }
  const int status = real(from, to);
  if (hit) die("kill after rename");
  return status;
}
