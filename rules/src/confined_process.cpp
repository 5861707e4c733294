#include "confined_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

namespace {

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void confine(const Isolation& limits) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  limit(RLIMIT_AS, limits.memory_bytes);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NPROC, 0);
  limit(RLIMIT_NOFILE, 32);  // rule files are read one at a time
}

void send(int pipe, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(3);
    sent += static_cast<std::size_t>(n);
  }
}

std::string receive(int pipe) {
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const ssize_t n = read(pipe, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(n));
  }
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    return "the isolated rules used up their processor time, or were killed";
  }
  if (WIFSIGNALED(status)) return "the process of the isolated rules ended with signal " + std::to_string(WTERMSIG(status));
  return "the process of the isolated rules ended without an answer";
}

/// What the child sends: '+' and the answer, or '-' and an error.
std::string outcome(const std::function<void(Writer&)>& task) {
  Writer out;
  try {
    out.number('+');
    task(out);
    return std::move(out.bytes);
  } catch (const Error& error) {
    out = {};
    out.number('-');
    out.text(error.what());
    out.text(error.traceback());
  } catch (const std::exception& error) {
    out = {};
    out.number('-');
    out.text(std::string("the isolated rules failed: ") + error.what());
    out.text("");
  }
  return std::move(out.bytes);
}

}  // namespace

std::string in_confined_process(const Isolation& limits, const std::function<void(Writer&)>& task) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(std::string("no pipe for the isolated rules: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    throw Error(std::string("no process for the isolated rules: ") + std::strerror(errno));
  }
  if (child == 0) {
    close(ends[0]);
    confine(limits);
    send(ends[1], outcome(task));
    _exit(0);
  }
  close(ends[1]);
  std::string bytes = receive(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) throw Error(how_it_ended(status));
  if (bytes[0] == '-') {
    Reader in(std::string_view(bytes).substr(1));
    const std::string text = in.text();
    throw Error(text, in.text());
  }
  return bytes.substr(1);
}

}  // namespace scenelore::rules
