#include "io/checkpoint_file.hpp"

#include <filesystem>

#include "io/hdf5.hpp"
#include "io/text_file.hpp"

namespace ashlar {

namespace {

/// Texts end with a zero each.
void write_texts(hdf5::File& file, const std::string& name, const std::vector<std::string>& texts) {
  std::vector<std::uint8_t> bytes;
  for (const std::string& text : texts) {
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.push_back(0);
  }
  if (!bytes.empty()) file.write(name, std::span<const std::uint8_t>(bytes), {bytes.size()});
}

std::vector<std::string> read_texts(hdf5::File& file, const std::string& name) {
  std::vector<std::string> texts;
  std::string text;
  for (const std::uint8_t byte : file.read<std::uint8_t>(name)) {
    if (byte != 0) {
      text += static_cast<char>(byte);
      continue;
    }
    texts.push_back(text);
    text.clear();
  }
  return texts;
}

}  // namespace

void write_checkpoint(const std::string& path, const StoredCheckpoint& stored) {
  const std::string temporary = path + ".part";
  {
    hdf5::File file(temporary);
    const Checkpoint& c = stored.checkpoint;
    for (const char* group : {"/numbers", "/texts"}) file.group(group);
    file.attribute("/", "stage", std::int64_t{c.stage});
    file.attribute("/", "within", std::int64_t{c.within});
    file.attribute("/", "outputs", static_cast<std::int64_t>(stored.outputs));
    write_texts(file, "/identity", stored.identity);
    for (const auto& [name, numbers] : c.numbers)
      if (!numbers.empty()) file.write("/numbers/" + name, std::span(numbers), {numbers.size()});
    for (const auto& [name, texts] : c.texts) write_texts(file, "/texts/" + name, texts);
    file.flush();
  }
  sync_to_disk(temporary);
  rename_file(temporary, path);
  sync_to_disk(std::filesystem::absolute(path).parent_path().string());
}

std::optional<StoredCheckpoint> read_checkpoint(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  hdf5::File file(path, hdf5::Mode::read);
  StoredCheckpoint stored;
  Checkpoint& c = stored.checkpoint;
  c.stage = static_cast<int>(file.number("/", "stage"));
  c.within = file.number("/", "within") != 0;
  stored.outputs = static_cast<std::size_t>(file.number("/", "outputs"));
  stored.identity = read_texts(file, "/identity");
  for (const std::string& name : file.names("/numbers")) c.numbers[name] = file.read<double>("/numbers/" + name);
  for (const std::string& name : file.names("/texts")) c.texts[name] = read_texts(file, "/texts/" + name);
  return stored;
}

}  // namespace ashlar
