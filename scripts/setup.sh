# Brings this machine to the point where Mote is built: packages, configuration, build.
# Sourced by scripts/demo and scripts/test, which then call `setup PRESET [TARGET...]`: all is built
# where no target is named. What is there already is not made again, so that a second call takes a
# moment. With native=ON, a first build is for this machine's instruction set alone, which takes half
# the time; what stands already is taken as it is.

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
self=${0##*/}

stage() { printf '==> %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$self" "$*" >&2
  exit 1
}

# quietly LOG COMMAND...: the output goes to LOG; its telling part is shown if the command fails.
quietly() {
  local log=$1
  shift
  mkdir -p "${log%/*}"
  if "$@" >"$log" 2>&1; then
    return 0
  fi
  # The first failure of a build says more than its end.
  { grep -m 1 -A 40 -E '^FAILED:|^CMake Error|^E: ' "$log" || tail -n 40 "$log"; } >&2
  return 1
}

missing_packages() {
  local wanted
  mapfile -t wanted < <(sed -E 's/[[:space:]]*#.*//; /^$/d' "$root/scripts/$1")
  comm -23 <(printf '%s\n' "${wanted[@]}" | sort) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null |
      sed -n 's/^installed //p' | sort)
}

# install_packages [LIST]: those of packages.txt, or of another list beside it.
install_packages() {
  local list=${1:-packages.txt}
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    stage "Not a Debian system: taking the packages of scripts/$list as given"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$list")
  if ((${#missing[@]} == 0)); then
    return
  fi
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || { [[ ! -t 0 ]] && ! sudo -n true 2>/dev/null; }; then
      fail "these packages are missing and only root can install them: ${missing[*]}"
    fi
    as_root=(sudo)
  fi
  stage "Installing packages: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y)
  local log=$root/build/packages.log
  # The package lists are fetched only when those at hand do not do.
  if ! quietly "$log" "${apt[@]}" install --no-install-recommends "${missing[@]}" 2>/dev/null; then
    quietly "$log" "${apt[@]}" update ||
      fail "apt-get update failed (see $log); is there a network?"
    quietly "$log" "${apt[@]}" install --no-install-recommends "${missing[@]}" ||
      fail "apt-get could not install the packages (see $log)"
  fi
}

configure() {
  local preset=$1 dir=$root/build/$1 native=${native:-OFF} options=()
  if [[ $native == OFF || ! -e $dir/CMakeCache.txt ]]; then
    options+=("-DMOTE_NATIVE=$native")
  fi
  # Ninja itself sees to changed CMake files; the presets and options are beyond its knowledge.
  if [[ -e $dir/build.ninja && ! $root/CMakePresets.json -nt $dir/build.ninja ]] &&
    { [[ $native == ON ]] || ! grep -q '^MOTE_NATIVE:BOOL=ON' "$dir/CMakeCache.txt"; }; then
    return
  fi
  stage "Configuring build/$preset"
  local embree
  embree=$(dpkg-query -W -f '${Version}' libembree-dev 2>/dev/null || true)
  if [[ -n $embree && $embree != 3.* ]]; then
    stage "Embree is $embree and not 3: leaving the benchmarks out"
    options+=(-DMOTE_BUILD_BENCHMARKS=OFF)
  fi
  (cd "$root" && quietly "$dir/configure.log" cmake --preset "$preset" "${options[@]}") ||
    fail "CMake could not configure the build (see $dir/configure.log)"
}

# One job a core, but no more than memory allows: a file that uses VTK takes up to 1.5 GB.
job_count() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1.5e6) }' /proc/meminfo)
  ((memory < cores)) && cores=$memory
  echo $((cores > 1 ? cores : 1))
}

build() {
  local preset=$1 dir=$root/build/$1 n
  shift
  n=$(job_count)
  stage "Building build/$preset, $n at a time"
  if [[ -t 1 ]]; then
    ninja -C "$dir" -j "$n" "$@" || fail "the build failed"
  else
    quietly "$dir/build.log" ninja -C "$dir" -j "$n" "$@" || fail "the build failed (see $dir/build.log)"
  fi
}

setup() {
  install_packages
  configure "$1"
  build "$@"
}
