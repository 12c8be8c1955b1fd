#include "io/text_file.hpp"

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
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path);
}

GrowingFile::GrowingFile(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) fail(path);
}

void GrowingFile::add(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
    fail(path_);
}

}  // namespace ashlar
