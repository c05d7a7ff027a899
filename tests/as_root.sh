#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# as_root.sh COMMAND...: run COMMAND as root, or print one line if neither root nor sudo is available.
set -euo pipefail

[ "$(id -u)" = 0 ] && exec "$@"
command -v sudo > /dev/null && exec sudo --preserve-env=http_proxy,https_proxy "$@"
echo "Installing what is missing takes root: run this as root, or install sudo" >&2
exit 1
