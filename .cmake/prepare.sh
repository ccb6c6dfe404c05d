# Sourced by examples/run.sh and test/run.sh.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
mkdir -p "$root/.build"

# Without it ccache takes no source that has a precompiled header.
export CCACHE_SLOPPINESS=pch_defines,time_macros
# What a source includes ccache takes from the compiler, instead of preprocessing it first.
export CCACHE_DEPEND=1
# Precompiled headers have hundreds of megabytes: each is hashed once, not for every source.
export CCACHE_INODECACHE=1

# Two runs at a time would build in the same folder. Where there is no flock, nothing is locked.
exec 9>"$root/.build/lock"
if command -v flock >/dev/null; then flock 9; fi
unlock() { exec 9>&-; }

# install_missing PACKAGE...: Debian packages. What fails here is said in one line, and the build is tried all the same.
install_missing() {
  local package missing=() as_root=()
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "no Debian-like system: trying to build without installing $*" >&2
    return
  fi
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed* ]] || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then return; fi
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "no right to install: trying to build without ${missing[*]}" >&2
      return
    fi
    as_root=(sudo)
  fi
  echo "installing ${missing[*]}" >&2
  # A stale source among several does not stop the installation.
  "${as_root[@]}" apt-get -qq update >/dev/null || true
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq install --no-install-recommends "${missing[@]}" >/dev/null ||
    echo "could not install: trying to build without ${missing[*]}" >&2
}

# configure FOLDER [OPTION]...: for a build with the CGAL of the environment variable CGAL_DIR, or else the system's.
# CMake by itself would keep the one of the last time.
configure() { cmake -G Ninja -S "$root" -B "$1" -U CGAL_DIR "${@:2}"; }

# Several files of tests in one unit: what they include is compiled once for all of them.
together=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=7)

build_packages=(g++ ninja-build cmake libcgal-dev libeigen3-dev nlohmann-json3-dev libtbb-dev libtinygltf-dev
  libboost-program-options-dev)

# clang with its sanitizers, which some releases have in a package of their own.
install_clang() {
  install_missing clang
  install_missing libclang-rt-dev
}
