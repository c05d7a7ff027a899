#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# as_root.sh COMMAND...: run COMMAND as root; where that cannot be, one line says so.
set -euo pipefail

[ "$(id -u)" = 0 ] && exec "$@"
command -v sudo > /dev/null && exec sudo --preserve-env=http_proxy,https_proxy "$@"
echo "Installing what is missing takes root: run this as root, or install sudo" >&2
exit 1
