// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the name of a file leads to.

#ifndef FILE_PLACE_H
#define FILE_PLACE_H

#include <filesystem>
#include <string>

// The place that a name leads to, which need not exist. Symbolic links are followed, those that lead nowhere as well.
struct File_place
{
  // `standard_stream`: the descriptor that is meant by "-".
  File_place(const std::string& name, int standard_stream);

  // Whether there is something that takes bytes as they come, and that no other file can replace.
  bool is_special() const;

  std::filesystem::path path;          // without a link at its end
  std::filesystem::path canonical;     // without a link anywhere
  int descriptor;                      // that the name means, as /dev/stdout does: the file is open already; or -1
};

// Of a file that is read, and of one that is written: "-" is the standard input, and the standard output.
File_place input_place(const std::string& name);
File_place output_place(const std::string& name);

bool is_standard_output(const std::string& name);

// Whether writing one of them changes the other one. Special files bear to be written twice; the standard output does
// not, as two files would be mixed there.
bool is_same_file(const File_place& a, const File_place& b);

#endif // FILE_PLACE_H
