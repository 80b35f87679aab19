# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs commands, and cpack to make the Debian packages."""

import shutil
import subprocess


def run(*command, **options):
    """What a command prints; the test fails where the command does."""
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def make_packages(cpack, build, folder):
    """The packages of a build tree by name: paths of files that cpack writes into the folder."""
    shutil.rmtree(folder, ignore_errors=True)
    run(cpack, "--config", build / "CPackConfig.cmake", "-B", folder)
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}
