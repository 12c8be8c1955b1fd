#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "script/deck.hpp"

namespace ashlar::test {

/// A folder of its own with deck.lua and what lies beside it.
class DeckFolder {
 public:
  DeckFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / ("ashlar_" + std::to_string(getpid()) + "_" + info->name());
    std::filesystem::create_directories(folder_);
  }
  ~DeckFolder() { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string path() const { return folder_.string() + "/"; }

 private:
  std::filesystem::path folder_;
};

inline Deck read_text(const std::string& text, const std::map<std::string, std::string>& settings = {},
                      const ScriptLimits& limits = {}) {
  const DeckFolder folder;
  return read_deck(folder.write("deck.lua", text), settings, limits);
}

/// What reading the deck complains about, without the folder; "" if it is right.
inline std::string complaint(const std::string& text, const std::map<std::string, std::string>& settings = {},
                             const ScriptLimits& limits = {}) {
  const DeckFolder folder;
  try {
    read_deck(folder.write("deck.lua", text), settings, limits);
    return "";
  } catch (const DeckError& error) {
    std::string message = error.what();
    for (std::size_t at; (at = message.find(folder.path())) != std::string::npos;)
      message.erase(at, folder.path().size());
    return message;
  }
}

}  // namespace ashlar::test
