#!/usr/bin/env bash
# Everything that must hold before a change lands: formatting, lints, all tests, on the real LIGGGHTS.
# Example: scripts/test.sh
set -euo pipefail
cd "$(dirname "$0")/.."
case "${1:-}" in
-h | --help) sed -n '2,3s/^# //p' "$0"; exit 0 ;;
esac
source scripts/setup.sh
granlaw_setup
# Where these cannot be had, the test that needs them says so.
(granlaw_packages=("${granlaw_emulator[@]}") && granlaw_setup) || true

cargo fmt --all --check
cargo build --release --workspace --locked
cargo clippy --release --workspace --all-targets --locked -- -D warnings
cargo test --release --workspace --locked
