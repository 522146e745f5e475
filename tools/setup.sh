#!/bin/sh
# Installs the Debian packages that a goal needs and this machine lacks: setup.sh build|test
# setup.sh --list build|test only prints their names, which tools/packages.py checks: with what they depend on, not what they
# recommend, they must be all that the build and the tests read.
set -eu

build_packages="g++ cmake ninja-build python3 libboost1.81-dev libboost-json1.81-dev libcli11-dev libspdlog-dev
  libfmt-dev libtbb-dev libstb-dev libpng-dev libyaml-cpp-dev libturbojpeg0-dev libjpeg62-turbo-dev zlib1g-dev libzstd-dev libbullet-dev
  libtomlplusplus-dev libassimp-dev libpugixml-dev libepoxy-dev libegl-dev libegl-mesa0 libopengl0 libgl1-mesa-dri pkgconf
  libssl-dev libavahi-client-dev ca-certificates"
test_packages="libgtest-dev libgmock-dev librapidcheck-dev clang lld libclang-rt-14-dev chromium procps python3-numpy
  assimp-utils default-jdk-headless junit4 sbcl cl-chipz tcl strace openssl dbus-daemon avahi-daemon avahi-utils"
# The device server alone, for this machine and for others.
core_packages="g++ cmake ninja-build python3 libspdlog-dev libfmt-dev libasio-dev zlib1g-dev"
cross_packages="g++-aarch64-linux-gnu g++-arm-linux-gnueabihf g++-powerpc-linux-gnu"
test_packages="$test_packages libasio-dev googletest $cross_packages qemu-user"

# They may come from elsewhere than Debian: what counts is whether the commands are there.
node_packages="nodejs npm"

list=
[ "${1:-}" != --list ] || { list=yes; shift; }
case "${1:-}" in
  build) wanted=$build_packages ;;
  test) wanted="$build_packages $test_packages" ;;
  core) wanted=$core_packages; node_packages= ;;
  cross) wanted="$core_packages $cross_packages"; node_packages= ;;
  *) echo "usage: setup.sh [--list] build|test|core|cross" >&2; exit 2 ;;
esac
# shellcheck disable=SC2086
[ -z "$list" ] || { printf '%s\n' $wanted $node_packages; exit 0; }

missing=
for package in $wanted; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing="$missing $package"
done
if [ -n "$node_packages" ]; then
  command -v node >/dev/null || missing="$missing nodejs"
  command -v npm >/dev/null || missing="$missing npm"
fi
[ -n "$missing" ] || exit 0

echo "== installing:$missing"
if [ "$(id -u)" -eq 0 ]; then
  as_root=
elif command -v sudo >/dev/null; then
  as_root=sudo
else
  echo "setup.sh: needs root or sudo to run: apt-get install$missing" >&2
  exit 1
fi
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get -qq update
# shellcheck disable=SC2086
$as_root apt-get -qq install -y --no-install-recommends $missing >/dev/null
