#include "io/text_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

#include "base/error.hpp"

namespace ashlar {

namespace {

[[noreturn]] void fail(const std::string& path) {
  throw ResourceError("cannot write '" + path + "': " + std::strerror(errno));
}

}  // namespace

std::string shortest(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

void replace_file(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".part";
  GrowingFile(temporary).add(text);
  rename_file(temporary, path);
}

void rename_file(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail(to);
}

void sync_to_disk(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!synced) fail(path);
}

GrowingFile::GrowingFile(const std::string& path, bool go_on)
    : path_(path), file_(std::fopen(path.c_str(), go_on ? "ab" : "wb")) {
  if (!file_) fail(path);
}

bool GrowingFile::claim() { return flock(fileno(file_.get()), LOCK_EX | LOCK_NB) == 0; }

void GrowingFile::add(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
    fail(path_);
}

}  // namespace ashlar
