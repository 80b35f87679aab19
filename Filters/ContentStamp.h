// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Is a data set still what it was? Private to the module.
 */

#ifndef ContentStamp_h
#define ContentStamp_h

#include "vtkType.h"

#include <cstdint>

class vtkDataSet;

/**
 * Notices when a data set's content changes: by modification time first, by a hash of the content
 * when that differs (a producer may have run again to the same result).
 */
class ContentStamp
{
public:
  /// Looks at the data set (null for none); true when its content is not that of the last look.
  bool Update(vtkDataSet* data);

private:
  vtkDataSet* Last = nullptr;
  vtkMTimeType Time = 0;
  std::uint64_t Hash = 0;
};

#endif
