#!/usr/bin/env bash
# Build granlaw and put program, libraries, header, pkg-config file and plugin under a prefix.
# Example: scripts/install.sh --prefix /usr/local
# Options: --prefix DIR (default /usr/local), --from DIR (take what is built there, build nothing); DESTDIR is honoured.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
prefix=/usr/local
from=
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    --prefix) prefix=${2:?--prefix needs a folder}; shift 2 ;;
    --from) from=${2:?--from needs a folder}; shift 2 ;;
    *) echo "install.sh: unknown argument $1; see --help" >&2; exit 2 ;;
    esac
done
fail() { echo "install.sh: $1" >&2; exit 2; }

prefix=$(realpath -m "$prefix")
if [ -z "$from" ]; then
    (cd "$here" && cargo build --release --workspace --locked)
    from=${CARGO_TARGET_DIR:-$here/target}/release
fi
for file in granlaw libgranlaw.so libgranlaw.a libgranlaw_liggghts.so; do
    [ -f "$from/$file" ] || fail "there is no $from/$file; run cargo build --release --workspace"
done
root=${DESTDIR:-}$prefix
manifest=$root/lib/granlaw/manifest
new=$(mktemp)
trap 'rm -f "$new"' EXIT

# Folders that an earlier installation made are still ours.
[ ! -f "$manifest" ] || grep '^folder ' "$manifest" >"$new" || true

folder() { # note it and those above it, if they are not there yet
    if [ "$1" = . ] || [ -d "$root/$1" ] || grep -qx "folder $1" "$new"; then return; fi
    folder "$(dirname "$1")"
    echo "folder $1" >>"$new"
}
# The manifest is written before anything it names, so that an installation that breaks off can be taken out.
files=(bin/granlaw include/granlaw.h lib/libgranlaw.so.1 lib/libgranlaw.so lib/libgranlaw.a lib/pkgconfig/granlaw.pc)
if grep -q 'granlaw-plugin abi=[0-9]* liggghts=none' "$from/libgranlaw_liggghts.so"; then
    echo "install.sh: the plugin is left out, it was built without LIGGGHTS's headers (packages libliggghts-dev, libopenmpi-dev)" >&2
else
    files+=(lib/granlaw/libgranlaw_liggghts.so)
fi
files+=(lib/granlaw/manifest)
for file in "${files[@]}"; do
    folder "$(dirname "$file")"
    echo "file $file" >>"$new"
done
mkdir -p "$root/lib/granlaw" 2>/dev/null || fail "cannot write to $root; use sudo or another --prefix"
install -m 644 "$new" "$manifest" || fail "cannot write to $root; use sudo or another --prefix"

put() { # MODE SOURCE TARGET: debug information stays behind
    install -D -m "$1" "$2" "$root/$3"
    command -v strip >/dev/null && strip --strip-debug "$root/$3"
}
put 755 "$from/granlaw" bin/granlaw
put 644 "$from/libgranlaw.so" lib/libgranlaw.so.1
put 644 "$from/libgranlaw.a" lib/libgranlaw.a
ln -sf libgranlaw.so.1 "$root/lib/libgranlaw.so"
install -D -m 644 "$here/ffi/capi/include/granlaw.h" "$root/include/granlaw.h"
case " ${files[*]} " in
*" lib/granlaw/libgranlaw_liggghts.so "*) put 644 "$from/libgranlaw_liggghts.so" lib/granlaw/libgranlaw_liggghts.so ;;
esac
install -d "$root/lib/pkgconfig"
cat >"$root/lib/pkgconfig/granlaw.pc" <<END
prefix=${prefix// /\\ }
includedir=\${prefix}/include
libdir=\${prefix}/lib

Name: granlaw
Description: Contact laws for granular simulation
Version: $(sed -n 's/^version = "\(.*\)"/\1/p' "$here/Cargo.toml" | head -1)
Cflags: -I\${includedir}
Libs: -L\${libdir} -lgranlaw
Libs.private: -lm -lpthread -ldl
END
# The linker's cache is brought up to date only where it would look.
if [ -z "${DESTDIR:-}" ] && [ "$(id -u)" -eq 0 ] && ldconfig -NXv 2>/dev/null | grep -q "^$prefix/lib:"; then ldconfig; fi
echo "granlaw is installed under $root; take it out with scripts/uninstall.sh --prefix $prefix"
