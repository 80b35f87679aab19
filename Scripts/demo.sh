#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [MESH [OUTDIR]]
#
# Installs what is missing, builds the product in build/release and shrink-wraps MESH (.obj .ply .stl .vtk .vtp;
# default: Data/bunny.ply) into OUTDIR (default: demo-output): evolution.pvd, result.vtp,
# history.csv and result.png. Further arguments go to demo.py; see demo.py --help.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

fail()
{
  echo "demo: $*" >&2
  exit 1
}

if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  exec /usr/bin/python3 "$root/Scripts/demo.py" --help
fi
mesh="${1:-$root/Data/bunny.ply}"
output="${2:-demo-output}"
# Said before minutes of building; demo.py looks into the file.
[[ -f "$mesh" && -r "$mesh" ]] || fail "'$mesh' is not a readable file; give the path of a mesh" \
  "(.obj, .ply, .stl, .vtk or .vtp)."

echo "== Packages"
bash "$root/Scripts/install-deps.sh"
echo "== Build, the first time two to five minutes on two cores"
bash "$root/Scripts/build.sh" release product
echo "== Shrink wrap"
package="$(find "$root/build/release" -type d -path '*-packages/evolvingsurfaces' -print -quit)"
[[ -n "$package" ]] || fail "The build made no Python package evolvingsurfaces; remove" \
  "$root/build/release and try again."
PYTHONPATH="$(dirname "$package")${PYTHONPATH:+:$PYTHONPATH}" \
  xvfb-run -a -s "-screen 0 1920x1200x24 -noreset" \
  /usr/bin/python3 "$root/Scripts/demo.py" "$mesh" "$output" "${@:3}"
