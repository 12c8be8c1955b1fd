#include "model/element_measures.hpp"

#include <gtest/gtest.h>

#include "model/model.hpp"

namespace ashlar {
namespace {

/// In a grid of bricks every crack along the grid is spread over one cell, whatever the cells are divided into.
TEST(lengths_across, are_those_of_the_cell_in_hex8_wedge6_and_tet4) {
  for (const Shape shape : {Shape::hex8, Shape::wedge6, Shape::tet4}) {
    Model model;
    Box box;
    box.name = "body";
    box.to = {2, 6, 1.5};
    box.cells = {4, 3, 2};
    box.shape = shape;
    model.boxes = {box};
    build_mesh(model);
    for (int e = 0; e < model.mesh.element_count(); ++e) {
      const Vec3<double> lengths = lengths_across(model.mesh, e);
      EXPECT_NEAR(lengths.x, 0.5, 1e-12);
      EXPECT_NEAR(lengths.y, 2, 1e-12);
      EXPECT_NEAR(lengths.z, 0.75, 1e-12);
    }
  }
}

}  // namespace
}  // namespace ashlar
