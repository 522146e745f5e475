#!/bin/bash
# bare_machine.sh [--keep] demo|test [FOLDER]: the README's two commands on a Debian 12 that has nothing but git and make, as a
# release should pass them: in a chroot that debootstrap makes in FOLDER (which must not be there yet; default: a temporary
# one), with a clone of the commit that is checked out. `test` runs `make test` there, too. Prints how long each step took and
# what it downloaded. Needs root, debootstrap, 6 GB (for `test` 20) and the network: Debian's archive and npm's registry.
# --keep leaves the folder.
#
# Everything is mounted in a mount namespace that ends with this script, so that no mount can outlive it and removing the
# folder cannot reach through one.
set -euo pipefail

usage() { echo "usage: bare_machine.sh [--keep] demo|test [FOLDER]" >&2; exit 2; }
keep=
[ "${1:-}" != --keep ] || { keep=yes; shift; }
goal=${1:-}
[ "$goal" = demo ] || [ "$goal" = test ] || usage
[ $# -le 2 ] || usage
root=${2:+$(realpath -m "$2")}
cd -P "$(dirname "$0")/.."
. tools/steps.sh

fail() { echo "bare_machine.sh: $*" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || fail "needs root, for chroot and mount"
command -v debootstrap >/dev/null || fail "needs debootstrap: apt-get install debootstrap"
# From here on in namespaces of its own; processes that a step leaves behind end with it.
if [ -z "${BARE_MACHINE_INSIDE:-}" ]; then
  BARE_MACHINE_INSIDE=yes exec unshare --mount --pid --fork --kill-child=TERM --mount-proc tools/bare_machine.sh ${keep:+--keep} "$goal" ${root:+"$root"}
fi

if [ -n "$root" ]; then
  [ ! -e "$root" ] || fail "$root exists: name a folder to be made"
  mkdir -p "$root"
else
  root=$(mktemp -d "${TMPDIR:-/tmp}/bare_machine.XXXXXX")
fi
ended() {
  local status=$?
  [ "$status" -eq 0 ] || echo "bare_machine.sh: failed: ${step_name:-before the first step}" >&2
  remove
}
remove() {
  if [ -n "$keep" ]; then
    echo "== left in $root"
    return
  fi
  # As the first process of its namespace: everything that a step left, and nothing else.
  [ $$ -ne 1 ] || kill -KILL -1 2>/dev/null || true
  umount --recursive "$root/proc" "$root/dev/shm" "$root/dev/pts" 2>/dev/null || true
  if grep -q " $root/" /proc/self/mounts; then
    echo "bare_machine.sh: something is mounted below $root, which is not removed" >&2
    return
  fi
  rm -rf --one-file-system "$root"
}
trap ended EXIT
trap 'exit 130' INT TERM

# What the network of this machine needs: its mirror of packages, its proxies, its own certificate authorities.
mirror=$(grep -rhoE '\bhttps?://[^ ]+/debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list 2>/dev/null | head -1 || true)
mirror=${mirror:-http://deb.debian.org/debian}
npm_setting() { [ -z "$(command -v npm)" ] || npm config get "$1" 2>/dev/null | grep -vx -e null -e undefined || true; }
home=/srv/newcomer  # in the chroot
environment=(HOME=$home PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
  NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt)
for variable in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY CMAKE_BUILD_PARALLEL_LEVEL; do
  [ -z "${!variable:-}" ] || environment+=("$variable=${!variable}")
done
for setting in registry proxy https-proxy; do
  value=$(npm_setting "$setting")
  [ -z "$value" ] || environment+=("npm_config_${setting//-/_}=$value")
done

# inside SHELL-SCRIPT: in the chroot.
inside() { chroot "$root" /usr/bin/env -i "${environment[@]}" sh -euc "$1"; }

make_machine() {
  debootstrap --variant=minbase --include=git,make,ca-certificates bookworm "$root" "$mirror" | sed '/^I: /d'
  mkdir -p "$root$home"
  mount -t proc proc "$root/proc"
  mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  use_debian_sources
  apt-config dump Acquire | grep -E '^Acquire::(http|https|Retries|Check-)' > "$root/etc/apt/apt.conf.d/90network" || true
  # So that what is downloaded can be measured.
  echo 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";' >> "$root/etc/apt/apt.conf.d/90network"
  if [ -d /usr/local/share/ca-certificates ]; then
    cp -rL /usr/local/share/ca-certificates "$root/usr/local/share/"
    inside 'update-ca-certificates >/dev/null 2>&1'
  fi
  inside 'apt-get clean'  # of what debootstrap downloaded
  git clone --quiet --bare "file://$PWD" "$root/srv/playhouse.git"
}

# Debian's own archives only: another one could bring a newer package than a bare machine has.
use_debian_sources() {
  if [ -f /etc/apt/sources.list.d/debian.sources ]; then
    rm -f "$root/etc/apt/sources.list"
    cp /etc/apt/sources.list.d/debian.sources "$root/etc/apt/sources.list.d/"
  elif grep -q '^deb .*bookworm-security' /etc/apt/sources.list 2>/dev/null; then
    grep -E '^deb .* bookworm(-security|-updates)? ' /etc/apt/sources.list > "$root/etc/apt/sources.list"
  fi
}

clone() { inside "cd && git clone --quiet /srv/playhouse.git playhouse && cd playhouse && git checkout --quiet $(git rev-parse HEAD)"; }

# Ports of their own: the network is this machine's.
PLAYER_PORT=${PLAYER_PORT:-16665}
WEB_PORT=${WEB_PORT:-18080}
environment+=("PLAYER_PORT=$PLAYER_PORT" "WEB_PORT=$WEB_PORT")

# Starts the demo and waits until the page comes and the devices are listed; then ends it as Ctrl-C does.
demo() {
  inside '
    cd ~/playhouse
    make demo & demo=$!
    page="import urllib.request; print(urllib.request.urlopen(\"http://127.0.0.1:$WEB_PORT/\").read().decode()[:15])"
    until [ -x build/playhouse ] && python3 -c "$page" 2>/dev/null; do
      kill -0 $demo 2>/dev/null || { echo "make demo ended before the page came"; exit 1; }
      sleep 1
    done
    build/playhouse devices 127.0.0.1:$PLAYER_PORT | head -5
    kill -TERM $demo
    wait $demo || true'
}

# Megabytes of these files.
megabytes() { cat "$@" | wc -c | awk '{printf "%.0f MB", $1 / 1e6}'; }

downloads() {
  inside 'rm -rf /var/lib/apt/lists/*'
  echo "   $(find "$root/var/cache/apt/archives" -name '*.deb' | wc -l) packages, $(megabytes "$root"/var/cache/apt/archives/*.deb)"
  echo "   lists of packages, $(inside 'apt-get update' | sed -n 's/^Fetched \(.*\) in .*/\1/p')"
  find "$root$home/.npm/_cacache/content-v2" -type f -print0 | xargs -0 cat | wc -c | awk '{printf "   from the registry of npm, %.0f MB\n", $1 / 1e6}'
}

main() {
  step "a machine with git and make" make_machine
  step "git clone" clone
  step "make demo, until the page and the devices are there" demo
  echo "== downloaded by make demo:"
  downloads
  if [ "$goal" = test ]; then
    step "make test" inside 'cd ~/playhouse && make test'
    echo "== downloaded in all:"
    downloads
  fi
  report_steps
}
main; exit  # read whole before it begins: the checkout may change while it runs
