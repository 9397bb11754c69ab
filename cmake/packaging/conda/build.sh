#!/usr/bin/env bash
# The build of recipe.yaml; PREFIX and SP_DIR (its site-packages) are conda's.
set -euo pipefail
: "${PREFIX:?where to install}" "${SP_DIR:?where Python packages go, under PREFIX}"
# shellcheck disable=SC2086  # CMAKE_ARGS are words
cmake -S . -B build-conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DCMAKE_INSTALL_LIBDIR=lib -DHFRAC_PYTHON_DIR="${SP_DIR#"$PREFIX"/}" \
  -DHFRAC_VIZ=OFF -DHFRAC_TESTS=OFF -DHFRAC_BENCH=OFF -DHFRAC_WERROR=OFF
cmake --build build-conda
cmake --install build-conda
