// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes files.

#include "write_file.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const bool is_special = fs::exists(status) && !fs::is_regular_file(status);
  const std::string temporary = is_special ? path : path + ".part";
  std::ofstream out(temporary, std::ios::binary);
  if (out) {
    try {
      write(out);
    } catch (...) {
      out.setstate(std::ios::badbit);
    }
    out.close();
    if (out && is_special)
      return;
    if (out) {
      fs::rename(temporary, path, error);
      if (!error)
        return;
    }
    if (!is_special)
      fs::remove(temporary, error);
  }
  throw std::runtime_error(path + ": cannot be written");
}
