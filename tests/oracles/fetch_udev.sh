#!/usr/bin/env bash
# Usage: fetch_udev.sh FOLDER [RELEASE]
# Unpacks udevadm of a newer Debian release (default trixie: 257) with its libraries into FOLDER, and installs nothing.
# Takes the mirror that apt already uses, with a package list of its own beside FOLDER.
set -euo pipefail

folder=$1
release=${2:-trixie}
packages=(
  udev libsystemd-shared libudev1 libsystemd0 libc6 libacl1 libaudit1 libblkid1 libcap2 libcap-ng0 libcrypt1 libgcc-s1
  libkmod2 liblzma5 libmount1 libpam0g libpcre2-8-0 libseccomp2 libselinux1 libssl3t64 libzstd1 zlib1g
)

mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/*$' | head -n 1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{etc/apt.conf.d,etc/preferences.d,etc/sources.list.d,state/lists/partial,cache/archives/partial} "$folder"
touch "$work/state/status"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $release main" >"$work/etc/sources.list"
cat >"$work/apt.conf" <<END
Dir::Etc "$work/etc";
Dir::State "$work/state";
Dir::State::status "$work/state/status";
Dir::Cache "$work/cache";
APT::Sandbox::User "root";
Acquire::Languages "none";
END
export APT_CONFIG=$work/apt.conf
apt-get update -q >/dev/null
cd "$work"
apt-get download -q "${packages[@]}" >/dev/null
for package in *.deb; do
  dpkg-deb -x "$package" "$folder"
done
rm -rf "$folder"/usr/share "$folder"/usr/lib/udev/hwdb.d "$folder"/usr/lib/*/gconv
