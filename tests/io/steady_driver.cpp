#include <gtest/gtest.h>

#include <filesystem>

#include "io/hdf5.hpp"

namespace ashlar {
namespace {

/// What a reader finds in the file as it lies on disk at this moment, as it would after a kill.
std::vector<double> rows_on_disk(const std::string& path) {
  const std::string copy = path + ".copy";
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
  hdf5::File file(copy, hdf5::Mode::read);
  for (const std::string& group : file.names("/Steps")) file.names("/Steps/" + group);
  return file.read<double>("/rows");
}

TEST(SteadyDriver, ReadersSeeWholeOutputsOnlyWhateverIsUnderWay) {
  const std::string path = testing::TempDir() + "steady.h5";
  std::vector<double> rows;
  {
    hdf5::File file(path);
    file.group("/Steps");
    file.create_rows("/rows", H5T_NATIVE_DOUBLE, 7, {}, true);
    file.flush();
    for (int step = 0; step < 300; ++step) {
      const std::vector<double> seen = rows;
      rows.push_back(step);
      file.append("/rows", H5T_NATIVE_DOUBLE, &rows.back(), 1);
      const std::string group = "/Steps/" + std::to_string(step);
      file.group(group);
      file.link_rows(group + "/row", "/rows", H5T_NATIVE_DOUBLE, rows.size() - 1, 1);
      file.attribute(group, "time", rows.back());
      ASSERT_EQ(rows_on_disk(path), seen);
      file.flush();
      if (step % 50 == 0) {
        ASSERT_EQ(rows_on_disk(path), rows);
      }
    }
    file.append("/rows", H5T_NATIVE_DOUBLE, rows.data(), rows.size());
    file.cut("/rows", 20);
  }
  rows.resize(20);
  EXPECT_EQ(rows_on_disk(path), rows);

  hdf5::File again(path, hdf5::Mode::change);
  again.remove("/Steps/7");
  EXPECT_FALSE(again.has("/Steps/7"));
  again.append("/rows", H5T_NATIVE_DOUBLE, rows.data(), 2);
  again.flush();
  rows.insert(rows.end(), {0, 1});
  EXPECT_EQ(rows_on_disk(path), rows);
}

}  // namespace
}  // namespace ashlar
