#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build.sh [PRESET [TARGET]]   configures and builds build/PRESET (default: release, and all of it;
#                              see CMakePresets.json). The target `product` is what is installed,
#                              without the tests. With CI set, as where tests run by themselves,
#                              warnings are errors
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset="${1:-release}"
cmake --preset "$preset" --log-level=WARNING ${CI:+-DEVOLVINGSURFACES_WARNINGS_AS_ERRORS=ON}
cmake --build "build/$preset" --parallel "$(nproc)" --target "${2:-all}"
