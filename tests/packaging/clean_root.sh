#!/usr/bin/env bash
# Installs the packages into a clean Debian 12 root and uses them there as a person would. Ends with one line, PASSED or FAILED.
#
#   tests/packaging/clean_root.sh [--qgis] [--root DIR] FOLDER
#
# FOLDER holds the .deb files (build/headless after `cmake --build --preset headless --target package`).
# --qgis   installs QGIS too and runs the Processing provider by qgis_process (half a gigabyte more)
# --root   where the root is made and kept for another run, instead of a temporary folder
#
# Needs: root, mmdebstrap, and the Debian archive of this machine's apt sources. docs/dev/packaging.md tells more.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
qgis="" root="" folder=""
while [ $# -gt 0 ]; do
  case "$1" in
    --qgis) qgis=1 ;;
    --root) root=$2; shift ;;
    -*) sed -n '4,8p' "${BASH_SOURCE[0]}"; exit 2 ;;
    *) folder=$1 ;;
  esac
  shift
done
[ "$(id -u)" -eq 0 ] || { echo "clean_root.sh: making a root needs root" >&2; exit 2; }
command -v mmdebstrap >/dev/null || { echo "clean_root.sh: apt install mmdebstrap" >&2; exit 2; }
debs=("${folder:?give the folder of the .deb files}"/*.deb)
[ -e "${debs[0]}" ] || { echo "clean_root.sh: no .deb in $folder; make them with: cmake --build --preset headless --target package" >&2; exit 2; }
if [ -z "$root" ]; then
  root=$(mktemp -d /tmp/bole_root_XXXXXX)/root
  trap 'rm -rf --one-file-system "$(dirname "$root")"' EXIT
fi

# The Debian archive as this machine's apt knows it: component main alone.
sources() {
  apt-get indextargets --format '$(CREATED_BY)|$(ORIGIN)|$(COMPONENT)|deb $(REPO_URI) $(RELEASE) main' | sed -n 's/^Packages|Debian|main|//p'
}

# A root as Debian's installer leaves it at the least, without recommended packages.
if [ ! -e "$root/etc/debian_version" ]; then
  sources | mmdebstrap --quiet --variant=minbase --dpkgopt=force-unsafe-io "" "$root" -
fi

# Runs a command in the root with /proc, /sys and /dev of its own mount namespace.
inside() {
  unshare --mount --pid --fork bash -c '
    root=$1; shift
    mount -t proc proc "$root/proc"
    mount --rbind --make-rslave /dev "$root/dev"
    mount -t tmpfs tmpfs "$root/dev/shm" 2>/dev/null || true
    exec chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"' _ "$root" "$@"
}
as_person() { inside runuser -u forester -- env HOME=/home/forester XDG_RUNTIME_DIR=/tmp/run-forester "$@"; }

cp -L /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
rm -rf "$root/root/debs"
mkdir -p "$root/root/debs"
cp "${debs[@]}" "$root/root/debs/"
inside apt-get -q update
inside bash -c 'apt-get -q install -y --no-install-recommends /root/debs/*.deb xvfb xauth file' > "$root/root/install.log"
id_of_person=1000
grep -q '^forester:' "$root/etc/passwd" || inside useradd -m -u $id_of_person forester
install -d -o $id_of_person -m 700 "$root/tmp/run-forester"
cp "$source_dir/tests/packaging/in_clean_root.sh" "$root/home/forester/"
if [ -n "$qgis" ]; then
  inside apt-get -q install -y --no-install-recommends qgis qgis-providers python3-qgis >> "$root/root/install.log"
fi
result=0
as_person bash /home/forester/in_clean_root.sh ${qgis:+qgis} || result=$?
version=$(inside dpkg-query -W -f '${Version}' bole)
if [ $result -eq 0 ]; then
  echo "PASSED: bole $version in a clean Debian $(cat "$root/etc/debian_version")${qgis:+ with QGIS $(inside dpkg-query -W -f '${Version}' qgis)}"
else
  echo "FAILED: bole $version in a clean Debian $(cat "$root/etc/debian_version")"
fi
exit $result
