#include "io/result_reader.hpp"

#include <filesystem>

#include "base/error.hpp"

namespace ashlar {

namespace {

const std::string& existing(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) throw DeckError({}, "there is no result file '" + path + "'");
  return path;
}

}  // namespace

ResultReader::ResultReader(const std::string& path) : file_(existing(path), hdf5::Mode::read) {
  if (!file_.has("/VTKHDF") || !file_.has("/Steps"))
    throw DeckError({}, "'" + path + "' is no result file of this program: it has no group VTKHDF or Steps");
  grid_.points = file_.read<double>("/VTKHDF/Points");
  grid_.connectivity = file_.read<std::int64_t>("/VTKHDF/Connectivity");
  grid_.offsets = file_.read<std::int64_t>("/VTKHDF/Offsets");
  grid_.types = file_.read<std::uint8_t>("/VTKHDF/Types");
  const auto count = static_cast<std::size_t>(file_.number("/VTKHDF/Steps", "NSteps"));
  for (std::size_t s = 0; s < count; ++s) steps_.push_back(read_step(file_, s));
  if (steps_.empty()) return;
  for (const std::string& name : file_.names(step_group(0))) {
    ResultField field{name, "", file_.has("/VTKHDF/PointData/" + name), 1, {}};
    const std::string dataset = std::string("/VTKHDF/") + (field.on_points ? "PointData/" : "CellData/") + name;
    field.unit = file_.text(dataset, "unit");
    const auto shape = file_.shape(dataset);
    if (shape.size() > 1) {
      field.components = static_cast<int>(shape[1]);
      field.labels = file_.texts(dataset, "components");
    }
    fields_.push_back(field);
  }
}

std::vector<double> ResultReader::values(std::size_t step, const ResultField& field) {
  return file_.read<double>(step_group(step) + "/" + field.name);
}

}  // namespace ashlar
