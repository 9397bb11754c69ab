#!/bin/bash
# Opens a run folder's paraview_state.py in Debian's own ParaView, without a display.
#
#   paraview_state_check.sh RUN_FOLDER [CACHE_FOLDER]
#
# The packages are those paraview_check.sh has unpacked into CACHE_FOLDER; it must have run before.
set -euo pipefail

run_folder=$(realpath "$1")
cache=$(realpath -m "${2:-${TMPDIR:-/tmp}/hfrac-paraview}")
[ -e "$cache/complete" ] || { echo "paraview_state_check: run paraview_check.sh first" >&2; exit 1; }

architecture=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
export LD_LIBRARY_PATH="$cache/root/usr/lib/$architecture:$cache/root/usr/lib/$architecture/paraview-5.11:$cache/root/lib/$architecture"
export PYTHONPATH="$cache/root/usr/lib/python3/dist-packages:$cache/root/usr/lib/$architecture/python3.11/site-packages"
unset DISPLAY WAYLAND_DISPLAY
exec "$cache/root/usr/bin/pvpython" "$(dirname "$(realpath "$0")")/paraview_state_check.py" "$run_folder"
