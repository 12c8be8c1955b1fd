#pragma once
#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// A thin layer over the HDF5 C library: handles that close themselves, failures that become ResourceError.
namespace ashlar::hdf5 {

/// Throws ResourceError: `path`, what failed and the library's own innermost reason ("No space left on device").
[[noreturn]] void fail(const std::string& path, const std::string& what);

/// An open file, group, dataset, data space, property list, type or attribute.
class Handle {
 public:
  /// Takes `id`; a negative one is a failure of `what` on `path`.
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& path, const std::string& what);
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle();
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

template <class T>
hid_t type_of();
template <>
inline hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t type_of<int>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t type_of<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t type_of<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

enum class Mode { create, read, change };

/// A file: it appears, in place of an older one, with its first flush; no time stamps, no file locking, links in order of creation, so that the same data give the same bytes and a
/// reader never stops the run.
class File {
 public:
  explicit File(const std::string& path, Mode mode = Mode::create);

  const std::string& path() const { return path_; }
  void group(const std::string& name);
  bool has(const std::string& name);
  /// Names of what a group holds, in order of creation.
  std::vector<std::string> names(const std::string& group);

  /// Writes a whole dataset of `shape` (its product is the size of `values`).
  template <class T>
  void write(const std::string& name, std::span<const T> values, const std::vector<hsize_t>& shape) {
    write_whole(name, type_of<T>(), values.data(), shape);
  }
  /// An empty dataset of rows; grows by `append`. One chunk holds `chunk_rows` rows, compressed if `compressed`.
  void create_rows(const std::string& name, hid_t type, hsize_t chunk_rows, const std::vector<hsize_t>& row_shape,
                   bool compressed);
  /// Adds `rows` rows and returns how many there were before. Compressed chunks that they fill are packed side by side.
  hsize_t append(const std::string& name, hid_t type, const void* values, hsize_t rows);
  /// Drops all rows behind the first `rows`.
  void cut(const std::string& name, hsize_t rows);
  void remove(const std::string& name);  ///< a group or dataset
  std::vector<hsize_t> shape(const std::string& name) { return shape_of(open(name)); }
  /// All values of a dataset, converted to T.
  template <class T>
  std::vector<T> read(const std::string& name) {
    std::vector<T> values(size_of(name));
    read_whole(name, type_of<T>(), values.data());
    return values;
  }
  double number(const std::string& object, const std::string& attribute);
  std::string text(const std::string& object, const std::string& attribute);  ///< "" if there is none
  std::vector<std::string> texts(const std::string& object, const std::string& attribute);  ///< none: empty
  /// A dataset without data of its own: `rows` rows of `source` from `first_row` on.
  void link_rows(const std::string& name, const std::string& source, hid_t type, hsize_t first_row, hsize_t rows);

  /// Sets an attribute of a group or dataset; an existing one of the same type is overwritten.
  template <class T>
  void attribute(const std::string& object, const std::string& name, const std::vector<T>& values) {
    write_attribute(object, name, type_of<T>(), values.data(), values.size());
  }
  void attribute(const std::string& object, const std::string& name, std::int64_t value) {
    write_attribute(object, name, H5T_NATIVE_INT64, &value, 0);
  }
  void attribute(const std::string& object, const std::string& name, double value) {
    write_attribute(object, name, H5T_NATIVE_DOUBLE, &value, 0);
  }
  void attribute(const std::string& object, const std::string& name, const std::string& text);
  void attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts);

  /// Everything written so far can be read even if the program is killed; until the next flush readers see nothing
  /// newer.
  void flush();

 private:
  Handle open(const std::string& name);
  std::size_t size_of(const std::string& name);
  void read_whole(const std::string& name, hid_t type, void* values);
  void write_whole(const std::string& name, hid_t type, const void* values, const std::vector<hsize_t>& shape);
  void write_rows(const std::string& name, hid_t dataset, hid_t type, const void* values, hsize_t first_row,
                  hsize_t rows);
  void write_attribute(const std::string& object, const std::string& name, hid_t type, const void* values,
                       std::size_t count);  ///< count 0: a scalar
  Handle space(const std::vector<hsize_t>& shape, const std::vector<hsize_t>& largest = {});
  std::vector<hsize_t> shape_of(hid_t dataset);
  void check(herr_t status, const std::string& what);

  std::string path_;
  std::string written_as_;  ///< until the file appears; then empty
  Handle file_;
};

}  // namespace ashlar::hdf5
