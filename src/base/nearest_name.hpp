#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ashlar {

/// Edit distance: inserted, left out, replaced and swapped neighbouring letters count one each.
inline int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// The valid name that was probably meant: at most 1 + length / 5 edits away, the first of the nearest; "" if none is.
inline std::string nearest_name(std::string_view name, std::span<const std::string> valid) {
  int best = 1 + static_cast<int>(name.size()) / 5;
  std::string nearest;
  for (const auto& candidate : valid) {
    // A letter or two must not be "corrected" into something else altogether.
    const int distance = edit_distance(name, candidate);
    if (distance < static_cast<int>(candidate.size()) && (nearest.empty() ? distance <= best : distance < best)) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

/// The end of a message about a wrong name: ": did you mean 'dam'?", or else "; valid: dam, rock".
inline std::string suggest_name(std::string_view name, std::span<const std::string> valid) {
  const auto nearest = nearest_name(name, valid);
  if (!nearest.empty()) return ": did you mean '" + nearest + "'?";
  if (valid.empty()) return "; there are none";
  std::string list;
  for (const auto& candidate : valid) list += (list.empty() ? "" : ", ") + candidate;
  return "; valid: " + list;
}

}  // namespace ashlar
