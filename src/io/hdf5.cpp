#include "io/hdf5.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "io/packed_chunk.hpp"
#include "io/steady_driver.hpp"
#include "io/text_file.hpp"

namespace ashlar::hdf5 {

namespace {

herr_t keep_innermost(unsigned, const H5E_error2_t* entry, void* reason) {
  auto& text = *static_cast<std::string*>(reason);
  if (text.empty() && entry->desc) text = entry->desc;
  return 0;
}

/// The library neither prints its error stacks nor tries again to write lost data when the program ends.
void be_quiet() {
  static const bool done = [] {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(done);
}

/// `path`: what messages call it.
Handle open_file(const std::string& path, const std::string& written_as, Mode mode) {
  be_quiet();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path, "prepare the file");
  H5Pset_file_locking(access, false, true);
  // Objects of the 1.8 format: superblock 2 has no "open for writing" mark that would lock readers out after a kill.
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);
  if (mode == Mode::read)
    return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, path, "read the file");
  use_steady_driver(access);
  if (mode == Mode::change)
    return Handle(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose, path, "open the file");
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, path, "prepare the file");
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(creation, false);
  return Handle(H5Fcreate(written_as.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose, path, "create the file");
}

/// Fixed-length text: ASCII where it is, UTF-8 elsewhere.
Handle text_type(const std::string& path, std::size_t length, bool ascii) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, path, "describe a text");
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

}  // namespace

void fail(const std::string& path, const std::string& what) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  // "file write failed: time = ..., errno = 28, error message = 'No space left on device', ...": the words between the
  // quotes say it.
  const std::string mark = "error message = '";
  if (const auto at = reason.find(mark); at != std::string::npos) {
    reason.erase(0, at + mark.size());
    reason.erase(std::min(reason.find('\''), reason.size()));
  }
  throw ResourceError(path + ": cannot " + what + (reason.empty() ? "" : ": " + reason));
}

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const std::string& path, const std::string& what)
    : id_(id), close_(close) {
  if (id < 0) fail(path, what);
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

File::File(const std::string& path, Mode mode)
    : path_(path), written_as_(mode == Mode::create ? path + ".part" : ""), file_(open_file(path, written_as_, mode)) {}

void File::cut(const std::string& name, hsize_t rows) {
  const Handle dataset = open(name);
  auto shape = shape_of(dataset);
  if (shape.at(0) < rows) throw ResourceError(path_ + ": " + name + " has lost rows: the file has been changed");
  shape[0] = rows;
  check(H5Dset_extent(dataset, shape.data()), "cut " + name);
}

void File::remove(const std::string& name) {
  check(H5Ldelete(file_, name.c_str(), H5P_DEFAULT), "remove " + name);
}

void File::check(herr_t status, const std::string& what) {
  if (status < 0) fail(path_, what);
}

Handle File::space(const std::vector<hsize_t>& shape, const std::vector<hsize_t>& largest) {
  return Handle(
      H5Screate_simple(static_cast<int>(shape.size()), shape.data(), largest.empty() ? nullptr : largest.data()),
      H5Sclose, path_, "describe an array");
}

Handle File::open(const std::string& name) {
  return Handle(H5Oopen(file_, name.c_str(), H5P_DEFAULT), H5Oclose, path_, "open " + name);
}

std::vector<hsize_t> File::shape_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose, path_, "measure an array");
  std::vector<hsize_t> shape(H5Sget_simple_extent_ndims(space));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

void File::group(const std::string& name) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, path_, "describe a group");
  H5Pset_obj_track_times(creation, false);
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Handle created(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose, path_,
                       "create group " + name);
}

bool File::has(const std::string& name) { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

std::vector<std::string> File::names(const std::string& group) {
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* all) {
    static_cast<std::vector<std::string>*>(all)->push_back(name);
    return herr_t{0};
  };
  check(H5Literate(open(group), H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, keep, &names), "list " + group);
  return names;
}

std::size_t File::size_of(const std::string& name) {
  std::size_t size = 1;
  for (const hsize_t n : shape(name)) size *= n;
  return size;
}

void File::read_whole(const std::string& name, hid_t type, void* values) {
  check(H5Dread(open(name), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "read " + name);
}

double File::number(const std::string& object, const std::string& attribute) {
  const Handle owner = open(object);
  const Handle found(H5Aopen(owner, attribute.c_str(), H5P_DEFAULT), H5Aclose, path_, "read " + attribute);
  double value = 0;
  check(H5Aread(found, H5T_NATIVE_DOUBLE, &value), "read " + attribute);
  return value;
}

std::vector<std::string> File::texts(const std::string& object, const std::string& attribute) {
  const Handle owner = open(object);
  if (H5Aexists(owner, attribute.c_str()) <= 0) return {};
  const Handle found(H5Aopen(owner, attribute.c_str(), H5P_DEFAULT), H5Aclose, path_, "read " + attribute);
  const Handle type(H5Aget_type(found), H5Tclose, path_, "read " + attribute);
  const Handle space(H5Aget_space(found), H5Sclose, path_, "read " + attribute);
  const std::size_t length = H5Tget_size(type);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  std::string stored(length * count, '\0');
  check(H5Aread(found, type, stored.data()), "read " + attribute);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = stored.substr(i * length, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::string File::text(const std::string& object, const std::string& attribute) {
  const auto all = texts(object, attribute);
  return all.empty() ? "" : all[0];
}

void File::write_whole(const std::string& name, hid_t type, const void* values, const std::vector<hsize_t>& shape) {
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path_, "describe an array");
  H5Pset_obj_track_times(creation, false);
  const Handle dataset(H5Dcreate2(file_, name.c_str(), type, space(shape), H5P_DEFAULT, creation, H5P_DEFAULT),
                       H5Dclose, path_, "create " + name);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write " + name);
}

void File::create_rows(const std::string& name, hid_t type, hsize_t chunk_rows, const std::vector<hsize_t>& row_shape,
                       bool compressed) {
  std::vector<hsize_t> start{0}, largest{H5S_UNLIMITED}, chunk{std::max<hsize_t>(chunk_rows, 1)};
  for (auto* shape : {&start, &largest, &chunk}) shape->insert(shape->end(), row_shape.begin(), row_shape.end());
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path_, "describe an array");
  H5Pset_obj_track_times(creation, false);
  H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  if (compressed) {
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, deflate_level);
  }
  const Handle created(H5Dcreate2(file_, name.c_str(), type, space(start, largest), H5P_DEFAULT, creation, H5P_DEFAULT),
                       H5Dclose, path_, "create " + name);
}

hsize_t File::append(const std::string& name, hid_t type, const void* values, hsize_t rows) {
  const Handle dataset = open(name);
  auto shape = shape_of(dataset);
  const hsize_t before = shape[0], after = before + rows;
  shape[0] = after;
  check(H5Dset_extent(dataset, shape.data()), "extend " + name);
  const std::size_t number_bytes = H5Tget_size(type);
  std::size_t row_bytes = number_bytes;
  for (std::size_t i = 1; i < shape.size(); ++i) row_bytes *= shape[i];
  const auto* bytes = static_cast<const unsigned char*>(values);
  const auto by_library = [&](hsize_t first, hsize_t end) {
    if (first < end) write_rows(name, dataset, type, bytes + (first - before) * row_bytes, first, end - first);
  };

  const Handle creation(H5Dget_create_plist(dataset), H5Pclose, path_, "describe an array");
  if (H5Pget_nfilters(creation) == 0) {
    by_library(before, after);
    return before;
  }
  std::vector<hsize_t> chunk(shape.size());
  H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  const hsize_t first = (before + chunk[0] - 1) / chunk[0], end = after / chunk[0];  // chunks that the rows fill
  if (first >= end) {
    by_library(before, after);
    return before;
  }
  by_library(before, first * chunk[0]);
  const std::size_t chunk_bytes = chunk[0] * row_bytes;
  constexpr hsize_t at_once = 256;
  std::vector<std::vector<unsigned char>> packed(std::min(at_once, end - first));
  for (hsize_t begin = first; begin < end; begin += at_once) {
    const int count = static_cast<int>(std::min(at_once, end - begin));
#pragma omp parallel for schedule(dynamic) if (count > 1)
    for (int i = 0; i < count; ++i)
      packed[i] = packed_chunk(bytes + ((begin + i) * chunk[0] - before) * row_bytes, chunk_bytes, number_bytes);
    std::vector<hsize_t> corner(shape.size(), 0);
    for (int i = 0; i < count; ++i) {
      corner[0] = (begin + i) * chunk[0];
      check(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, corner.data(), packed[i].size(), packed[i].data()), "write " + name);
    }
  }
  by_library(end * chunk[0], after);
  return before;
}

void File::write_rows(const std::string& name, hid_t dataset, hid_t type, const void* values, hsize_t first_row,
                      hsize_t rows) {
  const Handle in_file(H5Dget_space(dataset), H5Sclose, path_, "measure " + name);
  auto count = shape_of(dataset);
  std::vector<hsize_t> first(count.size(), 0);
  first[0] = first_row;
  count[0] = rows;
  H5Sselect_hyperslab(in_file, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr);
  check(H5Dwrite(dataset, type, space(count), in_file, H5P_DEFAULT, values), "write " + name);
}

void File::link_rows(const std::string& name, const std::string& source, hid_t type, hsize_t first_row, hsize_t rows) {
  auto shape = shape_of(open(source));
  const Handle source_space = space(shape);
  std::vector<hsize_t> first(shape.size(), 0);
  first[0] = first_row;
  shape[0] = rows;
  H5Sselect_hyperslab(source_space, H5S_SELECT_SET, first.data(), nullptr, shape.data(), nullptr);
  const Handle own_space = space(shape);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path_, "describe an array");
  H5Pset_obj_track_times(creation, false);
  check(H5Pset_virtual(creation, own_space, ".", source.c_str(), source_space), "link " + name);
  const Handle created(H5Dcreate2(file_, name.c_str(), type, own_space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose,
                       path_, "create " + name);
}

void File::write_attribute(const std::string& object, const std::string& name, hid_t type, const void* values,
                           std::size_t count) {
  const Handle owner = open(object);
  const std::string what = "write attribute " + name + " of " + object;
  auto set = [&](hid_t id) {
    const Handle attribute(id, H5Aclose, path_, what);
    check(H5Awrite(attribute, type, values), what);
  };
  if (H5Aexists(owner, name.c_str()) > 0) return set(H5Aopen(owner, name.c_str(), H5P_DEFAULT));
  const Handle extent = count == 0 ? Handle(H5Screate(H5S_SCALAR), H5Sclose, path_, what) : space({count});
  set(H5Acreate2(owner, name.c_str(), type, extent, H5P_DEFAULT, H5P_DEFAULT));
}

void File::attribute(const std::string& object, const std::string& name, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
  const std::string stored = text.empty() ? std::string(1, '\0') : text;
  write_attribute(object, name, text_type(path_, text.size(), ascii), stored.data(), 0);
}

void File::attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::string stored;
  for (const auto& text : texts) stored += text + std::string(length - text.size(), '\0');
  if (!texts.empty()) write_attribute(object, name, text_type(path_, length, false), stored.data(), texts.size());
}

void File::flush() {
  check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "write the file to disk");
  if (written_as_.empty()) return;
  rename_file(written_as_, path_);
  written_as_.clear();
}

}  // namespace ashlar::hdf5
