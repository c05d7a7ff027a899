#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# install.sh: install the missing packages among those that the tests need on this Debian system. Needs root to install.
set -euo pipefail

installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
missing=$(grep -v '^#' "$(dirname "$0")/packages.txt" | grep -vFx "$installed" || true)
installable() {
    apt-cache --names-only search . | cut -d' ' -f1 | grep -Fx "$missing" || true
}

[ -n "$missing" ] || exit 0
[ "$(id -u)" = 0 ] || exec "$(dirname "$0")/as_root.sh" "$0"
# On a fresh system the package lists are empty, and old lists can name versions that no longer exist.
if [ -n "$(installable)" ] || ! apt-cache show freecad > /dev/null 2>&1; then
    apt-get -q update
    installable | DEBIAN_FRONTEND=noninteractive xargs apt-get -qy install --no-install-recommends
fi
command -v freecad > /dev/null
