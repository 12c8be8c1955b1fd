#pragma once
#include <cstdio>
#include <memory>
#include <string>

namespace ashlar {

/// The shortest decimal text that reads back as the same number.
std::string shortest(double value);

/// Writes a whole file so that a reader finds either the old text or the new one. Throws ResourceError naming the path.
void replace_file(const std::string& path, const std::string& text);

/// A text file that grows line by line; every line is on its way to the disk when `add` returns.
class GrowingFile {
 public:
  explicit GrowingFile(const std::string& path);
  void add(const std::string& text);  ///< throws ResourceError naming the path

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace ashlar
