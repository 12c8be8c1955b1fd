#pragma once
#include <vector>

#include "model/mesh.hpp"
#include "model/model.hpp"

/// Faces of regions that were meshed apart: which of them a joint brings together (numerics 5, partial overlaps).
namespace ashlar {

/// What two facets share, seen along the mean of their normals.
struct Overlap {
  std::vector<Vec3<double>> polygon;  ///< m, convex, counter-clockwise about the normal
  Vec3<double> normal;                ///< unit, from a to b
  double area = 0;                    ///< m^2
  double gap = 0;                     ///< m, in its middle; negative: the facets overlap
};

/// Two free faces of the regions of a joint that lie on each other.
struct FacingFaces {
  Facet a, b;              ///< a.element < b.element
  int interface = -1;      ///< index into Model::interfaces
  bool identical = false;  ///< corner on corner: joined by node pairs like faces that share their nodes
  Overlap overlap;
};

/// A free face with more than half of its area joined.
struct CoveredFace {
  Facet facet;
  int interface = -1;  ///< index into Model::interfaces
};

/// A free face of which less than 99.9 % is joined, although the other region lies near.
struct UnmatchedFace {
  Facet facet;
  double free = 0;  ///< m^2, that is not joined
  double gap = 0;   ///< m, to the nearest face beyond the tolerance; 0 where a part is joined
};

/// How the faces of one joint found each other.
struct JointMatch {
  long joined = 0;                              ///< pairs of faces meshed apart
  double largest_gap = 0, largest_overlap = 0;  ///< m, between facets that are joined
  std::vector<UnmatchedFace> unmatched;         ///< covered in part, or beyond the tolerance
  long partly_covered = 0;                      ///< faces with less than 99.9 % of their area joined
  long too_far = 0;                             ///< faces that look at each other beyond the tolerance, not joined
  double outer_joined = 0;                      ///< m^2, joined parts of faces that are outer ones all the same
  double inner_free = 0;                        ///< m^2, free parts of faces that are outer ones no more
  double too_far_by = 0;                        ///< m, the smallest of their distances; negative: they overlap
};

struct Facing {
  std::vector<FacingFaces> faces;    ///< sorted by a, then b
  std::vector<JointMatch> matches;   ///< [interfaces]; joints only
  std::vector<CoveredFace> covered;  ///< sorted by facet
};

/// Looks at the free faces of both regions of every joint. Facets are joined that look against each other within 18
/// degrees and lie within the joint's tolerance of each other, by default a millionth of the model's size.
/// @param graph of model.mesh
Facing find_facing(const Model& model, const FaceGraph& graph);

/// Which of the corner nodes `others` lies on `node`, a corner of an identical facet.
int corner_on_corner(const Mesh& mesh, int node, const std::vector<int>& others);

}  // namespace ashlar
