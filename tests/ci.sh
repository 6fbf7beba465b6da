#!/usr/bin/env bash
# Everything that must hold, as one command: installs what is missing, then runs each check as a named step.
#
#   tests/ci.sh               all steps
#   tests/ci.sh test doc      only these
#
# A step that fails does not hide the ones after it; the last lines say which failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Here a missing driver or tool is a failure, not a skip.
export LOBE_REQUIRE_TOOLS=1
# Snapshots are compared, never written.
export INSTA_UPDATE=no
[[ -t 1 ]] || export CARGO_TERM_COLOR=never CARGO_TERM_PROGRESS_WHEN=never

all=(setup format lint test outside doc check mutate oracle golden measure throughput)
wanted=("$@")
[[ $# -gt 0 ]] || wanted=("${all[@]}")

# The program that the tests have built. `cargo run` would build all of it again: what the tests depend on gives its
# dependencies features that it alone does not have.
lobe() {
    cargo test --release --workspace --no-run --quiet &&
        "${CARGO_TARGET_DIR:-target}/release/lobe" "$@"
}

# One command each, so that its exit status is the step's.
# shellcheck disable=SC2317 # called by name
{
step_setup() { tests/setup.sh; }
step_format() { cargo fmt --all --check; }
# Optimised, as what follows: programs that run while others are built are then built once.
step_lint() { cargo clippy --release --workspace --all-targets -- -D warnings; }
# The tests' own time is spent in the interpreter.
step_test() { cargo test --release --workspace --no-fail-fast; }
# A crate of a user's own, as a user builds it: a workspace by itself, with the versions of ours. Its dependencies are built
# again, since the features that they have here come from tests of ours.
step_outside() (
    cd codegen/examples/fog
    cp ../../../Cargo.lock .
    export CARGO_TARGET_DIR=../../../target/fog
    cargo fmt -p fog -p fog-kernels --check
    cargo test --workspace
    "$CARGO_TARGET_DIR/debug/examples/glow"
)
step_doc() { RUSTDOCFLAGS="-D warnings" cargo doc --release --workspace --no-deps; }
# The main job, as a user runs it, with every road to the driver that CI must have, and drivers drawn by chance.
step_check() {
    lobe check --sanitize --perturbed 10 \
        --require "spirv@lavapipe" --require "wgsl+naga@lavapipe" --require "hlsl+dxc@lavapipe" \
        --require "hlsl+slang@lavapipe" --require "glsl+glslang@lavapipe" \
        --require "wgsl+tint@lavapipe" --require "glsl@llvmpipe"
}
# What share of faults seeded into the library a check notices.
step_mutate() { lobe mutate --equivalence 200000; }
# The tables that came with the kernels, on every route.
step_oracle() { lobe oracle tests/cases/oracle; }
# The pictures that were accepted, on every route; nothing is written.
step_golden() { lobe golden check --no-write --require "spirv@lavapipe" --require "spirv@swiftshader"; }
# The figures in the documentation are those of today.
step_measure() { lobe measure --check; }
# The interpreter keeps half of its goals against lavapipe: no more can be asked of a machine that does other things too.
step_throughput() { lobe bench --floor; }
}

command -v cargo >/dev/null || { echo "ci: cargo is missing: install Rust from https://rustup.rs" >&2; exit 1; }

summary=()
failed=0
for name in "${wanted[@]}"; do
    if ! declare -F "step_$name" >/dev/null; then
        echo "ci: there is no step '$name'; the steps are: ${all[*]}" >&2
        exit 2
    fi
done
for name in "${wanted[@]}"; do
    printf '\nci: == %s ==\n' "$name"
    start=$SECONDS
    status=0
    "step_$name" </dev/null || status=$?
    verdict=ok
    if [[ $status -ne 0 ]]; then
        verdict="FAILED (exit $status)"
        failed=1
    fi
    summary+=("$(printf 'ci: %-10s %4d s  %s' "$name" $((SECONDS - start)) "$verdict")")
    if [[ $name == setup && $status -ne 0 ]]; then
        break
    fi
done

printf '\n'
printf '%s\n' "${summary[@]}"
exit "$failed"
