#include "io/packed_chunk.hpp"

#include <zlib.h>

#include <stdexcept>

namespace ashlar::hdf5 {

namespace {

/// First bytes of all numbers, then their second bytes, and so on.
std::vector<unsigned char> shuffled(const unsigned char* bytes, std::size_t size, std::size_t number_size) {
  const std::size_t numbers = size / number_size;
  std::vector<unsigned char> result(size);
  for (std::size_t byte = 0; byte < number_size; ++byte)
    for (std::size_t i = 0; i < numbers; ++i) result[byte * numbers + i] = bytes[i * number_size + byte];
  return result;
}

}  // namespace

std::vector<unsigned char> packed_chunk(const void* values, std::size_t size, std::size_t number_size) {
  const auto bytes = shuffled(static_cast<const unsigned char*>(values), size, number_size);
  uLongf length = compressBound(size);
  std::vector<unsigned char> packed(length);
  if (compress2(packed.data(), &length, bytes.data(), size, deflate_level) != Z_OK)
    throw std::logic_error("zlib cannot compress into the room that it asked for");
  packed.resize(length);
  return packed;
}

}  // namespace ashlar::hdf5
