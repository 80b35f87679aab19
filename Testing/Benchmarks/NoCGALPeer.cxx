// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What stands in for CGALPeer.cxx where CGAL is not installed.
 */

#include "CGALPeer.h"

#include <stdexcept>

namespace benchmark
{

struct CGALPeer::Parts
{
};

std::string CGALPeer::version()
{
  return {};
}

CGALPeer::CGALPeer(const evolving::SurfaceMesh&)
{
  throw std::logic_error("This build has no CGAL.");
}

CGALPeer::~CGALPeer() = default;

bool CGALPeer::canRemesh() const
{
  return false;
}

void CGALPeer::wrap(double, double) {}

void CGALPeer::remesh(double, double) {}

evolving::SurfaceMesh CGALPeer::result() const
{
  return {};
}

} // namespace benchmark
