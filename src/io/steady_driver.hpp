#pragma once
#include <hdf5.h>

namespace ashlar::hdf5 {

/// Makes files of this access list go through a driver that keeps what is on disk readable when the program is killed:
/// what is new goes behind the end of the file as it comes, where no reader looks yet; what changes inside the part
/// that readers know waits in memory until the file is flushed and then goes out in one go, the file's size first.
void use_steady_driver(hid_t access);

}  // namespace ashlar::hdf5
