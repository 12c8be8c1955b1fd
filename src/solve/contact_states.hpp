#pragma once
#include <vector>

#include "solve/observer.hpp"
#include "solve/problem.hpp"

/// Contact points as they are at a moment, read back from the machine.
namespace ashlar {

/// One contact point; gap and traction split along its normal, tension and opening positive.
struct ContactPoint {
  Split<double> gap;       ///< m, u_b - u_a
  Split<double> traction;  ///< Pa, on side a
  Vec3<double> slip;       ///< m
  Vec3<double> rubbing;    ///< Pa, the part of the shear traction that slip has a share in
  double damage = 0;       ///< broken share
  ContactState state = ContactState::intact;  ///< with the present damage of what softens
  bool bonded = false;  ///< carries tension
  bool closed = false;  ///< pressed together, in its initial stress too
  /// Whether the sides hold each other: bonded, or pressed together.
  bool joined() const { return bonded || closed; }
};

/// Reads contact points in their order.
class ContactReader {
 public:
  explicit ContactReader(const Problem& problem);
  std::vector<ContactPoint> read() const;  ///< [contact points]
  /// Law of a contact point.
  const SpringLaw<double>& law(int contact) const { return laws_[problem_.contacts.interface[contact]]; }

 private:
  const Problem& problem_;
  std::vector<SpringLaw<double>> laws_;  ///< [interfaces]
};

/// [contact points] shares of the present state through which joints that resist heat are open; empty: none resists.
std::vector<double> open_to_heat(const Problem& problem);

/// Opening, slip, tractions and state of a snapshot; `opening`: ContactPoints::opening.
void fill_contact_fields(const std::vector<ContactPoint>& points, const std::vector<double>& opening,
                         Snapshot& snapshot);

}  // namespace ashlar
