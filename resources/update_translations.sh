#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Collect the texts of the code and of the form in the .ts files, and compile the translations in these files.
# The script needs lupdate and lrelease of Qt 6 (Debian: qt6-l10n-tools). To translate new texts, run the script, fill in
# the .ts files with Qt Linguist or an editor, and run the script again.
set -euo pipefail

cd "$(dirname "$0")/translations"
PATH=/usr/lib/qt6/bin:$PATH

mapfile -t sources < <(find ../../vkworkbench/{core,document,gui,language} -name '*.py' | LC_ALL=C sort)
sources+=(../ui/*.ui)

lupdate -silent -locations none -no-obsolete -source-language en "${sources[@]}" -ts VkWorkbench.ts
for language in de fr es-ES zh-CN; do
    lupdate -silent -locations none -no-obsolete -source-language en -target-language "${language/-/_}" \
        "${sources[@]}" -ts "VkWorkbench_$language.ts"
    lrelease -silent -nounfinished "VkWorkbench_$language.ts" -qm "VkWorkbench_$language.qm"
done
