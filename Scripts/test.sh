#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh             installs what is missing, builds build/release, runs every test but the
#                     nightly ones
# test.sh --fast      only the labels kernel, layering and python: for the working loop
# test.sh --plain     the same as without it, of build/plain: with Debian's VTK, without ParaView
# test.sh --nightly [SEED]
#                     every test; the tests of the kernel and of the filters with address and
#                     undefined-behaviour sanitizers, the kernel's parallel ones with the thread
#                     sanitizer; an hour of new inputs from SEED on (default: today's date); and
#                     Scripts/bootstrap.sh, VTK alone on Debian 12 and 13, and ParaView on 13
# The exit status is CTest's, or 1 where only what is nightly failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage()
{
  echo "usage: test.sh [--fast | --plain | --nightly [SEED]]" >&2
  exit 2
}

[[ $# -le 1 || ("$1" == --nightly && $# -eq 2) ]] || usage
[[ "${2:-1}" =~ ^[0-9]{1,18}$ ]] || usage
preset=release
install_arguments=()
case "${1:-}" in
  "") selection=(-LE '^nightly$') ;;
  --fast) selection=(-L '^(kernel|layering|python)$' -LE '^nightly$') ;;
  --plain)
    selection=(-LE '^nightly$')
    preset=plain
    install_arguments=(--plain)
    ;;
  --nightly) selection=() ;;
  *) usage ;;
esac

run_ctest()
{
  xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" ctest --no-tests=error --output-on-failure \
    --parallel "$(nproc)" "$@"
}

# sanitized PRESET TITLE CTEST_ARGUMENT...: builds a preset and runs some of its tests.
sanitized()
{
  echo "== $2"
  # VTK and Mesa leave memory behind when a program ends.
  export ASAN_OPTIONS=detect_leaks=0
  bash Scripts/build.sh "$1"
  run_ctest --test-dir "build/$1" "${@:3}" || failed+=("$2")
}

# Inputs that nobody has tried yet, from a seed on.
run_new_inputs()
{
  local seed="${1:-$(date +%Y%m%d)00000}"
  local title="An hour of inputs from seed $seed on"
  echo "== $title"
  build/release/bin/RobustnessRunner --seed "$seed" --count 0 --seconds 3600 || failed+=("$title")
}

# The tests in a fresh Debian: in_debian SUITE PRESET.
in_debian()
{
  local title="Preset $2 on Debian's $1" status=0
  echo "== $title"
  bash Scripts/bootstrap.sh "$1" "$2" || status=$?
  case $status in
    0) ;;
    77) skipped+=("$title") ;;
    *) failed+=("$title") ;;
  esac
}

echo "== Packages"
bash Scripts/install-deps.sh "${install_arguments[@]}"
failed=()
skipped=()
if [[ "${1:-}" == --nightly ]]; then
  sanitized sanitize "Kernel tests with sanitizers" -L '^kernel$'
  sanitized tsan "Parallel kernel tests with the thread sanitizer" -L '^kernel$' -R 'Thread'
  sanitized sanitize-filters "Filter tests with sanitizers" -L '^vtk$' -E '^Images\.'
fi
echo "== Build"
bash Scripts/build.sh "$preset"
echo "== Tests"
tested=0
run_ctest --test-dir "build/$preset" "${selection[@]}" || tested=$?
if [[ "${1:-}" == --nightly ]]; then
  run_new_inputs "${2:-}"
  in_debian bookworm plain
  in_debian trixie plain
  in_debian trixie release
fi
for title in "${skipped[@]}"; do
  echo "Skipped, see above: $title" >&2
done
for title in "${failed[@]}"; do
  echo "Failed, see above: $title" >&2
done
exit $((tested != 0 ? tested : ${#failed[@]} > 0))
