// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a file.

#ifndef WRITE_FILE_H
#define WRITE_FILE_H

#include "Output_files.h"

#include <functional>
#include <iosfwd>
#include <string>

// Writes a file as a whole or not at all.
inline void write_file(const std::string& name, const std::function<void(std::ostream&)>& write_content)
{
  Output_files files;
  files.write(name, write_content);
  files.commit();
}

#endif // WRITE_FILE_H
