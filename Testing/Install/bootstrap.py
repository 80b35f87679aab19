# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bootstrap folder: a Debian system of its own, to install packages in and to throw away."""

import os
import shutil
import subprocess

from commands import run

# Nothing of the caller's environment gets in: what is found is found without it.
ENVIRONMENT = ["HOME=/root", "LANG=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
               "DEBIAN_FRONTEND=noninteractive"]
# /proc and /dev are mounted for the command alone, and gone when it ends, however it ends.
ENTER = ('mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && '
         'exec chroot "$0" /usr/bin/env -i "$@"')
UNSHARE = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]


class Unavailable(Exception):
    """Why there can be no bootstrap folder here, in one sentence."""


class Bootstrap:
    def __init__(self, folder):
        """Debian's release of this system, or a copy of the folder EVOLVINGSURFACES_BOOTSTRAP."""
        self.folder = folder
        if os.geteuid() != 0:
            raise Unavailable("A bootstrap folder needs root.")
        if subprocess.run([*UNSHARE, "mount", "-t", "tmpfs", "tmpfs", "/mnt"],
                          capture_output=True, check=False).returncode != 0:
            raise Unavailable("This system does not let root mount anything.")
        self.remove()
        template = os.environ.get("EVOLVINGSURFACES_BOOTSTRAP")
        if template:
            run("cp", "--archive", "--one-file-system", template, folder)
            shutil.copyfile("/etc/resolv.conf", folder / "etc/resolv.conf")
        else:
            self.make()

    def make(self):
        if not shutil.which("debootstrap"):
            raise Unavailable("Debian's package debootstrap is not installed.")
        release = run("sh", "-c", '. /etc/os-release && echo "$VERSION_CODENAME"').strip()
        done = subprocess.run(["debootstrap", "--variant=minbase", release, str(self.folder)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        if done.returncode != 0:
            self.remove()
            raise Unavailable(f"debootstrap made no system of the release '{release}': "
                              f"{done.stdout.strip().splitlines()[-1]}")

    def run(self, *command):
        """What a command in the folder prints; the test fails where the command does."""
        return run(*UNSHARE, "sh", "-c", ENTER, self.folder, *ENVIRONMENT, *command)

    def has(self, path):
        """Whether there is such an absolute path, be it a link to nowhere."""
        return os.path.lexists(self.folder / path.lstrip("/"))

    def remove(self):
        run("rm", "-rf", "--one-file-system", self.folder)
