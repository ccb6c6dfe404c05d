// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the name of a file leads to.

#include "File_place.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace {

constexpr int standard_input = 0, standard_output = 1;

// The number N of /dev/fd/N, by whichever name of that folder; -1 for another path.
int descriptor_of(const fs::path& path)
{
  const std::string name = path.filename().string();
  std::error_code unused_error;
  const bool is_number = !name.empty() && name.size() < 6 && name.find_first_not_of("0123456789") == std::string::npos;
  return is_number && fs::equivalent(path.parent_path(), "/dev/fd", unused_error) ? std::stoi(name) : -1;
}

// Not by fs::canonical(), which fails where a link leads nowhere, and goes on behind /dev/fd, where a file must not be
// opened again but used as it is.
fs::path follow_links(fs::path path)
{
  constexpr int most_links = 40;       // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < most_links && descriptor_of(path) < 0 && fs::is_symlink(path, error); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    if (error)
      break;
    path = path.parent_path() / target;
  }
  return path;
}

} // namespace

File_place::File_place(const std::string& name, int standard_stream)
  : path(name == "-" ? fs::path() : follow_links(name)),
    descriptor(name == "-" ? standard_stream : descriptor_of(path))
{
  if (name == "-")
    path = "/dev/fd/" + std::to_string(descriptor);
  std::error_code error;
  canonical = fs::weakly_canonical(fs::absolute(path, error), error);      // "new" alone would stay relative
  if (error)
    canonical = path;
}

bool File_place::is_special() const
{
  std::error_code unused_error;
  const fs::file_status status = fs::status(path, unused_error);
  return descriptor >= 0 || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

File_place input_place(const std::string& name) { return File_place(name, standard_input); }

File_place output_place(const std::string& name) { return File_place(name, standard_output); }

bool is_standard_output(const std::string& name) { return output_place(name).descriptor == standard_output; }

bool is_same_file(const File_place& a, const File_place& b)
{
  if (a.descriptor >= 0 && a.descriptor == b.descriptor)
    return true;
  std::error_code unused_error;
  if (fs::exists(a.path, unused_error) && fs::exists(b.path, unused_error))
    return fs::is_regular_file(a.path, unused_error) && fs::equivalent(a.path, b.path, unused_error);
  return a.canonical == b.canonical;
}
