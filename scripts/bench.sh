#!/usr/bin/env bash
# Builds what is needed and times the Rust laws inside LIGGGHTS; arguments are those of `granlaw bench`.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"
cargo build --release --workspace --locked
exec target/release/granlaw bench "$@"
