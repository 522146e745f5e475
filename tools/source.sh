#!/bin/sh
# Packs build/playhouse-VERSION.tar.gz: the files that git has, as they are in this tree, what codegen makes of them, and the name
# of the commit. It builds without git, and without the Python that codegen needs.
set -eu
cd "$(dirname "$0")/.."
version=$(sed -n 's/^project(playhouse VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
archive=build/playhouse-$version.tar.gz
mkdir -p build
git describe --always --abbrev=7 --dirty '--exclude=*' > build/COMMIT  # for cmake/WriteVersion.cmake
python3 -m codegen > /dev/null
{ git ls-files; python3 -m codegen --list; } | while read -r file; do [ ! -e "$file" ] || echo "$file"; done |
  tar --create --gzip --file "$archive" --transform "s,^,playhouse-$version/,S" --sort=name --owner=0 --group=0 --numeric-owner \
    --files-from - -C build COMMIT
echo "== $archive"
