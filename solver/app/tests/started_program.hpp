#pragma once
/// The program itself, started as a person starts it.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "solver/app/tests/folder.hpp"

namespace sunder::app {

/// In `folder`; what it says goes to out.txt and err.txt there.
inline pid_t start(const std::vector<std::string>& words, const TestFolder& folder) {
  std::vector<std::string> line = {SUNDER_PROGRAM};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
  for (const auto& [descriptor, name] : {std::pair(STDOUT_FILENO, "out.txt"), std::pair(STDERR_FILENO, "err.txt")})
    ::dup2(::open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
  ::execv(SUNDER_PROGRAM, arguments.data());
  ::_exit(98);
}

/// The exit status; minus the signal where one ended the program.
inline int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace sunder::app
