# Sourced by the other scripts: installs the Debian packages that are missing, and nothing else.
# shellcheck shell=bash

granlaw_packages=(liggghts libliggghts-dev libopenmpi-dev openmpi-bin g++ libclang-dev pkg-config valgrind)
# More, for scripts/avx512.sh.
# shellcheck disable=SC2034
granlaw_emulator=(bochs bochs-term bochsbios vgabios isolinux syslinux-common xorriso cpio busybox-static)

granlaw_setup() {
    local missing=() package
    command -v cargo >/dev/null || {
        echo "cargo is missing: install a Rust toolchain (https://rustup.rs)" >&2
        return 2
    }
    for package in "${granlaw_packages[@]}"; do
        dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    command -v apt-get >/dev/null || {
        echo "these Debian packages are missing and there is no apt-get to install them: ${missing[*]}" >&2
        return 2
    }
    echo "installing ${missing[*]}"
    granlaw_root apt-get update -q
    DEBIAN_FRONTEND=noninteractive granlaw_root apt-get install -q -y --no-install-recommends "${missing[@]}"
}

granlaw_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}
