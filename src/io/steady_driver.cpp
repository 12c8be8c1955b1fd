#include "io/steady_driver.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

namespace ashlar::hdf5 {

namespace {

constexpr herr_t done = 0, failed = -1;

struct File {
  H5FD_t base;  ///< first: the library knows a file by it
  int descriptor = -1;
  haddr_t end_of_use = 0, size = 0;
  haddr_t known = 0;  ///< what readers know of: size at the last flush
  std::map<haddr_t, std::vector<char>> changes;  ///< of that part, apart from each other
};
File& of(H5FD_t* file) { return *reinterpret_cast<File*>(file); }
const File& of(const H5FD_t* file) { return *reinterpret_cast<const File*>(file); }

herr_t fail(const char* what) {
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_IO, H5E_WRITEERROR,
           "%s: error message = '%s'", what, std::strerror(errno));
  return failed;
}

bool write_all(int descriptor, const char* bytes, std::size_t size, haddr_t at) {
  while (size > 0) {
    const ssize_t count = pwrite(descriptor, bytes, size, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
    at += static_cast<haddr_t>(count);
  }
  return true;
}

/// Joins a change with those that it touches.
void change(std::map<haddr_t, std::vector<char>>& changes, haddr_t at, const char* bytes, std::size_t size) {
  auto next = changes.upper_bound(at);
  auto into = next;
  if (next != changes.begin() && std::prev(next)->first + std::prev(next)->second.size() >= at)
    into = std::prev(next);
  else
    into = changes.emplace_hint(next, at, std::vector<char>());
  const std::size_t from = at - into->first;
  std::vector<char>& held = into->second;
  held.resize(std::max(held.size(), from + size));
  std::copy_n(bytes, size, held.begin() + static_cast<std::ptrdiff_t>(from));
  while ((next = std::next(into)) != changes.end() && next->first <= into->first + held.size()) {
    const std::size_t inside = into->first + held.size() - next->first;
    if (inside < next->second.size())
      held.insert(held.end(), next->second.begin() + static_cast<std::ptrdiff_t>(inside), next->second.end());
    changes.erase(next);
  }
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t) {
  int mode = (flags & H5F_ACC_RDWR) ? O_RDWR : O_RDONLY;
  if (flags & H5F_ACC_TRUNC) mode |= O_TRUNC;
  if (flags & H5F_ACC_CREAT) mode |= O_CREAT;
  if (flags & H5F_ACC_EXCL) mode |= O_EXCL;
  const int descriptor = open(name, mode | O_CLOEXEC, 0666);
  struct stat status {};
  if (descriptor < 0 || fstat(descriptor, &status) != 0) {
    fail("open");
    if (descriptor >= 0) close(descriptor);
    return nullptr;
  }
  auto file = std::make_unique<File>();
  file->descriptor = descriptor;
  file->size = file->known = static_cast<haddr_t>(status.st_size);
  return &file.release()->base;
}

herr_t close_file(H5FD_t* base) {
  const std::unique_ptr<File> file(&of(base));
  return close(file->descriptor) == 0 ? done : fail("close");
}

herr_t read(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* buffer) {
  const File& file = of(base);
  auto* bytes = static_cast<char*>(buffer);
  std::size_t count = 0;
  while (count < size) {
    const ssize_t got = pread(file.descriptor, bytes + count, size - count, static_cast<off_t>(at + count));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail("file read failed");
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  std::fill(bytes + count, bytes + size, '\0');  // behind the end of the file
  auto change = file.changes.upper_bound(at);
  if (change != file.changes.begin()) --change;
  for (; change != file.changes.end() && change->first < at + size; ++change) {
    const haddr_t first = std::max(at, change->first),
                  last = std::min(at + size, change->first + change->second.size());
    if (first < last)
      std::copy_n(change->second.begin() + static_cast<std::ptrdiff_t>(first - change->first), last - first,
                  bytes + (first - at));
  }
  return done;
}

herr_t write(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* buffer) {
  File& file = of(base);
  const auto* bytes = static_cast<const char*>(buffer);
  if (at < file.known) {
    const std::size_t inside = std::min<haddr_t>(size, file.known - at);
    change(file.changes, at, bytes, inside);
    at += inside;
    bytes += inside;
    size -= inside;
  }
  if (size == 0) return done;
  if (!write_all(file.descriptor, bytes, size, at)) return fail("file write failed");
  file.size = std::max(file.size, at + size);
  return done;
}

herr_t truncate(H5FD_t* base, hid_t, hbool_t) {
  File& file = of(base);
  if (file.size >= file.end_of_use) return done;
  if (ftruncate(file.descriptor, static_cast<off_t>(file.end_of_use)) != 0) return fail("file write failed");
  file.size = file.end_of_use;
  return done;
}

/// The last call of H5Fflush: what readers know changes now. The file's head, which says how long it is, lies first.
herr_t flush(H5FD_t* base, hid_t, hbool_t) {
  File& file = of(base);
  for (const auto& [at, bytes] : file.changes)
    if (!write_all(file.descriptor, bytes.data(), bytes.size(), at)) return fail("file write failed");
  file.changes.clear();
  file.known = file.size;
  return done;
}

haddr_t end_of_use(const H5FD_t* file, H5FD_mem_t) { return of(file).end_of_use; }
herr_t set_end_of_use(H5FD_t* file, H5FD_mem_t, haddr_t at) {
  of(file).end_of_use = at;
  return done;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return of(file).size; }
herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags)
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
             H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return done;
}

hid_t driver() {
  static const H5FD_class_t description = [] {
    H5FD_class_t d{};
    d.name = "steady";
    d.maxaddr = HADDR_MAX / 4;
    d.fc_degree = H5F_CLOSE_WEAK;
    d.open = open_file;
    d.close = close_file;
    d.query = query;
    d.get_eoa = end_of_use;
    d.set_eoa = set_end_of_use;
    d.get_eof = end_of_file;
    d.read = read;
    d.write = write;
    d.truncate = truncate;
    d.flush = flush;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), d.fl_map);
    return d;
  }();
  static const hid_t id = H5FDregister(&description);
  return id;
}

}  // namespace

void use_steady_driver(hid_t access) { H5Pset_driver(access, driver(), nullptr); }

}  // namespace ashlar::hdf5
