#pragma once
#include <cstddef>
#include <vector>

namespace ashlar::hdf5 {

/// What HDF5's filters shuffle and deflate (of this level) make of a chunk, byte by byte: for many chunks at once, which
/// the library packs one after the other.
inline constexpr int deflate_level = 1;

/// @param size bytes; @param number_size bytes of one number
std::vector<unsigned char> packed_chunk(const void* values, std::size_t size, std::size_t number_size);

}  // namespace ashlar::hdf5
