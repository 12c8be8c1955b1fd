#include "io/vtu_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

namespace ashlar {

namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

struct Tag {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::size_t position = 0;
  std::size_t content = 0;  ///< behind the tag
  bool is_closing = false, is_empty = false;

  std::string attribute(const std::string& key) const {
    const auto it = attributes.find(key);
    return it == attributes.end() ? "" : it->second;
  }
};

/// The arrays of the file, not yet decoded, and how they are stored.
struct Arrays {
  std::map<std::string, Tag> of_cells;  ///< <Cells>, by name
  std::map<std::string, Tag> of_cell_data;
  std::map<std::string, Tag> of_field;  ///< of <FieldData>
  std::optional<Tag> points;
  Tag piece;
  std::size_t header_bytes = 4;
  std::size_t appended = 0;  ///< behind the '_' of the appended data; 0 if there is none
  bool appended_raw = false;
};

/// The tag that begins at `at`, which becomes the place behind it.
Tag read_tag(const Scanner& scanner, std::size_t& at) {
  const std::string& text = scanner.text();
  Tag tag;
  tag.position = at++;
  auto fail = [&]() { scanner.fail(tag.position, "this is no well-formed XML tag, or the file is truncated"); };
  auto skip_space = [&] {
    while (at < text.size() && is_space(text[at])) ++at;
  };
  auto word = [&] {
    const auto begin = at;
    while (at < text.size() && !is_space(text[at]) && !std::strchr("<>/='\"", text[at])) ++at;
    if (at == begin) fail();
    return text.substr(begin, at - begin);
  };
  if (at < text.size() && text[at] == '/') tag.is_closing = true, ++at;
  tag.name = word();
  for (;;) {
    skip_space();
    if (at >= text.size()) fail();
    if (text[at] == '/') tag.is_empty = true, ++at;
    if (at >= text.size()) fail();
    if (text[at] == '>') break;
    if (tag.is_empty) fail();
    const std::string key = word();
    skip_space();
    if (at >= text.size() || text[at] != '=') fail();
    ++at;
    skip_space();
    if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) fail();
    const auto close = text.find(text[at], at + 1);
    if (close == std::string::npos) fail();
    tag.attributes[key] = text.substr(at + 1, close - at - 1);
    at = close + 1;
  }
  tag.content = ++at;
  return tag;
}

void check_file_tag(const Scanner& scanner, const Tag& tag, Arrays& arrays) {
  if (tag.name != "VTKFile") scanner.fail(tag.position, "this is no VTK XML file: expected <VTKFile>");
  if (tag.attribute("type") != "UnstructuredGrid")
    scanner.fail(tag.position,
                 "the VTK file holds '" + tag.attribute("type").substr(0, 40) + "'; valid: UnstructuredGrid (.vtu)");
  if (!tag.attribute("compressor").empty())
    scanner.fail(tag.position,
                 "the file is compressed; save it without compression (ParaView: Compressor Type None; "
                 "meshio: compression=None)");
  if (tag.attribute("byte_order") == "BigEndian")
    scanner.fail(tag.position, "big-endian numbers are not read; save the file as ASCII");
  const std::string header = tag.attribute("header_type");
  if (header != "" && header != "UInt32" && header != "UInt64")
    scanner.fail(tag.position, "header_type '" + header.substr(0, 40) + "' is not known; valid: UInt32, UInt64");
  arrays.header_bytes = header == "UInt64" ? 8 : 4;
}

Arrays find_arrays(const Scanner& scanner) {
  const std::string& text = scanner.text();
  Arrays arrays;
  std::vector<std::string> open;
  bool has_piece = false, is_first = true;
  for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    if (text.compare(at, 2, "<?") == 0 || text.compare(at, 4, "<!--") == 0) {
      const bool comment = text[at + 1] == '!';
      const auto end = text.find(comment ? "-->" : "?>", at);
      if (end == std::string::npos) scanner.fail(at, "the file ends inside a comment: it is truncated");
      at = end;
      continue;
    }
    const Tag tag = read_tag(scanner, at);
    if (is_first) check_file_tag(scanner, tag, arrays);
    is_first = false;
    if (tag.is_closing) {
      if (open.empty() || open.back() != tag.name)
        scanner.fail(tag.position, "</" + tag.name.substr(0, 40) + "> closes nothing that is open");
      open.pop_back();
      continue;
    }
    const std::string parent = open.empty() ? "" : open.back();
    if (tag.name == "Piece") {
      if (has_piece) scanner.fail(tag.position, "the file has several pieces; merge them into one");
      has_piece = true;
      arrays.piece = tag;
    } else if (tag.name == "DataArray") {
      if (parent == "Points") arrays.points = tag;
      if (parent == "Cells") arrays.of_cells[tag.attribute("Name")] = tag;
      if (parent == "CellData") arrays.of_cell_data[tag.attribute("Name")] = tag;
      if (parent == "FieldData") arrays.of_field[tag.attribute("Name")] = tag;
    } else if (tag.name == "AppendedData") {
      const std::string encoding = tag.attribute("encoding");
      if (encoding != "raw" && encoding != "base64")
        scanner.fail(tag.position, "encoding '" + encoding.substr(0, 40) + "' is not known; valid: raw, base64");
      arrays.appended_raw = encoding == "raw";
      auto mark = tag.content;
      while (mark < text.size() && is_space(text[mark])) ++mark;
      if (mark >= text.size() || text[mark] != '_')
        scanner.fail(tag.position, "expected '_' before the appended data; the file may be truncated");
      arrays.appended = mark + 1;
      open.clear();
      break;  // what follows is no XML
    }
    if (!tag.is_empty) open.push_back(tag.name);
  }
  if (is_first) scanner.fail_file("this is no VTK XML file: there is no <VTKFile>");
  if (!open.empty()) scanner.fail_file("<" + open.back().substr(0, 40) + "> is not closed: the file is truncated");
  if (!has_piece) scanner.fail_file("there is no <Piece>");
  return arrays;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Numbers of one array.
class Decoder {
 public:
  Decoder(const Scanner& scanner, const Arrays& arrays, const Tag& tag)
      : scanner_(scanner), arrays_(arrays), tag_(tag), name_("array '" + tag.attribute("Name").substr(0, 40) + "'") {}

  template <typename Number>
  std::vector<Number> numbers() const {
    const std::string format = tag_.attribute("format"), type = tag_.attribute("type");
    if (format == "ascii" || format.empty()) return words<Number>();
    const std::string bytes = raw_bytes(format);
    if (type == "Float64") return converted<Number, double>(bytes);
    if (type == "Float32") return converted<Number, float>(bytes);
    if (type == "Int64" || type == "UInt64") return converted<Number, std::int64_t>(bytes);
    if (type == "Int32") return converted<Number, std::int32_t>(bytes);
    if (type == "UInt32") return converted<Number, std::uint32_t>(bytes);
    if (type == "Int16") return converted<Number, std::int16_t>(bytes);
    if (type == "UInt16") return converted<Number, std::uint16_t>(bytes);
    if (type == "Int8") return converted<Number, std::int8_t>(bytes);
    if (type == "UInt8") return converted<Number, std::uint8_t>(bytes);
    fail("has the unknown type '" + type.substr(0, 40) + "'");
  }

  [[noreturn]] void fail(const std::string& message) const { scanner_.fail(tag_.position, name_ + " " + message); }

 private:
  template <typename Number>
  std::vector<Number> words() const {
    const std::string& text = scanner_.text();
    const auto end = std::min(text.find('<', tag_.content), text.size());
    std::vector<Number> result;
    for (auto at = tag_.content; at < end;) {
      while (at < end && is_space(text[at])) ++at;
      if (at == end) break;
      auto stop = at;
      while (stop < end && !is_space(text[stop])) ++stop;
      Number value{};
      const char* first = text.data() + at + (text[at] == '+' ? 1 : 0);
      const auto [parsed, error] = std::from_chars(first, text.data() + stop, value);
      if (error != std::errc() || parsed != text.data() + stop)
        scanner_.fail(
            at, name_ + ": expected a number, found '" + text.substr(at, std::min<std::size_t>(stop - at, 40)) + "'");
      result.push_back(value);
      at = stop;
    }
    return result;
  }

  template <typename Number, typename Stored>
  std::vector<Number> converted(const std::string& bytes) const {
    if (std::is_integral_v<Number> && !std::is_integral_v<Stored>) fail("must hold integers");
    if (bytes.size() % sizeof(Stored)) fail("ends inside a number");
    std::vector<Number> result(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < result.size(); ++i) {
      Stored stored;
      std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
      result[i] = static_cast<Number>(stored);
    }
    return result;
  }

  /// The bytes behind the header, which counts them. The count is never trusted beyond the size of the file.
  std::string raw_bytes(const std::string& format) const {
    const std::string& text = scanner_.text();
    std::size_t begin = tag_.content;
    if (format == "appended") {
      const std::string given = tag_.attribute("offset");
      std::size_t offset = 0;
      const auto [stop, error] = std::from_chars(given.data(), given.data() + given.size(), offset);
      if (error != std::errc() || stop != given.data() + given.size()) fail("has no valid offset");
      if (!arrays_.appended) fail("is appended, but there is no <AppendedData>: the file is truncated");
      if (offset > text.size() - arrays_.appended) fail("begins behind the end of the file: it is truncated");
      begin = arrays_.appended + offset;
    } else if (format == "binary") {
      while (begin < text.size() && is_space(text[begin])) ++begin;
    } else {
      fail("has the unknown format '" + format.substr(0, 40) + "'; valid: ascii, binary, appended");
    }
    const bool raw = format == "appended" && arrays_.appended_raw;
    const std::size_t available = raw ? text.size() - begin : (text.size() - begin) / 4 * 3;
    const std::size_t header = arrays_.header_bytes;
    if (available < header) fail("is truncated");
    auto bytes = [&](std::size_t count) { return raw ? text.substr(begin, count) : base64(begin, count); };
    std::uint64_t count = 0;
    std::memcpy(&count, bytes(header).data(), header);
    if (count > available - header)
      fail("announces " + std::to_string(count) + " bytes, but the file has only " +
           std::to_string(available - header) + " left: the count is wrong or the file is truncated");
    return bytes(header + count).substr(header);
  }

  std::string base64(std::size_t begin, std::size_t count) const {
    const std::string& text = scanner_.text();
    std::string result;
    for (std::size_t at = begin; result.size() < count; at += 4) {
      std::uint32_t group = 0;
      for (std::size_t i = at; i < at + 4; ++i) {
        const bool padding = i < text.size() && text[i] == '=' && i > at + 1;
        const int digit = padding ? 0 : i < text.size() ? base64_digit(text[i]) : -1;
        if (digit < 0)
          scanner_.fail(std::min(i, text.size()), name_ + ": the base64 text ends too early or is damaged");
        group = group << 6 | static_cast<std::uint32_t>(digit);
      }
      for (const int shift : {16, 8, 0}) result += static_cast<char>(group >> shift & 0xFF);
    }
    result.resize(count);
    return result;
  }

  const Scanner& scanner_;
  const Arrays& arrays_;
  const Tag& tag_;
  std::string name_;
};

const Tag& needed(const Scanner& scanner, const Arrays& arrays, const std::string& name) {
  const auto it = arrays.of_cells.find(name);
  if (it == arrays.of_cells.end()) scanner.fail(arrays.piece.position, "<Cells> has no array '" + name + "'");
  return it->second;
}

/// Strings of a field array: the numbers of their characters, each string ended by a zero. Empty without the array.
std::vector<std::string> strings(const Scanner& scanner, const Arrays& arrays, const std::string& name) {
  const auto it = arrays.of_field.find(name);
  std::vector<std::string> result;
  if (it == arrays.of_field.end() || it->second.attribute("type") != "String") return result;
  const Decoder codes(scanner, arrays, it->second);
  std::string text;
  for (const long code : codes.numbers<long>()) {
    if (code) {
      text += static_cast<char>(code);
      continue;
    }
    result.push_back(text);
    text.clear();
  }
  return result;
}

/// The names that `ashlar export` gives to the numbers: regions first, then surfaces.
void read_names(const Scanner& scanner, const Arrays& arrays, MeshContent& content) {
  int number = 0;
  for (const auto& name : strings(scanner, arrays, "region_names")) content.names[{3, ++number}] = name;
  if (number == 0) return;
  for (const auto& name : strings(scanner, arrays, "surface_names")) content.names[{2, ++number}] = name;
}

void check_count(const Scanner& scanner, const Tag& piece, const char* key, std::size_t found) {
  if (piece.attribute(key) != std::to_string(found))
    scanner.fail(piece.position, std::string(key) + " is '" + piece.attribute(key).substr(0, 40) +
                                     "', but the arrays hold " + std::to_string(found));
}

/// VTK cell type -> cell; none for points and lines.
std::optional<Cell> cell_of(const Decoder& types, long type) {
  switch (type) {
    case 1:
    case 3: return {};
    case 5: return Cell::tri3;
    case 9: return Cell::quad4;
    case 10: return Cell::tet4;
    case 12: return Cell::hex8;
    case 13: return Cell::wedge6;
  }
  const bool second_order = type >= 21 && type <= 37;
  types.fail("has cell type " + std::to_string(type) +
             (second_order
                  ? " of second order; only first-order cells are read: mesh again with linear elements"
                  : ", which is not read; valid are hexahedron (12), wedge (13), tetrahedron (10), triangle (5) "
                    "and quad (9)"));
}

/// Six times the volume between triangle (0,1,2) and corner 3 of a wedge: positive in the order of Shape.
double wedge_sense(const MeshContent& content, std::span<const int> nodes) {
  auto from_first = [&](int i) { return content.points[nodes[i]] - content.points[nodes[0]]; };
  return dot(cross(from_first(1), from_first(2)), from_first(3));
}

/// VTK's manual gives the wedge with its first triangle outward; many programs write the order of Abaqus.
void order_wedges(const Scanner& scanner, MeshContent& content) {
  auto& volumes = content.volumes;
  int inverted = -1, upright = -1;
  for (int e = 0; e < volumes.count(); ++e)
    if (volumes.cells[e] == Cell::wedge6) (wedge_sense(content, volumes.element(e)) < 0 ? inverted : upright) = e;
  if (inverted < 0) return;
  if (upright >= 0)
    scanner.fail(volumes.positions[inverted], "wedges " + std::to_string(volumes.ids[upright]) + " and " +
                                                  std::to_string(volumes.ids[inverted]) +
                                                  " have opposite node orders; give all wedges the same order");
  for (int e = 0; e < volumes.count(); ++e)
    if (volumes.cells[e] == Cell::wedge6)
      for (int i = 0; i < 3; ++i)
        std::swap(volumes.nodes[volumes.first_node[e] + i], volumes.nodes[volumes.first_node[e] + i + 3]);
}

}  // namespace

MeshContent read_vtu(Scanner& scanner) {
  const Arrays arrays = find_arrays(scanner);
  if (!arrays.points) scanner.fail(arrays.piece.position, "<Points> has no array");
  const Decoder points(scanner, arrays, *arrays.points);
  const auto coordinates = points.numbers<double>();
  if (arrays.points->attribute("NumberOfComponents") != "3" || coordinates.size() % 3)
    points.fail("must have three components");
  if (coordinates.size() / 3 > INT_MAX) points.fail("has more than 2^31 points");
  MeshContent content;
  for (std::size_t n = 0; n < coordinates.size() / 3; ++n) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!std::isfinite(coordinates[3 * n + i]))
        points.fail("has a coordinate that is not finite, at point " + std::to_string(n));
    content.node_ids.push_back(static_cast<long>(n));
    content.points.push_back({coordinates[3 * n], coordinates[3 * n + 1], coordinates[3 * n + 2]});
  }
  content.used_by_volume.assign(content.points.size(), 0);
  content.used_at_all.assign(content.points.size(), 0);
  check_count(scanner, arrays.piece, "NumberOfPoints", content.points.size());

  const Tag& connectivity_tag = needed(scanner, arrays, "connectivity");
  const Decoder connectivity(scanner, arrays, connectivity_tag),
      offsets(scanner, arrays, needed(scanner, arrays, "offsets")),
      types(scanner, arrays, needed(scanner, arrays, "types"));
  const auto nodes = connectivity.numbers<long>(), ends = offsets.numbers<long>(), kinds = types.numbers<long>();
  check_count(scanner, arrays.piece, "NumberOfCells", kinds.size());
  if (ends.size() != kinds.size())
    offsets.fail("has " + std::to_string(ends.size()) + " entries, 'types' has " + std::to_string(kinds.size()));

  std::vector<long> numbers;
  for (const char* name : {"region", "material", "gmsh:physical"}) {
    const auto it = arrays.of_cell_data.find(name);
    if (it == arrays.of_cell_data.end()) continue;
    const Decoder regions(scanner, arrays, it->second);
    numbers = regions.numbers<long>();
    if (numbers.size() != kinds.size())
      regions.fail("has " + std::to_string(numbers.size()) + " entries for " + std::to_string(kinds.size()) + " cells");
    for (const long number : numbers)
      if (number > INT_MAX || number < -INT_MAX)
        regions.fail("has the number " + std::to_string(number) + ": too large");
    break;
  }

  std::map<std::pair<bool, int>, int> membership_of;
  std::array<int, 8> corners;
  long begin = 0;
  for (std::size_t c = 0; c < kinds.size(); ++c) {
    const auto cell = cell_of(types, kinds[c]);
    const long end = ends[c];
    const long expected = cell ? corner_count(*cell) : kinds[c] == 1 ? 1 : 2;
    if (end < begin || end > static_cast<long>(nodes.size()) || end - begin != expected)
      offsets.fail("gives cell " + std::to_string(c) + " another number of points than its type has (" +
                   std::to_string(expected) + ")");
    for (long i = begin; i < end; ++i) {
      if (nodes[i] < 0 || nodes[i] >= static_cast<long>(content.points.size()))
        connectivity.fail("gives cell " + std::to_string(c) + " the point " + std::to_string(nodes[i]) +
                          "; valid: 0 to " + std::to_string(static_cast<long>(content.points.size()) - 1));
      corners[i - begin] = static_cast<int>(nodes[i]);
      content.used_at_all[nodes[i]] = 1;
    }
    begin = end;
    if (!cell) continue;
    const int number = numbers.empty() ? 1 : static_cast<int>(numbers[c]);
    const auto [it, is_new] =
        membership_of.try_emplace({is_volume(*cell), number}, static_cast<int>(content.memberships.size()));
    if (is_new) {
      const bool belongs = is_volume(*cell) || !numbers.empty();
      content.memberships.push_back({number, belongs ? std::vector{number} : std::vector<int>{}});
    }
    content.add_element(scanner, *cell, static_cast<long>(c), connectivity_tag.position,
                        std::span(corners.data(), static_cast<std::size_t>(expected)), it->second);
  }
  if (begin != static_cast<long>(nodes.size())) connectivity.fail("has more entries than 'offsets' gives to cells");
  order_wedges(scanner, content);
  read_names(scanner, arrays, content);
  return content;
}

}  // namespace ashlar
