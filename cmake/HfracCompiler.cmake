# Compiler settings shared by every target.
#
# Results must not depend on the build: no fast-math, and multiply-add is never fused behind our back
# (-ffp-contract=off), so that SSE2, AVX2 and AVX-512 builds of the kernels give the same bits.
# -fno-math-errno and -fno-trapping-math change no result; without them sqrt and selects do not vectorise.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_C_FLAGS_RELEASE "-O3 -DNDEBUG")

add_library(hfrac_flags INTERFACE)
target_compile_options(hfrac_flags INTERFACE
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  -Wall -Wextra -Wpedantic -Wshadow -Wvla
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual -Wextra-semi>)
# Our own programs move with the interface; a host that wants unstable functions has to say so (hfrac/base.h).
target_compile_definitions(hfrac_flags INTERFACE HFRAC_ENABLE_UNSTABLE)
if(HFRAC_WERROR)
  target_compile_options(hfrac_flags INTERFACE -Werror)
endif()
if(HFRAC_SANITIZE)
  add_compile_options(-O1)  # compiles in two thirds of the time of -O2
  # GCC 12 with a sanitizer takes <regex> for uninitialized; without one the warning stands. Its checks of each pointer for null
  # and alignment take half of a compilation, those for overflow are a quarter of the code; clang's stand, in the fuzz targets, which run the whole engine.
  target_compile_options(hfrac_flags INTERFACE -fsanitize=${HFRAC_SANITIZE} -fno-omit-frame-pointer -g1
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -fno-sanitize=null,alignment,pointer-overflow>)
  target_link_options(hfrac_flags INTERFACE -fsanitize=${HFRAC_SANITIZE})
endif()
