#!/bin/bash
# Opens a run folder in Debian's own ParaView and looks for times and arrays.
#
#   paraview_check.sh RUN_FOLDER [CACHE_FOLDER]
#
# Debian's python3-paraview conflicts with the VTK development files, so nothing is installed: the packages that this
# machine lacks are downloaded and unpacked into CACHE_FOLDER, and ParaView runs from there. Needs apt's package lists
# and a Debian mirror; takes about 130 MB of downloads the first time.
set -euo pipefail

run_folder=$(realpath "$1")
cache=$(realpath -m "${2:-${TMPDIR:-/tmp}/hfrac-paraview}")
here=$(dirname "$(realpath "$0")")

if [ ! -e "$cache/complete" ]; then
  mkdir -p "$cache/packages" "$cache/root"
  (
    cd "$cache/packages"
    # Only asked, not done: which packages would be new or newer here?
    apt-get install --print-uris --yes --no-install-recommends paraview python3-paraview |
      sed -n "s/^'[^']*' \([^_]*\)_.*/\1/p" >names
    grep -qx python3-paraview names || echo python3-paraview >>names
    grep -qx paraview names || echo paraview >>names
    xargs apt-get download <names
    for package in *.deb; do dpkg -x "$package" "$cache/root"; done
  )
  rm -rf "$cache/packages"
  touch "$cache/complete"
fi

architecture=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
export LD_LIBRARY_PATH="$cache/root/usr/lib/$architecture:$cache/root/usr/lib/$architecture/paraview-5.11:$cache/root/lib/$architecture"
export PYTHONPATH="$cache/root/usr/lib/python3/dist-packages:$cache/root/usr/lib/$architecture/python3.11/site-packages"
unset DISPLAY
exec "$cache/root/usr/bin/pvpython" "$here/paraview_check.py" "$run_folder"
