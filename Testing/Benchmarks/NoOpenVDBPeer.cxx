// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What stands in for OpenVDBPeer.cxx where OpenVDB is not installed.
 */

#include "OpenVDBPeer.h"

#include <stdexcept>

namespace benchmark
{

struct OpenVDBPeer::Parts
{
};

std::string OpenVDBPeer::version()
{
  return {};
}

OpenVDBPeer::OpenVDBPeer(vtkPolyData*, vtkImageData*, int)
{
  throw std::logic_error("This build has no OpenVDB.");
}

OpenVDBPeer::~OpenVDBPeer() = default;

void OpenVDBPeer::convert(float) {}

OpenVDBPeer::Field OpenVDBPeer::field() const
{
  return {};
}

} // namespace benchmark
