// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes files.

#ifndef WRITE_FILE_H
#define WRITE_FILE_H

#include <functional>
#include <iosfwd>
#include <string>

// Writes a file as a whole or not at all: under another name first, unless the path is no regular file (a pipe, a
// device).
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

#endif // WRITE_FILE_H
