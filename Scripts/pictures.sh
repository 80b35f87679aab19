#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# pictures.sh [NAME]
#
# Makes the pictures of the repository anew: those in Examples/ by the example of the same name, the one
# of the README by the demo. NAME: a part of an example's name, for that one alone. Look at what changed
# before you commit it; a test compares each with what its example makes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash Scripts/build.sh release product
EVOLVINGSURFACES_KEEP_PICTURES=1 ctest --test-dir build/release --output-on-failure --no-tests=error \
  -R "^Example\..*${1:-}"
git status --short Examples
