#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# check.sh PROGRAM EXIT_CODE PATTERN REPORT_FOLDER: does `PROGRAM snapshot check` of the references that match exit so,
# and does it name changed pictures exactly when it should?
set -euo pipefail
program=$1 expected=$2 pattern=$3 report=$4

code=0
text=$("$program" snapshot check --backend cpu -g "$pattern" --report "$report") || code=$?
printf '%s\n' "$text"
if ((code != expected)); then
    printf 'exit code %d instead of %d\n' "$code" "$expected" >&2
    exit 1
fi
changed=$(grep -c '^changed' <<<"$text" || true)
if ((expected == 1 && changed == 0)); then
    printf 'no picture is named as changed\n' >&2
    exit 1
fi
