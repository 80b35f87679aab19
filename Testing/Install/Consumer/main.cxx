// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iostream>
#include <vtkIcosphereSource.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

/// Prints the number of points of an icosphere.
int main()
{
  vtkNew<vtkIcosphereSource> source;
  source->Update();
  std::cout << source->GetOutput()->GetNumberOfPoints() << std::endl;
  return 0;
}
