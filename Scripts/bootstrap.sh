#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# bootstrap.sh SUITE PRESET
#
# Builds and tests the files of this work tree, committed or not, in a fresh Debian: SUITE is its name
# (bookworm is Debian 12, trixie 13), PRESET is release (its ParaView) or plain (its VTK).
# Needs root and debootstrap, three to six gigabytes and a network.
#
# The Debian is the folder build/bootstrap/SUITE-PRESET. It is made the first time and kept, with
# what is built in it; remove it to start afresh. What is mounted in it is mounted for the
# processes of this script alone, so that nothing is left mounted however they end.
#
# The exit status is that of Scripts/test.sh in there, or 77 where this machine cannot do it.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { echo "bootstrap: $*"; }

skip()
{
  echo "bootstrap: skipped, $*" >&2
  exit 77
}

usage()
{
  echo "usage: bootstrap.sh SUITE release|plain    (SUITE: bookworm, trixie, ...)" >&2
  exit 2
}

# isolated COMMAND...: with mounts and processes of its own, which end with it.
isolated() { unshare --mount --pid --fork --kill-child "$@"; }

make_debian()
{
  say "making $debian"
  mkdir -p "$root/build/bootstrap/packages"
  rm -rf "$debian.part"
  isolated debootstrap --variant=minbase --include=iproute2 \
    --cache-dir="$root/build/bootstrap/packages" "$suite" "$debian.part"
  mv "$debian.part" "$debian"
}

# How this machine reaches the network: name servers, apt's proxies and the like.
copy_network_settings()
{
  local file
  cp -L --remove-destination /etc/resolv.conf "$debian/etc/resolv.conf"
  for file in /etc/apt/apt.conf /etc/apt/apt.conf.d/*; do
    if grep -qs '^[[:space:]]*Acquire' "$file"; then
      cp "$file" "$debian/etc/apt/apt.conf.d/"
    fi
  done
}

# With their times, so that only what has changed is built again; files that are gone here go there.
copy_sources()
{
  mkdir -p "$debian/src"
  find "$debian/src" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  existing_files | tar -C "$root" --null --files-from=- -cf - | tar -C "$debian/src" -xf -
}

# Those of the work tree, each ended by a zero, that Git knows or could add.
existing_files()
{
  local file
  git -C "$root" ls-files -z --cached --others --exclude-standard |
    while IFS= read -r -d '' file; do
      [[ ! -e "$root/$file" ]] || printf '%s\0' "$file"
    done
}

# inside [UNSHARE_OPTION...] -- COMMAND...: runs it in the Debian.
inside()
{
  local name namespaces=() settings=(HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin)
  while [[ "$1" != -- ]]; do
    namespaces+=("$1")
    shift
  done
  for name in CI http_proxy https_proxy no_proxy; do
    [[ -z "${!name:-}" ]] || settings+=("$name=${!name}")
  done
  # shellcheck disable=SC2016 # the inner shell expands these
  isolated "${namespaces[@]}" bash -c 'mount -t proc proc "$1/proc" &&
    mount -t sysfs -o ro sysfs "$1/sys" && mount --rbind /dev "$1/dev" &&
    exec chroot "$1" /usr/bin/env -i "${@:2}"' bash "$debian" "${settings[@]}" "${@:2}"
}

# With a network of their own, in which X servers have their numbers to themselves.
run_tests()
{
  # shellcheck disable=SC2016 # the inner shell expands these
  inside --net -- EVOLVINGSURFACES_SKIP_INSTALL=1 \
    bash -c 'ip link set lo up && exec bash /src/Scripts/test.sh "$@"' bash "${options[@]}"
}

[[ $# -eq 2 && "$1" =~ ^[a-z]+$ ]] || usage
suite="$1"
case "$2" in
  release) options=() ;;
  plain) options=(--plain) ;;
  *) usage ;;
esac
debian="$root/build/bootstrap/$suite-$2"
[[ $EUID -eq 0 ]] || skip "for it needs root to make a Debian and to mount in it; run it as root."
command -v debootstrap >/dev/null ||
  skip "for the program debootstrap was not found; install the package debootstrap."
isolated true 2>/dev/null ||
  skip "for this system lets no process have mounts of its own, as in some containers."

[[ -d "$debian" ]] || make_debian
copy_network_settings
copy_sources
inside -- bash /src/Scripts/install-deps.sh "${options[@]}"
run_tests
