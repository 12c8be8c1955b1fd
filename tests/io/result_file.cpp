#include "io/result_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "io/sample_model.hpp"

namespace ashlar {
namespace {

/// Reads a results file back with nothing but the HDF5 library.
class Reader {
 public:
  explicit Reader(const std::string& path) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_file_locking(access, false, true);  // one program must open a file the same way twice
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
    if (file_ < 0) throw std::runtime_error("cannot open " + path);
  }
  ~Reader() { H5Fclose(file_); }
  bool has(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

  std::vector<hsize_t> shape(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), space = H5Dget_space(dataset);
    std::vector<hsize_t> shape(H5Sget_simple_extent_ndims(space));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return shape;
  }
  std::vector<double> numbers(const std::string& name) const {
    hsize_t size = 1;
    for (const auto n : shape(name)) size *= n;
    std::vector<double> values(size);
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
    H5Dclose(dataset);
    return values;
  }
  long step_count() const {
    long count = -1;
    const hid_t attribute = H5Aopen_by_name(file_, "/VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT);
    H5Aread(attribute, H5T_NATIVE_LONG, &count);
    H5Aclose(attribute);
    return count;
  }
  std::string text_attribute(const std::string& object, const std::string& name) const {
    const hid_t attribute = H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    EXPECT_EQ(H5Tis_variable_str(type), 0);
    std::string text(H5Tget_size(type), '\0');
    H5Aread(attribute, type, text.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return text;
  }

 private:
  hid_t file_ = -1;
};

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

using Numbers = std::vector<double>;

TEST(ResultFile, has_the_vtkhdf_layout) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  const auto first = sample.snapshot("gravity", 1, 1, false), second = sample.snapshot("winter", 2, 2, true);
  file.append(first);
  file.append(second);

  const Reader reader(folder.file("results.vtkhdf"));  // while the writer still has it open
  const hsize_t nodes = sample.blocks.node_count(), elements = 4;
  EXPECT_GT(nodes, sample.model.mesh.points.size());
  EXPECT_EQ(reader.text_attribute("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(reader.numbers("/VTKHDF/NumberOfPoints"), Numbers{static_cast<double>(nodes)});
  EXPECT_EQ(reader.numbers("/VTKHDF/NumberOfCells"), Numbers{4});
  EXPECT_EQ(reader.numbers("/VTKHDF/NumberOfConnectivityIds"), Numbers{8 + 8 + 6 + 4});
  EXPECT_EQ(reader.numbers("/VTKHDF/Types"), (Numbers{12, 12, 13, 10}));
  EXPECT_EQ(reader.numbers("/VTKHDF/Offsets"), (Numbers{0, 8, 16, 22, 26}));
  EXPECT_EQ(reader.numbers("/VTKHDF/CellData/region"), (Numbers{0, 1, 2, 2}));
  EXPECT_EQ(reader.numbers("/VTKHDF/CellData/block"), (Numbers{0, 1, 2, 2}));
  EXPECT_EQ(reader.shape("/VTKHDF/PointData/displacement"), (std::vector<hsize_t>{2 * nodes, 3}));
  EXPECT_EQ(reader.shape("/VTKHDF/CellData/stress"), (std::vector<hsize_t>{2 * elements, 6}));
  EXPECT_EQ(reader.step_count(), 2);
  EXPECT_EQ(reader.numbers("/VTKHDF/Steps/Values"), (Numbers{1, 2}));
  EXPECT_EQ(reader.shape("/VTKHDF/Steps/CellOffsets"), (std::vector<hsize_t>{2, 1}));
  EXPECT_EQ(reader.numbers("/VTKHDF/Steps/NumberOfParts"), (Numbers{1, 1}));
  EXPECT_EQ(reader.numbers("/VTKHDF/Steps/PointDataOffsets/displacement"), (Numbers{0, static_cast<double>(nodes)}));
  EXPECT_EQ(reader.numbers("/VTKHDF/Steps/CellDataOffsets/stress"), (Numbers{0, 4}));
  EXPECT_EQ(reader.numbers("/VTKHDF/Steps/CellDataOffsets/region"), (Numbers{0, 0}));
  EXPECT_EQ(reader.text_attribute("/VTKHDF/PointData/temperature", "unit"), "degC");
  EXPECT_EQ(reader.text_attribute("/Steps/00002", "stage"), "winter");
}

TEST(ResultFile, every_point_stands_where_its_mesh_node_does) {
  const SampleModel sample;
  const TemporaryFolder folder;
  const ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  const Reader reader(folder.file("results.vtkhdf"));
  const auto points = reader.numbers("/VTKHDF/Points"), corners = reader.numbers("/VTKHDF/Connectivity");
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& expected = sample.model.mesh.points[sample.model.mesh.corners[i]];
    for (int c = 0; c < 3; ++c) EXPECT_EQ(points[3 * static_cast<std::size_t>(corners[i]) + c], expected[c]);
  }
}

TEST(ResultFile, virtual_datasets_show_each_step) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  for (int step = 1; step <= 3; ++step) {
    const auto snapshot = sample.snapshot("gravity", step, step, true);
    file.append(snapshot);
    const Reader reader(folder.file("results.vtkhdf")), faces(folder.file("interfaces.vtkhdf"));
    const std::string group = "/Steps/0000" + std::to_string(step) + "/";
    EXPECT_EQ(reader.numbers(group + "displacement"), snapshot.displacement);
    EXPECT_EQ(reader.numbers(group + "temperature"), snapshot.temperature);
    EXPECT_EQ(reader.numbers(group + "stress"), snapshot.stress);
    EXPECT_EQ(reader.numbers(group + "nodal_stress"), snapshot.nodal_stress);
    EXPECT_EQ(reader.numbers(group + "principal_stress"), snapshot.principal_stress);
    EXPECT_EQ(faces.numbers(group + "opening"), snapshot.opening);
    EXPECT_EQ(faces.numbers(group + "normal_traction"), snapshot.normal_traction);
    EXPECT_EQ(faces.numbers(group + "state"), Numbers(snapshot.contact_state.begin(), snapshot.contact_state.end()));
    EXPECT_EQ(reader.shape(group + "stress"), (std::vector<hsize_t>{4, 6}));
  }
}

TEST(ResultFile, interfaces_are_polygons_with_corners_of_their_own) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  const auto snapshot = sample.snapshot("gravity", 1, 1, false);
  file.append(snapshot);
  const Reader faces(folder.file("interfaces.vtkhdf"));
  EXPECT_EQ(faces.numbers("/VTKHDF/Types"), (Numbers{9, 9}));
  EXPECT_EQ(faces.numbers("/VTKHDF/NumberOfPoints"), Numbers{8});
  EXPECT_EQ(faces.numbers("/VTKHDF/CellData/interface").size(), 2u);
  // Displacement of a corner: the mean of the two nodes that its spring joins.
  const auto shown = faces.numbers("/Steps/00001/displacement");
  for (int i = 0; i < sample.contacts.count(); ++i)
    EXPECT_EQ(shown[3 * i], (snapshot.displacement[3 * sample.contacts.node_a[i]] +
                             snapshot.displacement[3 * sample.contacts.node_b[i]]) /
                                2);
}

TEST(ResultFile, temperature_is_the_reference_until_a_stage_computes_it) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  file.append(sample.snapshot("gravity", 1, 1, false));
  file.append(sample.snapshot("winter", 2, 2, true));
  const Reader reader(folder.file("results.vtkhdf"));
  for (const double t : reader.numbers("/Steps/00001/temperature")) EXPECT_EQ(t, 10);
  EXPECT_EQ(reader.numbers("/Steps/00002/temperature")[0], 2);
}

TEST(ResultFile, mechanical_fields_are_zero_before_the_first_mechanical_stage) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  Snapshot heat;
  heat.stage = "summer";
  heat.stage_number = 1;
  heat.temperature.assign(sample.blocks.node_count(), 20);
  file.append(heat);
  const Reader reader(folder.file("results.vtkhdf"));
  for (const double s : reader.numbers("/Steps/00001/stress")) EXPECT_EQ(s, 0);
}

TEST(ResultFile, a_mechanical_snapshot_without_a_recorded_field_is_an_error) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  auto snapshot = sample.snapshot("gravity", 1, 1, false);
  snapshot.stress.clear();
  EXPECT_THROW(file.append(snapshot), std::logic_error);
}

TEST(ResultFile, writes_what_is_recorded_and_nothing_else) {
  SampleModel sample;
  const TemporaryFolder folder;
  sample.model.outputs.resize(2);
  sample.model.outputs[0].record = {"displacement"};
  sample.model.outputs[1].record = {"temperature", "displacement"};
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  file.append(sample.snapshot("gravity", 1, 1, false));
  const Reader reader(folder.file("results.vtkhdf"));
  EXPECT_TRUE(reader.has("/VTKHDF/PointData/displacement"));
  EXPECT_TRUE(reader.has("/VTKHDF/PointData/temperature"));
  EXPECT_FALSE(reader.has("/VTKHDF/CellData/stress"));
  EXPECT_FALSE(reader.has("/VTKHDF/PointData/nodal_stress"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("interfaces.vtkhdf")));
  EXPECT_EQ(file.file_names(), (std::vector<std::string>{"results.vtkhdf", "results.xdmf"}));
}

TEST(ResultFile, outputs_of_one_time_stay_apart_and_in_order) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  for (const double time : {0.0, 1.0, 1.5, 2.0, 2.0}) file.append(sample.snapshot("winter", 2, time, true));
  EXPECT_EQ(Reader(folder.file("results.vtkhdf")).numbers("/VTKHDF/Steps/Values"), (Numbers{0, 1, 1.5, 2, 2 + 1e-6}));
}

TEST(ResultFile, a_run_that_blew_up_can_still_be_looked_at) {
  const SampleModel sample;
  const TemporaryFolder folder;
  ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
  auto snapshot = sample.snapshot("gravity", 1, 1, false);
  snapshot.displacement[4] = std::numeric_limits<double>::quiet_NaN();
  snapshot.stress.clear();
  file.append(snapshot);
  const Reader reader(folder.file("results.vtkhdf"));
  EXPECT_EQ(reader.numbers("/Steps/00001/displacement")[5], snapshot.displacement[5]);
  for (const double s : reader.numbers("/Steps/00001/stress")) EXPECT_TRUE(std::isnan(s));
}

TEST(ResultFile, the_same_run_gives_the_same_bytes) {
  const SampleModel sample;
  const TemporaryFolder a, b;
  for (const auto* folder : {&a, &b}) {
    ResultFile file(folder->path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
    file.append(sample.snapshot("gravity", 1, 1, false));
    file.append(sample.snapshot("winter", 2, 2, true));
    if (folder == &a) sleep(1);  // time stamps of HDF5 count whole seconds
  }
  for (const char* name : {"results.vtkhdf", "results.xdmf", "interfaces.vtkhdf", "interfaces.xdmf"}) {
    EXPECT_GT(bytes_of(a.file(name)).size(), 0u);
    EXPECT_TRUE(bytes_of(a.file(name)) == bytes_of(b.file(name))) << name;
  }
}

TEST(ResultFile, a_killed_run_leaves_every_output_readable) {
  const SampleModel sample;
  const TemporaryFolder folder;
  const auto snapshot = sample.snapshot("gravity", 1, 1, true);
  const pid_t child = fork();
  if (child == 0) {
    ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
    file.append(snapshot);
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const Reader reader(folder.file("results.vtkhdf"));
  EXPECT_EQ(reader.step_count(), 1);
  EXPECT_EQ(reader.numbers("/Steps/00001/temperature"), snapshot.temperature);
}

TEST(ResultFile, a_disk_that_takes_no_more_is_a_resource_error_that_names_the_file) {
  const SampleModel sample;
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{40000, 40000};
    setrlimit(RLIMIT_FSIZE, &limit);
    int code = 1;
    try {
      ResultFile file(folder.path(), "ashlar 0", sample.model, sample.blocks, sample.contacts);
      for (int step = 1; step < 100; ++step) file.append(sample.snapshot("gravity", step, step, true));
    } catch (const ResourceError& error) {
      const std::string expected = folder.file("results.vtkhdf") + ": cannot ", message = error.what();
      if (message.starts_with(expected) && message.ends_with(": File too large")) code = 5;
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 5);
}

TEST(ResultFile, a_folder_that_is_not_there_is_a_resource_error) {
  const SampleModel sample;
  try {
    ResultFile file("/no/such/folder", "ashlar 0", sample.model, sample.blocks, sample.contacts);
    FAIL();
  } catch (const ResourceError& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/results.vtkhdf: cannot create the file"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace ashlar
