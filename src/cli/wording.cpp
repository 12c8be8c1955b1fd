#include "cli/wording.hpp"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace ashlar {

std::string text(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string result(std::vsnprintf(nullptr, 0, format, arguments), '\0');
  std::vsnprintf(result.data(), result.size() + 1, format, again);
  va_end(arguments);
  va_end(again);
  return result;
}

std::string duration_text(double seconds) {
  if (seconds < 1) return text("%.0f ms", seconds * 1000);
  if (seconds < 60) return text("%.1f s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return text("%02ld:%02ld", whole / 60, whole % 60);
  return text("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string time_text(double seconds) {
  if (seconds < 1e-3) return text("%.3g us", 1e6 * seconds);
  if (seconds < 1) return text("%.3g ms", 1e3 * seconds);
  if (seconds < 3600) return text("%.3g s", seconds);
  return seconds < 86400 ? text("%.3g h", seconds / 3600) : text("%.3g days", seconds / 86400);
}

std::string count_text(long count) {
  const std::string digits = std::to_string(count);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t left = digits.size() - i;
    if (i > 0 && left % 3 == 0 && digits[i - 1] != '-') grouped += ' ';
    grouped += digits[i];
  }
  return grouped;
}

std::string counted(long count, const std::string& word) {
  return count_text(count) + " " + word + (count == 1 ? "" : "s");
}

std::string place_in_metres(const Vec3<double>& place) {
  const auto tidy = [](double v) {
    return std::round(v * 1000) / 1000 + 0.0;
  };  // no "-0", no digits below a millimetre
  return text("(%g, %g, %g) m", tidy(place.x), tidy(place.y), tidy(place.z));
}

std::string force_text(double newton) {
  const double size = std::abs(newton);
  if (size >= 1e9) return text("%.4g GN", newton / 1e9);
  if (size >= 1e6) return text("%.4g MN", newton / 1e6);
  if (size >= 1e3) return text("%.4g kN", newton / 1e3);
  return text("%.4g N", newton);
}

std::string mass_text(double kilogram) {
  return kilogram < 1e4 ? text("%.4g kg", kilogram) : count_text(std::lround(kilogram / 1000)) + " t";
}

}  // namespace ashlar
