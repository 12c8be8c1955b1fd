#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "model/check_mesh.hpp"
#include "model/model.hpp"

/// What tests of meshes share.
namespace ashlar::testing_meshes {

inline double region_volume(const Mesh& mesh, const std::string& region) {
  double volume = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.region_names[mesh.regions[e]] == region) volume += element_volume(mesh, e);
  return volume;
}

inline double all_volume(const Mesh& mesh) { return measure_quality(mesh).volume; }

/// Area of facets, m^2.
inline double area(const Mesh& mesh, const std::vector<Facet>& facets) {
  double sum = 0;
  for (const auto& f : facets) sum += norm(mesh.facet_area(f));
  return sum;
}
inline double area(const Mesh& mesh, const std::string& surface) {
  const auto* found = mesh.find_surface(surface);
  return found ? area(mesh, found->facets) : 0;
}

/// Every line of the error that `action` throws; fails if it throws none.
template <class Action>
std::string complaint(Action action) {
  try {
    action();
  } catch (const DeckError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no DeckError";
  return "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

inline Extrude extrude(const std::string& name, std::vector<std::array<double, 2>> section, double length, double size,
                       int line = 1) {
  Extrude e;
  e.name = name;
  e.where = {"dam.lua", line};
  e.section = std::move(section);
  e.length = length;
  e.size = size;
  return e;
}

/// D0 of the reference cases (section 6): dam 60 m high on 168 m x 60 m of rock, 12 m thick.
inline Model dam_on_rock(Shape shape = Shape::hex8) {
  Model model;
  model.extrudes = {extrude("dam", {{0, 0}, {48, 0}, {8, 50}, {8, 60}, {0, 60}}, 12, 8, 3),
                    extrude("rock", {{-60, -60}, {108, -60}, {108, 0}, {-60, 0}}, 12, 10, 4)};
  for (auto& e : model.extrudes) {
    e.shape = shape;
    e.layers = 2;
  }
  return model;
}

}  // namespace ashlar::testing_meshes
