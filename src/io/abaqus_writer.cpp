#include <algorithm>
#include <cctype>
#include <map>

#include "io/abaqus_elements.hpp"
#include "io/mesh_writer.hpp"
#include "io/text_file.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {

namespace {

const char* element_type(Shape shape) {
  return shape == Shape::hex8 ? "C3D8" : shape == Shape::wedge6 ? "C3D6" : "C3D4";
}

/// Names as Abaqus takes them, found again without regard to case.
class Names {
 public:
  std::string operator()(const std::string& name) {
    std::string plain = name;
    for (char& c : plain)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
    std::string key = plain;
    for (char& c : key) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto [at, fresh] = given_.try_emplace(key, name);
    if (!fresh && at->second != name)
      throw DeckError(Where{}, "'" + at->second + "' and '" + name + "' would be one name, " + plain +
                                   ", in an Abaqus file; rename one of them in the deck");
    return plain;
  }

 private:
  std::map<std::string, std::string> given_;
};

/// S1, S2, ... of a facet.
int face_label(Shape shape, int face) {
  for (int label = 0; label < face_count(shape); ++label)
    if (abaqus_face(shape, label) == face) return label + 1;
  return 0;
}

std::string mesh_text(const Mesh& mesh, Names& region_name, Names& surface_name) {
  std::string text = "*NODE\n";
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    const auto& p = mesh.points[n];
    text += std::to_string(n + 1) + ", " + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + '\n';
  }
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (e == 0 || mesh.regions[e] != mesh.regions[e - 1] || mesh.shapes[e] != mesh.shapes[e - 1])
      text += std::string("*ELEMENT, TYPE=") + element_type(mesh.shapes[e]) +
              ", ELSET=" + region_name(mesh.region_names[mesh.regions[e]]) + '\n';
    text += std::to_string(e + 1);
    for (const int n : mesh.element(e)) text += ", " + std::to_string(n + 1);
    text += '\n';
  }
  for (const Surface& surface : mesh.surfaces) {
    text += "*SURFACE, NAME=" + surface_name(surface.name) + ", TYPE=ELEMENT\n";
    for (const Facet& f : surface.facets)
      text += std::to_string(f.element + 1) + ", S" + std::to_string(face_label(mesh.shapes[f.element], f.face)) + '\n';
  }
  return text;
}

std::string material_text(const Material& material, double reference_temperature, const std::string& name) {
  const Elastic law = make_law<Elastic>(material.values);
  std::string text = "*MATERIAL, NAME=" + name + "\n*ELASTIC\n" + shortest(law.young) + ", " + shortest(law.poisson) +
                     "\n*DENSITY\n" + shortest(material.density) + '\n';
  if (law.expansion != 0)
    text += "*EXPANSION, ZERO=" + shortest(reference_temperature) + '\n' + shortest(law.expansion) + '\n';
  if (material.conductivity) text += "*CONDUCTIVITY\n" + shortest(*material.conductivity) + '\n';
  if (material.heat_capacity) text += "*SPECIFIC HEAT\n" + shortest(*material.heat_capacity) + '\n';
  return text;
}

std::string step_text(const NodalStep& step) {
  std::string held = "*BOUNDARY, OP=NEW\n", forces = "*CLOAD, OP=NEW\n";
  for (std::size_t n = 0; n < step.held.size(); ++n)
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string component = std::to_string(n + 1) + ", " + std::to_string(a + 1);
      if (step.held[n] >> a & 1u)
        held += component + ", " + std::to_string(a + 1) + ", " + shortest(step.displacement[3 * n + a]) + '\n';
      else if (step.force[3 * n + a] != 0)
        forces += component + ", " + shortest(step.force[3 * n + a]) + '\n';
    }
  return "** stage " + step.name + "\n*STEP\n*STATIC\n" + held + forces +
         "*NODE FILE\nU, RF\n*EL FILE\nS\n*END STEP\n";
}

}  // namespace

std::string abaqus_text(const Model& model, const std::vector<NodalStep>& steps,
                        const std::vector<std::string>& remarks) {
  std::string text = "*HEADING\n" + model.name + ", written by ashlar; SI units\n";
  for (const auto& remark : remarks) text += "** " + remark + '\n';
  Names region_name, surface_name, material_name;
  text += mesh_text(model.mesh, region_name, surface_name);
  for (const Material& material : model.materials) {
    text += material_text(material, model.reference_temperature, material_name(material.name));
    for (const auto& region : material.regions)
      text += "*SOLID SECTION, ELSET=" + region_name(region) + ", MATERIAL=" + material_name(material.name) + '\n';
  }
  for (const NodalStep& step : steps) text += step_text(step);
  return text;
}

}  // namespace ashlar
