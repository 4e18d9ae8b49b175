#!/usr/bin/env bash
# prepare.sh FOLDER: makes FOLDER/usr, which shows ParaView's files together with its Python modules. Debian's package
# python3-paraview cannot stand beside libvtk9-dev, so it is unpacked there and not installed. Exit code 3, with the
# reason, where that cannot be done.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
cannot() { echo "The ParaView plugin is skipped: $1" >&2; exit 3; }

arch=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
[ -d "/usr/lib/$arch/cmake/paraview-5.11" ] || cannot "paraview and paraview-dev 5.11 are not installed (./do paraview installs them)"

version=$(dpkg-query -W -f='${Version}' paraview)
[ "$(cat "$folder/usr/version" 2>/dev/null)" != "$version" ] || exit 0 # laid out before

python=$folder/python/usr/lib/python3/dist-packages
programs=$folder/python/usr/bin
if [ ! -f "$python/paraview/simple.py" ]; then
  if [ -f /usr/lib/python3/dist-packages/paraview/simple.py ]; then
    python=/usr/lib/python3/dist-packages
    programs=/usr/bin
  else
    (cd "$folder" && apt-get download -qq "python3-paraview=$version") || cannot "python3-paraview $version cannot be downloaded"
    dpkg -x "$folder"/python3-paraview_*.deb "$folder/python"
    rm -f "$folder"/python3-paraview_*.deb
  fi
fi

# CMake follows links to its files back to /usr, so those are copies.
rm -rf "$folder/usr"
mkdir -p "$folder/usr/bin" "$folder/usr/lib/python3" "$folder/usr/lib/$arch/cmake"
ln -sf -t "$folder/usr/bin" "$programs"/pvpython* /usr/bin/pv* /usr/bin/paraview* /usr/bin/*-pv5.11
ln -sfn /usr/include "$folder/usr/include"
find "/usr/lib/$arch" -mindepth 1 -maxdepth 1 ! -name cmake -exec ln -sfn -t "$folder/usr/lib/$arch" {} +
cp -r "/usr/lib/$arch/cmake/paraview-5.11" "$folder/usr/lib/$arch/cmake/"
# What the wrappers of ParaView's VTK know of its classes, in place of that of libvtk9-dev.
[ "$python" = /usr/lib/python3/dist-packages ] || ln -sfn "$folder/python/usr/lib/$arch/vtk" "$folder/usr/lib/$arch/vtk"
ln -sfn "$python" "$folder/usr/lib/python3/dist-packages"
echo "$version" > "$folder/usr/version"
