#!/bin/sh
# From a fresh Debian 12 to a cracked dam: sets up, builds, runs decks/dam/seasons.lua and draws it.
set -eu
cd "$(dirname "$0")/.."

tools/setup.sh

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DASHLAR_CUDA=AUTO
cmake --build build --target ashlar

build/ashlar run decks/dam/seasons.lua --out seasons.run --force
echo
echo "drawing four pictures"
build/ashlar plot seasons.run
echo
echo "to open in ParaView: seasons.run/results.xdmf (fields), seasons.run/interfaces.xdmf (joints and cracks)"
echo "to read again:       build/ashlar info seasons.run"
