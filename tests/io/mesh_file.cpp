#include "io/mesh_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

namespace ashlar {
namespace {

std::string data_file(const std::string& name) { return std::string(ASHLAR_TEST_DATA) + "/" + name; }

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A file in the temporary folder that goes away with the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text, const std::string& extension = ".msh") {
    path_ = (std::filesystem::temp_directory_path() / ("ashlar_mesh_" + std::to_string(getpid()) + extension)).string();
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

Mesh read_text(const std::string& text, const std::string& extension = ".msh") {
  const TemporaryFile file(text, extension);
  return read_mesh(file.path(), {"dam.lua", 3});
}

/// The complaint about a mesh file, without the path: "dam.lua:3: mesh:12: ...".
std::string complaint(const std::string& text, const std::string& extension = ".msh") {
  const TemporaryFile file(text, extension);
  try {
    read_mesh(file.path(), {"dam.lua", 3});
  } catch (const DeckError& error) {
    std::string message = error.what();
    const auto at = message.find(file.path());
    if (at != std::string::npos) message.replace(at, file.path().size(), "mesh");
    return message;
  }
  return "no complaint";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Two hex8 on each other, a facet below, one between them; 2.2. Node numbers have gaps.
const std::string two_cubes = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
3 1 "rock"
3 2 "dam"
2 5 "bottom"
$EndPhysicalNames
$Nodes
12
10 0 0 0
20 1 0 0
30 1 1 0
40 0 1 0
50 0 0 1
60 1 0 1
70 1 1 1
80 0 1 1
90 0 0 2
100 1 0 2
110 1 1 2
120 0 1 2
$EndNodes
$Elements
4
1 3 2 5 1 10 20 30 40
2 3 2 6 1 50 60 70 80
3 5 2 1 1 10 20 30 40 50 60 70 80
4 5 2 2 2 50 60 70 80 90 100 110 120
$EndElements
)";

/// Volume of one element by the divergence theorem: V = 1/3 sum of centroid . area over the faces (plane faces).
double volume(const Mesh& mesh, int e) {
  double sum = 0;
  for (int f = 0; f < face_count(mesh.shapes[e]); ++f)
    sum += dot(mesh.facet_centroid({e, f}), mesh.facet_area({e, f})) / 3;
  return sum;
}

double region_volume(const Mesh& mesh, const std::string& region) {
  double sum = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.region_names[mesh.regions[e]] == region) sum += volume(mesh, e);
  return sum;
}

Vec3<double> surface_area(const Mesh& mesh, const std::string& surface) {
  Vec3<double> sum;
  const Surface* found = mesh.find_surface(surface);
  if (!found) throw std::runtime_error("no surface " + surface);
  for (const Facet& f : found->facets) sum = sum + mesh.facet_area(f);
  return sum;
}

// A column of two unit cubes (regions) meshed by Gmsh and saved as 4.1.
class Column : public testing::TestWithParam<const char*> {};

TEST_P(Column, regions_fill_their_cubes_and_surfaces_have_their_areas) {
  const Mesh mesh = read_mesh(data_file(GetParam()), {});
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"dam body", "rock"}));  // by group number: 3, 7
  EXPECT_NEAR(region_volume(mesh, "rock"), 1, 1e-14);
  EXPECT_NEAR(region_volume(mesh, "dam body"), 1, 1e-14);
  for (int e = 0; e < mesh.element_count(); ++e) {
    EXPECT_GT(volume(mesh, e), 0);
    EXPECT_EQ(mesh.region_names[mesh.regions[e]], mesh.centroid(e).z < 1 ? "rock" : "dam body");
  }
  // Outward normals: down at the bottom; the contact is seen from the element that comes first, in the rock.
  EXPECT_NEAR(surface_area(mesh, "bottom").z, -1, 1e-14);
  EXPECT_NEAR(surface_area(mesh, "contact").z, 1, 1e-14);
  for (const Facet& f : mesh.find_surface("contact")->facets) EXPECT_LT(mesh.centroid(f.element).z, 1);
}
INSTANTIATE_TEST_SUITE_P(shapes, Column,
                         testing::Values("column_hex_41.msh", "column_wedge_41.msh", "column_tet_41.msh",
                                         "column_hex_22.msh", "column_hex_22_binary.msh", "column_hex_41_binary.msh",
                                         "column_wedge_41_binary.msh", "column_tet_41_binary.msh", "column_hex.inp",
                                         "column_wedge.inp", "column_tet.inp"));

TEST(MeshFile, facets_may_belong_to_several_surfaces_and_unnamed_groups_get_their_number) {
  const Mesh mesh = read_mesh(data_file("column_hex_41.msh"), {});
  ASSERT_NE(mesh.find_surface("surface_9"), nullptr);  // bottom and top
  EXPECT_EQ(mesh.find_surface("surface_9")->facets.size(),
            mesh.find_surface("bottom")->facets.size() + mesh.find_surface("top")->facets.size());
  EXPECT_NEAR(surface_area(mesh, "surface_9").z, 0, 1e-14);
}

TEST(MeshFile, nodes_of_geometry_points_are_left_out) {
  const Mesh mesh = read_mesh(data_file("column_hex_41.msh"), {});  // 46 nodes, one of them a lone point at (5, 5, 5)
  EXPECT_EQ(mesh.node_count(), 45);
  for (const auto& p : mesh.points) EXPECT_LE(p.x, 1);
}

TEST(MeshFile, both_versions_give_the_same_body) {
  const Mesh a = read_mesh(data_file("column_hex_41.msh"), {}), b = read_mesh(data_file("column_hex_22.msh"), {});
  EXPECT_EQ(a.node_count(), b.node_count());
  EXPECT_EQ(a.element_count(), b.element_count());
  EXPECT_EQ(a.surfaces.size(), b.surfaces.size());
  for (const auto& s : a.surfaces) EXPECT_EQ(s.facets.size(), b.find_surface(s.name)->facets.size());
}

/// Same nodes, elements, regions and surfaces, in the same order; coordinates to the last digit that the file has.
void expect_same(const Mesh& a, const Mesh& b, double tolerance) {
  ASSERT_EQ(a.node_count(), b.node_count());
  for (int n = 0; n < a.node_count(); ++n) {
    EXPECT_NEAR(a.points[n].x, b.points[n].x, tolerance);
    EXPECT_NEAR(a.points[n].y, b.points[n].y, tolerance);
    EXPECT_NEAR(a.points[n].z, b.points[n].z, tolerance);
  }
  EXPECT_EQ(a.shapes, b.shapes);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.region_names, b.region_names);
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
    EXPECT_EQ(a.surfaces[s].name, b.surfaces[s].name);
    EXPECT_EQ(a.surfaces[s].facets, b.surfaces[s].facets);
  }
}

TEST(MeshFile, binary_files_give_the_same_mesh) {
  for (const std::string name : {"column_hex_41", "column_wedge_41", "column_tet_41"}) {
    SCOPED_TRACE(name);
    expect_same(read_mesh(data_file(name + ".msh"), {}), read_mesh(data_file(name + "_binary.msh"), {}), 0);
  }
}

TEST(MeshFile, every_truncation_of_a_binary_file_gives_a_complaint) {
  for (const char* name : {"column_hex_22_binary.msh", "column_wedge_41_binary.msh"}) {
    const std::string column = text_of(data_file(name));
    for (std::size_t length = 0; length + 2 < column.size(); length += 11)
      EXPECT_NE(complaint(column.substr(0, length)), "no complaint") << name << " " << length;
    for (std::size_t i = 0; i < column.size(); i += 17)
      for (const char c : {'\x00', '\x7f', '\xff', '\x80', '$'}) {
        std::string damaged = column;
        damaged[i] = c;
        complaint(damaged);  // anything but DeckError ends the test program
      }
  }
}

TEST(MeshFile, complaints_about_binary_files_name_the_byte) {
  const std::string column = text_of(data_file("column_hex_41_binary.msh"));
  const auto nodes = column.find("$Nodes\n") + 7;
  std::string damaged = column;
  damaged.replace(nodes + 8, 8, std::string("\0\0\0\0\xff\0\0\0", 8));  // the number of nodes
  EXPECT_EQ(complaint(damaged), "dam.lua:3: mesh:byte " + std::to_string(nodes + 8) +
                                    ": expected the number of nodes, found " + std::to_string(255L << 32) +
                                    ", but the file has only " + std::to_string(column.size() - nodes - 16) +
                                    " bytes left: the count is wrong or the file is truncated");
}

TEST(MeshFile, public_dam_has_its_volumes_and_surfaces) {
  // Dam D0: section 8 x 60 + 40 x 50 / 2 = 1480 m^2, rock 168 x 60 m, slice 12 m; wetted face 55 m high.
  for (const char* name : {"dam_D0_r1_ny1.msh", "dam_D0_r2_ny4.msh"}) {
    const Mesh mesh = read_mesh(data_file(name), {});
    EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"rock", "concrete"}));
    EXPECT_EQ(mesh.surfaces.size(), 9u);
    EXPECT_NEAR(region_volume(mesh, "concrete"), 1480 * 12, 1e-8);
    EXPECT_NEAR(region_volume(mesh, "rock"), 168 * 60 * 12, 1e-7);
    EXPECT_NEAR(surface_area(mesh, "up_wet").x, -55 * 12, 1e-9);
    EXPECT_NEAR(surface_area(mesh, "bottom").z, -168 * 12, 1e-9);
    // Every outer face of the mesh together: a closed surface has no net area.
    Vec3<double> closed;
    for (const Facet& f : find_faces(mesh).outer) closed = closed + mesh.facet_area(f);
    EXPECT_NEAR(norm(closed), 0, 1e-8);
  }
}

TEST(MeshFile, inner_facet_belongs_to_the_first_element) {
  const Mesh mesh = read_text(two_cubes);
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"rock", "dam"}));
  ASSERT_NE(mesh.find_surface("surface_6"), nullptr);
  EXPECT_EQ(mesh.find_surface("surface_6")->facets[0].element, 0);
  EXPECT_EQ(mesh.source_ids, (std::vector<long>{3, 4}));
}

TEST(MeshFile, without_volume_groups_geometric_volumes_are_regions) {
  std::string text = replaced(two_cubes, "3 5 2 1 1", "3 5 2 0 14");
  text = replaced(text, "4 5 2 2 2", "4 5 2 0 15");
  EXPECT_EQ(read_text(text).region_names, (std::vector<std::string>{"region_14", "region_15"}));
}

TEST(MeshFile, windows_line_ends_and_unknown_sections_do_not_matter) {
  std::string text = replaced(two_cubes, "$Nodes", "$Comments\nnothing $Nodes\n$EndComments\n$Nodes");
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_text(windows).element_count(), 2);
}

TEST(MeshFile, complaints_name_the_line_and_what_was_expected) {
  const auto& cubes = two_cubes;
  EXPECT_EQ(complaint(cubes.substr(0, cubes.find("120 0 1 2"))),
            "dam.lua:3: mesh:23: expected a node number, but the file ends here: it is truncated "
            "(11 of the 12 nodes that the section announces were read)");
  EXPECT_EQ(complaint(cubes.substr(0, cubes.find("$Elements"))),
            "dam.lua:3: mesh: there is no section $Elements: the file is truncated");
  EXPECT_EQ(complaint(replaced(cubes, "60 1 0 1", "60 nan 0 1")),
            "dam.lua:3: mesh:17: expected a coordinate x, a finite number, found 'nan'");
  EXPECT_EQ(complaint(replaced(cubes, "60 1 0 1", "60 1 oops 1")),
            "dam.lua:3: mesh:17: expected a coordinate y, found 'oops' (5 of the 12 nodes that the section announces "
            "were read)");
  EXPECT_EQ(complaint(replaced(cubes, "60 70 80 90", "60 70 81 90")),
            "dam.lua:3: mesh:30: element 4 (hex8) uses node 81, which is not in $Nodes");
  EXPECT_EQ(complaint(replaced(cubes, "4 5 2 2 2", "4 5 2 0 2")),
            "dam.lua:3: mesh:30: hex8 element 4 (volume 2) is in no volume group, but the file has volume groups: put "
            "it into one");
  EXPECT_EQ(complaint(replaced(cubes, "50 60 70 80\n3", "50 60 70 110\n3")),
            "dam.lua:3: mesh:28: quad4 element 2 is not a face of any volume element");
  EXPECT_EQ(
      complaint(replaced(cubes, "2.2 0 8", "2.2 1 8")),
      "dam.lua:3: mesh:byte 20: the binary numbers have another order of bytes than this machine; save the mesh as "
      "ASCII ('Mesh.Binary = 0')");
  EXPECT_EQ(
      complaint(replaced(cubes, "2.2 0 8", "4 0 8")),
      "dam.lua:3: mesh:2: mesh file version '4' is not read; save it as version 4.1 or 2.2 ('gmsh -format msh41')");
  EXPECT_EQ(complaint(replaced(cubes, "$Nodes\n12", "$Nodes\n13")),
            "dam.lua:3: mesh:24: expected a node number, found '$EndNodes' "
            "(12 of the 13 nodes that the section announces were read)");
  EXPECT_EQ(complaint(replaced(cubes, "$Elements\n4", "$Elements\n3")),
            "dam.lua:3: mesh:30: expected $EndElements, found '4' (3 of the 3 elements that the section announces were "
            "read)");
  EXPECT_EQ(complaint(replaced(cubes, "120 0 1 2", "110 0 1 2")), "dam.lua:3: mesh: node 110 is given twice");
  EXPECT_EQ(complaint("solid cube"),
            "dam.lua:3: mesh:1: this is no Gmsh mesh file: expected '$MeshFormat' as its first word");
  EXPECT_EQ(complaint(""), "dam.lua:3: mesh:1: this is no Gmsh mesh file: expected '$MeshFormat' as its first word");
}

TEST(MeshFile, a_count_is_never_trusted_beyond_the_size_of_the_file) {
  EXPECT_NE(complaint(replaced(two_cubes, "$Nodes\n12", "$Nodes\n2000000000"))
                .find("mesh:11: expected the number of nodes, found 2000000000, but the file has only"),
            std::string::npos);
  EXPECT_EQ(complaint(replaced(two_cubes, "$Elements\n4", "$Elements\n99999999999999999999")),
            "dam.lua:3: mesh:26: the number '99999999999999999999' is too large");
  EXPECT_EQ(complaint(replaced(two_cubes, "$Elements\n4", "$Elements\n-4")),
            "dam.lua:3: mesh:26: expected the number of elements, found -4");
}

TEST(MeshFile, an_element_belongs_to_exactly_one_region) {
  std::string text = replaced(two_cubes, "$Elements\n4", "$Elements\n5");
  text = replaced(text, "$EndElements", "5 5 2 1 2 50 60 70 80 90 100 110 120\n$EndElements");
  EXPECT_EQ(complaint(text),
            "dam.lua:3: mesh:31: hex8 element 5 has the same nodes as element 4 (line 30): it is in two volume groups, "
            "'dam' and 'rock'; every element must be in exactly one");
  const std::string column = text_of(data_file("column_hex_41.msh"));
  const std::string volume_line = "1 0 0 0 1 1 1 1 7 6";
  EXPECT_NE(complaint(replaced(column, volume_line, "1 0 0 0 1 1 1 2 7 3 6"))
                .find("is in two volume groups, 'rock' and 'dam body'; every element must be in exactly one"),
            std::string::npos);
}

TEST(MeshFile, second_order_elements_and_pyramids_are_refused_by_name) {
  EXPECT_EQ(
      complaint(replaced(two_cubes, "3 5 2 1 1", "3 17 2 1 1")),
      "dam.lua:3: mesh:29: element type 17 (hex20) is of second order; only first-order elements are read: mesh again "
      "with 'Mesh.ElementOrder = 1'");
  EXPECT_NE(
      complaint(replaced(two_cubes, "3 5 2 1 1", "3 7 2 1 1")).find("type 7 (pyramid5) is not read; valid volume"),
      std::string::npos);
}

TEST(MeshFile, a_node_of_no_element_is_named) {
  std::string text = replaced(two_cubes, "$Nodes\n12\n", "$Nodes\n14\n7 9 9 9\n8 9 9 9\n");
  EXPECT_EQ(complaint(text),
            "dam.lua:3: mesh: 2 nodes belong to no element: 7, 8; remove them or save the elements that use them");
  text = replaced(replaced(text, "$Elements\n4\n", "$Elements\n5\n9 1 2 0 1 7 8\n"), "9 9 9", "9 9 8");
  EXPECT_EQ(read_text(text).node_count(), 12);
}

TEST(MeshFile, a_missing_file_is_a_deck_error) {
  try {
    read_mesh("no such.msh", {"dam.lua", 3});
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(), "dam.lua:3: there is no mesh file 'no such.msh'");
  }
  EXPECT_THROW(read_mesh("/", {}), DeckError);
}

TEST(MeshFile, every_truncation_and_every_damaged_byte_gives_a_complaint_or_a_mesh) {
  const std::string column = text_of(data_file("column_wedge_41.msh"));
  for (std::size_t length = 0; length + 2 < column.size(); length += 7)
    EXPECT_NE(complaint(column.substr(0, length)), "no complaint") << length;
  for (std::size_t i = 0; i < column.size(); i += 3)
    for (const char c : {'-', '9', ' ', '$'}) {
      std::string damaged = column;
      damaged[i] = c;
      complaint(damaged);  // anything but DeckError ends the test program
    }
}

TEST(MeshFile, abaqus_files_give_the_same_mesh) {
  for (const std::string shape : {"hex", "wedge", "tet"}) {
    SCOPED_TRACE(shape);
    expect_same(read_mesh(data_file("column_" + shape + "_41.msh"), {}),
                read_mesh(data_file("column_" + shape + ".inp"), {}), 1e-13);
  }
}

/// Two C3D8 on each other in the manner of CalculiX: sections, surfaces, sets by range and by name.
const std::string two_bricks = R"(** two bricks
*Heading
anything
*node, nset=Nall
10, 0, 0, 0
20, 1., 0, 0
30, 1.0D+00, 1, 0
40, 0, 1, 0
50, 0, 0, 1
60, 1, 0, 1
70, 1, 1, 1
80, 0, 1, 1
90, 0, 0, 2
100, 1, 0, 2
110, 1, 1, 2
120, 0, 1, 2
*Element, type=C3D8I,
 elset=Eall
3, 10, 20, 30, 40, 50,
60, 70, 80
4, 50, 60, 70, 80, 90, 100, 110, 120
*ELSET, ELSET=Rock, GENERATE
3, 3, 1
*ELSET, elset=dam
4
*ELSET, elset=both
rock, DAM
*NSET, NSET=Middle
50, 60, 70, 80
*NSET, NSET=Top, GENERATE
90, 120, 10
*SURFACE, NAME=Bottom, TYPE=ELEMENT
rock, S1
*SURFACE, NAME=Skin
both,
*SOLID SECTION, ELSET=ROCK, MATERIAL=m
*SOLID SECTION, ELSET=DAM, MATERIAL=m
1.,
*STEP
*STATIC
*END STEP
)";

TEST(AbaqusFile, sections_are_regions_and_sets_are_surfaces) {
  const Mesh mesh = read_text(two_bricks, ".inp");
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"Rock", "dam"}));
  EXPECT_EQ(mesh.regions, (std::vector<int>{0, 1}));
  EXPECT_EQ(surface_area(mesh, "Bottom").z, -1);
  EXPECT_EQ(surface_area(mesh, "Top").z, 1);
  EXPECT_EQ(surface_area(mesh, "Middle").z, 1);  // an inner face, seen from the rock
  for (const char* closed : {"Skin", "Nall"}) {
    EXPECT_EQ(mesh.find_surface(closed)->facets.size(), 10u);  // without the inner face
    EXPECT_EQ(norm(surface_area(mesh, closed)), 0);
  }
}

TEST(AbaqusFile, face_labels_mean_the_faces_of_the_manual) {
  const double z[] = {-1, 1, 0, 0, 0, 0}, y[] = {0, 0, -1, 0, 1, 0}, x[] = {0, 0, 0, 1, 0, -1};
  for (int s = 0; s < 6; ++s) {
    const Mesh mesh = read_text(replaced(two_bricks, "rock, S1", "rock, s" + std::to_string(s + 1)), ".inp");
    const auto area = surface_area(mesh, "Bottom");
    EXPECT_EQ(area.x, x[s]);
    EXPECT_EQ(area.y, y[s]);
    EXPECT_EQ(area.z, z[s]);
  }
}

TEST(AbaqusFile, without_sections_disjoint_sets_are_regions_and_else_those_of_the_elements) {
  std::string text = two_bricks.substr(0, two_bricks.find("*SOLID"));
  EXPECT_EQ(read_text(text, ".inp").region_names, (std::vector<std::string>{"Rock", "dam"}));
  text = replaced(text, "3, 3, 1", "3, 4, 1");
  EXPECT_EQ(read_text(replaced(text, "3, 4, 1", "3, 3, 1\n*ELSET, ELSET=low\n3"), ".inp").region_names,
            (std::vector<std::string>{"Eall"}));
  text = replaced(replaced(text, " elset=Eall\n", ""), "C3D8I,", "C3D8I");
  EXPECT_EQ(complaint(replaced(text, "3, 4, 1", "3, 3, 1\n*ELSET, ELSET=low\n3"), ".inp"),
            "dam.lua:3: mesh:18: hex8 element 3 is in two element sets, 'Rock' and 'low'; every element must be in "
            "exactly one: name those that are regions by *SOLID SECTION");
  EXPECT_EQ(read_text(text.substr(0, text.find("*ELSET")), ".inp").region_names,
            (std::vector<std::string>{"region_1"}));
}

TEST(AbaqusFile, complaints_name_the_line_and_the_remedy) {
  auto complain = [](const std::string& from, const std::string& to) {
    return complaint(replaced(two_bricks, from, to), ".inp");
  };
  EXPECT_EQ(
      complain("C3D8I", "C3D20R"),
      "dam.lua:3: mesh:17: element type C3D20R is of second order; only first-order elements are read: mesh again "
      "with C3D8, C3D6 or C3D4");
  EXPECT_EQ(
      complain("*Heading", "*PART, NAME=dam"),
      "dam.lua:3: mesh:2: *PART is not read; write a flat file (Abaqus/CAE: Model > Edit Attributes > 'Do not use "
      "parts and assemblies in input files')");
  EXPECT_EQ(complain("90, 100, 110, 120\n", "90, 100, 110, 121\n"),
            "dam.lua:3: mesh:21: element 4 (C3D8I) uses node 121, which *NODE does not give");
  EXPECT_EQ(complain("60, 70, 80\n", "60, 70\n"), "dam.lua:3: mesh:19: an element C3D8I has 8 nodes, found 16");
  EXPECT_EQ(complain("rock, S1", "rock, S7"), "dam.lua:3: mesh:33: a hex8 element has the faces S1 to S6, found 'S7'");
  EXPECT_EQ(complain("20, 1., 0, 0", "20, one, 0, 0"), "dam.lua:3: mesh:6: expected a coordinate x, found 'one'");
  EXPECT_EQ(complain("20, 1., 0, 0", "10, 1., 0, 0"), "dam.lua:3: mesh: node 10 is given twice");
  EXPECT_EQ(complain("3, 3, 1", "3, 3000000000, 1"),
            "dam.lua:3: mesh:23: the sets have more members than a file of this size can hold");
  EXPECT_EQ(complain("ELSET=DAM, MAT", "ELSET=both, MAT"),
            "dam.lua:3: mesh:19: hex8 element 3 is in two element sets, 'Rock' and 'both'; every element must be in "
            "exactly one: name those that are regions by *SOLID SECTION");
  EXPECT_EQ(complaint(two_bricks.substr(0, two_bricks.find("*Element")), ".inp").substr(0, 50),
            "dam.lua:3: mesh: there are no volume elements; hex");
}

TEST(AbaqusFile, every_truncation_and_every_damaged_byte_gives_a_complaint_or_a_mesh) {
  for (std::size_t length = 0; length < two_bricks.size(); ++length) complaint(two_bricks.substr(0, length), ".inp");
  for (std::size_t i = 0; i < two_bricks.size(); ++i)
    for (const char c : {'-', '9', ' ', '*', ',', '\n', '='}) {
      std::string damaged = two_bricks;
      damaged[i] = c;
      complaint(damaged, ".inp");  // anything but DeckError ends the test program
    }
}

TEST(VtuFile, every_way_to_store_arrays_gives_the_same_mesh) {
  struct Case {
    const char *shape, *file;
    double tolerance;  // VTK writes 11 digits into ASCII files
  };
  for (const Case& c : {Case{"hex", "ascii", 1e-11}, {"hex", "raw", 0}, {"wedge", "base64", 0}, {"tet", "inline", 0}}) {
    SCOPED_TRACE(c.file);
    Mesh expected = read_mesh(data_file("column_" + std::string(c.shape) + "_41.msh"), {});
    expected.region_names = {"region_3", "region_7"};  // the numbers of the groups
    expected.surfaces.resize(3);
    for (int s = 0; s < 3; ++s) expected.surfaces[s].name = "surface_" + std::to_string(s + 1);
    expect_same(expected, read_mesh(data_file("column_" + std::string(c.shape) + "_" + c.file + ".vtu"), {}),
                c.tolerance);
  }
}

/// Two wedges that fill a unit cube, and the half of its bottom below the first.
const std::string two_wedges = R"(<?xml version="1.0"?>
<!-- by hand -->
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid>
<Piece NumberOfPoints="8" NumberOfCells="3">
<CellData><DataArray type="Int32" Name="material" format="ascii">4 9 2</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0
0 0 1 1 0 1 1 1 1 0 1 1
</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">
0 1 2 4 5 6 0 2 3 4 6 7 0 1 2
</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">6 12 15</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">13 13 5</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>
)";

TEST(VtuFile, wedges_of_either_order_are_turned_upright_but_not_mixed) {
  const std::string other = replaced(two_wedges, "0 1 2 4 5 6 0 2 3 4 6 7", "4 5 6 0 1 2 4 6 7 0 2 3");
  for (const auto& text : {two_wedges, other}) {
    const Mesh mesh = read_text(text, ".vtu");
    EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"region_4", "region_9"}));
    EXPECT_EQ(region_volume(mesh, "region_4"), 0.5);
    EXPECT_EQ(region_volume(mesh, "region_9"), 0.5);
    EXPECT_EQ(surface_area(mesh, "surface_2").z, -0.5);
  }
  EXPECT_EQ(complaint(replaced(two_wedges, "0 2 3 4 6 7", "4 6 7 0 2 3"), ".vtu"),
            "dam.lua:3: mesh:12: wedges 0 and 1 have opposite node orders; give all wedges the same order");
}

TEST(VtuFile, complaints_name_the_line_and_the_remedy) {
  auto complain = [](const std::string& from, const std::string& to) {
    return complaint(replaced(two_wedges, from, to), ".vtu");
  };
  EXPECT_EQ(complain("type=\"UnstructuredGrid\"", "type=\"ImageData\""),
            "dam.lua:3: mesh:3: the VTK file holds 'ImageData'; valid: UnstructuredGrid (.vtu)");
  EXPECT_EQ(complain("version=\"0.1\"", "compressor=\"vtkZLibDataCompressor\"").substr(0, 52),
            "dam.lua:3: mesh:3: the file is compressed; save it w");
  EXPECT_EQ(complain("0 1 2 4 5 6", "0 1 2 4 5 8"),
            "dam.lua:3: mesh:12: array 'connectivity' gives cell 0 the point 8; valid: 0 to 7");
  EXPECT_EQ(complain("6 12 15", "5 12 15"),
            "dam.lua:3: mesh:15: array 'offsets' gives cell 0 another number of points than its type has (6)");
  EXPECT_EQ(complain("13 13 5", "13 26 5").substr(0, 73),
            "dam.lua:3: mesh:16: array 'types' has cell type 26 of second order; only ");
  EXPECT_EQ(complain("4 9 2", "4 9"), "dam.lua:3: mesh:6: array 'material' has 2 entries for 3 cells");
  EXPECT_EQ(complain("4 9 2", "4 9.5 2"), "dam.lua:3: mesh:6: array 'material': expected a number, found '9.5'");
  EXPECT_EQ(complain("1 1 1 0 1 1\n", "1 nan 1 0 1 1\n"),
            "dam.lua:3: mesh:7: array '' has a coordinate that is not finite, at point 6");
  EXPECT_EQ(complain("NumberOfPoints=\"8\"", "NumberOfPoints=\"9\""),
            "dam.lua:3: mesh:5: NumberOfPoints is '9', but the arrays hold 8");
  EXPECT_EQ(complain("</Cells>", "</Cell>"), "dam.lua:3: mesh:17: </Cell> closes nothing that is open");
  EXPECT_EQ(complaint(two_wedges, ".stl"),
            "dam.lua:3: mesh: the extension '.stl' of a mesh file is not known; valid: .msh (Gmsh), .inp (Abaqus, "
            "CalculiX), .vtu (VTK)");
}

TEST(VtuFile, every_truncation_and_every_damaged_byte_gives_a_complaint_or_a_mesh) {
  for (const char* name : {"column_hex_raw.vtu", "column_wedge_base64.vtu", "column_tet_inline.vtu"}) {
    const std::string column = text_of(data_file(name));
    const auto end =
        column.rfind("</AppendedData>") == std::string::npos ? column.size() : column.rfind("</AppendedData>");
    for (std::size_t length = 0; length + 4 < end; length += 29)
      EXPECT_NE(complaint(column.substr(0, length), ".vtu"), "no complaint") << name << " " << length;
    for (std::size_t i = 0; i < column.size(); i += 31)
      for (const char c : {'\x00', '\xff', '9', '<', '"'}) {
        std::string damaged = column;
        damaged[i] = c;
        complaint(damaged, ".vtu");  // anything but DeckError ends the test program
      }
  }
}

}  // namespace
}  // namespace ashlar
