#pragma once
#include <limits>
#include <vector>

#include "model/mesher/section_graph.hpp"

namespace ashlar {

/// A place where elements are to be of a size, m.
struct SizeAt {
  PlanePoint place;
  double size;
};

/// Element sizes over a plane: at most `largest`, at most the size at each given place, and growing away from there by
/// `slope` metres per metre: by the factor 1 + slope from one element to the next.
class SizeField {
 public:
  SizeField(std::vector<SizeAt> places, double slope, double largest);
  double at(const PlanePoint& p) const;

 private:
  /// The places of a range, halved at its middle: the middle one is the node, both halves are its children.
  struct Bounds {
    PlanePoint low, high;
    double smallest;
  };
  Bounds build(std::size_t from, std::size_t to, int axis);
  void search(std::size_t from, std::size_t to, const PlanePoint& p, double& best) const;

  std::vector<SizeAt> places_;
  std::vector<Bounds> bounds_;  ///< [places] of the range whose middle this place is
  double slope_, largest_;
};

}  // namespace ashlar
