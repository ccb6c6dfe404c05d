// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For code that prints, and writes files that nobody asked for.

#ifndef CONFINEMENT_H
#define CONFINEMENT_H

#include <stdlib.h>

#include <cerrno>
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
    : m_outside(std::filesystem::current_path()), m_folder(make_folder())
  {
    std::error_code error;
    std::filesystem::current_path(m_folder, error);
    if (error) {
      std::filesystem::remove(m_folder);
      throw std::system_error(error, m_folder.string());
    }
    std::filesystem::remove(m_folder, error);    // where that can be: nothing stays if a signal ends the program
    m_output = std::cout.rdbuf(nullptr);
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
  // A folder that nobody had before.
  static std::filesystem::path make_folder()
  {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    if (error)
      throw std::system_error(error, "the folder for temporary files, see TMPDIR");
    std::string name = (parent / "hierarchical_parameterization_XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw std::system_error(errno, std::generic_category(), name);
    return name;
  }

  std::filesystem::path m_outside, m_folder;
  std::streambuf* m_output = nullptr;
};

#endif // CONFINEMENT_H
