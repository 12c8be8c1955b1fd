#!/bin/sh
# Sets up, builds and runs every test.
#   tools/test.sh             what each change must pass
#   tools/test.sh --nightly   also the tests labelled nightly
set -eu
cd "$(dirname "$0")/.."

labels="--label-exclude nightly"
case "${1-}" in
  "") ;;
  --nightly) labels="" ;;
  *) echo "usage: tools/test.sh [--nightly]" >&2; exit 2 ;;
esac

tools/setup.sh --test

# Threads that spin while they wait would slow each other where there are more of them than cores.
export OMP_WAIT_POLICY=passive

# Where no device will run them, kernels are compiled for one kind: all of them are the same source.
devices="-UASHLAR_CUDA_ARCHITECTURES"
command -v nvidia-smi >/dev/null || devices="-DASHLAR_CUDA_ARCHITECTURES=90-real"
# shellcheck disable=SC2086
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DASHLAR_CUDA=AUTO $devices
cmake --build build
# shellcheck disable=SC2086
ctest --test-dir build --output-on-failure --parallel 1 $labels

# Where nvcc took part, the program must also build without it, with the same flags.
if command -v nvcc >/dev/null || [ -x /usr/local/cuda/bin/nvcc ]; then
  cmake -S . -B build-cpu -G Ninja -DCMAKE_BUILD_TYPE=Release -DASHLAR_CUDA=OFF
  cmake --build build-cpu --target ashlar
  ctest --test-dir build-cpu --output-on-failure --label-regex source
fi

# At night also with sanitizers: unit tests, wrong decks, the decks to start from, and random mistakes.
if [ -z "$labels" ]; then
  cmake --preset sanitize
  cmake --build build-sanitize
  ctest --test-dir build-sanitize --output-on-failure --parallel 1 --label-exclude "nightly|verify|source" \
    --exclude-regex "decks_dam|parity|plot|readme"
fi
