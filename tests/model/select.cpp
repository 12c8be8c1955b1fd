#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "model/mesh_tools.hpp"
#include "model/select_surface.hpp"

namespace ashlar {
namespace {

using namespace testing_meshes;

SurfaceChoice choice(const std::string& name, std::vector<std::string> of) {
  SurfaceChoice c;
  c.name = name;
  c.where = {"dam.lua", 20};
  c.of = std::move(of);
  return c;
}
SurfaceChoice side_of(const std::string& name, std::vector<std::string> of, std::vector<std::string> side) {
  auto c = choice(name, std::move(of));
  c.side = std::move(side);
  return c;
}
SurfaceChoice facing(const std::string& name, std::vector<std::string> of, Vec3<double> direction, double within = 30) {
  auto c = choice(name, std::move(of));
  c.facing = direction;
  c.within = within * std::numbers::pi / 180;
  return c;
}

std::string refusal(Model model, SurfaceChoice c) {
  model.surfaces = {std::move(c)};
  return complaint([&] { build_mesh(model); });
}

TEST(select, surfaces_of_the_deck_page_have_the_areas_of_the_dam) {
  const double H = 160, base = 120, crest = 14, y = 20;
  Model model;
  model.extrudes = {
      extrude("dam", {{0, 0}, {base, 0}, {crest, H * 0.92}, {crest, H}, {0, H}}, y, 4),
      extrude("rock", {{-2 * H, -1.5 * H}, {base + 2 * H, -1.5 * H}, {base + 2 * H, 0}, {-2 * H, 0}}, y, 12)};
  model.surfaces = {facing("upstream", {"dam"}, {-1, 0, 0}), facing("downstream", {"dam"}, {1, 0, 0.5}, 60),
                    side_of("bottom", {"rock"}, {"bottom"}), side_of("far_field", {"rock"}, {"left", "right"}),
                    side_of("end", {"dam", "rock"}, {"front"})};
  build_mesh(model);
  const auto& mesh = model.mesh;
  EXPECT_NEAR(area(mesh, "upstream"), H * y, 1e-8);
  EXPECT_NEAR(area(mesh, "downstream"), (std::hypot(base - crest, 0.92 * H) + 0.08 * H) * y, 1e-8);
  EXPECT_NEAR(area(mesh, "bottom"), (base + 4 * H) * y, 1e-8);
  EXPECT_NEAR(area(mesh, "far_field"), 2 * 1.5 * H * y, 1e-8);
  const double dam_section = crest * H + 0.5 * (base - crest) * 0.92 * H;
  EXPECT_NEAR(area(mesh, "end"), dam_section + (base + 4 * H) * 1.5 * H, 1e-6);
  // The sides made without being asked: the ground beside the dam is the rock's top.
  EXPECT_NEAR(area(mesh, "rock.top"), 4 * H * y, 1e-8);
  EXPECT_NEAR(area(mesh, "dam.top"), crest * y, 1e-8);
}

TEST(select, the_ground_on_one_side_of_the_dam_by_box_and_by_plane) {
  auto model = dam_on_rock();
  auto ground = side_of("upstream ground", {"rock"}, {"top"});
  ground.box = {{{-60, 0, -1}, {0, 12, 1}}};
  auto level = choice("level", {"rock"});
  level.plane = {{{0, 0, 0}, {0, 0, 2}}};
  model.surfaces = {ground, level};
  build_mesh(model);
  EXPECT_NEAR(area(model.mesh, "upstream ground"), 60 * 12, 1e-9);
  EXPECT_NEAR(area(model.mesh, "level"), 120 * 12, 1e-9);
  for (const auto& f : model.mesh.find_surface("level")->facets) EXPECT_GT(model.mesh.facet_area(f).z, 0);
}

/// A block of 3 x 1 x 3 cells without its middle: a gallery along y.
Model gallery() {
  Model model;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (i != 1 || k != 1)
        model.boxes.push_back({"cell" + std::to_string(i) + std::to_string(k),
                               {},
                               {double(i), 0, double(k)},
                               {i + 1., 1, k + 1.},
                               {2, 2, 2},
                               Shape::hex8});
  return model;
}

TEST(select, walls_of_a_gallery_are_no_sides_but_face_their_direction) {
  auto model = gallery();
  std::vector<std::string> all;
  for (const auto& box : model.boxes) all.push_back(box.name);
  model.surfaces = {side_of("left", all, {"left"}), facing("towards left", all, {-1, 0, 0})};
  build_mesh(model);
  EXPECT_NEAR(area(model.mesh, "left"), 3, 1e-12);
  EXPECT_NEAR(area(model.mesh, "towards left"), 4, 1e-12);
}

TEST(select, a_stepped_face_is_one_side) {
  Model model;
  for (int k = 0; k < 3; ++k)
    model.boxes.push_back(
        {"lift" + std::to_string(k), {}, {0, 0, double(k)}, {3. - k, 1, k + 1.}, {3 - k, 1, 1}, Shape::hex8});
  model.surfaces = {side_of("downstream", {"lift0", "lift1", "lift2"}, {"right"})};
  build_mesh(model);
  EXPECT_NEAR(area(model.mesh, "downstream"), 3, 1e-12);
}

TEST(select, a_battered_face_is_a_side_up_to_thirty_degrees) {
  const auto front_area = [](double run) {
    Model model;
    model.extrudes = {extrude("dam", {{-run, 0}, {20, 0}, {20, 30}, {0, 30}}, 1, 5)};
    build_mesh(model);
    return area(model.mesh, "dam.left");
  };
  EXPECT_NEAR(front_area(30 * std::tan(29 * std::numbers::pi / 180)), 30 / std::cos(29 * std::numbers::pi / 180), 1e-9);
  EXPECT_EQ(front_area(30 * std::tan(31 * std::numbers::pi / 180)), 0);
}

/// The dam as if a file had given it, with groups.
Model imported_dam() {
  auto source = dam_on_rock();
  build_mesh(source);
  Model model;
  auto& import = model.imports.emplace_back();
  import.where = {"dam.lua", 2};
  import.file = "dam.msh";
  import.mesh = source.mesh;
  auto& mesh = import.mesh;
  const auto end = std::partition(mesh.surfaces.begin(), mesh.surfaces.end(),
                                  [](const Surface& s) { return s.name == "dam.left" || s.name == "rock.bottom"; });
  mesh.surfaces.erase(end, mesh.surfaces.end());
  return model;
}

TEST(select, groups_of_a_file_are_surfaces_and_can_be_narrowed) {
  auto model = imported_dam();
  auto wet = choice("wet", {});
  wet.group = {"dam.left"};
  wet.box = {{{-1, 0, 0}, {1, 12, 50}}};
  auto both = choice("both", {"dam"});
  both.group = {"rock.bottom", "dam.left", "dam.left"};
  model.surfaces = {wet, both};
  build_mesh(model);
  EXPECT_NEAR(area(model.mesh, "rock.bottom"), 168 * 12, 1e-9);
  EXPECT_NEAR(area(model.mesh, "wet"), 50 * 12, 1e-9);
  EXPECT_NEAR(area(model.mesh, "both"), 60 * 12, 1e-9);
}

TEST(select, a_box_joins_an_imported_mesh_where_their_nodes_coincide) {
  auto model = imported_dam();
  model.boxes = {{"parapet", {}, {0, 0, 60}, {8, 12, 61}, {6, 2, 1}, Shape::hex8}};
  build_mesh(model);
  EXPECT_EQ(model.mesh.find_surface("parapet.bottom"), nullptr);
  EXPECT_NEAR(measure_quality(model.mesh).volume, 12 * (1480 + 168 * 60 + 8), 1e-7);
}

// ---------------------------------------------------------------- wrong input

TEST(select, unknown_names_get_a_suggestion) {
  EXPECT_SAYS(refusal(dam_on_rock(), side_of("base", {"rok"}, {"bottom"})),
              "dam.lua:20: surface 'base': there is no region 'rok': did you mean 'rock'?");
  EXPECT_SAYS(refusal(dam_on_rock(), side_of("base", {"abutment"}, {"bottom"})),
              "there is no region 'abutment'; valid: dam, rock");
  EXPECT_SAYS(refusal(dam_on_rock(), side_of("base", {"rock"}, {"botom"})),
              "there is no side 'botom': did you mean 'bottom'?");
  auto c = choice("wet", {});
  c.group = {"dam.lef"};
  EXPECT_SAYS(refusal(imported_dam(), c), "no surface group 'dam.lef': did you mean 'dam.left'?");
}

TEST(select, an_empty_side_names_the_sides_that_exist) {
  Model model;
  model.extrudes = {extrude("wedge", {{0, 0}, {40, 0}, {21, 30}, {19, 30}}, 1, 5)};
  EXPECT_SAYS(refusal(model, side_of("wet", {"wedge"}, {"left"})), "surface 'wet' selects nothing: none of the");
  EXPECT_SAYS(refusal(model, side_of("wet", {"wedge"}, {"left"})), "it has front, back, bottom, top");
}

TEST(select, an_empty_side_says_that_faces_lie_inside_the_model) {
  EXPECT_SAYS(refusal(dam_on_rock(), side_of("base", {"dam"}, {"bottom"})),
              "faces that fit lie inside the model, against 'rock'");
}

TEST(select, an_empty_direction_says_what_came_nearest) {
  // Downstream slope: normal (50, 0, 40) / 64.03, that is atan(40/50) = 38.66 degrees above +x.
  const auto text = refusal(dam_on_rock(), facing("slope", {"dam"}, {1, 0, 5}, 10));
  EXPECT_SAYS(text, "faces (1, 0, 5) within 10 degrees; the nearest faces (0, 0, 1), 11.3099 degrees off, at (");
  EXPECT_SAYS(refusal(dam_on_rock(), facing("slope", {"dam"}, {0, 0, 0})), "'facing' needs a direction");
}

TEST(select, an_empty_box_or_plane_says_how_far_the_nearest_is) {
  auto c = choice("part", {"rock"});
  c.box = {{{-100, 0, -60}, {-65, 12, 0}}};
  EXPECT_SAYS(refusal(dam_on_rock(), c), "the nearest centre is 5 m outside, at (-60, ");
  c.box = {{{1, 0, 0}, {0, 1, 1}}};
  EXPECT_SAYS(refusal(dam_on_rock(), c), "'box' goes from its low corner to its high one");
  c.box.reset();
  c.plane = {{{0, 0, -60.5}, {0, 0, 1}}};
  EXPECT_SAYS(refusal(dam_on_rock(), c), "the nearest reaches 0.5 m off it");
}

TEST(select, a_name_that_exists_is_refused_and_all_wrong_surfaces_are_reported) {
  auto model = imported_dam();
  model.surfaces = {side_of("rock.bottom", {"rock"}, {"bottom"}), side_of("x", {"nowhere"}, {"bottom"})};
  const auto text = complaint([&] { build_mesh(model); });
  EXPECT_SAYS(text, "there is a surface of this name already");
  EXPECT_SAYS(text, "there is no region 'nowhere'");
}

}  // namespace
}  // namespace ashlar
