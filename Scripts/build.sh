#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# build.sh [PRESET]   configures and builds build/PRESET (default: release; see CMakePresets.json)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset="${1:-release}"
cmake --preset "$preset" --log-level=WARNING
cmake --build "build/$preset" --parallel "$(nproc)"
