#pragma once
#include <string>

#include "base/tensor.hpp"

/// Numbers as people read them.
namespace ashlar {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// "850 ms", "12.3 s", "04:10", "2:15:00".
std::string duration_text(double seconds);

/// Time in a model: "850 us", "12.3 s", "1.5 h", "30 days".
std::string time_text(double seconds);

/// "312", "12 480", "2 500 000": thin groups of three.
std::string count_text(long count);

/// "1 stage", "3 stages".
std::string counted(long count, const std::string& word);

/// "(8, 6, 0) m".
std::string place_in_metres(const Vec3<double>& place);

/// Force or mass with a decimal prefix: "3.563 GN", "418.1 MN", "42 624 t" for masses.
std::string force_text(double newton);
std::string mass_text(double kilogram);

}  // namespace ashlar
