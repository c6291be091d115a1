# Shared by ./kerf and ./test: the Debian packages, one build at a time, the configured build folder.
# The caller sets `root`, the checkout. Nothing here writes to standard output: what kerf prints stays clean.
# shellcheck shell=bash
: "${root:?}"

kBuildPackages=(g++ cmake ninja-build libeigen3-dev libboost-dev libspdlog-dev libcli11-dev libtomlplusplus-dev
  nlohmann-json3-dev libexpected-dev zlib1g-dev)
# shellcheck disable=SC2034  # used by ./test
kTestPackages=("${kBuildPackages[@]}" libgtest-dev libgmock-dev libbenchmark-dev python3 python3-jsonschema
  clang-format pkg-config)
# shellcheck disable=SC2034  # used by ./test all and .ci/run; the last two build scripts/tidy_own_code.cpp
kTidyPackages=(clang-tidy libclang-14-dev llvm-14-dev)
kCannotRun=125  # as env and timeout have it: the command itself was not reached

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

give_up() {
  say "$@"
  exit "$kCannotRun"
}

# find_missing NAME...: sets `missing` to those that are not installed.
find_missing() {
  local name
  missing=()
  for name in "$@"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || missing+=("$name")
  done
}

# Sets `as_root` to what runs a command as root, or fails.
find_root() {
  if ((EUID == 0)); then
    as_root=()
  elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [[ -t 0 && -t 2 ]] && sudo -v; }; }; then
    as_root=(sudo)
  else
    return 1
  fi
}

install_packages() {
  local log="$root/build/packages.log" missing=("$@") as_root
  find_root || give_up "these Debian packages are missing: ${missing[*]}" \
    $'\n'"  neither root nor sudo is at hand here; as root: apt-get install --no-install-recommends ${missing[*]}"
  say "installing Debian packages: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
  local install=("${apt[@]}" install -y --no-install-recommends "${missing[@]}")
  "${install[@]}" >"$log" 2>&1 </dev/null && return
  # Most often there are no package lists yet, or old ones.
  "${apt[@]}" update >>"$log" 2>&1 </dev/null
  "${install[@]}" >>"$log" 2>&1 </dev/null && return
  tail -n 20 "$log" >&2
  find_missing "$@"
  give_up "these Debian packages are missing and could not be installed: ${missing[*]} (log: $log)"
}

# require_packages NAME...: installs what is missing. A stamp newer than dpkg's own record makes the next call free.
require_packages() {
  local status=/var/lib/dpkg/status stamp="$root/build/.packages" wanted="$*" missing
  command -v dpkg-query >/dev/null || return 0  # not Debian: the build says what it lacks
  if [[ -f $stamp && $stamp -nt $status ]] && grep -qxF -- "$wanted" "$stamp"; then
    return 0
  fi
  find_missing "$@"
  ((${#missing[@]} == 0)) || install_packages "${missing[@]}"
  [[ $stamp -nt $status ]] || : >"$stamp"
  printf '%s\n' "$wanted" >>"$stamp"
}

# What the page of `kerf report` and `kerf view` needs, and only they: node 18 or newer, from wherever it comes.
require_node() {
  { command -v node && command -v npm; } >/dev/null || require_packages nodejs npm 9>&-
  local version
  version=$(node --version 2>/dev/null) || give_up "node does not start"
  version=${version#v}
  ((${version%%.*} >= 18)) || give_up "node 18 or newer is needed for the page; this one is $version"
}

# Installs the page's libraries where the lock file asks for others than there are.
install_page_libraries() {
  local web="$root/web" log="$root/build/npm.log"
  [[ $web/node_modules/.package-lock.json -nt $web/package-lock.json ]] && return
  say "installing the page's libraries"
  (cd -- "$web" && npm ci --ignore-scripts --no-audit) >"$log" 2>&1 9>&- </dev/null && return
  tail -n 20 "$log" >&2
  give_up "npm could not install the page's libraries (log: $log)"
}

# build_page FOLDER: the page without data, as FOLDER/page.html.
build_page() {
  local web="$root/web" built="$root/build/web/page.html" log="$root/build/page.log"
  if [[ ! -f $built || -n $(find "$web" -name node_modules -prune -o -type f -newer "$built" -print -quit) ]]; then
    require_node
    install_page_libraries
    if ! (cd -- "$web" && node build.mjs) >"$log" 2>&1 9>&- </dev/null; then
      cat -- "$log" >&2
      give_up "the page could not be built (log: $log)"
    fi
  fi
  cmp -s -- "$built" "$1/page.html" || cp -- "$built" "$1/page.html"
}

# Holds the checkout's build lock on descriptor 9 until unlock.
lock() {
  exec 9>"$root/build/.lock"
  flock -n 9 || { say "waiting for another build"; flock 9; }
}

unlock() { exec 9>&-; }

# configure PRESET [OPTION...]: from nothing if the folder was configured for another place.
configure() {
  local preset=$1 folder="$root/build/$1" fresh=()
  shift
  if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    fresh=(--fresh)
  fi
  if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  (cd -- "$root" && cmake --preset "$preset" "${fresh[@]}" "$@")
}
