#!/usr/bin/env bash
# Take out what scripts/install.sh put under a prefix, and nothing else.
# Example: scripts/uninstall.sh --prefix /usr/local
set -euo pipefail
prefix=/usr/local
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '2,3s/^# //p' "$0"; exit 0 ;;
    --prefix) prefix=${2:?--prefix needs a folder}; shift 2 ;;
    *) echo "uninstall.sh: unknown argument $1; see --help" >&2; exit 2 ;;
    esac
done
fail() { echo "uninstall.sh: $1" >&2; exit 2; }

prefix=$(realpath -m "$prefix")
root=${DESTDIR:-}$prefix
manifest=$root/lib/granlaw/manifest
[ -f "$manifest" ] || fail "there is no $manifest; granlaw is not installed under $prefix"
if grep -qvE '^(file|folder) [a-z]' "$manifest" || grep -qF .. "$manifest"; then
    fail "$manifest holds lines that are not ours; nothing was removed"
fi
[ -w "$root/lib/granlaw" ] || fail "cannot write to $root; use sudo"

folders=()
while read -r kind path; do
    case "$kind" in
    file) rm -f "$root/$path" ;;
    folder) folders=("$path" "${folders[@]}") ;;
    esac
done < <(cat "$manifest")
# Folders that the installation made go if nothing else moved in; the deepest are first.
for path in "${folders[@]}"; do rmdir "$root/$path" 2>/dev/null || true; done
if [ -z "${DESTDIR:-}" ] && [ "$(id -u)" -eq 0 ] && ldconfig -NXv 2>/dev/null | grep -q "^$prefix/lib:"; then ldconfig; fi
echo "granlaw is gone from $root"
