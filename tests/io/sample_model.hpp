#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

#include "model/blocks.hpp"
#include "solve/observer.hpp"

namespace ashlar {

/// A folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("ashlar_io_" + std::to_string(getpid()) + "_" + std::to_string(++count));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::string path() const { return path_.string(); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A hex8 with a wedge6 and a tet4 beside it (nodes 0-7 the unit cube), and a second hex8 on top that a joint cuts off;
/// the joint also separates the wedge from the first cube. Mixed cells, a quad face each between "rock" and "dam" and
/// "rock" and "side".
struct SampleModel {
  Model model;
  Blocks blocks;
  ContactPoints contacts;

  SampleModel() {
    model.name = "sample";
    model.reference_temperature = 10;
    Mesh& mesh = model.mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
                   {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {2, 0, 0}, {2, 1, 0}, {3, 0, 0}};
    mesh.region_names = {"rock", "dam", "side"};
    mesh.add_element(Shape::hex8, std::array{0, 1, 2, 3, 4, 5, 6, 7}, 0, 11);
    mesh.add_element(Shape::hex8, std::array{4, 5, 6, 7, 8, 9, 10, 11}, 1, 12);
    mesh.add_element(Shape::wedge6, std::array{1, 12, 5, 2, 13, 6}, 2, 13);
    mesh.add_element(Shape::tet4, std::array{12, 14, 13, 5}, 2, 14);
    for (const char* region : {"rock", "dam", "side"}) {
      Material material;
      material.name = region;
      material.regions = {region};
      material.values = {{"young", 20e9}, {"poisson", 0.2}};
      model.materials.push_back(material);
    }
    for (const char* other : {"dam", "side"}) {
      Interface joint;
      joint.name = std::string(other) + "_base";
      joint.regions = {"rock", other};
      joint.law = "elastic";
      model.interfaces.push_back(joint);
    }
    model.stages.resize(2);
    model.stages[0].name = "gravity";
    model.stages[1].name = "winter";
    model.stages[1].solve = ThermalSolve{false, 1000, 1e-10};
    blocks = split_blocks(model, find_faces(mesh));
    contacts = place_contacts(model, blocks);
  }

  Snapshot snapshot(const std::string& stage, int number, double time, bool warm) const {
    Snapshot s;
    s.stage = stage;
    s.stage_number = number;
    s.time = time;
    s.load_factor = 1;
    const int elements = model.mesh.element_count();
    for (int i = 0; i < 3 * blocks.node_count(); ++i) s.displacement.push_back(number * 1e-3 * i);
    if (warm)
      for (int i = 0; i < blocks.node_count(); ++i) s.temperature.push_back(time + i);
    for (int i = 0; i < 6 * elements; ++i) s.stress.push_back(number * 1e6 + i);
    for (int i = 0; i < 6 * blocks.node_count(); ++i) s.nodal_stress.push_back(-number * 1e6 - i);
    for (int i = 0; i < 3 * elements; ++i) s.principal_stress.push_back(number * 3e6 - i);
    for (int i = 0; i < contacts.count(); ++i) {
      s.opening.push_back(number * 1e-4 * i);
      s.slip.push_back(number * 1e-5 * i);
      s.normal_traction.push_back(-number * 1e5 * i);
      s.shear_traction.push_back(number * 1e4 * i);
      s.contact_state.push_back(static_cast<std::uint8_t>((i + number) % 3));
    }
    return s;
  }
};

}  // namespace ashlar
