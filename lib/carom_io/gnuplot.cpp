#include "carom_io/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "carom_io/plot.hpp"

extern char** environ;

namespace carom::io::detail {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File temporaryFile() {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw DrawingError(std::string("no temporary file: ") + std::strerror(errno));
  return file;
}

std::string contentOf(std::FILE* file) {
  std::rewind(file);
  std::string content;
  std::array<char, 65536> chunk;
  for (std::size_t n; (n = std::fread(chunk.data(), 1, chunk.size(), file)) > 0;) {
    content.append(chunk.data(), n);
  }
  return content;
}

}  // namespace

std::string runGnuplot(const std::string& script) {
  const File in = temporaryFile(), out = temporaryFile(), err = temporaryFile();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() ||
      std::fflush(in.get()) != 0) {
    throw DrawingError(std::string("a plot's script cannot be stored: ") + std::strerror(errno));
  }
  std::rewind(in.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err.get()), STDERR_FILENO);
  std::string program = "gnuplot", plainSettings = "-d";
  std::array<char*, 3> arguments{program.data(), plainSettings.data(), nullptr};
  pid_t child = 0;
  const int failure =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) {
    throw DrawingError(
        "gnuplot is not installed: plots need it (Debian and Ubuntu: package gnuplot-nox)");
  }
  if (failure != 0) throw DrawingError(std::string("gnuplot: ") + std::strerror(failure));

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw DrawingError(std::string("gnuplot: ") + std::strerror(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw DrawingError("gnuplot failed: " + contentOf(err.get()));
  }
  return contentOf(out.get());
}

}  // namespace carom::io::detail
