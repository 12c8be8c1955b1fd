#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "model/mesher/closed_surface.hpp"
#include "model/mesher/facet_soup.hpp"
#include "model/place_text.hpp"

namespace ashlar {

namespace {

/// Lines of text, without empty ones and remarks, which begin with '#'. No number of things that a line announces is
/// believed unless the file is long enough for them.
class Lines {
 public:
  Lines(const std::string& path, const Where& where)
      : path_(path), where_(where), stream_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  /// The next line; false at the end of the file.
  bool next(std::istringstream& line) {
    for (std::string text; std::getline(stream_, text);) {
      ++number_;
      const auto first = text.find_first_not_of(" \t\r");
      if (first == std::string::npos || text[first] == '#') continue;
      line = std::istringstream(text);
      return true;
    }
    return false;
  }
  std::istringstream need(const std::string& what) {
    std::istringstream line;
    if (!next(line)) fail("expected " + what + ", but the file ends here: it is truncated");
    return line;
  }
  long count(std::istringstream& line, const std::string& things) const {
    long number = -1;
    if (!(line >> number) || number < 0) fail("expected the number of " + things);
    if (static_cast<unsigned long>(number) > size_)
      fail("the number of " + things + " is " + std::to_string(number) + ", but the file has only " +
           std::to_string(size_) + " bytes: the number is wrong or the file is truncated");
    return number;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw DeckError(where_, path_ + ":" + std::to_string(number_) + ": " + message);
  }

 private:
  std::string path_;
  Where where_;
  std::ifstream stream_;
  std::size_t size_;
  long number_ = 0;
};

/// Object File Format as text: "OFF", the numbers of points, facets and edges, then a line for each point and each
/// facet, where colours may follow.
FacetSoup read_off(const std::string& path, const Where& where) {
  Lines lines(path, where);
  std::string head;
  if (!(lines.need("OFF") >> head) || head != "OFF")
    lines.fail("expected OFF; only the text kind of the Object File Format with x, y, z for every point is read");
  auto counts = lines.need("the numbers of points and facets");
  const long points = lines.count(counts, "points"), facets = lines.count(counts, "facets");
  FacetSoup soup;
  for (long i = 1; i <= points; ++i) {
    const auto which = "point " + std::to_string(i) + " of " + std::to_string(points);
    auto line = lines.need(which);
    auto& p = soup.points.emplace_back();
    if (!(line >> p.x >> p.y >> p.z)) lines.fail("expected " + which + ", three coordinates");
  }
  for (long f = 1; f <= facets; ++f) {
    const auto which = "facet " + std::to_string(f) + " of " + std::to_string(facets);
    auto line = lines.need(which);
    auto& corners = soup.facets.emplace_back(lines.count(line, "corners of " + which));
    for (long& corner : corners)
      if (!(line >> corner)) lines.fail("expected " + which + ", the numbers of its corners, from 0");
  }
  return soup;
}

/// What CGAL would reserve memory for.
void check_header_of_ply(const std::string& path, const Where& where) {
  Lines lines(path, where);
  std::istringstream line;
  for (std::string word, type; lines.next(line) && line >> word && word != "end_header";) {
    if (word == "element" && line >> type) lines.count(line, "things of the kind '" + type + "'");
    if (word == "property" && line >> type && type == "list" && line >> type &&
        type.find("char") == std::string::npos && type.find("int8") == std::string::npos)
      lines.fail("lists must count their entries by one byte, as in 'property list uchar int vertex_indices'");
  }
}

/// The corner from which a fan of triangles covers a polygon; -1 if there is none.
int fan_start(const std::vector<Vec3<double>>& corners) {
  const int n = static_cast<int>(corners.size());
  Vec3<double> normal;
  for (int i = 1; i + 1 < n; ++i) normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  for (int start = 0; start < n; ++start) {
    bool covers = true;
    for (int i = 1; i + 1 < n; ++i) {
      const auto &a = corners[start], &b = corners[(start + i) % n], &c = corners[(start + i + 1) % n];
      covers = covers && dot(cross(b - a, c - a), normal) > 0;
    }
    if (covers) return start;
  }
  return -1;
}

}  // namespace

FacetSurface read_facets(const std::string& path, const Where& where) {
  const auto kind = std::filesystem::path(path).extension();
  if (kind == ".ply") check_header_of_ply(path, where);
  const auto soup = kind == ".off" ? read_off(path, where) : read_facet_soup(path);
  if (soup.facets.empty())
    throw DeckError(where, path + ": no facets can be read; is the file whole, and of the kind that its name says? " +
                               "Valid: .stl, .off, .obj, .ply");
  FacetSurface surface;
  std::map<std::array<double, 3>, int> known;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    const auto facet = path + ": facet " + std::to_string(f + 1);
    std::vector<int> nodes;
    std::vector<Vec3<double>> corners;
    for (const long corner : soup.facets[f]) {
      if (corner < 0 || corner >= static_cast<long>(soup.points.size()))
        throw DeckError(where, facet + " has a corner that the file does not give; it gives " +
                                   std::to_string(soup.points.size()) + " points");
      const auto& p = soup.points[corner];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw DeckError(where, facet + " has a corner that is no finite place, " + place_text(p));
      const auto [at, fresh] = known.try_emplace({p.x, p.y, p.z}, static_cast<int>(surface.points.size()));
      if (fresh) surface.points.push_back(p);
      nodes.push_back(at->second);
      corners.push_back(p);
    }
    const int n = static_cast<int>(nodes.size()), start = n > 3 ? fan_start(corners) : n < 3 ? -1 : 0;
    if (start < 0)
      throw DeckError(where, facet + " with " + std::to_string(n) + " corners" +
                                 (n ? ", the first at " + place_text(corners[0]) + "," : "") +
                                 " cannot be cut into triangles from one corner; give it as triangles");
    for (int i = 1; i + 1 < n; ++i) {
      surface.triangles.push_back({nodes[start], nodes[(start + i) % n], nodes[(start + i + 1) % n]});
      surface.facets.push_back(static_cast<int>(f) + 1);
    }
  }
  return surface;
}

}  // namespace ashlar
