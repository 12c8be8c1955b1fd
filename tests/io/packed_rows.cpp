#include <gtest/gtest.h>

#include <cmath>

#include "io/hdf5.hpp"

namespace ashlar {
namespace {

constexpr hsize_t chunk_rows = 10;

/// Rows of three numbers, in pieces of so many.
std::vector<double> write_in_pieces(const std::string& path, const std::vector<hsize_t>& pieces) {
  hdf5::File file(path);
  file.create_rows("/rows", H5T_NATIVE_DOUBLE, chunk_rows, {3}, true);
  std::vector<double> all;
  for (const hsize_t rows : pieces) {
    std::vector<double> piece;
    for (hsize_t i = 0; i < 3 * rows; ++i) piece.push_back(std::sin(0.1 * double(all.size() + i)));
    EXPECT_EQ(file.append("/rows", H5T_NATIVE_DOUBLE, piece.data(), rows), all.size() / 3);
    all.insert(all.end(), piece.begin(), piece.end());
  }
  file.flush();
  return all;
}

std::vector<unsigned char> bytes_of_chunk(const std::string& path, hsize_t first_row) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), rows = H5Dopen2(file, "/rows", H5P_DEFAULT);
  const hsize_t corner[2] = {first_row, 0};
  hsize_t size = 0;
  H5Dget_chunk_storage_size(rows, corner, &size);
  std::vector<unsigned char> bytes(size);
  std::uint32_t filters = 1;
  H5Dread_chunk(rows, H5P_DEFAULT, corner, &filters, bytes.data());
  EXPECT_EQ(filters, 0u) << "a filter was left out";
  H5Dclose(rows);
  H5Fclose(file);
  return bytes;
}

TEST(PackedRows, read_back_the_same_wherever_pieces_begin_and_end) {
  const std::string path = testing::TempDir() + "rows.h5";
  const std::vector<double> rows = write_in_pieces(path, {25, 3, 47, 10, 5, 2, 90, 8});
  EXPECT_EQ(hdf5::File(path, hdf5::Mode::read).read<double>("/rows"), rows);
}

TEST(PackedRows, whole_chunks_are_the_bytes_that_the_library_makes_of_them) {
  const std::string own = testing::TempDir() + "own.h5", library = testing::TempDir() + "library.h5";
  write_in_pieces(own, {30});
  write_in_pieces(library, {6, 6, 6, 6, 6});  // no piece fills a chunk
  for (const hsize_t row : {0, 10, 20}) {
    const auto bytes = bytes_of_chunk(own, row);
    EXPECT_GT(bytes.size(), 0u);
    EXPECT_TRUE(bytes == bytes_of_chunk(library, row)) << row;
  }
}

}  // namespace
}  // namespace ashlar
