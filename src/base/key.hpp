#pragma once
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Keys: the one description of a number that a deck gives. It drives reading, range checks, units, documentation and
/// the echo in result files.
namespace ashlar {

/// Exponents of metre, kilogram, second and kelvin.
struct Dimension {
  int m = 0, kg = 0, s = 0, K = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension temperature{0, 0, 0, 1};
inline constexpr Dimension pressure{-1, 1, -2, 0};              // Pa
inline constexpr Dimension density{-3, 1, 0, 0};                // kg/m^3
inline constexpr Dimension velocity{1, 0, -1, 0};               // m/s
inline constexpr Dimension acceleration{1, 0, -2, 0};           // m/s^2
inline constexpr Dimension frequency{0, 0, -1, 0};              // 1/s
inline constexpr Dimension energy{2, 1, -2, 0};                 // J
inline constexpr Dimension force{1, 1, -2, 0};                  // N
inline constexpr Dimension stiffness_per_area{-2, 1, -2, 0};    // Pa/m; N/m^3
inline constexpr Dimension fracture_energy{0, 1, -2, 0};        // J/m^2
inline constexpr Dimension conductivity{1, 1, -3, -1};          // W/(m K)
inline constexpr Dimension film{0, 1, -3, -1};                  // W/(m^2 K)
inline constexpr Dimension heat_flux{0, 1, -3, 0};              // W/m^2
inline constexpr Dimension heat_source{-1, 1, -3, 0};           // W/m^3
inline constexpr Dimension heat_capacity{2, 0, -2, -1};         // J/(kg K)
inline constexpr Dimension expansion{0, 0, 0, -1};              // 1/K
}  // namespace dimension

/// Closed range; `open_low` excludes the lower end.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = false;
  bool contains(double v) const { return (open_low ? v > low : v >= low) && v <= high; }
};
namespace range {
inline constexpr Range any{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0.0, std::numeric_limits<double>::infinity(), false};
}  // namespace range

/// Default of a key that may be left out and then has no value.
inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
inline bool given(double value) { return value == value; }

/// One number of a law: its name in decks, member, dimension, range, default (none: required) and what it means.
/// A choice among words is the number of the word.
template <class Law>
struct LawKey {
  const char* name;
  double Law::* member;
  Dimension dimension;
  Range range;
  std::optional<double> fallback;
  const char* doc;
  std::span<const char* const> choices{};
};

/// The same without the member: what the deck schema sees.
struct Key {
  std::string name;
  Dimension dimension;
  Range range;
  std::optional<double> fallback;
  std::string doc;
  std::vector<std::string> choices;
};

/// What is wrong with the numbers of a law together; `key` may be empty.
struct LawComplaint {
  std::string key, message;
};

/// A law as the deck sees it.
struct LawDoc {
  std::string name;
  std::string doc;
  std::vector<Key> keys;
};

template <class Law>
LawDoc law_doc() {
  LawDoc d{Law::name, Law::doc, {}};
  for (const auto& k : Law::keys)
    d.keys.push_back({k.name, k.dimension, k.range, k.fallback, k.doc, {k.choices.begin(), k.choices.end()}});
  return d;
}

}  // namespace ashlar
