#!/usr/bin/env bash
# Run every deck three ways and write the report; arguments go to `granlaw verify`.
# Example: scripts/verify.sh liggghts_inputs/sticking.in --out /tmp/sticking
set -euo pipefail
cd "$(dirname "$0")/.."
case "${1:-}" in
-h | --help) sed -n '2,3s/^# //p' "$0"; exit 0 ;;
esac
source scripts/setup.sh
granlaw_setup

cargo build --release --workspace --locked
exec target/release/granlaw verify --require-liggghts "$@"
