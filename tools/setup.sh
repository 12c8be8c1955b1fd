#!/bin/sh
# Installs what Ashlar needs on Debian 12, from Debian's packages only.
#   tools/setup.sh          to build and run
#   tools/setup.sh --test   also what only the tests need (ParaView's Python: 0.8 GB on disk)
set -eu

packages="g++ cmake ninja-build pkg-config liblua5.4-dev libeigen3-dev libcgal-dev libhdf5-dev zlib1g-dev nlohmann-json3-dev libgtest-dev
  python3 python3-numpy python3-h5py python3-matplotlib"

case "${1-}" in
  "") ;;
  --test) packages="$packages python3-paraview" ;;
  *) echo "usage: tools/setup.sh [--test]" >&2; exit 2 ;;
esac

missing=""
for package in $packages; do
  case "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)" in
    installed) ;;
    *) missing="$missing $package" ;;
  esac
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup: run as root, or install sudo; missing:$missing" >&2; exit 1; }
  as_root="sudo"
fi
echo "setup: installing$missing"
$as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
