#pragma once
#include <string>
#include <vector>

namespace ashlar {

/// The folder that a run writes: "dam.run" for "decks/dam.lua", in the working directory, unless the user names one.
class RunFolder {
 public:
  /// Creates the folder, with the folders above it. A folder that is not empty is refused with a DeckError that says
  /// what to do; `replace` empties it first, but only if it holds an earlier run (its manifest.json). Throws
  /// ResourceError if the disk refuses.
  RunFolder(const std::string& path, bool replace);

  /// The folder of a run that goes on.
  static RunFolder existing(const std::string& path) { return RunFolder(path); }

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const;

 private:
  explicit RunFolder(const std::string& path) : path_(path) {}
  std::string path_;
};

/// "dam.run" for "decks/dam.lua".
std::string run_folder_name(const std::string& deck);

/// `name` with everything but letters, digits, '_', '-' and '.' turned into '_': fit for a file name.
std::string file_name_of(const std::string& name);

}  // namespace ashlar
