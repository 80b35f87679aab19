// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChildProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace robustness
{

namespace
{

int checked(int result, const char* what)
{
  if (result < 0)
  {
    throw std::system_error(errno, std::generic_category(), what);
  }
  return result;
}

void limit(int resource, rlim_t value)
{
  const rlimit limits{ value, value };
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

void limitYourself(const ChildLimits& limits)
{
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpuSeconds));
  if (!IsSanitized)
  {
    limit(RLIMIT_AS, limits.bytes);
  }
}

/// A file without a name, for what a child prints.
int makeErrorFile()
{
  char name[] = "/tmp/robustness-XXXXXX";
  const int file = checked(mkstemp(name), "mkstemp");
  unlink(name);
  return file;
}

std::string contentsOf(int file)
{
  std::string text(1 << 16, '\0');
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

/// The line of a sanitizer, of an assertion or of an exception; otherwise the last one.
std::string tellingLine(const std::string& text)
{
  std::istringstream stream(text);
  std::string last;
  for (std::string line; std::getline(stream, line);)
  {
    for (const char* sign :
      { "runtime error:", "ERROR: AddressSanitizer", "ThreadSanitizer:", "Assertion", "what():" })
    {
      if (line.find(sign) != std::string::npos)
      {
        return line;
      }
    }
    last = line.empty() ? last : line;
  }
  return last;
}

/// Does no thread of a process want to run? Where the system does not tell, yes.
bool isIdle(int process)
{
  std::error_code unknown;
  const std::filesystem::path threads = "/proc/" + std::to_string(process) + "/task";
  for (const auto& thread : std::filesystem::directory_iterator(threads, unknown))
  {
    std::ifstream stream(thread.path() / "stat");
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::size_t name = text.rfind(')'); // the state follows the name, which may be anything
    const char state = name + 2 < text.size() ? text[name + 2] : ' ';
    if (state == 'R' || state == 'D')
    {
      return false;
    }
  }
  return true;
}

} // namespace

ChildPool::ChildPool(const ChildLimits& limits, Work work)
  : Limits(limits)
  , Task(std::move(work))
{
}

ChildPool::~ChildPool()
{
  for (const Child& child : this->Running)
  {
    kill(child.process, SIGKILL);
    waitpid(child.process, nullptr, 0);
    close(child.pipe);
    close(child.errors);
  }
}

void ChildPool::start(std::uint64_t seed)
{
  int ends[2];
  checked(pipe(ends), "pipe");
  const int errors = makeErrorFile();
  const int process = checked(fork(), "fork");
  if (process == 0)
  {
    close(ends[0]);
    dup2(errors, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    limitYourself(this->Limits);
    this->Task(seed, Messenger(ends[1]));
    _exit(0);
  }
  close(ends[1]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  this->Running.push_back(
    { seed, process, ends[0], errors, std::chrono::steady_clock::now(), false, {} });
}

void ChildPool::listen(int milliseconds)
{
  std::vector<pollfd> pipes;
  for (const Child& child : this->Running)
  {
    pipes.push_back({ child.pipe, POLLIN, 0 });
  }
  poll(pipes.data(), pipes.size(), milliseconds);
  for (Child& child : this->Running)
  {
    char buffer[4096];
    for (ssize_t size; (size = read(child.pipe, buffer, sizeof buffer)) > 0;)
    {
      child.told.append(buffer, static_cast<std::size_t>(size));
    }
  }
}

void ChildPool::endOverdue()
{
  const auto now = std::chrono::steady_clock::now();
  for (Child& child : this->Running)
  {
    // Who wants to run only waits for a busy machine: his processor time is limited.
    if (!child.isOverdue && now - child.start > std::chrono::seconds(this->Limits.wallSeconds) &&
      isIdle(child.process))
    {
      child.isOverdue = true;
      kill(child.process, SIGKILL);
    }
  }
}

ChildResult ChildPool::wait()
{
  for (;;)
  {
    this->listen(50);
    this->endOverdue();
    for (std::size_t i = 0; i < this->Running.size(); ++i)
    {
      int status = 0;
      if (waitpid(this->Running[i].process, &status, WNOHANG) > 0)
      {
        this->listen(0);
        const Child child = this->Running[i];
        this->Running.erase(this->Running.begin() + static_cast<std::ptrdiff_t>(i));
        const ChildResult result = resultOf(child, status);
        close(child.pipe);
        close(child.errors);
        return result;
      }
    }
  }
}

ChildResult ChildPool::resultOf(const Child& child, int status)
{
  ChildResult result;
  result.seed = child.seed;
  const bool hasVerdict = readTold(child.told, result);
  const std::string printed = contentsOf(child.errors);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (hasVerdict && signal == 0 && WEXITSTATUS(status) == 0)
  {
    return result;
  }
  const bool ranOut = printed.find("bad_alloc") != std::string::npos;
  const bool tookTooLong = child.isOverdue || signal == SIGXCPU ||
    (signal == SIGKILL && !ranOut); // the hard limit of processor time ends with SIGKILL
  result.verdict.outcome = tookTooLong ? Outcome::TimedOut
    : ranOut                           ? Outcome::OutOfMemory
                                       : Outcome::Crashed;
  result.verdict.fault = Fault::None;
  result.verdict.what =
    signal != 0 ? strsignal(signal) : "exit status " + std::to_string(WEXITSTATUS(status));
  const std::string line = tellingLine(printed);
  result.verdict.what += line.empty() ? "" : ": " + line;
  return result;
}

} // namespace robustness
