// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_RUNS_H
#define PROGRAM_RUNS_H

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

// Runs of the program on files, and what is to come of them.
namespace program_runs {

namespace fs = std::filesystem;

struct Row
{
  std::string name;                          // of the test, with the ending of the file: "truncated.off"
  std::function<std::string()> content;      // none: there is no file
  int exit_status;
  std::string status;                        // in the report; empty: whichever
  std::string words = "";                    // on the line that stderr has then; no words: stderr is empty
  std::string arguments = "";
  std::string before = "";                   // a command of the shell
};

inline void PrintTo(const Row& row, std::ostream* os) { *os << row.name; }

inline std::string test_name(const testing::TestParamInfo<Row>& info)
{
  std::string name = info.param.name;
  std::replace_if(name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

inline std::string content_of(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}

// The value of that name in a report, quotes included.
inline std::string field(const std::string& report, const std::string& name)
{
  const std::size_t at = report.find("\"" + name + "\":");
  if (at == std::string::npos)
    return "";
  const std::size_t begin = at + name.size() + 3;
  return report.substr(begin, report.find_first_of(",}", begin) - begin);
}

// A folder of its own, which goes with it, in which the program runs.
class Program_folder
{
public:
  explicit Program_folder(const std::string& name)
  {
    std::string folder = testing::TempDir() + "program_" + name + "_XXXXXX";
    if (!mkdtemp(&folder[0]))
      throw std::system_error(errno, std::generic_category(), folder);
    m_folder = folder;
  }

  ~Program_folder() { fs::remove_all(m_folder); }
  Program_folder(const Program_folder&) = delete;
  Program_folder& operator=(const Program_folder&) = delete;

  // Runs the program, after a command of the shell. Returns its exit status; 124 after a minute, 128 and more after a
  // crash.
  int run(const std::string& arguments, const std::string& before = "") const
  {
    const std::string command = before + "cd '" + m_folder.string() + "' && timeout 60 '" PROGRAM "' " + arguments +
                                " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  const fs::path& folder() const { return m_folder; }

  // All files in the folder, sorted.
  std::vector<std::string> files() const
  {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(m_folder))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  fs::path m_folder;
};

class Program_input : public testing::TestWithParam<Row>, public Program_folder
{
protected:
  Program_input() : Program_folder("input_" + test_name({ GetParam(), 0 })) { }

  int run(const std::string& arguments) const { return Program_folder::run(arguments, GetParam().before); }
};

constexpr int good = 0, bad_input = 2, failed = 3;
const std::string ok = "ok", any = "", unreadable = "unreadable", no_disk = "ERROR_NO_TOPOLOGICAL_DISC",
                  no_number = "ERROR_WRONG_PARAMETER", no_faces = "ERROR_EMPTY_MESH",
                  no_triangle = "ERROR_NON_TRIANGULAR_MESH";

} // namespace program_runs

#endif // PROGRAM_RUNS_H
