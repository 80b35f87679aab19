#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# test.sh             installs what is missing, builds build/release, runs every test but the
#                     nightly ones
# test.sh --fast      only the labels kernel, layering and python: for the working loop
# test.sh --nightly   every test, and the kernel's tests with address and undefined-behaviour
#                     sanitizers
# The exit status is CTest's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage()
{
  echo "usage: test.sh [--fast | --nightly]" >&2
  exit 2
}

[[ $# -le 1 ]] || usage
case "${1:-}" in
  "") selection=(-LE '^nightly$') ;;
  --fast) selection=(-L '^(kernel|layering|python)$' -LE '^nightly$') ;;
  --nightly) selection=() ;;
  *) usage ;;
esac

run_ctest()
{
  xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" ctest --no-tests=error --output-on-failure \
    --parallel "$(nproc)" "$@"
}

echo "== Packages"
bash Scripts/install-deps.sh
sanitized=0
if [[ "${1:-}" == --nightly ]]; then
  echo "== Kernel tests with sanitizers"
  bash Scripts/build.sh sanitize
  run_ctest --test-dir build/sanitize -L '^kernel$' || sanitized=$?
fi
echo "== Build"
bash Scripts/build.sh release
echo "== Tests"
tested=0
run_ctest --test-dir build/release "${selection[@]}" || tested=$?
if [[ $sanitized -ne 0 ]]; then
  echo "The kernel tests with sanitizers failed too, see above." >&2
fi
exit $((tested != 0 ? tested : sanitized))
