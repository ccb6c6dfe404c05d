// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes files that belong together. What needs POSIX is here.

#include "Output_files.h"

#include "File_place.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& name, int error)
{
  throw std::runtime_error(name + ": cannot be written (" + std::generic_category().message(error) + ')');
}

// ---- signals ----

// The files to remove if a signal ends the program. The lock is a flag, as a handler of signals may use no mutex; the
// vector is never destroyed, as a signal may come after main().
std::atomic_flag is_locked = ATOMIC_FLAG_INIT;
std::vector<const char*>& temporary_files = *new std::vector<const char*>;

constexpr int ending_signals[] = { SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU };

sigset_t set_of_ending_signals()
{
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : ending_signals)
    sigaddset(&signals, signal);
  return signals;
}

void lock()
{
  while (is_locked.test_and_set()) { }
}

// The lock is kept to the end: no thread makes another file. The signal raised here comes when the handler returns.
extern "C" void remove_temporary_files(int signal)
{
  lock();
  for (const char* file : temporary_files)
    ::unlink(file);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

// What is ignored stays ignored, as nohup wants it.
bool handle_ending_signals()
{
  struct sigaction action = {}, former;
  action.sa_handler = remove_temporary_files;
  action.sa_mask = set_of_ending_signals();
  for (const int signal : ending_signals)
    if (::sigaction(signal, nullptr, &former) == 0 && former.sa_handler == SIG_DFL)
      ::sigaction(signal, &action, nullptr);
  return true;
}

// While it lives no handler runs: not in this thread, where it would wait for the lock forever, nor past the lock in
// another one. So the list and the files agree.
class Signal_lock
{
public:
  Signal_lock()
  {
    static const bool is_handled = handle_ending_signals();
    static_cast<void>(is_handled);
    const sigset_t signals = set_of_ending_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, &m_former_mask);
    lock();
  }

  ~Signal_lock()
  {
    is_locked.clear();
    ::pthread_sigmask(SIG_SETMASK, &m_former_mask, nullptr);
  }

  Signal_lock(const Signal_lock&) = delete;
  Signal_lock& operator=(const Signal_lock&) = delete;

private:
  sigset_t m_former_mask;
};

// ---- descriptors ----

// An open file, which it closes.
class Descriptor_buffer : public std::streambuf
{
public:
  explicit Descriptor_buffer(int descriptor) : m_descriptor(descriptor) { setp(m_bytes, m_bytes + sizeof m_bytes); }

  ~Descriptor_buffer() override
  {
    if (m_descriptor >= 0)
      ::close(m_descriptor);
  }

  // Returns the error number of what failed first, or 0.
  int close()
  {
    sync();
    if (::close(m_descriptor) != 0 && m_error == 0)
      m_error = errno;
    m_descriptor = -1;
    return m_error;
  }

protected:
  int_type overflow(int_type c) override
  {
    if (sync() != 0)
      return traits_type::eof();
    return traits_type::eq_int_type(c, traits_type::eof()) ? traits_type::not_eof(c) : sputc(char(c));
  }

  int sync() override
  {
    for (const char* at = pbase(); at != pptr() && m_error == 0;) {
      const ssize_t n = ::write(m_descriptor, at, std::size_t(pptr() - at));
      if (n >= 0)
        at += n;
      else if (errno == EAGAIN || errno == EWOULDBLOCK)
        wait_until_writable();
      else if (errno != EINTR)
        m_error = errno;
    }
    setp(m_bytes, m_bytes + sizeof m_bytes);
    return m_error == 0 ? 0 : -1;
  }

private:
  // Of a pipe that others have made non-blocking.
  void wait_until_writable() const
  {
    pollfd pipe = { m_descriptor, POLLOUT, 0 };
    ::poll(&pipe, 1, -1);
  }

  int m_descriptor, m_error = 0;
  char m_bytes[1 << 16];
};

// Writes what is open, and closes it.
void write_to(int descriptor, const std::string& name, const std::function<void(std::ostream&)>& write_content)
{
  if (descriptor < 0)
    fail(name, errno);
  Descriptor_buffer buffer(descriptor);
  std::ostream out(&buffer);
  write_content(out);
  if (const int error = buffer.close(); error != 0 || !out)
    fail(name, error != 0 ? error : EIO);
}

int open_special(const File_place& place)
{
  return place.descriptor >= 0 ? ::dup(place.descriptor) : ::open(place.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
}

} // namespace

void check_permission(const std::string& name)
{
  const File_place place = output_place(name);
  const fs::path folder = place.path.has_parent_path() ? place.path.parent_path() : fs::path(".");
  const bool is_replacing = ::access(place.path.c_str(), F_OK) == 0;
  if (!place.is_special() && ((is_replacing && ::access(place.path.c_str(), W_OK) != 0) ||
                              ::access(folder.c_str(), W_OK | X_OK) != 0))
    fail(name, errno);
}

// ---- temporary files ----

// A file beside the place that it is for. It is removed unless it gets there.
class Output_files::Temporary
{
public:
  Temporary(const std::string& name, const fs::path& place) : m_name(name), m_place(place)
  {
    struct stat replaced;
    const bool is_replacing = ::stat(place.c_str(), &replaced) == 0;
    if (!is_replacing && errno != ENOENT)
      fail(name, errno);
    if (is_replacing && S_ISDIR(replaced.st_mode))
      fail(name, EISDIR);
    if (is_replacing && ::access(place.c_str(), W_OK) != 0)
      fail(name, errno);
    create(is_replacing ? S_IRUSR | S_IWUSR : 0666);
    if (is_replacing)
      ::fchmod(m_descriptor, replaced.st_mode & 0777);
  }

  ~Temporary()
  {
    if (m_file.empty())
      return;
    const Signal_lock signal_lock;
    ::unlink(m_file.c_str());
    forget();
  }

  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return m_descriptor; }

  // Under a Signal_lock.
  void move_to_place()
  {
    if (::rename(m_file.c_str(), m_place.c_str()) != 0)
      fail(m_name, errno);
    forget();
    m_file.clear();
  }

private:
  // A name that nobody has: O_EXCL takes no file that exists, and no link. It is short, as that of the place may be as
  // long as names can be.
  void create(mode_t mode)
  {
    const Signal_lock signal_lock;
    temporary_files.reserve(temporary_files.size() + 1);
    for (int i = 0; m_descriptor < 0; ++i) {
      m_file = m_place.parent_path() / (".part" + std::to_string(::getpid()) + '_' + std::to_string(i));
      m_descriptor = ::open(m_file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (m_descriptor < 0 && errno != EEXIST)
        fail(m_name, errno);
    }
    temporary_files.push_back(m_file.c_str());
  }

  void forget()
  {
    temporary_files.erase(std::find(temporary_files.begin(), temporary_files.end(), m_file.c_str()));
  }

  const std::string m_name;
  const fs::path m_place;
  fs::path m_file;
  int m_descriptor = -1;
};

Output_files::Output_files() = default;
Output_files::~Output_files() = default;

void Output_files::write(const std::string& name, const std::function<void(std::ostream&)>& write_content)
{
  const File_place place = output_place(name);
  if (place.is_special()) {
    write_to(open_special(place), name, write_content);
    return;
  }
  m_temporaries.push_back(std::make_unique<Temporary>(name, place.path));
  write_to(m_temporaries.back()->descriptor(), name, write_content);
}

void Output_files::commit()
{
  {
    const Signal_lock signal_lock;
    for (const auto& temporary : m_temporaries)
      temporary->move_to_place();
  }
  m_temporaries.clear();
}
