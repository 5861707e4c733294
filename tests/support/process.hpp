// Runs a program as a user's shell would, and keeps what it says.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

namespace scenelore::test {

struct Finished {
  int code = -1;    ///< exit code; 128 + signal when killed, as shells say
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

/// Starts `arguments` (the first is the program) with stdout and stderr into files of `folder`; returns the process id.
inline pid_t start(const std::vector<std::string>& arguments, const TemporaryFolder& folder) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const std::string out = folder / "stdout", err = folder / "stderr";
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

inline Finished finish(pid_t child, const TemporaryFolder& folder) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(folder / "stdout"),
          read_file(folder / "stderr")};
}

inline Finished run(const std::vector<std::string>& arguments, const TemporaryFolder& folder) {
  return finish(start(arguments, folder), folder);
}

}  // namespace scenelore::test
