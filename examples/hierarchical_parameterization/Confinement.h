// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For code that prints, and writes files that nobody asked for.

#ifndef CONFINEMENT_H
#define CONFINEMENT_H

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <streambuf>
#include <string>
#include <system_error>

// While it lives, the current folder is a new one, which goes with it, and the standard output is switched off.
class Confinement
{
public:
  Confinement()
    : m_outside(std::filesystem::current_path()),
      m_folder(std::filesystem::temp_directory_path() / ("hierarchical_parameterization_" + std::to_string(getpid()))),
      m_output(std::cout.rdbuf(nullptr))
  {
    std::filesystem::create_directory(m_folder);
    std::filesystem::current_path(m_folder);
  }

  ~Confinement()
  {
    std::error_code unused_error;
    std::filesystem::current_path(m_outside, unused_error);
    std::filesystem::remove_all(m_folder, unused_error);
    std::cout.rdbuf(m_output);
  }

  Confinement(const Confinement&) = delete;
  Confinement& operator=(const Confinement&) = delete;

private:
  std::filesystem::path m_outside, m_folder;
  std::streambuf* m_output;
};

#endif // CONFINEMENT_H
