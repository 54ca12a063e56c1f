# Shared by quickstart and check (sourced by sh): installs what is missing, configures and builds.

set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/release

# Debian's and Ubuntu's package names, and why each is needed.
packages() {
    cat <<'END'
cmake                     builds Ajar
ninja-build               builds Ajar
g++                       the C++20 compiler
glslang-tools             compiles the kernels to SPIR-V
spirv-tools               optimises them
libvulkan-dev             Vulkan headers and loader
mesa-vulkan-drivers       Vulkan drivers, among them one for machines without a GPU
vulkan-validationlayers   the tests run under them
libglm-dev                vectors and matrices
libfmt-dev                text
libcli11-dev              the command line
nlohmann-json3-dev        reports and information for machines
libtbb-dev                threads
libxxhash-dev             content hashes
libdraco-dev              reads Draco-compressed meshes
libmeshoptimizer-dev      reads meshopt-compressed meshes
libopenimageio-dev        reads and writes images
openimageio-tools         named by the CMake package of the former
libgtest-dev              the tests
python3                   the scenes' generator, which a test runs
END
}

say() { printf '%s\n' "$*"; }

missing_packages() {
    packages | while read -r package why; do
        status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
        [ "$status" = "install ok installed" ] || printf '  %-25s %s\n' "$package" "$why"
    done
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    elif command -v sudo >/dev/null 2>&1; then
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    else
        say "Installing needs root or sudo. As root: apt-get install $names" >&2
        exit 1
    fi
}

install_missing() {
    if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
        say "This system has no apt-get. Ajar needs the counterparts of these Debian packages:" >&2
        packages >&2
        say "Once they are there:  cmake --preset release && cmake --build --preset release" >&2
        exit 1
    fi
    missing=$(missing_packages)
    [ -n "$missing" ] || return 0
    say "Installing with apt-get what is missing:"
    say "$missing"
    names=$(say "$missing" | while read -r package why; do printf '%s ' "$package"; done)
    # Absent package lists show in a simulation, outdated ones when a package cannot be fetched.
    # shellcheck disable=SC2086
    apt-get install -s --no-install-recommends $names >/dev/null 2>&1 || as_root apt-get update
    # shellcheck disable=SC2086
    as_root apt-get install -y --no-install-recommends $names || {
        as_root apt-get update
        as_root apt-get install -y --no-install-recommends $names
    }
}

# build_targets TARGET...: configures a Release build and builds.
build_targets() {
    say "Building in $build"
    generator=
    [ -f "$build/CMakeCache.txt" ] || generator="-G Ninja"
    mkdir -p "$build"
    # shellcheck disable=SC2086
    cmake -S "$root" --preset release $generator >"$build/configure.log" 2>&1 || {
        cat "$build/configure.log" >&2
        exit 1
    }
    cmake --build "$build" --target "$@"
}
