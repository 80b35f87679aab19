# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Debian packages."""

import shutil
from pathlib import Path

from commands import run


def add_arguments(parser):
    """What is needed to make them."""
    parser.add_argument("--cpack", required=True)
    parser.add_argument("--build", required=True, type=Path)
    parser.add_argument("--source", required=True, type=Path)
    parser.add_argument("--output", required=True, type=Path)
    parser.add_argument("--plugin", action="store_true", help="there is one for ParaView")


def make_packages(cpack, build, folder):
    """The packages of a build tree by name: paths of files that cpack writes into the folder."""
    shutil.rmtree(folder, ignore_errors=True)
    run(cpack, "--config", build / "CPackConfig.cmake", "-B", folder)
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}
