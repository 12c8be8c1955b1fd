#pragma once
#include <cmath>
#include <cstdio>
#include <string>

#include "physics/laws/cone.hpp"

/// Complaints that several laws share.
namespace ashlar {

/// "'a' = 2 MPa is above b = 1 MPa", values given in that unit.
inline std::string above(const char* key, double value, const char* other, double limit, const char* unit) {
  char text[160];
  std::snprintf(text, sizeof text, "'%s' = %.6g%s is above %s = %.6g%s", key, value, unit, other, limit, unit);
  return text;
}

inline std::string dilation_above(double dilation, double friction) {
  constexpr double degrees = 57.295779513082320877;
  return above("dilation", degrees * dilation, "friction", degrees * friction, " deg") +
         ": flow would make energy; give at most the friction angle";
}

/// Complains of a tensile strength beyond the tip of the Mohr-Coulomb pyramid.
inline void check_tip(double tensile_strength, double cohesion, double friction, std::vector<LawComplaint>& found) {
  const double tip = cohesion / std::tan(friction);
  if (tensile_strength > tip)
    found.push_back(
        {"tensile_strength", above("tensile_strength", tensile_strength, "cohesion / tan(friction)", tip, " Pa") +
                                 ", where shear strength ends; lower it"});
}

/// Softening faster than the elastic spring of the point itself has no static answer.
inline void check_softening(const ConePoint<double>& p, double hardening, std::vector<LawComplaint>& found) {
  const double resistance = p.part.shear + p.slope * p.trace_per_flow;
  if (p.hardening <= -resistance) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "'hardening' = %.6g Pa softens faster than the material unloads; it must be above %.6g Pa", hardening,
                  -resistance * hardening / p.hardening);
    found.push_back({"hardening", text});
  }
}

}  // namespace ashlar
