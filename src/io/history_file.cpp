#include "io/history_file.hpp"

namespace ashlar {

namespace {

/// A cell of the table: quoted where it holds a comma, a quotation mark or a line end (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

HistoryFile::HistoryFile(const std::string& path, const HistoryTable& table) : file_(path) {
  std::string header = "stage,time,load_factor,balanced";
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    header += "," + cell(table.columns[c] + " [" + table.units.at(c) + "]");
  file_.add(header + "\n");
}

void HistoryFile::update(const HistoryTable& table) {
  std::string lines;
  for (; rows_ < table.rows.size(); ++rows_) {
    const auto& row = table.rows[rows_];
    lines += cell(row.stage) + "," + shortest(row.time) + "," + shortest(row.load_factor) + (row.balanced ? ",1" : ",0");
    for (const double value : row.values) lines += "," + shortest(value);
    lines += "\n";
  }
  if (!lines.empty()) file_.add(lines);
}

}  // namespace ashlar
