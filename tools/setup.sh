#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing. Usage: setup.sh KIND… (kinds: build, test)
set -euo pipefail
cd "$(dirname "$0")/.."

wanted=()
while read -r package kind _; do
  case "$package" in '' | '#'*) continue ;; esac
  for want in "$@"; do [ "$kind" = "$want" ] && wanted+=("$package"); done
done < packages.txt

missing=()
for package in "${wanted[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup: these packages are missing and sudo is not there to install them: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
