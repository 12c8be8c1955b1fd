#pragma once
#include <cstdio>
#include <memory>
#include <string>

namespace ashlar {

/// The shortest decimal text that reads back as the same number.
std::string shortest(double value);

/// Writes a whole file so that a reader finds either the old text or the new one. Throws ResourceError naming the path.
void replace_file(const std::string& path, const std::string& text);

/// Gives a file another name; one of that name is replaced. Throws ResourceError naming the path.
void rename_file(const std::string& from, const std::string& to);

/// Waits until a file or folder would survive a loss of power. Throws ResourceError naming the path.
void sync_to_disk(const std::string& path);

/// A text file that grows line by line; every line is on its way to the disk when `add` returns.
class GrowingFile {
 public:
  /// @param go_on whether what the file has already stays
  explicit GrowingFile(const std::string& path, bool go_on = false);
  void add(const std::string& text);  ///< throws ResourceError naming the path
  /// Keeps it to this program for as long as it is open. False: another one has it.
  bool claim();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace ashlar
