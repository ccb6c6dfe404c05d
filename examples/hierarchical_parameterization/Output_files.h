// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes files that belong together.

#ifndef OUTPUT_FILES_H
#define OUTPUT_FILES_H

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

// Throws a std::runtime_error if there is no permission to write a file of that name.
void check_permission(const std::string& name);

// Files that appear together, each as a whole, or not at all: also if a signal ends the program. Each is written under
// a name of its own beside its place, and then gets its name. It is written through a symbolic link, and has the mode
// of the file that it replaces.
//
// What is no regular file (a pipe, a device, or "-", the standard output) gets its bytes as they are written.
class Output_files
{
public:
  Output_files();
  ~Output_files();                     // removes what has not got its name

  // Throws a std::runtime_error if the file cannot be written.
  void write(const std::string& name, const std::function<void(std::ostream&)>& write_content);

  // Gives all files their names.
  void commit();

private:
  class Temporary;

  std::vector<std::unique_ptr<Temporary>> m_temporaries;
};

#endif // OUTPUT_FILES_H
