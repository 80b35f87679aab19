#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
#
# install-deps.sh [--plain]
#
# Installs the packages that building and testing need and that are missing; does nothing when all
# are there. For Debian 12 and 13 and systems with the same packages. Works as root or with sudo.
#
#   --plain   those of the preset plain: Debian's VTK in place of ParaView's, which exclude each other
#
# EVOLVINGSURFACES_SKIP_INSTALL=1 skips it: the packages are then yours to provide.
set -euo pipefail

needed_packages=(
  # compiler and build tools
  g++ make cmake ninja-build
  # Python, and the kernel's libraries
  python3-dev libeigen3-dev libgtest-dev
  # a display for rendering
  xvfb xauth
  # what cpack makes Debian packages with
  dpkg-dev file
)
# VTK alone, which brings what find_package(VTK) looks for.
plain_packages=(libvtk9-dev python3-vtk9 python3-numpy)
# ParaView's SDK with its VTK and Python.
paraview_packages=(
  paraview-dev python3-paraview
  # what find_package(ParaView) looks for
  libdouble-conversion-dev libxml2-dev libexpat1-dev libutfcpp-dev libhdf5-openmpi-dev
  libnetcdf-dev libgdal-dev libgl-dev libglew-dev libgl2ps-dev libfreetype-dev libpng-dev
  libogg-dev libtheora-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev
)
# What it looks for of Qt, and the tool for the plugin's help pages: ParaView 5.11 and 5.13.
qt5_packages=(qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev qtxmlpatterns5-dev-tools)
qt6_packages=(qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-svg-dev qt6-5compat-dev xsltproc)
# An MR scan for an example, 16 MB under BSD-3-Clause: left out where the system has no such package,
# as its test is skipped then.
data_packages=(mricron-data)

say() { echo "install-deps: $*"; }

fail()
{
  echo "install-deps: $*" >&2
  exit 1
}

is_installed()
{
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

# By the package lists that the system has now.
choose_packages()
{
  packages=("${needed_packages[@]}")
  if [[ $plain -eq 1 ]]; then
    packages+=("${plain_packages[@]}")
  else
    choose_paraview_packages
  fi
  local package
  for package in "${data_packages[@]}"; do
    if apt-cache show "$package" >/dev/null 2>&1; then
      packages+=("$package")
    fi
  done
}

choose_paraview_packages()
{
  packages+=("${paraview_packages[@]}")
  if apt-cache show paraview 2>/dev/null | grep '^Depends:.*libqt6' >/dev/null; then
    packages+=("${qt6_packages[@]}")
  else
    packages+=("${qt5_packages[@]}")
  fi
}

find_missing()
{
  missing=()
  local package
  for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
}

as_root()
{
  if [[ $EUID -eq 0 ]]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

# ParaView's packages and those of VTK alone exclude each other: say so before apt removes some, and
# ask where one can.
confirm_removals()
{
  local removed answer
  removed="$(apt-get install --simulate --no-install-recommends "${missing[@]}" 2>/dev/null |
    awk '$1 == "Remv" { print $2 }' | sort | tr '\n' ' ')" || true
  [[ -n "$removed" ]] || return 0
  say "the packages to install exclude these installed ones, which will be removed: $removed"
  if [[ -t 0 && -t 1 ]]; then
    read -r -p "install-deps: go on? [y/N] " answer
    [[ "$answer" == [yY]* ]] || fail "Nothing was changed; set EVOLVINGSURFACES_SKIP_INSTALL=1 to" \
      "build without installing packages."
  fi
}

plain=0
case "$*" in
  "") ;;
  --plain) plain=1 ;;
  *) fail "There is no option '$*', expected --plain or nothing." ;;
esac
if [[ "${EVOLVINGSURFACES_SKIP_INSTALL:-0}" == 1 ]]; then
  say "skipped, as EVOLVINGSURFACES_SKIP_INSTALL=1 asks."
  exit 0
fi
if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  vtk="ParaView's development files, its Qt"
  [[ $plain -eq 0 ]] || vtk="VTK's development files, its Python"
  fail "This system has no apt-get; install $vtk, Eigen 3.4, GoogleTest, CMake, Ninja and Xvfb" \
    "with your package manager and set EVOLVINGSURFACES_SKIP_INSTALL=1."
fi

choose_packages
find_missing
if [[ ${#missing[@]} -eq 0 ]]; then
  say "all ${#packages[@]} packages are there."
  exit 0
fi
if [[ $EUID -ne 0 ]] && ! command -v sudo >/dev/null; then
  fail "Installing packages needs root or sudo; as root run: apt-get install" \
    "--no-install-recommends ${missing[*]}"
fi

say "${#missing[@]} of ${#packages[@]} packages are missing: ${missing[*]}"
say "updating the package lists"
as_root apt-get update -q || say "the package lists could not be updated; trying with those here."
choose_packages
find_missing
confirm_removals
say "installing"
as_root apt-get install -q -y --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" ||
  fail "apt-get could not install the packages, see its message above; this script knows the" \
    "package names of Debian 12 and 13."
find_missing
[[ ${#missing[@]} -eq 0 ]] || fail "Still missing after the installation: ${missing[*]}"
say "done."
