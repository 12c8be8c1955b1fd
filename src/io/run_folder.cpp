#include "io/run_folder.hpp"

#include <filesystem>

#include "base/error.hpp"

namespace ashlar {

namespace fs = std::filesystem;

RunFolder::RunFolder(const std::string& path, bool replace) : path_(path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw DeckError({}, "'" + path + "' is a file; choose another folder for the results with --out");
  if (fs::is_directory(path, error) && !fs::is_empty(path, error)) {
    const bool earlier_run = fs::exists(fs::path(path) / "manifest.json", error);
    if (!earlier_run)
      throw DeckError({}, "folder '" + path + "' is not empty and holds no run; choose another one with --out");
    if (!replace)
      throw DeckError({}, "folder '" + path +
                              "' holds an earlier run; replace it with --force or choose another folder with --out");
    // The manifest goes last: what is left of a folder that could not be emptied is still known as a run.
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(path, error))
      if (entry.path().filename() != "manifest.json") old.push_back(entry.path());
    old.push_back(fs::path(path) / "manifest.json");
    for (const auto& entry : old)
      if (!error) fs::remove_all(entry, error);
    if (error) throw ResourceError("cannot empty folder '" + path + "': " + error.message());
  }
  fs::create_directories(path, error);
  if (error) throw ResourceError("cannot create folder '" + path + "': " + error.message());
}

std::string RunFolder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

std::string run_folder_name(const std::string& deck) { return fs::path(deck).stem().string() + ".run"; }

std::string file_name_of(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool fit =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    out += fit ? c : '_';
  }
  return out;
}

}  // namespace ashlar
