#pragma once
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "io/result_reader.hpp"

/// Two runs of one mesh, value by value (the paper's Table 3).
namespace ashlar {

/// How far a field of one run is from the same of another, over all outputs of a stage. The difference at a node or
/// element is the root of the sum of the squares of its components' differences; relative: over the largest such value
/// of the field in the second run, all stages.
struct FieldDifference {
  std::string field, unit;
  double largest = 0;             ///< in the field's unit
  double largest_relative = 0;    ///< infinite where only one run has a value, or the second is zero everywhere
  double mean_relative = 0;       ///< over nodes or elements, and outputs
  bool on_points = true;
  std::size_t index = 0;          ///< node or element of the largest, counted from 0 as in ParaView
  Vec3<double> place;             ///< m
};
struct StageDifference {
  std::string stage;
  std::vector<FieldDifference> fields;
};
struct Comparison {
  std::vector<StageDifference> stages;  ///< those that both have
  std::vector<std::string> missing;     ///< outputs and fields that one of them lacks, a line each
  double largest_relative() const;
};
/// Throws DeckError: the meshes differ.
Comparison compare_results(ResultReader& a, ResultReader& b);

/// Values along a straight line at the end of a stage, interpolated inside elements; element fields as they are there.
struct LineSample {
  double along = 0;  ///< m from the line's start
  Vec3<double> place;
  bool inside = false;
  double a = 0, b = 0;
  double relative = 0;  ///< |a - b| over the largest |b| of the line
};
struct LineComparison {
  std::string name, unit;  ///< "displacement.x"
  std::vector<LineSample> samples;
};
/// One table a component of the fields on `b`'s mesh whose name is `of`; all, if it is empty.
std::vector<LineComparison> compare_along(ResultReader& a, ResultReader& b, const std::string& stage,
                                          const Vec3<double>& from, const Vec3<double>& to, const std::string& of);

}  // namespace ashlar
