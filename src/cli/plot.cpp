#include "cli/plot.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "base/error.hpp"

namespace ashlar {
namespace {

namespace fs = std::filesystem;

constexpr const char* interpreter = "/usr/bin/python3";  // Debian's: another one on the path may lack h5py

fs::path find_script() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/ashlar/plot.py";
  for (const fs::path& place : {installed, fs::path(ASHLAR_TOOLS) / "plot.py"})
    if (fs::exists(place, error)) return place;
  throw ResourceError("the plotting program is missing: neither " + installed.string() +
                      " nor " ASHLAR_TOOLS "/plot.py exists");
}

}  // namespace

int plot(const std::vector<std::string>& arguments) {
  const std::string script = find_script().string();
  std::vector<char*> words{const_cast<char*>(interpreter), const_cast<char*>(script.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw ResourceError(std::string("cannot start the plotting program: ") + std::strerror(errno));
  if (child == 0) {
    execv(interpreter, words.data());
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return 128 + WTERMSIG(status);
  if (WEXITSTATUS(status) == 127)
    throw ResourceError(std::string(interpreter) + " is missing: apt-get install python3");
  return WEXITSTATUS(status);
}

}  // namespace ashlar
